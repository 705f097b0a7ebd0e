#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

#include "numerics/event/held.h"
#include "numerics/event/period.h"
#include "numerics/event/regular.h"
#include "numerics/event/solve.h"

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

/* No contraction, and a balance of nothing but rounding, that of the decimals included: c lies in an interval of steady
 * states. Only where l' jumps over 0 can c pass a period without being sheared by a curve (docs/theory.md). */
static bool flat(const struct scallop_scaled *s, double c)
{
  struct period p;
  period_begin(&p);
  period_solve(s, c, &p);
  bool gives = p.phase[0].extra_impulse != 0 || p.phase[1].extra_impulse != 0;
  return !p.forgets && p.balance_slope == 0 && fabs(p.balance) <= p.noise + (gives ? DBL_EPSILON : 0);
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

/* A distance over which a flat stretch is looked for beside a root: some thousand ulp */
static double beside(const struct bracket *all) { return ldexp(all->hi - all->lo, -40); }

/* The steady states around the root c: c itself, or the interval that it belongs to, perhaps as its end. */
static struct bracket steady_states(const struct scallop_scaled *s, double c)
{
  if (!has_jump(s))
    return (struct bracket){ c, c };
  struct bracket all = surely(s);
  double step = beside(&all);
  const double near[] = { c, c - step, c + step };
  for (int i = 0; i < 3; i++)
    if (flat(s, near[i]))
      return (struct bracket){ flat_end(s, near[i], all.lo), flat_end(s, near[i], all.hi) };
  return (struct bracket){ c, c };
}

/* Whether a body is held at c for less than rounding of c, and the balance, level on a side of c, drives c away there.
 * If so, sets *c to a velocity on that side. Without a jump of l' no balance is level. */
static bool is_driven_away(const struct scallop_scaled *s, double *c)
{
  if (!has_jump(s))
    return false;
  struct bracket all = surely(s);
  struct period p;
  for (int side = -1; side <= 1; side += 2) {
    period_begin(&p);
    period_solve(s, *c + side * beside(&all), &p);
    if (!p.forgets && p.balance_slope == 0 && side * p.balance > p.noise) {
      *c = p.c_start;
      return true;
    }
  }
  return false;
}

/* The contraction maps velocities as the extension maps their opposites. Then the mirror image of a steady state, half
 * a period late, is steady too. As there is only one steady state, both are the same, and the displacement is 0. */
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

static bool is_level(const struct scallop_shape *shape)
{
  for (int i = 0; i < shape->count; i++)
    if (!shape->pieces[i].linear || shape->pieces[i].acceleration != 0)
      return false;
  return true;
}

/* l' jumps between two levels, and each jump throws the same body, first one way and then the other. Friction brings it
 * to rest each time, in opposite modes, so that the displacement is 0. */
static bool is_thrown_back(const struct scallop_scaled *s, const struct period *p)
{
  struct scallop_modes modes[2];
  for (int kind = 0; kind < 2; kind++) {
    motion_modes(&p->phase[kind], (enum scallop_phase_kind)kind, &modes[kind]);
    if (!is_level(&s->gait->phase[kind]) || modes[kind].count != 2)
      return false;
  }
  const struct scallop_mode *e = modes[SCALLOP_EXTENSION].kept, *c = modes[SCALLOP_CONTRACTION].kept;
  bool opposite = e[0].s1 * c[0].s1 < 0 && e[0].s2 * c[0].s2 < 0;
  return opposite && ((e[1].s1 == 0 && c[1].s1 == 0) || (e[1].s2 == 0 && c[1].s2 == 0));
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

/* The velocity to go to from c: Newton's step on the balance, or, once a body has been stuck and the map has forgotten
 * where it began, the map's value. */
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
    period_solve(s, p->c_end, p);
    return;
  }
  p->c_mid += e->stretch * (p->c_end - p->c_start);
  p->c_start = p->c_end;
}

/* Newton's method in a bracket, which is halved whenever two steps did not halve the balance. within: the bracket;
 * NULL: surely(), which is computed only when Newton's method is slow or leaves what is known of the bracket. */
static enum scallop_status find_root(const struct scallop_scaled *s, double guess, const struct bracket *within,
                                     struct period *p, struct scallop_work *work)
{
  double c = isfinite(guess) ? guess + 0.0 : 0; /* no -0 */
  struct bracket b = within ? *within : (struct bracket){ -INFINITY, INFINITY };
  double last = INFINITY, before = INFINITY;
  for (int i = 0; i < STEPS; i++) {
    period_solve(s, c, p);
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

static bool has_ramps(const struct scallop_gait *gait) { return gait->phase[0].ramps && gait->phase[1].ramps; }

/* If the root is near the level of a curve over a plateau of l', finds it once more with velocities counted from that
 * level: friction may change c by less than an ulp of c, but this change decides where on the plateau c meets the
 * curve, and so the modes and the multiplier. False: the search from there finds no root, or one from which c goes far
 * from the level. */
static bool find_from_level(const struct scallop_scaled *s, struct period *p, struct scallop_work *work)
{
  const double c = p->c_start, rounding = 4 * DBL_EPSILON;
  const double reach = fmin(2 * s->eps, 0x1p-19 * fabs(c)); /* friction changes c by eps at most */
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
    period_begin(&q);
    q.base[kind] = level;
    q.base[1 - kind] = same != 0 ? same : there;
    if (find_root(s, 0, &within, &q, work) == SCALLOP_OK && fabs(q.c_start) < 0.75 * reach
        && fabs(q.c_mid) < 2 * reach) {
      period_sum_up(s, &q);
      q.base[0] = q.base[1] = 0;
      q.c_start += base;
      q.c_mid += base;
      q.c_end += base;
      *p = q;
      return true;
    }
  }
  return false;
}

/* Whether a phase begins on such a level, as far as c tells */
static bool begins_on_level(const struct scallop_scaled *s, const struct period *p)
{
  bool on_level = false;
  for (int kind = 0; kind < 2; kind++) {
    const struct motion_input in = motion_input_of(s, (enum scallop_phase_kind)kind);
    double c = (kind == SCALLOP_EXTENSION ? p->c_start : p->c_mid) * s->fraction[kind];
    on_level |= motion_level(&in, c, 0x1p-48 * fabs(c)) != 0;
  }
  return on_level;
}

/* A steady state as each of the solvers below tells it */
struct steady {
  struct scallop_period_result
      period;         /* velocities in L/T, the displacement in L; v_start: that of the state               */
  struct bracket all; /* steady start velocities                                                         */
  double size;        /* of the parts that the displacement is the sum of; 0: nothing cancels            */
  struct doubt doubt; /* left: of the velocities                                                       */
  struct scallop_work work;
};

static void set_regular(struct steady *at, const struct regular *r)
{
  struct scallop_period_result *p = &at->period;
  p->v_start = at->all.lo = at->all.hi = r->c_start;
  p->v_mid = r->c_mid;
  p->v_end = r->c_end;
  p->displacement = r->travel;
  p->multiplier = r->multiplier;
  p->balance = r->balance;
  p->regime = SCALLOP_SLIDING;
  regular_modes(r->c_start > 0, p->modes);
  at->size = 0;
  at->doubt.delicate = r->delicate;
}

static void set_held(struct steady *at, const struct held *h)
{
  struct scallop_period_result *p = &at->period;
  p->v_start = p->v_end = at->all.lo = at->all.hi = h->c_start;
  p->v_mid = h->c_mid;
  p->displacement = h->travel;
  p->multiplier = p->balance = 0;
  p->regime = held_regime(h->starts, h->ends, h->stuck);
  held_modes(h->starts, h->ends, h->stuck, h->grip, p->modes);
  at->size = h->size;
}

/* Where |l'| rises with the n-th power of the time, c meets it at a time that goes with the n-th root of c. Rounding of
 * the times, of which the balance is the sum, is magnified n-fold in c then: with n = 14 the results of the four
 * rounding modes were up to 91 units apart. It matters where an ulp of F1, F2 or alpha does less to the balance. */
static bool is_amplified(const struct scallop_scaled *s, const struct period *p)
{
  const double most = 6; /* as for n = 3, where half of the sum balances the other half */
  double alpha = s->fraction[SCALLOP_EXTENSION], driven = fabs(period_driven(s->gait, alpha));
  double unit = fabs(p->balance_slope * p->c_start) + 4 * s->f1 * s->f2 * driven + alpha * fabs(s->delta);
  bool linear = s->gait->phase[0].concave && s->gait->phase[1].concave;
  return !linear && !p->forgets && p->noise > most * DBL_EPSILON * unit;
}

/* on_level: a phase begins on the level of a plateau, as far as c tells. */
static void look_for_doubt(const struct scallop_scaled *s, const struct period *p, bool on_level, struct steady *at)
{
  const struct motion *e = &p->phase[SCALLOP_EXTENSION], *c = &p->phase[SCALLOP_CONTRACTION];
  const int many = 8; /* a crossing adds an ulp or two to the error of the multiplier */
  bool crosses_often = e->work.events + c->work.events > many;
  struct doubt *doubt = &at->doubt;
  doubt->delicate = !p->forgets
                    && (on_level || e->delicate || c->delicate || crosses_often || at->period.multiplier < 0.0625);
  if (at->all.lo == at->all.hi)
    doubt->left = motion_left(&s->gait->phase[0], e) * motion_left(&s->gait->phase[1], c)
                  * (is_amplified(s, p) ? 0x1p-3 : 1);
  doubt->amplified = doubt->left < 1;
}

/* A displacement is the sum of a part for each mode and piece. With more than three straight pieces in a phase the
 * results of the four rounding modes were up to 11 ulp of the sum of the magnitudes of the parts apart. */
static bool has_many(const struct scallop_shape *shape) { return shape->count > (shape->pieces[0].linear ? 3 : 4); }

/* As in struct doubt */
static double left_of(const struct scallop_gait *gait, double alpha, double travel, double size)
{
  const struct scallop_shape *phase = gait->phase;
  bool cancels = period_cancels(travel, size, has_ramps(gait));
  if (has_many(&phase[0]) || has_many(&phase[1]))
    cancels = fabs(travel) < 0x1p-1 * size;
  double left = cancels ? fabs(travel) / size : 1, driven = period_driven(gait, alpha);
  return travel != 0 && period_undoes(driven) ? fmin(left, fabs(driven)) : left;
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
static bool solve_held(const struct scallop_scaled *s, double order, struct steady *at)
{
  struct held h;
  const struct scallop_shape *phase = s->gait->phase;
  const struct scaling scaling = scaling_again(s);
  if (!has_ramps(s->gait))
    return false;
  struct ramps e = ramps_of(&phase[SCALLOP_EXTENSION]), c = ramps_of(&phase[SCALLOP_CONTRACTION]);
  held_steady(&scaling, s->fraction[SCALLOP_EXTENSION], order, &e, &c, &h);
  if (!(h.margin > 0))
    return false;
  if (period_cancels(h.travel, h.size, false))
    look_at_bodies(&h);
  set_held(at, &h);
  at->work = (struct scallop_work){ .periods = 1, .events = 4 - (h.stuck[0] > 0) - (h.stuck[1] > 0) };
  return true;
}

/* Any motion, beginning from c, or, where the extension ends at rest, from there. */
static enum scallop_status search(const struct scallop_scaled *s, enum regular_outcome hint, double c,
                                  struct steady *at)
{
  struct period period;
  at->work = (struct scallop_work){ 0 };
  period_begin(&period);
  if (hint == EXTENSION_HOLDS) {
    period.c_mid = 0;
    period_phase(s, SCALLOP_CONTRACTION, &period, NULL, NULL);
    c = period.c_end;
  }
  enum scallop_status status = find_root(s, c, NULL, &period, &at->work);
  c = period.c_start;
  if (period.forgets && is_driven_away(s, &c))
    status = find_root(s, c, NULL, &period, &at->work);
  if (status != SCALLOP_OK)
    return status; /* GCOVR_EXCL_LINE: halving ends before that */
  period_sum_up(s, &period);
  bool ramps = has_ramps(s->gait);
  bool on_level = !ramps && !find_from_level(s, &period, &at->work) && begins_on_level(s, &period);
  at->all = steady_states(s, period.c_start);
  if (at->all.lo < at->all.hi) {
    period_begin(&period);
    period_solve(s, fmin(fmax(0, at->all.lo), at->all.hi), &period);
    period_sum_up(s, &period);
    status = SCALLOP_INTERVAL;
  } else if (is_mirrored(s) || is_thrown_back(s, &period))
    period.travel = period.size = 0;
  period_result(s, &period, &at->period);
  at->size = period.size;
  if (!ramps) /* of ramps the multiplier does not depend on the velocity, and a phase has few straight lines */
    look_for_doubt(s, &period, on_level, at);
  return status;
}

static enum scallop_status find(const struct scallop_scaled *s, struct steady *at)
{
  struct regular regular;
  at->work = (struct scallop_work){ 0 };
  at->doubt = (struct doubt){ .left = 1 };
  enum regular_outcome outcome = regular_solve(s, &regular, &at->work);
  if (outcome == REGULAR_FOUND) {
    set_regular(at, &regular);
    return SCALLOP_OK;
  }
  if (outcome != REGULAR_NOT && solve_held(s, outcome == CONTRACTION_HOLDS ? 1 : -1, at))
    return SCALLOP_OK;
  return search(s, outcome, regular.c_start, at);
}

enum scallop_status solve_steady(const struct scallop_crawler *crawler, struct scallop_steady_result *result,
                                 struct doubt *doubt)
{
  struct scallop_scaled s;
  struct steady at;
  enum scallop_status status = scallop_scale(crawler, &s);
  if (status != SCALLOP_OK)
    return status;
  status = find(&s, &at);
  if (status < 0)
    return status; /* GCOVR_EXCL_LINE: as above */
  struct scallop_period_result *p = &at.period;
  double froude = 1 / s.eps, v_start = p->v_start * s.velocity, v_mid = p->v_mid * s.velocity, travel = p->displacement;
  double displacement = scaling_back(travel, crawler->L), mean_velocity = displacement / crawler->T;
  if (!scaling_keeps(1, froude) || !scaling_keeps(p->v_start, v_start) || !scaling_keeps(p->v_mid, v_mid)
      || !scaling_keeps(travel, displacement) || !scaling_keeps(travel, mean_velocity))
    return SCALLOP_ERANGE;
  *doubt = at.doubt;
  if (at.size > 0)
    doubt->left *= left_of(s.gait, crawler->alpha, travel, at.size);
  p->v_start = v_start;
  p->v_mid = v_mid;
  p->v_end *= s.velocity;
  p->displacement = displacement;
  result->froude = froude;
  result->mean_velocity = mean_velocity;
  result->period = *p;
  result->v_low = at.all.lo * s.velocity;
  result->v_high = at.all.hi * s.velocity;
  result->work = at.work;
  return status;
}

enum scallop_status scallop_friction_work(const struct scallop_crawler *crawler, double v_start, double v_mid,
                                          double *work)
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
