#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

#include "numerics/held.h"
#include "numerics/period.h"
#include "numerics/regular.h"
#include "numerics/wide_parts.h"

enum { STEPS = 2200 /* doubles can be halved no longer */ };

struct bracket {
  double lo, hi;
};

/* Above the highest curve both bodies always move forward, below the lowest always backward. */
static struct bracket surely(const struct scallop_scaled *s)
{
  double e = s->gait->phase[SCALLOP_EXTENSION].peak / s->fraction[SCALLOP_EXTENSION];
  double c = s->gait->phase[SCALLOP_CONTRACTION].peak / s->fraction[SCALLOP_CONTRACTION];
  double margin = 1 + 8 * DBL_EPSILON;
  if (fabs(s->gait->phase[SCALLOP_EXTENSION].net) < 1 || fabs(s->gait->phase[SCALLOP_CONTRACTION].net) < 1) {
    /* where l' changes its sign within a phase either body may be in front at its highest speed */
    double most = (fmax(s->mu1, s->mu2) * fmax(e, c) + s->eps) * margin;
    return (struct bracket){ -most, most };
  }
  return (struct bracket){ -(fmax(s->mu1 * e, s->mu2 * c) + s->eps) * margin,
                           (fmax(s->mu2 * e, s->mu1 * c) + s->eps) * margin };
}

/* No contraction, and a balance of nothing but rounding: c lies in an interval of steady states. Only
 * where l' jumps over 0 can c pass a whole period without being sheared by a curve (docs/theory.md). */
static bool flat(const struct scallop_scaled *s, double c)
{
  struct period p;
  p.base[0] = p.base[1] = 0;
  period_solve(s, c, NAN, &p);
  return !p.forgets && p.balance_slope == 0 && fabs(p.balance) <= p.noise;
}

static bool has_jump(const struct scallop_scaled *s)
{
  for (int kind = 0; kind < 2; kind++)
    for (int i = 0; !s->gait->phase[kind].ramps && i < s->gait->phase[kind].count; i++)
      if (s->gait->phase[kind].pieces[i].jump)
        return true;
  return false;
}

/* The end, on the side of outside, of the flat stretch that holds inside. */
static double flat_end(const struct scallop_scaled *s, double inside, double outside)
{
  for (double mid; (mid = inside + (outside - inside) / 2) != inside && mid != outside;)
    *(flat(s, mid) ? &inside : &outside) = mid;
  return inside;
}

/* The steady states around the root c: c itself, or the interval that it belongs to, perhaps as its end. */
static struct bracket steady_states(const struct scallop_scaled *s, double c)
{
  if (!has_jump(s))
    return (struct bracket){ c, c };
  struct bracket all = surely(s);
  double step = ldexp(all.hi - all.lo, -40);
  const double near[] = { c, c - step, c + step };
  for (int i = 0; i < 3; i++)
    if (flat(s, near[i]))
      return (struct bracket){ flat_end(s, near[i], all.lo), flat_end(s, near[i], all.hi) };
  return (struct bracket){ c, c };
}

/* The contraction does to velocities what the extension does to their opposites. Then the mirror image of the only steady state, half
 * a period late, is steady as well: it is that state, which goes back as far as it came. */
static bool is_mirrored(const struct scallop_scaled *s)
{
  if (s->fraction[SCALLOP_EXTENSION] != s->fraction[SCALLOP_CONTRACTION] || !scallop_gait_mirrors(s->gait))
    return false;
  const struct scallop_shape *e = &s->gait->phase[SCALLOP_EXTENSION], *c = &s->gait->phase[SCALLOP_CONTRACTION];
  for (int i = 0; i < e->count; i++)
    if (e->pieces[i].direction != -c->pieces[i].direction)
      return false;
  return true;
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

/* The velocity to go to from c: Newton's step on the balance, or, once a body has been stuck and the map has forgotten where it
 * began, the map's value. */
static double next_guess(const struct period *p)
{
  return p->forgets ? p->c_end : p->c_start - p->balance / p->balance_slope;
}

/* The balance is nothing but rounding, or a step changes nothing. */
static bool settled(const struct period *p)
{
  if (p->forgets)
    return p->c_end == p->c_start;
  return fabs(p->balance) <= p->noise || fabs(p->balance) <= -2 * DBL_EPSILON * p->balance_slope * fabs(p->c_start);
}

/* Where the map shrinks the error of its argument, its value is better, as in regular.h. */
static void improve(const struct scallop_scaled *s, struct period *p)
{
  const struct motion *e = &p->phase[SCALLOP_EXTENSION], *c = &p->phase[SCALLOP_CONTRACTION];
  if (p->forgets || !(e->stretch * c->stretch < 0.5))
    return;
  if ((p->c_end > 0) != (p->c_start > 0)) { /* other bodies turn there */
    period_solve(s, p->c_end, NAN, p);
    return;
  }
  p->c_mid += e->stretch * (p->c_end - p->c_start);
  p->c_start = p->c_end;
}

/* Newton's method, kept inside a bracket that is halved whenever two steps did not halve the balance. within: the bracket, or NULL: it is
 * surely(), which is wanted when Newton's method is in doubt, which is seldom. solved as in period_solve. */
static enum scallop_status find_root(const struct scallop_scaled *s, double guess, double solved,
                                     const struct bracket *within, struct period *p, struct scallop_work *work)
{
  double c = isfinite(guess) ? guess + 0.0 : 0; /* no -0 */
  struct bracket b = within ? *within : (struct bracket){ -INFINITY, INFINITY };
  double last = INFINITY, before = INFINITY;
  for (int i = 0; i < STEPS; i++) {
    period_solve(s, c, solved, p);
    solved = p->c_mid;
    add_work(work, p);
    if (settled(p)) {
      improve(s, p);
      return SCALLOP_OK;
    }
    double balance = p->forgets ? p->c_end - c : p->balance, next = next_guess(p);
    *(balance > 0 ? &b.lo : &b.hi) = c;
    bool slow = fabs(balance) > before / 2;
    before = last;
    last = fabs(balance);
    if (slow || !(next > b.lo && next < b.hi)) {
      struct bracket all = within ? b : surely(s);
      b.lo = fmax(b.lo, all.lo);
      b.hi = fmin(b.hi, all.hi);
      next = b.lo + (b.hi - b.lo) / 2;
    }
    c = next;
    work->root_iterations++;
    if (!(c > b.lo && c < b.hi))
      return SCALLOP_OK;
  }
  return SCALLOP_ECONVERGE; /* GCOVR_EXCL_LINE: halving ends before STEPS */
}

/* If the root is near the level of a curve over a plateau of l', finds the root once more, counted from that level. Friction may change c by
 * less than rounding of c there; the rest tells where on the plateau c meets the curve, and so the modes and the multiplier. */
static void find_from_level(const struct scallop_scaled *s, struct period *p, struct scallop_work *work)
{
  const double c = p->c_start, rounding = 4 * DBL_EPSILON, reach = 2 * s->eps; /* friction changes c by eps at most */
  if (!(s->eps < 0x1p-20 * fabs(c)) || has_jump(s))
    return;
  for (int kind = 0; kind < 2; kind++) {
    const struct motion_input in = motion_input_of(s, (enum scallop_phase_kind)kind);
    const struct motion_input other = motion_input_of(s, (enum scallop_phase_kind)(1 - kind));
    double level = motion_level(&in, c * s->fraction[kind], (reach + 8 * rounding * fabs(c)) * s->fraction[kind]);
    if (level == 0)
      continue;
    double base = level / s->fraction[kind], there = base * s->fraction[1 - kind];
    double same = motion_level(&other, there, rounding * fabs(there)); /* if both phases have a plateau there */
    struct bracket within = { -reach, reach };
    struct period q;
    q.base[kind] = level;
    q.base[1 - kind] = same != 0 ? same : there;
    if (find_root(s, 0, NAN, &within, &q, work) == SCALLOP_OK && fabs(q.c_start) < 0.75 * reach) {
      period_sum_up(s, &q);
      q.base[0] = q.base[1] = 0;
      q.c_start += base;
      q.c_mid += base;
      q.c_end += base;
      *p = q;
      return;
    }
  }
}

static void regular_result(const struct scallop_scaled *s, const struct regular *r, double L,
                           struct scallop_steady_result *result)
{
  struct scallop_period_result *p = &result->period;
  result->v_low = result->v_high = p->v_start = r->c_start * s->velocity;
  p->v_mid = r->c_mid * s->velocity;
  p->v_end = r->c_end * s->velocity;
  p->displacement = r->travel * L;
  p->multiplier = r->multiplier;
  p->balance = r->balance;
  p->regime = SCALLOP_SLIDING;
  regular_modes(r->c_start > 0, p->modes);
}

static void held_result(const struct scallop_scaled *s, const struct held *h, double L, struct scallop_steady_result *result)
{
  struct scallop_period_result *p = &result->period;
  result->v_low = result->v_high = p->v_start = p->v_end = h->c_start * s->velocity;
  p->v_mid = h->c_mid * s->velocity;
  p->displacement = h->travel * L;
  p->multiplier = p->balance = 0;
  p->regime = held_regime(h->starts, h->ends, h->stuck);
  held_modes(h->starts, h->ends, h->stuck, h->grip, p->modes);
}

/* A displacement is the sum of a part for each mode and straight piece. With more than three pieces in a phase the results of the four
 * rounding modes were up to 11 ulp of the sum of the magnitudes of the parts apart. */
static bool has_many_straight(const struct scallop_shape *shape) { return shape->count > 3 && shape->pieces[0].linear; }

/* A displacement that rounding has spoilt, or a multiplier that depends on where in the last digit of v_start the root lies. */
static void mend(const struct scallop_crawler *crawler, double travel, double size, bool delicate,
                 struct scallop_steady_result *result)
{
  struct scallop_wide_steady wider;
  const struct scallop_shape *phase = crawler->gait->phase;
  bool cancels = period_cancels(travel, size, phase[0].ramps && phase[1].ramps);
  if (has_many_straight(&phase[0]) || has_many_straight(&phase[1]))
    cancels = fabs(travel) < 0x1p-1 * size;
  double left = cancels ? fabs(travel) / size : 1, driven = period_driven(crawler->gait, crawler->alpha);
  if (size > 0 && travel != 0 && period_undoes(driven)) {
    cancels = true;
    left = fmin(left, fabs(driven));
  }
  if ((!cancels && !delicate) || !wide_enough_steady(crawler, result->period.v_start, left, &wider))
    return;
  if (cancels) {
    result->period.displacement = wider.period.displacement.high;
    result->mean_velocity = wider.mean_velocity.high;
  }
  if (delicate)
    result->period.multiplier = wider.period.multiplier.high;
}

/* As in period.c. */
static void look_at_bodies(struct held *h)
{
  const double way[] = { h->way1, h->way2 }, size[] = { h->size1, h->size2 };
  for (int body = 0; body < 2; body++)
    if (size[body] < h->size) {
      h->travel = way[body];
      h->size = size[body];
    }
}

/* order as in held.h. True: it is that simple. */
static bool solve_held(const struct scallop_scaled *s, double order, struct held *h, struct scallop_work *work)
{
  const struct scallop_shape *phase = s->gait->phase;
  const struct scaling scaling = { s->mu1, s->mu2, s->mu_difference, s->f1, s->f2, s->delta, s->eps, s->velocity };
  if (!phase[SCALLOP_EXTENSION].ramps || !phase[SCALLOP_CONTRACTION].ramps)
    return false;
  struct ramps e = ramps_of(&phase[SCALLOP_EXTENSION]), c = ramps_of(&phase[SCALLOP_CONTRACTION]);
  held_steady(&scaling, s->fraction[SCALLOP_EXTENSION], order, &e, &c, h);
  if (period_cancels(h->travel, h->size, false))
    look_at_bodies(h);
  *work = (struct scallop_work){ .periods = 1, .events = 4 - (h->stuck[0] > 0) - (h->stuck[1] > 0) };
  return h->margin > 0;
}

/* Any motion, beginning from c, or, where the extension ends at rest, from there. */
static enum scallop_status search(const struct scallop_scaled *s, enum regular_outcome hint, double c, struct period *period,
                                  struct bracket *at, struct scallop_work *work)
{
  double solved = NAN;
  *work = (struct scallop_work){ 0 };
  period->base[0] = period->base[1] = 0;
  if (hint == EXTENSION_HOLDS) {
    period->c_mid = solved = 0;
    period_phase(s, SCALLOP_CONTRACTION, period, NULL, NULL);
    c = period->c_end;
  }
  enum scallop_status status = find_root(s, c, solved, NULL, period, work);
  if (status != SCALLOP_OK)
    return status; /* GCOVR_EXCL_LINE: as above */
  period_sum_up(s, period);
  find_from_level(s, period, work);
  *at = steady_states(s, period->c_start);
  if (!(at->lo < at->hi) && is_mirrored(s))
    period->travel = period->size = 0;
  if (!(at->lo < at->hi))
    return SCALLOP_OK;
  period_solve(s, fmin(fmax(0, at->lo), at->hi), NAN, period);
  period_sum_up(s, period);
  return SCALLOP_INTERVAL;
}

static bool in_range(const struct scallop_crawler *crawler, const struct scallop_scaled *s, double c_start, double c_mid,
                     double travel)
{
  double displacement = travel * crawler->L;
  return scaling_keeps(1, 1 / s->eps) && scaling_keeps(c_start, c_start * s->velocity)
         && scaling_keeps(c_mid, c_mid * s->velocity) && scaling_keeps(travel, displacement)
         && scaling_keeps(travel, displacement / crawler->T);
}

enum scallop_status scallop_steady(const struct scallop_crawler *crawler, struct scallop_steady_result *result)
{
  struct scallop_scaled s;
  struct regular regular;
  struct held held;
  struct period period;
  struct bracket at = { 0, 0 };
  struct scallop_work work = { 0 };
  enum scallop_status status = scallop_scale(crawler, &s);
  if (status != SCALLOP_OK)
    return status;
  enum regular_outcome outcome = regular_solve(&s, &regular, &work);
  bool is_regular = outcome == REGULAR_FOUND, holds = outcome == CONTRACTION_HOLDS || outcome == EXTENSION_HOLDS;
  bool is_held = holds && solve_held(&s, outcome == CONTRACTION_HOLDS ? 1 : -1, &held, &work);
  if (!is_regular && !is_held)
    status = search(&s, outcome, regular.c_start, &period, &at, &work);
  if (status < 0)
    return status; /* GCOVR_EXCL_LINE: as above */
  double travel = is_regular ? regular.travel : is_held ? held.travel : period.travel;
  double c_start = is_regular ? regular.c_start : is_held ? held.c_start : period.c_start;
  double c_mid = is_regular ? regular.c_mid : is_held ? held.c_mid : period.c_mid;
  if (!in_range(crawler, &s, c_start, c_mid, travel))
    return SCALLOP_ERANGE;
  result->froude = 1 / s.eps;
  result->mean_velocity = travel * crawler->L / crawler->T;
  result->work = work;
  if (is_regular) {
    regular_result(&s, &regular, crawler->L, result);
    mend(crawler, NAN, NAN, regular.delicate, result);
  } else if (is_held) {
    held_result(&s, &held, crawler->L, result);
    mend(crawler, held.travel, held.size, false, result);
  } else {
    period_result(crawler, &s, &period, &result->period);
    result->v_low = at.lo * s.velocity;
    result->v_high = at.hi * s.velocity;
    bool ramps = s.gait->phase[0].ramps && s.gait->phase[1].ramps; /* there it does not depend on the velocity */
    bool delicate = period.phase[0].delicate || period.phase[1].delicate || (!ramps && result->period.multiplier < 0.0625);
    mend(crawler, period.travel, period.size, delicate && !period.forgets, result);
  }
  return status;
}

enum scallop_status scallop_friction_work(const struct scallop_crawler *crawler, double v_start, double v_mid, double *work)
{
  struct scallop_scaled s;
  struct motion motion;
  struct motion_ways ways;
  double path[2] = { 0, 0 }, v[2] = { v_start, v_mid };
  enum scallop_status status = scallop_scale(crawler, &s);
  if (status != SCALLOP_OK)
    return status;
  if (!isfinite(v_start) || !isfinite(v_mid))
    return SCALLOP_EDOMAIN;
  for (int kind = 0; kind < 2; kind++) {
    struct motion_input input = motion_input_of(&s, (enum scallop_phase_kind)kind);
    motion_solve_ways(&input, v[kind] / s.velocity * s.fraction[kind], &motion, &ways);
    path[0] += ways.path[0];
    path[1] += ways.path[1];
  }
  double energy = crawler->F1 * (path[0] * crawler->L) + crawler->F2 * (path[1] * crawler->L);
  if (!isnormal(energy))
    return SCALLOP_ERANGE;
  *work = energy;
  return SCALLOP_OK;
}
