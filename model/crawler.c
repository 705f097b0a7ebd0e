#include "model/model.h"

#include <math.h>
#include <stddef.h>

#include "model/scaling.h"

const char *scallop_status_text(enum scallop_status status)
{
  switch (status) {
  case SCALLOP_OK: return "ok";
  case SCALLOP_INTERVAL: return "interval of steady states";
  case SCALLOP_EDOMAIN: return "a parameter is outside its domain";
  case SCALLOP_ERANGE: return "out of range: a scaled quantity overflows or underflows";
  case SCALLOP_ECONVERGE: return "no convergence";
  case SCALLOP_EUNDECIDED: return "cannot be decided";
  case SCALLOP_STOPPED:
  case SCALLOP_ESTOPPED: return "stopped before the end";
  }
  return "unknown status";
}

struct scallop_crawler scallop_crawler_default(void)
{
  return (struct scallop_crawler){
    .m1 = 1, .m2 = 1, .F1 = 4, .F2 = 1, .L = 10, .T = 1, .alpha = 0.75, .gait = &scallop_gait_quadratic
  };
}

static enum scallop_status complain(struct scallop_complaint *complaint, const char *name, double given,
                                    const char *allowed)
{
  if (complaint)
    *complaint = (struct scallop_complaint){ name, given, allowed };
  return SCALLOP_EDOMAIN;
}

static bool is_positive(double x) { return x > 0 && x <= DBL_MAX; }

/* Returns true if the crawler needs no complaint, the usual case. */
static bool is_good(const struct scallop_crawler *c)
{
  return is_positive(c->m1) && is_positive(c->m2) && is_positive(c->F1) && is_positive(c->F2) && is_positive(c->L)
         && is_positive(c->T) && c->alpha > 0 && c->alpha < 1 && c->gait;
}

enum scallop_status scallop_crawler_check(const struct scallop_crawler *crawler, struct scallop_complaint *complaint)
{
  if (is_good(crawler))
    return SCALLOP_OK;
  const struct {
    const char *name;
    double value;
  } positive[] = {
    { "m1", crawler->m1 }, { "m2", crawler->m2 }, { "F1", crawler->F1 },
    { "F2", crawler->F2 }, { "L", crawler->L },   { "T", crawler->T },
  };
  for (size_t i = 0; i < sizeof positive / sizeof *positive; i++)
    if (!is_positive(positive[i].value))
      return complain(complaint, positive[i].name, positive[i].value, "a finite number > 0");
  if (!(crawler->alpha > 0 && crawler->alpha < 1))
    return complain(complaint, "alpha", crawler->alpha, "a number between 0 and 1, both excluded");
  return complain(complaint, "gait", NAN, "a gait");
}

double scallop_phase_duration(const struct scallop_crawler *crawler, enum scallop_phase_kind kind)
{
  return (kind == SCALLOP_EXTENSION ? crawler->alpha : 1 - crawler->alpha) * crawler->T;
}

/* Returns T^2 F/(M L), exponents apart, for parameters of which an intermediate result leaves the normal range. */
static double inverse_froude(double T, double F, double M, double L)
{
  int eT, eF, eM, eL;
  T = frexp(T, &eT), F = frexp(F, &eF), M = frexp(M, &eM), L = frexp(L, &eL);
  return ldexp((T / L) * (F / M * T), 2 * eT + eF - eM - eL);
}

enum scallop_status scallop_scale(const struct scallop_crawler *c, struct scallop_scaled *scaled)
{
  struct scallop_scaled s;
  if (scaling_is_moderate(c->m1) && scaling_is_moderate(c->m2) && scaling_is_moderate(c->F1)
      && scaling_is_moderate(c->F2) && scaling_is_moderate(c->L) && scaling_is_moderate(c->T)
      && scaling_is_moderate(c->alpha) && 1 - c->alpha > 0 && c->gait) { /* the usual case; within the domain */
    scaling_set(c->m1, c->m2, c->F1, c->F2, c->L, c->T, c->alpha, scaled);
    scaled->gait = c->gait;
    return SCALLOP_OK;
  }
  if (!scaling_of(c->m1, c->m2, c->F1, c->F2, c->L, c->T, c->alpha, &s) || !c->gait) {
    if (scallop_crawler_check(c, NULL) != SCALLOP_OK)
      return SCALLOP_EDOMAIN;
    s.eps = inverse_froude(c->T, c->F1 + c->F2, c->m1 + c->m2, c->L);
    double a = c->alpha, b = 1 - a;
    const double must_be_normal[] = { s.mu1,           s.mu2,           s.f1,  s.f2,  s.eps,          s.velocity,
                                      s.eps * (a * a), s.eps * (b * b), a * a, b * b, s.velocity / a, s.velocity / b };
    for (size_t i = 0; i < sizeof must_be_normal / sizeof *must_be_normal; i++)
      if (!scaling_is_normal(must_be_normal[i]))
        return SCALLOP_ERANGE;
  }
  s.gait = c->gait;
  *scaled = s;
  return SCALLOP_OK;
}

double scallop_kinematic_length(const struct scallop_gait *gait, enum scallop_phase_kind kind, double L)
{
  double l0 = gait->phase[kind].l0, lT = gait->phase[kind].lT;
  double size = l0 * lT / (2 * (lT - l0));
  return L * (kind == SCALLOP_EXTENSION ? size : -size);
}
