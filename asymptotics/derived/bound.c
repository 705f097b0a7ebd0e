/* Error bounds of the steady state's series: Taylor's theorem with the remainder in Lagrange's form, the last
 * coefficient enclosed for every eps between 0 and eps0. That the motion has the branch's modes all the way is
 * proven interval by interval; the steady state is unique (docs/theory.md), so it is this one. */
#include "asymptotics/derived/derived.h"

#include <stddef.h>

#include "asymptotics/derived/holds.h"
#include "asymptotics/derived/scoped.h"

enum { LEAST_PRECISION = 32 };

void scallop_bound_init(struct scallop_bound *b)
{
  arb_init(b->C);
  arb_init(b->T0);
  arb_init(b->T_end);
  b->power = 0;
  b->ends = NULL;
}

void scallop_bound_clear(struct scallop_bound *b)
{
  arb_clear(b->C);
  arb_clear(b->T0);
  arb_clear(b->T_end);
}

static void copy_branches(struct limit *to, const struct limit *from)
{
  for (int k = 0; k < 2; k++) {
    to->branch[k].count = from->branch[k].count;
    to->branch[k].first_region = from->branch[k].first_region;
    for (int i = 0; i < from->branch[k].count; i++) {
      to->branch[k].crossing[i].piece = from->branch[k].crossing[i].piece;
      to->branch[k].crossing[i].curve = from->branch[k].crossing[i].curve;
      to->branch[k].crossing[i].to = from->branch[k].crossing[i].to;
      series_set(&to->branch[k].crossing[i].offset, &from->branch[k].crossing[i].offset);
    }
  }
  series_set(&to->w, &from->w);
}

enum { MORE = 8 }; /* further terms, by which a coefficient is carried from the middle of a ball to all of it */

struct around { /* the expansions around the middle of the ball, and around anywhere in it              */
  struct steady_lift middle, all;
};
#define AROUND(of) of(steady_lift, &s->middle) of(steady_lift, &s->all)
SCOPED_PARTS(around, struct around, AROUND)

/* The branch followed to every eps in the ball, and expanded there to so many terms */
static bool lift_at(struct steady_lift *lifted, struct limit *l, const arb_t eps, slong terms, slong precision)
{
  const struct ring ring = { terms, precision };
  SCOPED(arb, w);
  SCOPED(series, eps_series, x);
  series_set_x(&x);
  series_set_ball(&eps_series, eps);
  series_add(&eps_series, &eps_series, &x, &ring);
  series_coefficient(w, &l->w, 0, precision);
  bool found = limit_follow(l, w, eps, precision);
  if (found)
    series_set_ball(&l->w, w);
  found = found && steady_lift(lifted, l, &eps_series, &ring);
  return found;
}

/* First the middle, which is near where l is; l ends enclosing all of it. */
static bool lift_around(struct around *a, struct limit *l, const arb_t eps, slong terms, slong precision)
{
  SCOPED(arb, middle);
  arb_get_mid_arb(middle, eps);
  return lift_at(&a->middle, l, middle, terms, precision) && lift_at(&a->all, l, eps, terms, precision);
}

/* The coefficient c_n at eps + h, |h| <= r: sum over k < MORE of binomial(n + k, n) c_(n+k) h^k, from the middle, and
 * the last term with c_(n+MORE) from anywhere in the ball. */
static void carry(arb_t value, const struct series *middle, const struct series *all, slong n, const mag_t r,
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

/* A ball for all of them becomes as narrow as the expansion says. False: the two exclude each other, so one is of
 * another branch. */
static bool narrow(arb_t ball, const struct series *middle, const struct series *all, const mag_t r, slong precision)
{
  SCOPED(arb, value);
  carry(value, middle, all, 0, r, precision);
  return arb_intersection(ball, ball, value, precision);
}

static const char *const not_smooth = "the steady state is not shown to be smooth in T";

/* Crossings and start velocities, enclosed by plain ball arithmetic, are narrowed, and the modes looked at. NULL, or
 * why not. */
static const char *modes_around(const struct around *a, struct limit *l, const arb_t eps, slong precision)
{
  const mag_struct *r = arb_radref(eps);
  SCOPED(arb, u, w, w_mid);
  series_coefficient(w, &a->all.w, 0, precision);
  series_coefficient(w_mid, &a->all.w_mid, 0, precision);
  bool meet = narrow(w, &a->middle.w, &a->all.w, r, precision);
  meet = meet && narrow(w_mid, &a->middle.w_mid, &a->all.w_mid, r, precision);
  for (int k = 0; k < 2; k++)
    for (int i = 0; i < l->branch[k].count; i++) {
      struct crossing *at = &l->branch[k].crossing[i];
      bool forward = at->piece->anchor == SCALLOP_FROM_START;
      const struct lift *middle = &a->middle.phase[k], *all = &a->all.phase[k];
      series_coefficient(u, &at->offset, 0, precision);
      meet = meet
             && narrow(u, forward ? &middle->when.at[i] : &middle->left.at[i],
                       forward ? &all->when.at[i] : &all->left.at[i], r, precision);
      series_set_ball(&at->offset, u);
    }
  return meet ? limit_holds(l, w, w_mid, eps, precision) : not_smooth;
}

/* The largest eps up to which the modes are shown to be those of the branch, by steps down to 2^FINEST of it and
 * MOST_FINE attempts with finer ones, which come no nearer than their number; *ends: what happens there. */
static void find_end(arf_t end, const char **ends, const struct limit *from,
                     const struct scallop_rational_crawler *crawler, slong precision)
{
  enum { STEPS = 4000, FINEST = -11, SMALLEST = -400, FAILURES = 4, MOST_FINE = 64 };
  int failures = 0, fine = 0;
  SCOPED(around, around);
  ENDED_BY(limit_clear) struct limit here;
  limit_init(&here, crawler);
  ENDED_BY(limit_clear) struct limit trial;
  limit_init(&trial, crawler);
  SCOPED(arf, step, next);
  SCOPED(arb, eps);
  copy_branches(&here, from);
  arf_zero(end);
  arf_one(step);
  for (int i = 0; i < STEPS; i++) {
    arf_add(next, end, step, precision, ARF_RND_NEAR);
    arb_set_interval_arf(eps, end, next, precision);
    copy_branches(&trial, &here);
    const char *why = lift_around(&around, &trial, eps, MORE + 1, precision)
                          ? modes_around(&around, &trial, eps, precision)
                          : not_smooth;
    if (!why) {
      copy_branches(&here, &trial);
      arf_set(end, next);
      arf_mul_2exp_si(step, step, 1);
      failures = 0;
      continue;
    }
    failures++;
    *ends = why;
    arf_mul_2exp_si(step, step, -1);
    if (arf_cmpabs_2exp_si(step, SMALLEST) < 0)
      break; /* GCOVR_EXCL_LINE: no limit that is found is known to hold nowhere */
    arf_mul_2exp_si(next, end, FINEST);
    fine += arf_cmp(step, next) < 0;
    if (arf_cmp(step, next) < 0 && (failures >= FAILURES || fine > MOST_FINE))
      break;
  }
}

struct cover {
  struct limit here, trial; /* followed to where we are; where the next attempt goes           */
  const slong *power;
  slong precision;
  arb_t most[2]; /* the largest |coefficient of x^power[i]| so far, of w and of the displacement over L */
};

/* The absolute values of the coefficients for every eps in the ball; false if the branch could not be followed there,
 * or is not shown to be the steady state, and cover is then as before. */
static bool coefficients(struct cover *cover, arb_t value[2], const arb_t eps)
{
  slong most = cover->power[0] > cover->power[1] ? cover->power[0] : cover->power[1];
  SCOPED(around, a);
  copy_branches(&cover->trial, &cover->here);
  bool found = lift_around(&a, &cover->trial, eps, most + MORE + 1, cover->precision)
               && !modes_around(&a, &cover->trial, eps, cover->precision);
  for (int i = 0; found && i < 2; i++) {
    carry(value[i], i == 0 ? &a.middle.w : &a.middle.travel, i == 0 ? &a.all.w : &a.all.travel, cover->power[i],
          arb_radref(eps), cover->precision);
    arb_abs(value[i], value[i]);
    found = arb_is_finite(value[i]);
  }
  if (found)
    copy_branches(&cover->here, &cover->trial);
  return found;
}

/* The values at a few points: less than the largest, and of its size. */
static void take_points(struct cover *cover, arb_t value[2], const arf_t end)
{
  enum { POINTS = 16 };
  SCOPED(arb, eps);
  for (ulong i = 1; i <= POINTS; i++) {
    arf_mul_ui(arb_midref(eps), end, i, cover->precision, ARF_RND_DOWN);
    arf_mul_2exp_si(arb_midref(eps), arb_midref(eps), -4);
    if (coefficients(cover, value, eps))
      for (int k = 0; k < 2; k++)
        arb_max(cover->most[k], cover->most[k], value[k], cover->precision);
  }
}

/* value <= 2 most, or it is nothing beside a function of size 1 on [0, end]: some coefficients vanish identically */
static bool is_tight(const arb_t value, const arb_t most, const arf_t end, slong n, slong precision)
{
  SCOPED(arb, room, size);
  arb_mul_2exp_si(room, most, 1);
  arb_sub(room, room, value, precision);
  arb_set_arf(size, end);
  arb_pow_ui(size, size, (ulong)n, precision);
  arb_mul(size, size, value, precision);
  bool nothing = mag_cmp_2exp_si(arb_radref(size), -precision / 2) < 0
                 && arf_cmpabs_2exp_si(arb_midref(size), -precision / 2) < 0;
  return arb_is_nonnegative(room) || nothing;
}

/* Covers [0, end] by intervals, which are halved while they are wide or their balls are: more than twice the value at
 * points. */
static bool take_intervals(struct cover *cover, arb_t value[2], const arf_t end)
{
  enum { MOST = 6000, NARROW = -11 };
  bool found = true;
  SCOPED(arf, lo, hi, step, narrow);
  SCOPED(arb, eps);
  arf_mul_2exp_si(step, end, -4);
  arf_mul_2exp_si(narrow, end, NARROW);
  for (int i = 0; found && arf_cmp(lo, end) < 0; i++) {
    arf_add(hi, lo, step, cover->precision, ARF_RND_UP);
    if (arf_cmp(hi, end) > 0)
      arf_set(hi, end);
    arb_set_interval_arf(eps, lo, hi, cover->precision);
    bool followed = coefficients(cover, value, eps), tight = followed;
    for (int k = 0; k < 2; k++)
      tight = tight && is_tight(value[k], cover->most[k], end, cover->power[k], cover->precision);
    found = i < MOST;
    if (tight || (followed && arf_cmp(step, narrow) < 0)) {
      for (int k = 0; k < 2; k++)
        arb_max(cover->most[k], cover->most[k], value[k], cover->precision);
      arf_set(lo, hi);
      arf_mul_2exp_si(step, step, 1);
    } else
      arf_mul_2exp_si(step, step, -1);
  }
  return found;
}

/* The largest |coefficient of x^power[i]| of w and of the displacement over L, for all eps in [0, end]: an upper
 * bound. */
static bool largest_coefficients(arb_t most[2], const slong power[2], const arf_t end, const struct limit *from,
                                 const struct scallop_rational_crawler *crawler, slong precision)
{
  struct cover cover = { .power = power, .precision = precision };
  arb_t value[2];
  limit_init(&cover.here, crawler);
  limit_init(&cover.trial, crawler);
  for (int k = 0; k < 2; k++) {
    arb_init(value[k]);
    arb_init(cover.most[k]);
  }
  copy_branches(&cover.here, from);
  take_points(&cover, value, end);
  copy_branches(&cover.here, from);
  bool found = take_intervals(&cover, value, end);
  for (int k = 0; k < 2; k++) {
    arb_get_ubound_arf(arb_midref(most[k]), cover.most[k], precision);
    mag_zero(arb_radref(most[k]));
    arb_clear(value[k]);
    arb_clear(cover.most[k]);
  }
  limit_clear(&cover.here);
  limit_clear(&cover.trial);
  return found;
}

/* (F1 + F2)/(M L): eps / T^2 */
static void eps_over_T2(arb_t kappa, const struct scallop_rational_crawler *c, slong precision)
{
  SCOPED(fmpq, q, M);
  fmpq_add(M, c->m1, c->m2);
  fmpq_add(q, c->F1, c->F2);
  fmpq_div(q, q, M);
  fmpq_div(q, q, c->L);
  arb_set_fmpq(kappa, q, precision);
}

static void time_of(arb_t T, const arf_t eps, const arb_t kappa, slong precision)
{
  arb_set_arf(T, eps);
  arb_div(T, T, kappa, precision);
  arb_sqrt(T, T, precision);
}

static enum scallop_status bounds_from(const struct limit *l, const struct scallop_rational_crawler *crawler,
                                       slong order, slong precision, struct scallop_bound bounds[2], const char **why)
{
  slong of_displacement = (order + 1) / 2;
  if (l->even)
    of_displacement += of_displacement % 2;
  const slong power[2] = { order / 2 + 1, of_displacement };
  const char *ends = not_smooth;
  arb_t kappa, most[2];
  SCOPED(arf, end, eps0);
  arb_init(kappa);
  arb_init(most[0]);
  arb_init(most[1]);
  eps_over_T2(kappa, crawler, precision);
  find_end(end, &ends, l, crawler, precision);
  arf_mul_ui(eps0, end, 13, precision, ARF_RND_DOWN); /* T0 is 0.9 of T_end */
  arf_mul_2exp_si(eps0, eps0, -4);
  bool found = !arf_is_zero(end) && largest_coefficients(most, power, eps0, l, crawler, precision);
  for (int i = 0; found && i < 2; i++) {
    struct scallop_bound *b = &bounds[i];
    b->power = (int)(2 * power[i] - (i == 0));
    b->ends = ends;
    arb_pow_ui(b->C, kappa, (ulong)power[i], precision);
    arb_mul(b->C, b->C, most[i], precision);
    ball_times(b->C, b->C, crawler->L, precision);
    time_of(b->T0, eps0, kappa, precision);
    time_of(b->T_end, end, kappa, precision);
  }
  /* GCOVR_EXCL_START: as above, no limit is known to */
  if (!found && why)
    *why = "the modes of the limit are not shown to hold for any T > 0: it is too close to a boundary";
  /* GCOVR_EXCL_STOP */
  arb_clear(kappa);
  arb_clear(most[0]);
  arb_clear(most[1]);
  return found ? SCALLOP_OK : SCALLOP_EUNDECIDED;
}

/* NULL, or which of the arguments is outside its domain. */
static const char *outside(const struct scallop_rational_crawler *crawler, slong order, slong precision)
{
  return !scallop_rational_is_valid(crawler)       ? "a parameter is outside its domain"
         : order < 1 || order > SCALLOP_MOST_TERMS ? "the order is outside of 1 to 1000"
         : precision < LEAST_PRECISION             ? "fewer than 32 bits"
                                                   : NULL;
}

enum scallop_status scallop_steady_modes_hold(const struct scallop_rational_crawler *crawler, slong precision, arb_t T,
                                              const char **ends, const char **why)
{
  const char *reason = outside(crawler, 1, precision);
  if (reason) {
    if (why)
      *why = reason;
    return SCALLOP_EDOMAIN;
  }
  ENDED_BY(limit_clear) struct limit l;
  limit_init(&l, crawler);
  enum scallop_status status = limit_find(&l, crawler, precision, &reason);
  if (status == SCALLOP_OK) {
    SCOPED(arf, end);
    SCOPED(arb, kappa);
    *ends = not_smooth;
    eps_over_T2(kappa, crawler, precision);
    find_end(end, ends, &l, crawler, precision);
    time_of(T, end, kappa, precision);
  } else if (why)
    *why = reason;
  return status;
}

enum scallop_status scallop_steady_bounds(const struct scallop_rational_crawler *crawler, slong order, slong precision,
                                          struct scallop_bound bounds[2], const char **why)
{
  const char *reason = outside(crawler, order, precision);
  if (reason) {
    if (why)
      *why = reason;
    return SCALLOP_EDOMAIN;
  }
  ENDED_BY(limit_clear) struct limit l;
  limit_init(&l, crawler);
  enum scallop_status status = limit_find(&l, crawler, precision, &reason);
  if (status == SCALLOP_OK && series_coefficient_is_zero(&l.w, 0)) {
    reason = "the start velocity is 0 in the limit (F1 = F2, or alpha = 1/2): this bound is for those where it is not";
    status = SCALLOP_EDOMAIN;
  }
  if (status == SCALLOP_OK)
    status = bounds_from(&l, crawler, order, precision, bounds, &reason);
  if (status != SCALLOP_OK && why)
    *why = reason;
  return status;
}
