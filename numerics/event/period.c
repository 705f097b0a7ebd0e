#include "numerics/event/period.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

#include "numerics/event/concave.h"
#include "numerics/event/ramps.h"
#include "numerics/event/solve.h"
#include "numerics/event/start.h"

/* By a short cut where there is one. */
static void solve_motion(const struct motion_input *input, double c0, struct motion *motion)
{
  bool ramps = input->shape->ramps, concave = input->shape->concave;
  bool solved = input->base == 0
                && (ramps ? ramps_solve(input, c0, motion) : concave && concave_solve(input, c0, motion));
  if (!solved)
    motion_solve(input, c0, motion, NULL, NULL);
}

void period_phase(const struct scallop_scaled *s, enum scallop_phase_kind kind, struct period *period,
                  scallop_visitor *visit, void *context)
{
  struct motion_input input = motion_input_of(s, kind);
  input.base = period->base[kind];
  bool extension = kind == SCALLOP_EXTENSION;
  double fraction = s->fraction[kind], entry = extension ? period->c_start : period->c_mid;
  struct motion *motion = &period->phase[kind];
  if (visit)
    motion_solve(&input, entry * fraction, motion, visit, context);
  else
    solve_motion(&input, entry * fraction, motion);
  *(extension ? &period->c_mid : &period->c_end) = motion->c_end / fraction;
  period->goes_on = !extension;
}

/* Over a whole period the centre of mass and both bodies come equally far. Where much of that cancels for the first,
 * the one for which least does tells best. */
static void look_at_bodies(const struct scallop_scaled *s, struct period *period)
{
  struct motion_ways ways[2];
  const double c[2] = { period->c_start, period->c_mid };
  for (int kind = 0; kind < 2; kind++) {
    struct motion_input input = motion_input_of(s, (enum scallop_phase_kind)kind);
    struct motion again;
    input.base = period->base[kind];
    motion_solve_ways(&input, c[kind] * s->fraction[kind], &again, &ways[kind]);
  }
  for (int i = 1; i < 3; i++)
    if (ways[0].size[i] + ways[1].size[i] < period->size) {
      period->travel = ways[0].way[i] + ways[1].way[i];
      period->size = ways[0].size[i] + ways[1].size[i];
    }
}

void period_conclude(const struct scallop_scaled *s, struct period *period)
{
  const struct motion *e = &period->phase[SCALLOP_EXTENSION], *c = &period->phase[SCALLOP_CONTRACTION];
  double a = s->fraction[SCALLOP_EXTENSION], b = s->fraction[SCALLOP_CONTRACTION];
  period->travel = e->travel + c->travel;
  period->size = e->size + c->size;
  period->forgets = e->forgets || c->forgets;
  double driven = s->delta * period_driven(s->gait, s->fraction[SCALLOP_EXTENSION]);
  double from_e = a * e->extra_impulse, from_c = b * c->extra_impulse;
  period->balance = driven + from_e + from_c;
  period->noise = DBL_EPSILON * (fabs(driven) + fabs(from_e) + fabs(from_c));
  double slope_e = a * a * e->slope, slope_c = b * b * c->slope;
  period->balance_slope = slope_e + slope_c + s->eps * slope_e * slope_c;
}

void period_sum_up(const struct scallop_scaled *s, struct period *period)
{
  if (period_cancels(period->travel, period->size, false))
    look_at_bodies(s, period);
}

void period_begin(struct period *period)
{
  period->base[0] = period->base[1] = 0;
  period->goes_on = false;
}

void period_solve(const struct scallop_scaled *scaled, double c_start, struct period *period)
{
  bool solved = period->goes_on;
  double from = solved ? period->c_mid : 0;
  period->c_start = c_start;
  period_phase(scaled, SCALLOP_EXTENSION, period, NULL, NULL);
  if (solved && period->c_mid == from) /* once a body has been held, it is often the very same */
    period->goes_on = true;
  else
    period_phase(scaled, SCALLOP_CONTRACTION, period, NULL, NULL);
  period_conclude(scaled, period);
}

void period_result(const struct scallop_scaled *scaled, const struct period *p, struct scallop_period_result *result)
{
  double near_1 = 1 + scaled->eps * p->balance_slope;
  bool at_rest = false, sticks = p->phase[0].sticks || p->phase[1].sticks;
  for (int body = 0; body < 2; body++)
    at_rest |= p->phase[0].never_moved[body] && p->phase[1].never_moved[body];
  result->v_start = p->c_start;
  result->v_mid = p->c_mid;
  result->v_end = p->c_end;
  result->displacement = p->travel;
  result->multiplier = p->forgets ? 0 : near_1 > 0.5 ? near_1 : p->phase[0].stretch * p->phase[1].stretch;
  result->balance = p->forgets ? (p->c_end - p->c_start) / scaled->eps : p->balance;
  result->regime = at_rest ? SCALLOP_AT_REST : sticks ? SCALLOP_STICK_SLIP : SCALLOP_SLIDING;
  for (int kind = 0; kind < 2; kind++)
    motion_modes(&p->phase[kind], (enum scallop_phase_kind)kind, &result->modes[kind]);
}

enum scallop_status solve_period(const struct scallop_crawler *crawler, double v0, struct scallop_period_result *result,
                                 struct doubt *doubt)
{
  struct scallop_scaled scaled;
  double c_start;
  enum scallop_status status = start_scaled(crawler, v0, &scaled, &c_start);
  if (status != SCALLOP_OK)
    return status;
  struct period period;
  period_begin(&period);
  period_solve(&scaled, c_start, &period);
  period_sum_up(&scaled, &period);
  double v_mid = period.c_mid * scaled.velocity, v_end = period.c_end * scaled.velocity;
  double displacement = period.travel * crawler->L;
  if (!scaling_keeps(period.c_mid, v_mid) || !scaling_keeps(period.c_end, v_end)
      || !scaling_keeps(period.travel, displacement))
    return SCALLOP_ERANGE;
  period_result(&scaled, &period, result);
  result->v_start = v0;
  result->v_mid = v_mid;
  result->v_end = v_end;
  result->displacement = displacement;
  bool ramps = scaled.gait->phase[0].ramps && scaled.gait->phase[1].ramps;
  const struct scallop_shape *phase = scaled.gait->phase;
  doubt->left = 1;
  for (int kind = 0; kind < 2 && !ramps; kind++)
    doubt->left *= motion_left(&phase[kind], &period.phase[kind]);
  doubt->amplified = doubt->left < 1;
  if (period_cancels(period.travel, period.size, ramps))
    doubt->left *= fabs(period.travel) / period.size;
  return SCALLOP_OK;
}
