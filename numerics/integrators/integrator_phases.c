#include "numerics/integrators/integrator_phases.h"

#include <math.h>

#include "numerics/event/motion.h"

/* Both phases from v0 in L/T; v[kind] is the velocity after each, in the same unit. */
static enum scallop_status run_phases(struct integrator_phases *r, const struct scallop_scaled *s, double v0,
                                      double v[2])
{
  for (int kind = 0; kind < 2; kind++) {
    r->fraction = s->fraction[kind];
    r->eps = s->eps * (r->fraction * r->fraction);
    r->c = (kind == SCALLOP_EXTENSION ? v0 : v[SCALLOP_EXTENSION]) * r->fraction;
    enum scallop_status status = r->phase(r, &s->gait->phase[kind]);
    if (status != SCALLOP_OK)
      return status;
    v[kind] = r->c / r->fraction;
  }
  return SCALLOP_OK;
}

enum scallop_status integrator_period(struct integrator_phases *r, const struct scallop_crawler *crawler, double v0,
                                      struct scallop_integrator_period *period)
{
  struct scallop_scaled s;
  double c0, v[2];
  enum scallop_status status = start_scaled(crawler, v0, &s, &c0);
  if (status != SCALLOP_OK)
    return status;
  *r = (struct integrator_phases){
    .phase = r->phase, .patience = r->patience, .mu = { s.mu1, s.mu2 }, .f = { s.f1, s.f2 }, .f_difference = s.delta
  };
  status = run_phases(r, &s, c0, v);
  if (status != SCALLOP_OK)
    return status;
  struct scallop_integrator_period answer = { .v_mid = v[0] * s.velocity,
                                              .v_end = v[1] * s.velocity,
                                              .displacement = r->x * crawler->L, /* l has returned */
                                              .steps = r->steps,
                                              .evaluations = r->evaluations,
                                              .events = r->events };
  if (!isfinite(answer.v_mid) || !isfinite(answer.v_end) || !isfinite(answer.displacement))
    return SCALLOP_ERANGE;
  *period = answer;
  return SCALLOP_OK;
}
