#include "numerics/event/regular.h"

#include <math.h>
#include <stddef.h>

enum { STEPS = 24 };

/* The steady velocity of the quadratic gait, if its modes are the regular ones: only a place to begin */
static double first_guess(const struct scallop_scaled *s)
{
  const struct tangents ends = { { 4, 0 }, { 4, 0 } };
  struct regular_system system;
  regular_system_of(s, period_driven(s->gait, s->fraction[SCALLOP_EXTENSION]), 1, &system);
  regular_times(&system, &ends, &ends);
  return system.sign * (system.e.c / system.alpha);
}

/* The tangent of |l'| at offset x of a piece, in the direction of growing x. */
SCALLOP_INLINE struct tangent tangent_at(const struct scallop_piece *p, bool sine, double x)
{
  double velocity, acceleration;
  if (sine)
    return regular_sine(x);
  piece_rates(p, x, &velocity, &acceleration);
  double slope = law_sense(p) * p->direction * acceleration;
  return (struct tangent){ slope, p->direction * velocity - slope * x };
}

/* Puts the tangents at the crossings just found. Returns whether they are the last. */
SCALLOP_INLINE bool touch(const struct scallop_shape *shape, bool sine, const struct regular_phase *p, double at[2],
                          struct tangents *tangents)
{
  bool last = regular_is_near(p->t, at[0]) && regular_is_near(p->u, at[1]) && regular_settles(p, at[0], at[1]);
  tangents->first = tangent_at(&shape->pieces[0], sine, p->t);
  tangents->last = tangent_at(&shape->pieces[shape->count - 1], sine, p->u);
  at[0] = p->t;
  at[1] = p->u;
  return last;
}

static bool is_sine(const struct scallop_shape *shape)
{
  return law_is_sine(&shape->pieces[0]) && law_is_sine(&shape->pieces[shape->count - 1]);
}

void regular_modes(bool forward, double side, struct scallop_modes modes[2])
{
  const struct scallop_mode to[2] = { { -1, -1 }, { 1, 1 } }, apart[2] = { { -1, 1 }, { 1, -1 } };
  const bool middle = forward == (side > 0); /* the direction between the phases */
  modes[0].count = modes[1].count = 3;
  modes[0].kept[0] = modes[1].kept[2] = to[forward];
  modes[0].kept[1] = apart[0];
  modes[1].kept[1] = apart[1];
  modes[0].kept[2] = modes[1].kept[0] = to[middle];
}

SCALLOP_INLINE bool solve(const struct scallop_scaled *s, double side, bool ramps, bool sine, struct regular *r,
                          struct scallop_work *work)
{
  const struct scallop_shape *phase = s->gait->phase;
  struct tangents tangents[2] = { regular_ends(&phase[0]), regular_ends(&phase[1]) };
  const struct tangents ends[2] = { tangents[0], tangents[1] };
  double at[2][2] = { { 0, 0 }, { 0, 0 } };
  struct regular_system system;
  bool last = ramps;
  regular_system_of(s, period_driven(s->gait, s->fraction[SCALLOP_EXTENSION]), side, &system);
  work->periods = 1;
  r->c_start = NAN;
  for (int i = 0; i < STEPS; i++) {
    const struct regular_phase *e = &system.e, *c = &system.c;
    if (!regular_times(&system, &tangents[0], &tangents[1]) || !regular_is_inside(&phase[0], e->t, e->u)
        || !regular_is_inside(&phase[1], c->t, c->u))
      break;
    work->events = 4;
    if (last) {
      r->delicate = !ramps
                    && (regular_delicate_margin(e, ends[0].first.slope, ends[0].last.slope) < 0
                        || regular_delicate_margin(c, ends[1].first.slope, ends[1].last.slope) < 0);
      return regular_result(&system, r);
    }
    last = touch(&phase[0], sine, e, at[0], &tangents[0]);
    last &= touch(&phase[1], sine, c, at[1], &tangents[1]);
    work->gait_evaluations += 4;
    work->root_iterations++;
  }
  regular_result(&system, r);
  return false;
}

bool regular_solve(const struct scallop_scaled *s, double side, struct regular *r, struct scallop_work *work)
{
  const struct scallop_shape *phase = s->gait->phase;
  const bool ramps = phase[0].ramps && phase[1].ramps, sine = !ramps && is_sine(&phase[0]) && is_sine(&phase[1]);
#ifndef __wasm__ /* where size counts more */
  if (ramps && side > 0)
    return solve(s, 1, true, false, r, work);
  if (sine && side > 0)
    return solve(s, 1, false, true, r, work);
#endif
  return solve(s, side, ramps, sine, r, work);
}

enum regular_outcome regular_begin(const struct scallop_scaled *s, double *guess)
{
  const struct scallop_shape *phase = s->gait->phase;
  const double a = s->fraction[SCALLOP_EXTENSION], b = s->fraction[SCALLOP_CONTRACTION];
  const double driven = period_driven(s->gait, a);
  *guess = 0;
  if (!phase[0].concave || !phase[1].concave) {
    *guess = first_guess(s);
    const bool bells = (phase[0].concave || phase[0].bell) && (phase[1].concave || phase[1].bell);
    return bells ? REGULAR_BELL : REGULAR_NOT;
  }
  const double e = -phase[0].pieces[0].direction * phase[0].lT, c = -phase[1].pieces[0].direction * phase[1].lT;
  if (!regular_may_be(s, SCALLOP_CONTRACTION, driven, c, s->eps * (b * b)))
    return CONTRACTION_STICKS;
  return regular_may_be(s, SCALLOP_EXTENSION, driven, e, s->eps * (a * a)) ? REGULAR_MAY_BE : EXTENSION_STICKS;
}
