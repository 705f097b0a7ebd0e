#include <math.h>

#include "model/scaling.h"
#include "numerics/event/motion.h"
#include "numerics/event/period.h"
#include "numerics/event/solve.h"
#include "numerics/event/start.h"

/* unit is the velocity L/tau, c0 is v0 in that. */
static enum scallop_status scale(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0,
                                 struct scallop_scaled *scaled, double *unit, double *c0)
{
  enum scallop_status status = scallop_scale(crawler, scaled);
  if (status != SCALLOP_OK)
    return status;
  if (!isfinite(v0))
    return SCALLOP_EDOMAIN;
  double tau = scallop_phase_duration(crawler, kind);
  *unit = crawler->L / tau;
  *c0 = v0 / *unit;
  bool kept = scaling_is_normal(tau) && start_is_kept(v0, *c0, motion_input_of(scaled, kind).eps);
  return kept ? SCALLOP_OK : SCALLOP_ERANGE;
}

enum scallop_status scallop_phase_intervals(const struct scallop_crawler *crawler, enum scallop_phase_kind kind,
                                            double v0, scallop_visitor *visit, void *context)
{
  struct scallop_scaled scaled;
  struct motion motion;
  double unit, c0;
  enum scallop_status status = scale(crawler, kind, v0, &scaled, &unit, &c0);
  if (status != SCALLOP_OK)
    return status;
  struct motion_input input = motion_input_of(&scaled, kind);
  motion_solve(&input, c0, &motion, visit, context);
  return SCALLOP_OK;
}

/* How far something comes, beyond[i] further than the centre of mass, body 1 and body 2: from the one whose parts
 * cancel least. left: of the sum, if that is less than it was and much has cancelled. */
static double best_way(const struct motion_ways *ways, const double beyond[3], double *left)
{
  int best = 0;
  for (int i = 1; i < 3; i++)
    if (ways->size[i] + fabs(beyond[i]) < ways->size[best] + fabs(beyond[best]))
      best = i;
  double way = ways->way[best] + beyond[best], size = ways->size[best] + fabs(beyond[best]);
  if (period_cancels(way, size, false) && fabs(way) / size < *left)
    *left = fabs(way) / size;
  return way;
}

enum scallop_status solve_phase(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0,
                                struct scallop_phase_result *result, struct doubt *doubt)
{
  struct scallop_scaled scaled;
  struct motion motion;
  struct motion_ways ways;
  double unit, c0, tau = scallop_phase_duration(crawler, kind), stroke = kind == SCALLOP_EXTENSION ? 1 : -1;
  enum scallop_status status = scale(crawler, kind, v0, &scaled, &unit, &c0);
  if (status != SCALLOP_OK)
    return status;
  struct motion_input input = motion_input_of(&scaled, kind);
  motion_solve_ways(&input, c0, &motion, &ways);
  doubt->left = motion_left(input.shape, &motion);
  doubt->amplified = doubt->left < 1;
  const double body_1[3] = { -stroke * scaled.mu2, 0, -stroke }, body_2[3] = { stroke * scaled.mu1, stroke, 0 };
  const double middle[3] = { 0.5 * stroke * scaled.mu_difference, 0.5 * stroke, -0.5 * stroke };
  const double way[3] = { best_way(&ways, body_1, &doubt->left), best_way(&ways, body_2, &doubt->left),
                          best_way(&ways, middle, &doubt->left) };
  struct scallop_phase_result answer = {
    .t1 = motion.first_switch * tau,
    .dT = motion.last_switch * tau,
    .v_end = motion.c_end * unit,
    .dx1 = way[0] * crawler->L,
    .dx2 = way[1] * crawler->L,
    .dxC = way[2] * crawler->L,
    .regime = motion.never_moved[0] || motion.never_moved[1] ? SCALLOP_AT_REST
              : motion.sticks                                ? SCALLOP_STICK_SLIP
                                                             : SCALLOP_SLIDING,
    .work = motion.work,
  };
  motion_modes(&motion, kind, &answer.modes);
  bool has_switch = !isnan(motion.first_switch);
  if (!scaling_keeps(motion.c_end, answer.v_end) || !scaling_keeps(way[0], answer.dx1)
      || !scaling_keeps(way[1], answer.dx2) || !scaling_keeps(way[2], answer.dxC)
      || (has_switch
          && !(scaling_keeps(motion.first_switch, answer.t1) && scaling_keeps(motion.last_switch, answer.dT))))
    return SCALLOP_ERANGE;
  *result = answer;
  return SCALLOP_OK;
}
