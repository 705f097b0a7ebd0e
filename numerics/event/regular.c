#include "numerics/event/regular.h"

#include <math.h>
#include <stddef.h>

/* in double, as regular.h has it */
#include "model/bernstein.h"

enum { STEPS = 24, BELL_STEPS = 16 };

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

/* A bell, as of minimum-jerk: |l'| is convex, then concave, then convex, and 0 at both ends of a phase.
 *
 * The same step of Newton's method for all four crossings and the velocity. Near an end of a phase |l'| is almost
 * level, so that a step may lead too far: a place of contact changes by a factor of 4 at most.
 *
 * That these are the modes follows from the signs of d = q |l'| - c at the two crossings.
 *     Before the first one |l'| rises while c falls, so that they meet only once.
 *     In between, d leaves 0 upwards and comes back to 0 downwards, and is convex, then concave, then convex. Therefore
 *     it grows in the first part and falls in the last, and in the second it is not below its ends.
 *     After the last one -d leaves 0 upwards, ends as c > 0, and is convex, then concave.
 * If the line crosses the other curve at last (side = -1), c is 0 once in between, and meets neither curve where it has
 * the other sign. Between that place and a crossing |l'| is at least what it is at the crossing if it is so at that
 * place, as it has one maximum; else, seen from the crossing, its last part is convex, and c stays apart if |l'| is
 * still steeper there than c. */

/* Returns the piece with offset x from the start or, back, from the end, of at most half a phase. */
static const struct scallop_piece *piece_at(const struct scallop_shape *shape, bool back, double x)
{
  const struct scallop_piece *p = &shape->pieces[back ? shape->count - 1 : 0];
  while (x > (back ? p->begin : p->end) && p[back ? -1 : 1].anchor == p->anchor)
    p += back ? -1 : 1;
  return p;
}

/* Returns the offset from the start or, back, from the end, where |l'| is steepest; half way to the middle if it is
 * concave. */
static double first_steepest(const struct scallop_shape *shape, bool back)
{
  const struct scallop_piece *p = &shape->pieces[back ? shape->count - 1 : 0];
  return !shape->bell ? 0.25 : back ? p->begin : p->end;
}

/* |l'| and its slope in double, for the first steps: faster than in long double */
struct rough {
  const struct scallop_law *law;
  struct bernstein speed, differences;
};
static struct tangent rough_tangent(struct rough *r, const struct scallop_piece *p, double x)
{
  if (!p->law || p->law->kind != SCALLOP_LAW_BERNSTEIN)
    return tangent_at(p, false, x);
  if (r->law != p->law) {
    r->law = p->law;
    r->speed = r->differences = bernstein_of(p->law);
    bernstein_differences(&r->differences);
  }
  const struct bernstein *f = &r->speed, *d = &r->differences;
  const double range = f->far - f->near, right = (x - f->near) / range, left = (f->far - x) / range;
  const double slope = f->degree / range * bernstein_sum(d->b, d->degree, right, left);
  return (struct tangent){ slope, bernstein_sum(f->b, f->degree, right, left) - slope * x };
}

/* Moves the places of contact of a phase to the crossings just found. Returns whether they were close. */
static bool move(const struct regular_phase *p, double at[2])
{
  const bool near = regular_is_near(p->t, at[0]) && regular_is_near(p->u, at[1]);
  const double to[2] = { p->t, p->u };
  for (int i = 0; i < 2; i++)
    at[i] = fmin(fmax(to[i], at[i] / 4), fmin(4 * at[i], 0.5));
  return near;
}

/* Returns whether the phase has the modes that were assumed. */
static bool confirms(const struct scallop_shape *shape, double side, const struct regular_phase *p)
{
  const bool inside = p->t < 0.5 && p->u < 0.5 && p->up > 0 && side * p->down > 0;
  if (side > 0)
    return inside;
  const double first = p->up * p->t + p->up_offset, last = p->down * p->u + p->down_offset;
  const double after = p->t - first / p->between, before = p->u + last / p->between; /* where c is 0 */
  const bool back = before < 0.5;
  const double zero = back ? before : after;
  const struct tangent there = tangent_at(piece_at(shape, back, zero), false, zero);
  const double speed = there.slope * zero + there.offset;
  const bool falls = back == (there.slope > 0);
  const double q = falls ? p->q : -p->q_last, level = falls ? first : -last;
  return inside && p->between < 0 && (q * speed >= level || q * fabs(there.slope) >= -p->between);
}

/* Returns whether the last digits of the crossings decide the multiplier, as walk_meet.h tells it: near the peak, where
 * |l'| is level. It is level near the ends as well, but there the offsets have all their digits. */
static bool is_delicate_phase(const struct scallop_shape *shape, const struct regular_phase *p)
{
  const double steepest = 3 * shape->peak, start = first_steepest(shape, false), end = first_steepest(shape, true);
  return regular_delicate_margin(p, p->t > start ? steepest : 0, p->u > end ? steepest : 0) < 0;
}

bool regular_solve_bell(const struct scallop_scaled *s, double side, struct regular *r, struct scallop_work *work)
{
  const struct scallop_shape *shape = s->gait->phase;
  struct regular_system system;
  struct regular_phase *const phase[2] = { &system.e, &system.c };
  struct rough rough[2][2] = { { { .law = NULL } } };
  struct tangents tangents[2];
  double at[2][2];
  bool near = false, settled = false, last = false, valid = false;
  regular_system_of(s, period_driven(s->gait, s->fraction[SCALLOP_EXTENSION]), side, &system);
  for (int kind = 0; kind < 2; kind++)
    for (int end = 0; end < 2; end++)
      at[kind][end] = first_steepest(&shape[kind], end);
  work->periods = 1;
  for (int i = 0; i < BELL_STEPS && !last; i++) {
    for (int kind = 0; kind < 2; kind++)
      for (int end = 0; end < 2; end++) {
        const struct scallop_piece *p = piece_at(&shape[kind], end, at[kind][end]);
        *(end ? &tangents[kind].last : &tangents[kind].first) =
            near ? tangent_at(p, false, at[kind][end]) : rough_tangent(&rough[kind][end], p, at[kind][end]);
      }
    work->gait_evaluations += 4;
    work->root_iterations++;
    valid = regular_times(&system, &tangents[0], &tangents[1]);
    last = settled; /* then these tangents touch at the crossings */
    settled = near;
    near = true;
    for (int kind = 0; kind < 2; kind++) {
      settled = settled && regular_settles(phase[kind], at[kind][0], at[kind][1]);
      near = move(phase[kind], at[kind]) && near;
    }
  }
  work->events = 4;
  r->delicate = is_delicate_phase(&shape[0], &system.e) || is_delicate_phase(&shape[1], &system.c);
  return last && valid && confirms(&shape[0], side, &system.e) && confirms(&shape[1], side, &system.c)
         && regular_result(&system, r);
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
