/* The limit T -> 0 as a root in w, and Newton's method in truncated series around it. */
#include "asymptotics/derived/limit.h"

#include "asymptotics/derived/holds.h"
#include "asymptotics/derived/scoped.h"

#include <stddef.h>

void limit_init(struct limit *l, const struct scallop_rational_crawler *crawler)
{
  for (int k = 0; k < 2; k++) {
    phase_constants_init(&l->phase[k], crawler, (enum scallop_phase_kind)k);
    branch_init(&l->branch[k]);
  }
  series_init(&l->w);
  l->at_rest = fmpq_is_zero(l->phase[0].beta[1]);
  bool halves = fmpq_equal(l->phase[0].fraction,
                           l->phase[1].fraction); /* then w is of the order of eps, and the branches for -eps others */
  l->even = !halves && scallop_gait_is_reversible(crawler->gait);
  l->returns = l->at_rest || (halves && scallop_gait_mirrors(crawler->gait));
}

void limit_clear(struct limit *l)
{
  for (int k = 0; k < 2; k++) {
    phase_constants_clear(&l->phase[k]);
    branch_clear(&l->branch[k]);
  }
  series_clear(&l->w);
}

/* The balance and its derivative by w, with the branches as they are. same: as for base_follow */
static bool follow(struct limit *l, arb_t balance, arb_t slope, const arb_t w, const arb_t eps, bool same,
                   slong precision)
{
  bool followed = true;
  SCOPED(base, base);
  SCOPED(arb, c, c_slope, here);
  arb_set(c, w);
  arb_one(c_slope);
  arb_zero(balance);
  arb_zero(slope);
  for (int k = 0; followed && k < 2; k++) { /* c and c_slope in units of L and the period between the phases */
    struct phase_constants *p = &l->phase[k];
    SCOPED(arb, fraction);
    arb_set_fmpq(fraction, p->fraction, precision);
    arb_mul(here, eps, fraction, precision);
    arb_mul(here, here, fraction, precision);
    arb_mul(c, c, fraction, precision);
    arb_mul(c_slope, c_slope, fraction, precision);
    followed = base_follow(&base, &l->branch[k], p, here, c, c_slope, same, precision);
    arb_div(c, base.c_end, fraction, precision);
    arb_div(c_slope, base.c_end_slope, fraction, precision);
    arb_addmul(balance, base.balance, fraction, precision);
    arb_addmul(slope, base.balance_slope, fraction, precision);
  }
  return followed;
}

/* The offsets of all crossings, kept for a second attempt */
struct offsets {
  arb_t u[2][MOST_CROSSINGS];
};

static void offsets_init(struct offsets *o)
{
  for (int k = 0; k < 2; k++)
    for (int i = 0; i < MOST_CROSSINGS; i++)
      arb_init(o->u[k][i]);
}

static void offsets_clear(struct offsets *o)
{
  for (int k = 0; k < 2; k++)
    for (int i = 0; i < MOST_CROSSINGS; i++)
      arb_clear(o->u[k][i]);
}

static void keep_offsets(struct offsets *o, const struct limit *l, slong precision)
{
  for (int k = 0; k < 2; k++)
    for (int i = 0; i < l->branch[k].count; i++)
      series_coefficient(o->u[k][i], &l->branch[k].crossing[i].offset, 0, precision);
}

static void put_offsets(struct limit *l, const struct offsets *o)
{
  for (int k = 0; k < 2; k++)
    for (int i = 0; i < l->branch[k].count; i++)
      series_set_ball(&l->branch[k].crossing[i].offset, o->u[k][i]);
}

/* The root for the middle of w, by Newton's method; balance is that at the w it ends with. */
static bool middle_of_branch(struct limit *l, arb_t w, arb_t balance, arb_t slope, const arb_t eps, slong precision)
{
  enum { STEPS = 60 };
  bool sound = true, settled = false;
  SCOPED(arb, step);
  for (int i = 0; sound && !settled && i < STEPS; i++) {
    mag_zero(arb_radref(w));
    sound = follow(l, balance, slope, w, eps, false, precision);
    arb_div(step, balance, slope, precision);
    sound = sound && arb_is_finite(step);
    settled = sound && arf_cmpabs_mag(arb_midref(step), arb_radref(step)) <= 0;
    if (sound && !settled)
      arf_sub(arb_midref(w), arb_midref(w), arb_midref(step), precision, ARF_RND_NEAR);
  }
  return settled;
}

bool limit_follow(struct limit *l, arb_t w, const arb_t eps, slong precision)
{
  enum { TRIES = 40 };
  bool inside = false;
  ENDED_BY(offsets_clear) struct offsets before;
  offsets_init(&before);
  ENDED_BY(offsets_clear) struct offsets middle;
  offsets_init(&middle);
  SCOPED(arb, balance, slope, wide, next);
  keep_offsets(&before, l, precision);
  bool sound = middle_of_branch(l, w, balance, slope, eps, precision);
  keep_offsets(&middle, l, precision);
  arb_div(next, balance, slope, precision);
  arb_set(wide, w);
  arb_get_mag(arb_radref(wide), next);
  for (int i = 0; sound && !inside && i < TRIES; i++) {
    mag_mul_2exp_si(arb_radref(wide), arb_radref(wide), 1);
    put_offsets(l, &middle); /* the crossings for all of wide must be those of its middle */
    sound = follow(l, next, slope, wide, eps, true, precision) && !arb_contains_zero(slope);
    arb_div(next, balance, slope, precision);
    arb_sub(next, w, next, precision);
    inside = sound && arb_contains(wide, next);
  }
  if (inside)
    arb_set(w, next); /* the offsets are those for wide, which holds it */
  else
    put_offsets(l, &before);
  return inside;
}

/* The branches of the level w, and its balance and slope there. */
static bool balance_of_level(struct limit *l, arb_t balance, arb_t slope, const arb_t w, slong precision)
{
  bool found = true;
  SCOPED(arb, c, eps);
  for (int k = 0; found && k < 2; k++) {
    ball_times(c, w, l->phase[k].fraction, precision);
    found = branch_of_level(&l->branch[k], &l->phase[k], c, precision);
  }
  found = found && follow(l, balance, slope, w, eps, false, precision);
  return found;
}

/* A level above every curve on the side of sign: twice the highest */
static void bracket(arf_t high, const struct limit *l)
{
  double most = 0;
  for (int k = 0; k < 2; k++) {
    double peak = 2 * l->phase[k].shape->peak / fmpq_get_d(l->phase[k].fraction);
    most = peak > most ? peak : most;
  }
  arf_set_d(high, most);
}

/* Newton's method for |w|, halving the bracket where it leaves it: the balance falls as w grows. */
static bool approach_limit(struct limit *l, arb_t w, int sign, slong precision)
{
  enum { STEPS = 200, CLOSE = 30 };
  bool close = false;
  SCOPED(arf, lo, hi, step);
  SCOPED(arb, balance, slope);
  bracket(hi, l);
  arb_set_arf(w, hi);
  arb_mul_2exp_si(w, w, -3);
  for (int i = 0; i < STEPS && !close; i++) {
    arb_mul_si(w, w, sign, precision);
    bool found = balance_of_level(l, balance, slope, w, precision);
    arb_mul_si(w, w, sign, precision);
    if (found)
      arf_set(arf_sgn(arb_midref(balance)) == sign ? lo : hi, arb_midref(w));
    arf_div(step, arb_midref(balance), arb_midref(slope), precision, ARF_RND_NEAR);
    arf_mul_si(step, step, sign, precision, ARF_RND_NEAR);
    arf_sub(step, arb_midref(w), step, precision, ARF_RND_NEAR);
    if (found && arf_is_finite(step) && arf_cmp(step, lo) >= 0 && arf_cmp(step, hi) <= 0) {
      arf_sub(arb_midref(balance), step, arb_midref(w), precision, ARF_RND_NEAR);
      close = arf_is_zero(arb_midref(balance))
              || arf_cmpabs_2exp_si(arb_midref(balance), arf_abs_bound_lt_2exp_si(step) - CLOSE) < 0;
      arf_set(arb_midref(w), step);
    } else { /* not quite the middle, where a second attempt could touch the same curve */
      arf_sub(step, hi, lo, precision, ARF_RND_NEAR);
      arf_mul_ui(step, step, found ? 128 : (ulong)(101 + i % 50), precision, ARF_RND_NEAR);
      arf_mul_2exp_si(step, step, -8);
      arf_add(arb_midref(w), lo, step, precision, ARF_RND_NEAR);
    }
  }
  arb_mul_si(w, w, sign, precision);
  close = close && balance_of_level(l, balance, slope, w, precision);
  return close;
}

static bool is_linear(const struct scallop_piece *p)
{
  return p->law ? p->law->kind != SCALLOP_LAW_SINE && p->law->degree <= 1 : p->linear;
}

bool limit_is_linear(const struct limit *l)
{
  for (int k = 0; k < 2; k++)
    for (int i = 0; i < l->branch[k].count; i++)
      if (!is_linear(l->branch[k].crossing[i].piece))
        return false;
  return true;
}

/* The offset at which q |l'| = w fraction, |l'| being a + b (time) in the piece */
static void exact_offset(struct crossing *at, const struct phase_constants *p, const fmpq_t w)
{
  SCOPED(fmpq, u, a, b);
  SCOPED(fmpq_poly, speed);
  scallop_rational_speed_series(speed, at->piece, u, 2, NULL);
  fmpq_poly_get_coeff_fmpq(a, speed, 0);
  fmpq_poly_get_coeff_fmpq(b, speed, 1);
  fmpq_mul(u, w, p->fraction);
  fmpq_div(u, u, p->curve[at->curve]);
  fmpq_sub(u, u, a);
  fmpq_div(u, u, b);
  if (at->piece->anchor == SCALLOP_FROM_END)
    fmpq_neg(u, u);
  series_set_rational(&at->offset, u);
}

static void exact_offsets(struct limit *l, const fmpq_t w)
{
  for (int k = 0; k < 2; k++)
    for (int i = 0; i < l->branch[k].count; i++)
      exact_offset(&l->branch[k].crossing[i], &l->phase[k], w);
  series_set_rational(&l->w, w);
}

/* The balance is a linear function of w here: one Newton step from anywhere on the branch ends on the root. */
static bool make_exact(struct limit *l, const arb_t near)
{
  const struct ring ring = { 1, 64 };
  SCOPED(fmpq, w);
  SCOPED(series, zero);
  SCOPED(steady_lift, lifted);
  SCOPED(arf, few);
  arf_set_round(few, arb_midref(near), 30, ARF_RND_NEAR);
  arf_get_fmpq(w, few);
  exact_offsets(l, w);
  bool exact = steady_lift(&lifted, l, &zero, &ring) && series_rational_coefficient(w, &lifted.w, 0);
  if (exact)
    exact_offsets(l, w);
  return exact;
}

static enum scallop_status from_ends(struct limit *l, int sign, const char **why)
{
  series_set_si(&l->w, 0);
  for (int k = 0; k < 2; k++)
    if (l->phase[k].shape->pieces[0].jump) {
      *why = "l' jumps where a phase begins: the steady states may fill an interval";
      return SCALLOP_EDOMAIN;
    }
  if (branch_from_ends(&l->branch[0], &l->phase[0], -sign, sign)
      && branch_from_ends(&l->branch[1], &l->phase[1], sign, -sign))
    return SCALLOP_OK;
  *why = branch_without_ends;
  return SCALLOP_EDOMAIN;
}

enum scallop_status limit_find(struct limit *l, const struct scallop_rational_crawler *crawler, slong precision,
                               const char **why)
{
  SCOPED(fmpq, driven);
  fmpq_sub(driven, l->phase[0].fraction, l->phase[1].fraction);
  int difference = fmpq_sgn(l->phase[0].beta[1]), sign = difference * fmpq_sgn(driven);
  if (!scallop_gait_is_exact(crawler->gait)) {
    *why = "the gait has no exact law";
    return SCALLOP_EDOMAIN;
  }
  if (!branch_is_possible(crawler->gait)) {
    *why = branch_impossible;
    return SCALLOP_EDOMAIN;
  }
  if (sign == 0) /* w = 0: from there c is of the order of eps, and at 0 throughout if F1 = F2 */
    return from_ends(l, l->at_rest ? 0 : difference, why);
  SCOPED(arb, w, eps);
  bool found = approach_limit(l, w, sign, precision);
  if (found && scallop_gait_is_rational(crawler->gait) && limit_is_linear(l))
    found = make_exact(l, w);
  else if (found) {
    found = limit_follow(l, w, eps, precision);
    series_set_ball(&l->w, w);
  }
  if (found) { /* the level that it ends at crosses what the one it began with did */
    series_coefficient(w, &l->w, 0, precision);
    found = !limit_holds(l, w, w, eps, precision);
  }
  if (found)
    return SCALLOP_OK;
  *why = "in the limit T -> 0 a body touches v = 0 without turning, or too nearly to tell";
  return SCALLOP_EUNDECIDED;
}
