/* A phase and a period in double. */
#include <math.h>
#include <stddef.h>

#include "numerics/event/motion.h"

struct phase {
  struct scallop_scaled scaled;
  struct phase_input in;
  struct period_motion motion;
  double tau, velocity; /* their units, in the crawler's units */
};

static enum scallop_status walk_phase(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0,
                                      scallop_visitor *visit, void *context, struct phase *p)
{
  enum scallop_status status = scallop_scale(crawler, &p->scaled);
  if (status != SCALLOP_OK)
    return status;
  if (!isfinite(v0))
    return SCALLOP_EDOMAIN;
  p->tau = scallop_phase_duration(crawler, kind);
  p->velocity = crawler->L / p->tau;
  p->in = phase_input_of(&p->scaled, &p->scaled.gait->phase[kind], p->scaled.fraction[kind]);
  double c_0 = v0 / p->velocity;
  if (!scaling_is_normal(p->tau) || !start_is_kept(v0, c_0, p->in.eps))
    return SCALLOP_ERANGE;
  motion_walk(&p->in, c_0, visit, context, &p->motion);
  return SCALLOP_OK;
}

enum scallop_status scallop_phase_intervals(const struct scallop_crawler *crawler, enum scallop_phase_kind kind,
                                            double v0, scallop_visitor *visit, void *context)
{
  struct phase phase;
  return walk_phase(crawler, kind, v0, visit, context, &phase);
}

enum scallop_status solve_phase(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0,
                                struct scallop_phase_result *result, struct doubt *doubt)
{
  struct phase p;
  double way[3], size[3], L = crawler->L;
  enum scallop_status status = walk_phase(crawler, kind, v0, NULL, NULL, &p);
  if (status != SCALLOP_OK)
    return status;
  const struct period_motion *m = &p.motion;
  motion_bodies(&p.in, kind, p.scaled.mu_difference, m, way, size);
  const double scaled[] = { m->c_end, way[0], way[1], way[2], m->first_switch, m->last_switch };
  const double back[] = { m->c_end * p.velocity, way[0] * L, way[1] * L, way[2] * L, m->first_switch * p.tau,
                          m->last_switch * p.tau };
  for (int i = 0; i < (isnan(m->first_switch) ? 4 : 6); i++)
    if (!scaling_keeps(scaled[i], back[i]))
      return SCALLOP_ERANGE;
  doubt->left = motion_left(p.in.shape, m);
  doubt->amplified = doubt->left < 1;
  for (int i = 0; i < 3; i++)
    if (period_cancels(way[i], size[i], false))
      doubt->left = fmin(doubt->left, fabs(way[i]) / size[i]);
  *result = (struct scallop_phase_result){ back[4], back[5],          back[0],  back[1], back[2],
                                           back[3], motion_regime(m), m->modes, m->work };
  return SCALLOP_OK;
}

enum scallop_status solve_period(const struct scallop_crawler *crawler, double v0, struct scallop_period_result *result,
                                 struct doubt *doubt)
{
  struct scallop_scaled scaled;
  struct period period;
  double c_start;
  enum scallop_status status = start_scaled(crawler, v0, &scaled, &c_start);
  if (status != SCALLOP_OK)
    return status;
  const struct walker walker = walker_of(&scaled);
  period.continues = false;
  period_solve(&walker, c_start, &period);
  period_sum_up(&walker, &period);
  double v_mid = period.c_mid * scaled.velocity, v_end = period.c_end * scaled.velocity;
  double displacement = period.travel * crawler->L;
  if (!scaling_keeps(period.c_mid, v_mid) || !scaling_keeps(period.c_end, v_end)
      || !scaling_keeps(period.travel, displacement))
    return SCALLOP_ERANGE;
  period_result(&walker, &period, result);
  result->v_start = v0;
  result->v_mid = v_mid;
  result->v_end = v_end;
  result->displacement = displacement;
  const struct scallop_shape *phase = scaled.gait->phase;
  bool ramps = phase[0].ramps && phase[1].ramps;
  doubt->left = ramps ? 1 : motion_left(&phase[0], &period.phase[0]) * motion_left(&phase[1], &period.phase[1]);
  doubt->amplified = doubt->left < 1;
  if (period_cancels(period.travel, period.size, ramps))
    doubt->left *= fabs(period.travel) / period.size;
  return SCALLOP_OK;
}
