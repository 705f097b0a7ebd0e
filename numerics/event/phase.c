/* A phase and a period in double. */
#include <math.h>
#include <stddef.h>

#include "numerics/event/doubt.h"
#include "numerics/event/motion.h"
#include "numerics/event/start.h"

/* unit is the velocity L/tau, c_0 is v0 in that. */
static enum scallop_status begin_phase(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0,
                                       struct scallop_scaled *scaled, struct phase_input *in, double *unit, double *c_0)
{
  enum scallop_status status = scallop_scale(crawler, scaled);
  if (status != SCALLOP_OK)
    return status;
  if (!isfinite(v0))
    return SCALLOP_EDOMAIN;
  double tau = scallop_phase_duration(crawler, kind);
  *in = phase_input_of(scaled, &scaled->gait->phase[kind], scaled->fraction[kind]);
  *unit = crawler->L / tau;
  *c_0 = v0 / *unit;
  return scaling_is_normal(tau) && start_is_kept(v0, *c_0, in->eps) ? SCALLOP_OK : SCALLOP_ERANGE;
}

enum scallop_status scallop_phase_intervals(const struct scallop_crawler *crawler, enum scallop_phase_kind kind,
                                            double v0, scallop_visitor *visit, void *context)
{
  struct scallop_scaled scaled;
  struct phase_input in;
  struct motion motion;
  double unit, c_0;
  enum scallop_status status = begin_phase(crawler, kind, v0, &scaled, &in, &unit, &c_0);
  if (status == SCALLOP_OK)
    motion_walk(&in, c_0, visit, context, &motion);
  return status;
}

enum scallop_status solve_phase(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0,
                                struct scallop_phase_result *result, struct doubt *doubt)
{
  struct scallop_scaled scaled;
  struct phase_input in;
  struct motion motion;
  double unit, c_0, way[3], size[3], tau = scallop_phase_duration(crawler, kind), L = crawler->L;
  enum scallop_status status = begin_phase(crawler, kind, v0, &scaled, &in, &unit, &c_0);
  if (status != SCALLOP_OK)
    return status;
  motion_walk(&in, c_0, NULL, NULL, &motion);
  motion_bodies(&in, kind, scaled.mu_difference, &motion, way, size);
  struct scallop_phase_result answer = { .t1 = motion.first_switch * tau,
                                         .dT = motion.last_switch * tau,
                                         .v_end = motion.c_end * unit,
                                         .dx1 = way[0] * L,
                                         .dx2 = way[1] * L,
                                         .dxC = way[2] * L,
                                         .regime = motion_regime(&motion),
                                         .modes = motion.modes,
                                         .work = motion.work };
  bool has_switch = !isnan(motion.first_switch);
  if (!scaling_keeps(motion.c_end, answer.v_end) || !scaling_keeps(way[0], answer.dx1)
      || !scaling_keeps(way[1], answer.dx2) || !scaling_keeps(way[2], answer.dxC)
      || (has_switch
          && !(scaling_keeps(motion.first_switch, answer.t1) && scaling_keeps(motion.last_switch, answer.dT))))
    return SCALLOP_ERANGE;
  doubt->left = motion_left(in.shape, &motion);
  doubt->amplified = doubt->left < 1;
  for (int i = 0; i < 3; i++)
    if (period_cancels(way[i], size[i], false))
      doubt->left = fmin(doubt->left, fabs(way[i]) / size[i]);
  *result = answer;
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
  period.goes_on = false;
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
