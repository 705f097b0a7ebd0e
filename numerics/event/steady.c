#include <math.h>
#include <stddef.h>

#include "numerics/event/regular.h"
#include "numerics/event/stuck.h"

struct bracket {
  double lo, hi;
};

/* Returns whether c lies in an interval of steady states: no contraction, and a balance of only rounding, also of the
 * decimals. Only where l' jumps over 0 can c go a period unsheared by a curve (docs/background/theory.md). */
static bool flat(const struct walker *s, double c)
{
  struct period p;
  p.continues = false;
  period_solve(s, c, &p);
  bool gives = p.phase[0].extra_impulse != 0 || p.phase[1].extra_impulse != 0;
  return !p.forgets && p.slope == 0 && fabs(p.balance) <= p.noise + (gives ? DBL_EPSILON : 0);
}

static bool has_jump(const struct walker *s)
{
  for (int kind = 0; kind < 2; kind++)
    for (int i = 0; !s->gait->phase[kind].ramps && i < s->gait->phase[kind].count; i++)
      if (s->gait->phase[kind].pieces[i].jump)
        return true;
  return false;
}

/* Returns the end, towards outside, of the flat interval that contains inside. */
static double flat_end(const struct walker *s, double inside, double outside)
{
  for (double mid; (mid = inside + (outside - inside) / 2) != inside && mid != outside;)
    *(flat(s, mid) ? &inside : &outside) = mid;
  return inside;
}

/* Returns the distance over which a flat interval is looked for beside a root: some thousand ulp. */
static double beside(const struct walker *s) { return 0x1p-40 * steady_bound(s); }

/* The steady states around the root c: c itself, or the interval that it belongs to, perhaps as its end. */
static struct bracket steady_states(const struct walker *s, double c)
{
  if (!has_jump(s))
    return (struct bracket){ c, c };
  double step = beside(s), bound = steady_bound(s);
  const double near[] = { c, c - step, c + step };
  for (int i = 0; i < 3; i++)
    if (flat(s, near[i]))
      return (struct bracket){ flat_end(s, near[i], -bound), flat_end(s, near[i], bound) };
  return (struct bracket){ c, c };
}

/* Returns whether a body is stuck at c for less than rounding of c, and the balance, level on a side of c, drives c
 * away there. If so, sets *c to a velocity on that side. Without a jump of l' no balance is level. */
static bool is_driven_away(const struct walker *s, double *c)
{
  if (!has_jump(s))
    return false;
  struct period p;
  for (int side = -1; side <= 1; side += 2) {
    p.continues = false;
    period_solve(s, *c + side * beside(s), &p);
    if (!p.forgets && p.slope == 0 && side * p.balance > p.noise) {
      *c = p.c_start;
      return true;
    }
  }
  return false;
}

/* Returns whether the contraction maps velocities as the extension maps their opposites. Then the mirror image of the
 * steady state, half a period late, is that state itself, and the displacement is 0. */
static bool is_mirrored(const struct walker *s)
{
  if (s->fraction[SCALLOP_EXTENSION] != s->fraction[SCALLOP_CONTRACTION] || !scallop_gait_mirrors(s->gait))
    return false;
  const struct scallop_shape *e = &s->gait->phase[SCALLOP_EXTENSION], *c = &s->gait->phase[SCALLOP_CONTRACTION];
  for (int i = 0; i < e->count; i++)
    if (e->pieces[i].direction != -c->pieces[i].direction)
      return false;
  return true;
}

static bool is_level(const struct scallop_shape *shape)
{
  for (int i = 0; i < shape->count; i++)
    if (!shape->pieces[i].linear || shape->pieces[i].acceleration != 0)
      return false;
  return true;
}

/* Returns whether l' jumps between two levels, and each jump throws the same body, first one way and then the other.
 * Friction brings it to rest each time, in opposite modes: the displacement is 0. */
static bool is_thrown_back(const struct walker *s, const struct period *p)
{
  const struct scallop_modes *extension = &p->phase[SCALLOP_EXTENSION].modes;
  const struct scallop_modes *contraction = &p->phase[SCALLOP_CONTRACTION].modes;
  const struct scallop_mode *e = extension->kept, *c = contraction->kept;
  if (!is_level(s->phase[0].shape) || !is_level(s->phase[1].shape) || extension->count != 2 || contraction->count != 2)
    return false;
  bool opposite = e[0].s1 * c[0].s1 < 0 && e[0].s2 * c[0].s2 < 0;
  return opposite && ((e[1].s1 == 0 && c[1].s1 == 0) || (e[1].s2 == 0 && c[1].s2 == 0));
}

static bool has_ramps(const struct scallop_gait *gait) { return gait->phase[0].ramps && gait->phase[1].ramps; }

/* Returns whether a phase begins, within rounding of c, on the level of a curve over a plateau. */
static bool begins_on_level(const struct walker *s, const struct period *p)
{
  double e = p->c_start * s->fraction[SCALLOP_EXTENSION], c = p->c_mid * s->fraction[SCALLOP_CONTRACTION];
  return walk_level(&s->phase[SCALLOP_EXTENSION], e, 0x1p-48 * fabs(e)) != 0
         || walk_level(&s->phase[SCALLOP_CONTRACTION], c, 0x1p-48 * fabs(c)) != 0;
}

/* Where |l'| rises with the n-th power of the time, c meets it at a time that goes with the n-th root of c. Rounding of
 * the times, of which the balance is the sum, is magnified n-fold in c then: with n = 14 the results of the four
 * rounding modes were up to 91 units apart. It matters where an ulp of F1, F2 or alpha does less to the balance. */
static bool is_amplified(const struct walker *s, const struct period *p)
{
  const double most = 6; /* as for n = 3, where half of the sum balances the other half */
  const struct phase_input *in = &s->phase[0];
  double alpha = s->fraction[SCALLOP_EXTENSION], driven = fabs(s->driven);
  double unit = fabs(p->slope * p->c_start) + 4 * in->f1 * in->f2 * driven + alpha * fabs(in->delta);
  bool linear = s->gait->phase[0].concave && s->gait->phase[1].concave;
  return !linear && !p->forgets && p->noise > most * DBL_EPSILON * unit;
}

/* Sets the doubt of velocities and of the multiplier, for a gait that is not made of ramps: of ramps the multiplier
 * does not depend on the velocity, and a phase has few straight lines. */
static void doubt_velocities(const struct walker *s, const struct period *p, bool on_level, bool interval,
                             struct doubt *doubt)
{
  const struct period_motion *e = &p->phase[SCALLOP_EXTENSION], *c = &p->phase[SCALLOP_CONTRACTION];
  const int many = 8; /* a crossing adds an ulp or two to the error of the multiplier */
  bool crosses_often = e->work.events + c->work.events > many;
  doubt->delicate = !p->forgets
                    && (on_level || e->delicate || c->delicate || crosses_often || period_multiplier(s, p) < 0.0625);
  if (!interval)
    doubt->left = motion_left(&s->gait->phase[0], e) * motion_left(&s->gait->phase[1], c)
                  * (is_amplified(s, p) ? 0x1p-3 : 1);
  doubt->amplified = doubt->left < 1;
}

/* A displacement is the sum of a part for each mode and piece. With more than three straight pieces in a phase the
 * results of the four rounding modes were up to 11 ulp of the sum of the magnitudes of the parts apart. */
static bool has_many(const struct scallop_shape *shape) { return shape->count > (shape->pieces[0].linear ? 3 : 4); }

/* size: of the parts that the displacement is the sum of; 0: nothing cancels */
static void doubt_displacement(const struct scallop_scaled *s, double travel, double size, struct doubt *doubt)
{
  const struct scallop_shape *phase = s->gait->phase;
  double left = 1, driven = period_driven(s->gait, s->fraction[SCALLOP_EXTENSION]);
  bool cancels = period_cancels(travel, size, has_ramps(s->gait));
  if (has_many(&phase[0]) || has_many(&phase[1]))
    cancels = fabs(travel) < 0x1p-1 * size;
  if (cancels)
    left = fabs(travel) / size;
  if (size > 0 && travel != 0 && period_undoes(driven))
    left = fmin(left, fabs(driven));
  doubt->left *= left;
}

/* The solvers below return velocities in L/T and the displacement in L; scaled results are left out. */

static void put_regular(const struct regular *r, double side, struct scallop_steady_result *out)
{
  struct scallop_period_result *p = &out->period;
  p->v_start = out->v_low = out->v_high = r->c_start;
  p->v_mid = r->c_mid;
  p->v_end = r->c_end;
  p->displacement = r->travel;
  p->multiplier = r->multiplier;
  p->balance = r->balance;
  p->regime = SCALLOP_SLIDING;
  regular_modes(r->c_start > 0, side, p->modes);
}

/* order as in stuck_steady. True: it is that simple. */
static bool solve_stuck(const struct scallop_scaled *s, double order, struct scallop_steady_result *out,
                        struct doubt *doubt)
{
  struct stuck h;
  const struct scallop_shape *phase = s->gait->phase;
  const struct ramps e = ramps_of(&phase[SCALLOP_EXTENSION]), c = ramps_of(&phase[SCALLOP_CONTRACTION]);
  stuck_steady(s, order, &e, &c, &h);
  if (!(h.margin > 0))
    return false;
  struct scallop_period_result *p = &out->period;
  p->v_start = p->v_end = out->v_low = out->v_high = h.c_start;
  p->v_mid = h.c_mid;
  p->displacement = h.travel;
  p->multiplier = p->balance = 0;
  p->regime = course_regime(h.course);
  out->work = (struct scallop_work){ .periods = 1 };
  for (int kind = 0; kind < 2; kind++) {
    course_modes((enum scallop_phase_kind)kind, h.course[kind], &p->modes[kind]);
    out->work.events += course_turns(h.course[kind]) ? 2 : 1;
  }
  doubt_displacement(s, h.travel, h.size, doubt);
  return true;
}

/* Solves for any motion, beginning from c, or from rest after the extension if it ends so. */
static enum scallop_status search(const struct scallop_scaled *scaled, enum regular_outcome hint, double c,
                                  struct scallop_steady_result *out, struct doubt *doubt)
{
  const struct walker s = walker_of(scaled);
  struct period period;
  period.continues = false;
  out->work = (struct scallop_work){ 0 };
  if (hint == EXTENSION_STICKS)
    c = steady_from_rest(&s, &period);
  double bound = steady_bound(&s);
  steady_find(&s, isfinite(c) ? c : 0, bound, &period, &out->work);
  c = period.c_start;
  if (period.forgets && is_driven_away(&s, &c))
    steady_find(&s, c, bound, &period, &out->work);
  period_sum_up(&s, &period);
  bool ramps = has_ramps(s.gait);
  bool on_level = !ramps && !steady_find_from_level(&s, &period, &out->work) && begins_on_level(&s, &period);
  struct bracket all = steady_states(&s, period.c_start);
  bool interval = all.lo < all.hi;
  if (interval) {
    period_solve(&s, fmin(fmax(0, all.lo), all.hi), &period);
    period_sum_up(&s, &period);
  } else if (is_mirrored(&s) || is_thrown_back(&s, &period))
    period.travel = period.size = 0;
  period_result(&s, &period, &out->period);
  out->v_low = all.lo;
  out->v_high = all.hi;
  if (!ramps)
    doubt_velocities(&s, &period, on_level, interval, doubt);
  doubt_displacement(scaled, period.travel, period.size, doubt);
  return interval ? SCALLOP_INTERVAL : SCALLOP_OK;
}

/* Returns whether no body is stuck at the end of a phase by which both have changed their direction. */
static bool may_reverse(const struct scallop_scaled *s)
{
  const struct scallop_shape *phase = s->gait->phase;
  const double a = s->fraction[SCALLOP_EXTENSION], b = s->fraction[SCALLOP_CONTRACTION];
  const double q = s->delta < 0 ? s->mu1 : s->mu2; /* of the body that turns last */
  return q * fabs(phase[0].lT) > s->eps * (a * a) && q * fabs(phase[1].lT) > s->eps * (b * b);
}

/* Takes over the solution with the regular modes. Returns false if much of the displacement cancels: its parts have one
 * sign for side = 1. */
static bool take_regular(const struct scallop_scaled *s, const struct regular *r, double side,
                         struct scallop_steady_result *out, struct doubt *doubt)
{
  if (side < 0 && period_cancels(r->travel, r->size, false))
    return false;
  put_regular(r, side, out);
  doubt->delicate = r->delicate;
  if (side < 0)
    doubt_displacement(s, r->travel, r->size, doubt);
  return true;
}

static enum scallop_status find(const struct scallop_scaled *s, struct scallop_steady_result *out, struct doubt *doubt)
{
  struct regular regular;
  double guess;
  *doubt = (struct doubt){ .left = 1 };
  out->work = (struct scallop_work){ 0 };
  const enum regular_outcome outcome = regular_begin(s, &guess);
  for (int side = 1; outcome == REGULAR_BELL && side >= -1; side -= 2)
    if (regular_solve_bell(s, side, &regular, &out->work) && take_regular(s, &regular, side, out, doubt))
      return SCALLOP_OK;
  if (outcome == REGULAR_BELL || outcome == REGULAR_NOT)
    return search(s, outcome, guess, out, doubt);
  if (outcome == REGULAR_MAY_BE) {
    if (regular_solve(s, 1, &regular, &out->work) && take_regular(s, &regular, 1, out, doubt))
      return SCALLOP_OK;
    guess = regular.c_start;
  } else if (has_ramps(s->gait)) {
    const double order = outcome == CONTRACTION_STICKS ? 1 : -1;
    if (solve_stuck(s, order, out, doubt) || solve_stuck(s, -order, out, doubt))
      return SCALLOP_OK;
  }
  if (may_reverse(s) && regular_solve(s, -1, &regular, &out->work)) {
    guess = regular.c_start;
    if (take_regular(s, &regular, -1, out, doubt))
      return SCALLOP_OK;
  }
  return search(s, outcome, guess, out, doubt);
}

enum scallop_status solve_steady(const struct scallop_crawler *crawler, struct scallop_steady_result *result,
                                 struct doubt *doubt)
{
  struct scallop_scaled s;
  struct scallop_steady_result answer;
  enum scallop_status status = scallop_scale(crawler, &s);
  if (status != SCALLOP_OK)
    return status;
  status = find(&s, &answer, doubt);
  struct scallop_period_result *p = &answer.period;
  double c_start = p->v_start, c_mid = p->v_mid, travel = p->displacement;
  answer.froude = 1 / s.eps;
  p->v_start *= s.velocity;
  p->v_mid *= s.velocity;
  p->v_end *= s.velocity;
  p->displacement = scaling_back(travel, crawler->L);
  answer.mean_velocity = p->displacement / crawler->T;
  answer.v_low *= s.velocity;
  answer.v_high *= s.velocity;
  if (!scaling_keeps(1, answer.froude) || !scaling_keeps(c_start, p->v_start) || !scaling_keeps(c_mid, p->v_mid)
      || !scaling_keeps(travel, p->displacement) || !scaling_keeps(travel, answer.mean_velocity))
    return SCALLOP_ERANGE;
  *result = answer;
  return status;
}

enum scallop_status scallop_friction_work(const struct scallop_crawler *crawler, double v_start, double v_mid,
                                          double *work)
{
  struct scallop_scaled s;
  double path[2] = { 0, 0 }, v[2] = { v_start, v_mid };
  enum scallop_status status = scallop_scale(crawler, &s);
  if (status != SCALLOP_OK)
    return status;
  if (!isfinite(v_start) || !isfinite(v_mid))
    return SCALLOP_EDOMAIN;
  const struct walker walker = walker_of(&s);
  for (int kind = 0; kind < 2; kind++) {
    struct period_motion motion;
    motion_walk(&walker.phase[kind], v[kind] / s.velocity * s.fraction[kind], NULL, NULL, &motion);
    path[0] += motion.path[0];
    path[1] += motion.path[1];
  }
  double energy = crawler->F1 * (path[0] * crawler->L) + crawler->F2 * (path[1] * crawler->L);
  if (!isnormal(energy))
    return SCALLOP_ERANGE;
  *work = energy;
  return SCALLOP_OK;
}
