/* Error bounds of the steady state's series: Taylor's theorem with Lagrange's remainder, the last coefficient enclosed
 * for every eps between 0 and eps0. The modes of the motion are proven interval by interval; the steady state is unique
 * (docs/background/theory.md), therefore the motion is the steady state. */
#include "asymptotics/derived/derived.h"

#include "asymptotics/derived/scoped.h"

enum { MORE = 8 }; /* further terms, to extend a coefficient from the middle of a ball to all of it */

struct expansions { /* expansions around the middle of the ball, and around every point of it */
  struct steady_lift middle, all;
};
#define EXPANSIONS(of) of(steady_lift, &s->middle) of(steady_lift, &s->all)
SCOPED_PARTS(expansions, struct expansions, EXPANSIONS)

/* Follows the branch to every eps in the ball, and expands it there to this many terms. */
static bool lift_at(struct steady_lift *lifted, struct limit *l, const arb_t eps, slong terms, slong precision)
{
  const struct ring ring = { terms, precision };
  SCOPED(arb, w);
  SCOPED(series, eps_series, x);
  series_set_x(&x);
  series_set_ball(&eps_series, eps);
  series_add(&eps_series, &eps_series, &x, &ring);
  series_coefficient(w, &l->w, 0, precision);
  if (!limit_follow(l, w, eps, precision))
    return false;
  series_set_ball(&l->w, w);
  return steady_lift(lifted, l, NULL, &eps_series, &ring);
}

/* Computes the coefficient c_n at eps + h, |h| <= r: sum over k < MORE of binomial(n + k, n) c_(n+k) h^k, from the
 * middle, and the last term with c_(n+MORE) from all of the ball. */
static void extend(arb_t value, const struct series *middle, const struct series *all, slong n, const mag_t r,
                   slong precision)
{
  SCOPED(fmpz, ways);
  SCOPED(arb, h, power, term);
  mag_set(arb_radref(h), r);
  arb_one(power);
  arb_zero(value);
  for (slong k = 0; k <= MORE; k++) {
    series_coefficient(term, k < MORE ? middle : all, n + k, precision);
    fmpz_bin_uiui(ways, (ulong)(n + k), (ulong)n);
    arb_mul_fmpz(term, term, ways, precision);
    arb_addmul(value, term, power, precision);
    arb_mul(power, power, h, precision);
  }
}

/* Intersects a ball for all eps with the expansion. Returns false if they are disjoint: of different branches. */
static bool narrow(arb_t ball, const struct series *middle, const struct series *all, const mag_t r, slong precision)
{
  SCOPED(arb, value);
  extend(value, middle, all, 0, r, precision);
  return arb_intersection(ball, ball, value, precision);
}

static const char *const not_smooth = "the steady state is not proven to be smooth in T";

/* Narrows crossings and start velocities, enclosed by plain ball arithmetic, and checks the modes. Returns NULL, or the
 * reason of a failure. */
static const char *modes_around(const struct expansions *a, struct limit *l, const arb_t eps, slong precision)
{
  const mag_struct *r = arb_radref(eps);
  SCOPED(arb, u, w, w_mid);
  series_coefficient(w, &a->all.w, 0, precision);
  series_coefficient(w_mid, &a->all.w_mid, 0, precision);
  if (!narrow(w, &a->middle.w, &a->all.w, r, precision)
      || !narrow(w_mid, &a->middle.w_mid, &a->all.w_mid, r, precision))
    return not_smooth; /* GCOVR_EXCL_LINE: balls too wide */
  for (int k = 0; k < 2; k++)
    for (int i = 0; i < l->branch[k].count; i++) {
      struct crossing *at = &l->branch[k].crossing[i];
      const struct lift *middle = &a->middle.phase[k], *all = &a->all.phase[k];
      const bool forward = at->piece->anchor == SCALLOP_FROM_START;
      const struct of_crossings *of_middle = forward ? &middle->when : &middle->left,
                                *of_all = forward ? &all->when : &all->left;
      series_coefficient(u, &at->offset, 0, precision);
      if (!narrow(u, &of_middle->at[i], &of_all->at[i], r, precision))
        return not_smooth; /* GCOVR_EXCL_LINE: balls too wide */
      series_set_ball(&at->offset, u);
    }
  return limit_holds(l, w, w_mid, eps, precision);
}

/* Moves `here` to every eps in the ball, by its middle. Returns NULL; or the reason why the motion is not proven to be
 * the steady state, with `here` unchanged. */
static const char *move_to(struct expansions *a, struct limit *here, const arb_t eps, slong terms, slong precision)
{
  SCOPED(arb, middle);
  SCOPED(limit, trial);
  limit_set(&trial, here);
  arb_get_mid_arb(middle, eps);
  if (!lift_at(&a->middle, &trial, middle, terms, precision) || !lift_at(&a->all, &trial, eps, terms, precision))
    return not_smooth;
  const char *why = modes_around(a, &trial, eps, precision);
  if (!why)
    limit_set(here, &trial);
  return why;
}

/* Computes the largest eps up to which the modes of the branch are proven, by steps down to 2^FINEST of it and at most
 * MOST_FINE attempts with finer ones; *ends: the event there. */
static void find_end(arf_t end, const char **ends, const struct limit *from, slong precision)
{
  enum { STEPS = 4000, FINEST = -11, SMALLEST = -400, FAILURES = 4, MOST_FINE = 64 };
  int failures = 0, fine = 0;
  SCOPED(expansions, around);
  SCOPED(limit, here);
  SCOPED(arf, step, next);
  SCOPED(arb, eps);
  limit_set(&here, from);
  *ends = not_smooth;
  arf_zero(end);
  arf_one(step);
  for (int i = 0; i < STEPS && arf_cmpabs_2exp_si(step, SMALLEST) > 0; i++) {
    arf_add(next, end, step, precision, ARF_RND_NEAR);
    arb_set_interval_arf(eps, end, next, precision);
    const char *why = move_to(&around, &here, eps, MORE + 1, precision);
    if (!why) {
      arf_set(end, next);
      arf_mul_2exp_si(step, step, 1);
      failures = 0;
      continue;
    }
    failures++;
    *ends = why;
    arf_mul_2exp_si(step, step, -1);
    arf_mul_2exp_si(next, end, FINEST);
    fine += arf_cmp(step, next) < 0;
    if (arf_cmp(step, next) < 0 && (failures >= FAILURES || fine > MOST_FINE))
      break;
  }
}

/* The coefficients of x^power[i], of w and of the displacement over L, maximal over all eps so far */
struct maxima {
  struct limit here; /* followed to the current eps */
  slong power[2], precision;
  arb_t value[2], most[2]; /* absolute values at the current eps, and the largest so far */
};
#define MAXIMA(of) of(limit, &s->here) of(arb, s->value[0]) of(arb, s->value[1]) of(arb, s->most[0]) of(arb, s->most[1])
SCOPED_PARTS(maxima, struct maxima, MAXIMA)

/* Computes the values for every eps in the ball. Returns false if the motion is not proven to be the steady state. */
static bool evaluate_at(struct maxima *l, const arb_t eps)
{
  const slong terms = FLINT_MAX(l->power[0], l->power[1]) + MORE + 1;
  SCOPED(expansions, a);
  if (move_to(&a, &l->here, eps, terms, l->precision))
    return false;
  extend(l->value[0], &a.middle.w, &a.all.w, l->power[0], arb_radref(eps), l->precision);
  extend(l->value[1], &a.middle.travel, &a.all.travel, l->power[1], arb_radref(eps), l->precision);
  for (int i = 0; i < 2; i++)
    arb_abs(l->value[i], l->value[i]);
  return arb_is_finite(l->value[0]) && arb_is_finite(l->value[1]);
}

static void count(struct maxima *l)
{
  for (int i = 0; i < 2; i++)
    arb_max(l->most[i], l->most[i], l->value[i], l->precision);
}

/* Computes the values at a few points: lower bounds of the largest, of the same size. */
static void evaluate_at_points(struct maxima *l, const arf_t end)
{
  enum { POINTS = 16 };
  SCOPED(arb, eps);
  for (ulong i = 1; i <= POINTS; i++) {
    arf_mul_ui(arb_midref(eps), end, i, l->precision, ARF_RND_DOWN);
    arf_mul_2exp_si(arb_midref(eps), arb_midref(eps), -4);
    if (evaluate_at(l, eps))
      count(l);
  }
}

/* Returns true if value <= 2 most, or if value is negligible beside a function of size 1 on [0, end]: some coefficients
 * vanish identically. */
static bool is_tight(const struct maxima *l, int i, const arf_t end)
{
  SCOPED(arb, margin, size);
  arb_mul_2exp_si(margin, l->most[i], 1);
  arb_sub(margin, margin, l->value[i], l->precision);
  arb_set_arf(size, end);
  arb_pow_ui(size, size, (ulong)l->power[i], l->precision);
  arb_mul(size, size, l->value[i], l->precision);
  bool nothing = mag_cmp_2exp_si(arb_radref(size), -l->precision / 2) < 0
                 && arf_cmpabs_2exp_si(arb_midref(size), -l->precision / 2) < 0;
  return arb_is_nonnegative(margin) || nothing;
}

/* Covers [0, end] by intervals; an interval is halved if it is wide or its ball exceeds twice the value at points. */
static bool evaluate_on_intervals(struct maxima *l, const arf_t end)
{
  enum { MOST = 6000, NARROW = -11 };
  SCOPED(arf, lo, hi, step, narrow);
  SCOPED(arb, eps);
  arf_mul_2exp_si(step, end, -4);
  arf_mul_2exp_si(narrow, end, NARROW);
  for (int i = 0; i <= MOST; i++) {
    if (arf_cmp(lo, end) >= 0)
      return true;
    arf_add(hi, lo, step, l->precision, ARF_RND_UP);
    arf_min(hi, hi, end);
    arb_set_interval_arf(eps, lo, hi, l->precision);
    bool followed = evaluate_at(l, eps), tight = followed && is_tight(l, 0, end) && is_tight(l, 1, end);
    if (tight || (followed && arf_cmp(step, narrow) < 0)) {
      count(l);
      arf_set(lo, hi);
      arf_mul_2exp_si(step, step, 1);
    } else
      arf_mul_2exp_si(step, step, -1);
  }
  return false; /* GCOVR_EXCL_LINE: balls too wide */
}

static void time_of(arb_t T, const arf_t eps, const arb_t kappa, slong precision)
{
  arb_set_arf(T, eps);
  arb_div(T, T, kappa, precision);
  arb_sqrt(T, T, precision);
}

/* Computes eps/T^2, and the eps up to which the modes of the limit are proven. */
static void follow_to_end(arb_t kappa, arf_t end, const char **ends, const struct limit *l,
                          const struct scallop_rational_crawler *crawler, slong precision)
{
  SCOPED(fmpq, exact);
  set_kappa(exact, crawler);
  arb_set_fmpq(kappa, exact, precision);
  find_end(end, ends, l, precision);
}

enum scallop_status scallop_steady_modes_hold(const struct scallop_rational_crawler *crawler, slong precision, arb_t T,
                                              const char **ends, const char **why)
{
  SCOPED(limit, l);
  SCOPED(arf, end);
  SCOPED(arb, kappa);
  enum scallop_status status = limit_find(&l, crawler, precision, why);
  if (status == SCALLOP_OK) {
    follow_to_end(kappa, end, ends, &l, crawler, precision);
    time_of(T, end, kappa, precision);
  }
  return status;
}

/* Sets the bound of the series in T from |coefficient of x^power| of all eps up to eps0. */
static void set_bound(struct scallop_bound *b, const struct maxima *l, int i, const arb_t kappa,
                      const struct scallop_rational_crawler *crawler, const arf_t eps0, const arf_t end)
{
  SCOPED(arb, most);
  arb_get_ubound_arf(arb_midref(most), l->most[i], l->precision);
  b->power = (int)(2 * l->power[i] - (i == 0));
  arb_pow_ui(b->C, kappa, (ulong)l->power[i], l->precision);
  arb_mul(b->C, b->C, most, l->precision);
  ball_times(b->C, b->C, crawler->L, l->precision);
  time_of(b->T0, eps0, kappa, l->precision);
  time_of(b->T_end, end, kappa, l->precision);
}

/* Finds the largest coefficients over all eps up to eps0, of the first nonzero powers at or above T^order. */
static bool find_largest(struct maxima *largest, const struct limit *l, slong order, const arf_t eps0, slong precision)
{
  largest->precision = precision;
  largest->power[0] = order / 2 + 1;
  largest->power[1] = (order + 1) / 2;
  if (l->even)
    largest->power[1] += largest->power[1] % 2;
  limit_set(&largest->here, l);
  evaluate_at_points(largest, eps0);
  limit_set(&largest->here, l);
  return evaluate_on_intervals(largest, eps0);
}

enum scallop_status scallop_steady_bounds(const struct scallop_rational_crawler *crawler, slong order, slong precision,
                                          struct scallop_bound bounds[2], const char **why)
{
  const char *ends, *none = not_expandable(crawler, order, precision);
  if (none)
    return refused_for(SCALLOP_EDOMAIN, none, why);
  SCOPED(limit, l);
  SCOPED(maxima, largest);
  SCOPED(arf, end, eps0);
  SCOPED(arb, kappa);
  enum scallop_status status = limit_find(&l, crawler, precision, why);
  if (status != SCALLOP_OK)
    return status;
  if (series_coefficient_is_zero(&l.w, 0))
    return refused_for(SCALLOP_EDOMAIN,
                       "the start velocity is 0 in the limit (F1 = F2, or alpha = 1/2): the bound requires another one",
                       why);
  follow_to_end(kappa, end, &ends, &l, crawler, precision);
  arf_mul_ui(eps0, end, 13, precision, ARF_RND_DOWN); /* T0 is 0.9 of T_end */
  arf_mul_2exp_si(eps0, eps0, -4);
  if (arf_is_zero(end)
      || !find_largest(&largest, &l, order, eps0, precision)) /* GCOVR_EXCL_START: no limit is known to fail */
    return refused_for(SCALLOP_EUNDECIDED,
                       "the modes of the limit are not shown to hold for any T > 0: it is too close to a boundary",
                       why);
  /* GCOVR_EXCL_STOP */
  for (int i = 0; i < 2; i++) {
    set_bound(&bounds[i], &largest, i, kappa, crawler, eps0, end);
    bounds[i].ends = ends;
  }
  return SCALLOP_OK;
}
