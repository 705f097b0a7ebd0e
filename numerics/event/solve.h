/* Definitions for period.h, one text for every floating type. Not public. Before including it define what period.h,
 * walk.h and concave.h need. */
#ifndef WALKS_ONLY
#define WALKS_ONLY false
#endif
#include "numerics/event/walk.h"

#include "numerics/event/concave.h"

SOLVE void motion_bodies(const struct phase_input *in, enum scallop_phase_kind kind, real mu_difference,
                         const struct period_motion *m, real way[3], real size[3])
{
  real stroke = kind == SCALLOP_EXTENSION ? 1 : -1, middle = mu_difference / 2;
  const real beyond[3][3] = { { -stroke * in->mu2, 0,
                                -stroke }, /* further than the centre of mass, body 1 and 2 come */
                              { stroke * in->mu1, stroke, 0 },
                              { stroke * middle, stroke / 2, -stroke / 2 } };
  for (int i = 0; i < 3; i++) {
    int best = 0; /* the way with the least cancellation */
    for (int j = 1; j < 3; j++)
      if (m->size[j] + magnitude(beyond[i][j]) < m->size[best] + magnitude(beyond[i][best]))
        best = j;
    way[i] = m->way[best] + beyond[i][best];
    size[i] = m->size[best] + magnitude(beyond[i][best]);
  }
}

SOLVE enum scallop_regime motion_regime(const struct period_motion *m)
{
  return m->never_moved[0] || m->never_moved[1] ? SCALLOP_AT_REST : m->sticks ? SCALLOP_STICK_SLIP : SCALLOP_SLIDING;
}

SOLVE real period_phase(const struct walker *s, enum scallop_phase_kind kind, real c, struct period_motion *motion)
{
  const struct phase_input *in = &s->phase[kind];
  if (WALKS_ONLY || s->walks || in->base != 0 || !concave_phase(in, c * s->fraction[kind], motion))
    motion_walk(in, c * s->fraction[kind], NULL, NULL, motion);
  return motion->c_end / s->fraction[kind];
}

SOLVE void period_conclude(const struct walker *s, struct period *p)
{
  const struct period_motion *e = &p->phase[SCALLOP_EXTENSION], *c = &p->phase[SCALLOP_CONTRACTION];
  real a = s->fraction[SCALLOP_EXTENSION], b = s->fraction[SCALLOP_CONTRACTION];
  real driven = s->phase[0].delta * s->driven, from_e = a * e->extra_impulse, from_c = b * c->extra_impulse;
  p->travel = e->way[0] + c->way[0];
  p->size = e->size[0] + c->size[0];
  p->forgets = e->forgets || c->forgets;
  p->balance = driven + from_e + from_c;
  p->noise = 2 * ROUNDING * (magnitude(driven) + magnitude(from_e) + magnitude(from_c));
  real slope_e = a * a * e->slope, slope_c = b * b * c->slope;
  p->slope = slope_e + slope_c + s->eps * slope_e * slope_c;
}

SOLVE void period_solve(const struct walker *s, real c_start, struct period *p)
{
  /* cppcheck-suppress ctuuninitvar ; it is set before the first solve */
  bool solved = p->continues;
  real from = solved ? p->c_mid : 0;
  p->c_start = c_start;
  p->c_mid = period_phase(s, SCALLOP_EXTENSION, c_start, &p->phase[SCALLOP_EXTENSION]);
  if (!solved || p->c_mid != from) /* once a body has stuck, c_mid often repeats */
    p->c_end = period_phase(s, SCALLOP_CONTRACTION, p->c_mid, &p->phase[SCALLOP_CONTRACTION]);
  p->continues = true;
  period_conclude(s, p);
}

/* Over a whole period the centre of mass and both bodies come equally far. If much cancels for the first, the way with
 * the least cancellation is the most accurate. */
SOLVE void period_sum_up(const struct walker *s, struct period *p)
{
  if (!period_cancels(p->travel, p->size, false))
    return;
  const real c[2] = { p->c_start, p->c_mid };
  for (int kind = 0; kind < 2; kind++) {
    const struct scallop_shape *shape = s->phase[kind].shape;
    struct period_motion walked, *m = &p->phase[kind];
    if (WALKS_ONLY || !m->short_cut)
      continue;
    /* straight pieces are added up with fewer roundings by the walk */
    if (concave_is_plain(shape) && (!shape->ramps || sizeof(real) > sizeof(double))) {
      concave_bodies(&s->phase[kind], m);
      continue;
    }
    motion_walk(&s->phase[kind], c[kind] * s->fraction[kind], NULL, NULL, &walked);
    memcpy(m->way + 1, walked.way + 1, 2 * sizeof *m->way);
    memcpy(m->size + 1, walked.size + 1, 2 * sizeof *m->size);
  }
  for (int i = 1; i < 3; i++)
    if (p->phase[0].size[i] + p->phase[1].size[i] < p->size) {
      p->travel = p->phase[0].way[i] + p->phase[1].way[i];
      p->size = p->phase[0].size[i] + p->phase[1].size[i];
    }
}

SOLVE real period_multiplier(const struct walker *s, const struct period *p)
{
  real near_1 = 1 + s->eps * p->slope;
  return p->forgets ? 0 : 2 * near_1 > 1 ? near_1 : p->phase[0].stretch * p->phase[1].stretch;
}

SOLVE enum scallop_regime period_regime(const struct period *p)
{
  const struct period_motion *e = &p->phase[0], *c = &p->phase[1];
  for (int body = 0; body < 2; body++)
    if (e->never_moved[body] && c->never_moved[body])
      return SCALLOP_AT_REST;
  return e->sticks || c->sticks ? SCALLOP_STICK_SLIP : SCALLOP_SLIDING;
}

SOLVE real steady_bound(const struct walker *s)
{
  return 2 * (s->phase[0].shape->peak / s->fraction[0] + s->phase[1].shape->peak / s->fraction[1] + s->eps);
}

SOLVE real steady_from_rest(const struct walker *s, struct period *p)
{
  p->c_mid = 0;
  p->c_end = period_phase(s, SCALLOP_CONTRACTION, 0, &p->phase[SCALLOP_CONTRACTION]);
  p->continues = true;
  return p->c_end;
}

static void add_work(struct scallop_work *work, const struct period *p)
{
  work->periods++;
  for (int kind = 0; kind < 2; kind++) {
    const struct scallop_work *phase = &p->phase[kind].work;
    work->events += phase->events;
    work->gait_evaluations += phase->gait_evaluations;
    work->root_iterations += phase->root_iterations;
  }
}

/* The balance is nothing but rounding, or a step changes nothing. */
static bool is_settled(const struct period *p)
{
  if (p->forgets)
    return p->c_end == p->c_start;
  return magnitude(p->balance) <= p->noise || magnitude(p->balance) <= -4 * ROUNDING * p->slope * magnitude(p->c_start);
}

/* Replaces c_start by the value of the map if the map shrinks the error of its argument, as in regular.h. */
static void improve(const struct walker *s, struct period *p)
{
  const struct period_motion *e = &p->phase[SCALLOP_EXTENSION], *c = &p->phase[SCALLOP_CONTRACTION];
  if (p->forgets || !(2 * e->stretch * c->stretch < 1))
    return;
  if ((p->c_end > 0) != (p->c_start > 0)) { /* other bodies turn there */
    period_solve(s, p->c_end, p);
    return;
  }
  p->c_mid += e->stretch * (p->c_end - p->c_start);
  p->c_start = p->c_end;
}

/* Newton's method on the balance, or, once a body has been stuck and the map has forgotten its start, the map itself,
 * in a bracket that is halved whenever two steps did not halve the balance. */
SOLVE void steady_find(const struct walker *s, real guess, real bound, struct period *p, struct scallop_work *work)
{
  real low = -bound, high = bound, c = guess < low ? low : guess > high ? high : guess + 0; /* no -0 */
  real last = HUGE_VAL, before = last;
  for (;;) {
    period_solve(s, c, p);
    add_work(work, p);
    if (is_settled(p)) {
      improve(s, p);
      return;
    }
    real balance = p->forgets ? p->c_end - c : p->balance, next = p->forgets ? p->c_end : c - balance / p->slope;
    *(balance > 0 ? &low : &high) = c;
    bool slow = 2 * magnitude(balance) > before;
    before = last;
    last = magnitude(balance);
    if (slow || !(next > low && next < high))
      next = low + (high - low) / 2;
    c = next;
    work->root_iterations++;
    if (!(c > low && c < high))
      break;
  }
  if (!p->forgets && p->slope == 0) /* no root on this side of a kink */
    period_solve(s, p->c_start == low ? high : low, p);
}

SOLVE bool steady_find_from_level(const struct walker *s, struct period *p, struct scallop_work *work)
{
  const real c = p->c_start, rounding = 8 * ROUNDING, near = magnitude(c) / (1 << 19);
  const real reach = 2 * s->eps < near ? 2 * s->eps : near; /* friction changes c by eps at most */
  for (int kind = 0; kind < 2; kind++) {
    real a = s->fraction[kind], b = s->fraction[1 - kind];
    real level = walk_level(&s->phase[kind], c * a, (reach + 8 * rounding * magnitude(c)) * a);
    if (level == 0)
      continue;
    real base = level / a, there = base * b;
    real same = walk_level(&s->phase[1 - kind], there, rounding * magnitude(there)); /* both have a plateau there */
    struct walker from_level = *s;
    struct period q = { .continues = false };
    from_level.phase[kind].base = level;
    from_level.phase[1 - kind].base = same != 0 ? same : there;
    steady_find(&from_level, 0, reach, &q, work);
    if (4 * magnitude(q.c_start) < 3 * reach && magnitude(q.c_mid) < 2 * reach) {
      period_sum_up(&from_level, &q);
      q.c_start += base;
      q.c_mid += base;
      q.c_end += base;
      *p = q;
      return true;
    }
  }
  return false;
}
