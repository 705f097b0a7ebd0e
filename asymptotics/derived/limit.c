/* The limit T -> 0 as a root in w; the steady state around it, as a series by Newton's method, and in balls */
#include "asymptotics/derived/limit.h"

#include "asymptotics/derived/scoped.h"

static void constants_set(struct phase_constants *to, const struct phase_constants *from)
{
  to->kind = from->kind;
  to->shape = from->shape;
  fmpq_set(to->fraction, from->fraction);
  for (int i = 0; i < 2; i++)
    fmpq_set(to->curve[i], from->curve[i]);
  for (int i = 0; i < 3; i++)
    fmpq_set(to->beta[i], from->beta[i]);
}

void limit_set(struct limit *to, const struct limit *from)
{
  for (int k = 0; k < 2; k++) {
    constants_set(&to->phase[k], &from->phase[k]);
    branch_set(&to->branch[k], &from->branch[k]);
  }
  series_set(&to->w, &from->w);
  to->at_rest = from->at_rest;
  to->returns = from->returns;
  to->even = from->even;
}

/* Computes both phases from start velocity s->w; balance of the period, and slope, its derivative by w. */
static bool lift_period(struct steady_lift *s, struct limit *l, const struct phase_series *const phases[2],
                        const struct series *eps, enum crossings crossings, struct series *balance,
                        struct series *slope, const struct ring *ring)
{
  SCOPED(series, c, c_slope, here);
  series_set(&c, &s->w);
  series_set_si(&c_slope, 1);
  series_set_si(balance, 0);
  series_set_si(slope, 0);
  series_set_si(&s->travel, 0);
  for (int k = 0; k < 2; k++) { /* c and c_slope in units of L and the period between the phases */
    const struct series *fraction = &phases[k]->fraction;
    struct lift *phase = &s->phase[k];
    series_mul(&here, eps, fraction, ring);
    series_mul(&here, &here, fraction, ring);
    series_mul(&c, &c, fraction, ring);
    series_mul(&c_slope, &c_slope, fraction, ring);
    if (!lift_phase(phase, &l->branch[k], phases[k], &here, &c, &c_slope, crossings, ring))
      return false;
    series_div(&c, &phase->c_end, fraction, ring);
    series_div(&c_slope, &phase->c_end_slope, fraction, ring);
    if (k == SCALLOP_EXTENSION)
      series_set(&s->w_mid, &c);
    series_mul(&here, &phase->balance, fraction, ring);
    series_add(balance, balance, &here, ring);
    series_mul(&here, &phase->balance_slope, fraction, ring);
    series_add(slope, slope, &here, ring);
    series_add(&s->travel, &s->travel, &phase->travel, ring);
  }
  return true;
}

bool steady_lift_start(struct steady_lift *s, struct limit *l, const struct phase_series *const phases[2],
                       const struct series *eps, const struct ring *ring)
{
  bool last = false;
  SCOPED(series, balance, slope);
  series_set(&s->w, &l->w);
  for (slong length = ring->length > 1 ? 2 : 1; !last; length *= 2) {
    last = length >= ring->length;
    const struct ring part = { last ? ring->length : length, ring->precision };
    s->w.known = SERIES_ALL;
    if (!lift_period(s, l, phases, eps, CROSSINGS_KNOWN, &balance, &slope, &part))
      return false; /* GCOVR_EXCL_LINE: balls too wide */
    for (slong k = 0; balance.kind == SERIES_BALLS && k < (length + 1) / 2; k++)
      series_set_zero(&balance, k); /* w is correct up to here, whatever its balls are */
    if (!series_div(&balance, &balance, &slope, &part))
      return false; /* GCOVR_EXCL_LINE: balls too wide */
    series_sub(&s->w, &s->w, &balance, &part);
  }
  return true;
}

struct two_phases {
  struct phase_series phase[2];
};
#define TWO_PHASES(of) of(phase_series, &s->phase[0]) of(phase_series, &s->phase[1])
SCOPED_PARTS(two_phases, struct two_phases, TWO_PHASES)

static void set_phases(struct two_phases *to, const struct limit *l)
{
  SCOPED(fmpq, one);
  fmpq_one(one);
  for (int k = 0; k < 2; k++)
    phase_series_set(&to->phase[k], &l->phase[k], one);
}

bool steady_lift(struct steady_lift *s, struct limit *l, const struct phase_series *const phases[2],
                 const struct series *eps, const struct ring *ring)
{
  SCOPED(two_phases, own);
  SCOPED(series, balance, slope);
  const struct phase_series *const used[] = { phases ? phases[0] : &own.phase[0], phases ? phases[1] : &own.phase[1] };
  if (!phases)
    set_phases(&own, l);
  return steady_lift_start(s, l, used, eps, ring)
         && lift_period(s, l, used, eps, CROSSINGS_KNOWN, &balance, &slope, ring); /* all that depends on w */
}

/* Computes the balance and its derivative with respect to w, with newly enclosed crossings. */
static bool follow(struct limit *l, arb_t balance, arb_t slope, const arb_t w, const arb_t eps,
                   enum crossings crossings, slong precision)
{
  const struct ring ring = { 1, precision };
  SCOPED(steady_lift, s);
  SCOPED(two_phases, phases);
  SCOPED(series, at, sum, sum_slope);
  set_phases(&phases, l);
  series_set_ball(&s.w, w);
  series_set_ball(&at, eps);
  if (!lift_period(&s, l, (const struct phase_series *[]){ &phases.phase[0], &phases.phase[1] }, &at, crossings, &sum,
                   &sum_slope, &ring))
    return false;
  series_coefficient(balance, &sum, 0, precision);
  series_coefficient(slope, &sum_slope, 0, precision);
  return true;
}

struct following { /* the branch at eps: at places w, and for all w of a ball */
  struct limit middle, around;
  arb_t eps;
};
#define FOLLOWING(of) of(limit, &s->middle) of(limit, &s->around) of(arb, s->eps)
SCOPED_PARTS(following, struct following, FOLLOWING)

static bool balance_at(arb_t balance, arb_t slope, const arb_t w, void *following, slong precision)
{
  struct following *f = following;
  if (arb_is_exact(w))
    return follow(&f->middle, balance, slope, w, f->eps, CROSSINGS_ANEW, precision);
  limit_set(&f->around, &f->middle); /* the crossings for all w must be the same as for the middle */
  return follow(&f->around, balance, slope, w, f->eps, CROSSINGS_THE_SAME, precision);
}

bool limit_follow(struct limit *l, arb_t w, const arb_t eps, slong precision)
{
  SCOPED(following, f);
  limit_set(&f.middle, l);
  arb_set(f.eps, eps);
  bool found = enclose_root(w, balance_at, &f, NULL, precision);
  if (found)
    limit_set(l, &f.around); /* for a ball that contains w */
  return found;
}

/* Computes the branches of the level w, and its balance and slope. */
static bool balance_of_level(struct limit *l, arb_t balance, arb_t slope, const arb_t w, slong precision)
{
  SCOPED(arb, c, eps);
  for (int k = 0; k < 2; k++) {
    ball_times(c, w, l->phase[k].fraction, precision);
    if (!branch_of_level(&l->branch[k], &l->phase[k], c, precision))
      return false;
  }
  return follow(l, balance, slope, w, eps, CROSSINGS_ANEW, precision);
}

/* Computes a level above every curve on the side of sign: twice the highest. */
static void bracket(arf_t high, const struct limit *l)
{
  double most = 0;
  for (int k = 0; k < 2; k++) {
    double peak = 2 * l->phase[k].shape->peak / fmpq_get_d(l->phase[k].fraction);
    most = peak > most ? peak : most;
  }
  arf_set_d(high, most);
}

/* Finds |w| by Newton's method, and by bisection if a step leaves the bracket: the balance decreases with w. */
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
    } else { /* not quite the middle: a second attempt could touch the same curve there */
      arf_sub(step, hi, lo, precision, ARF_RND_NEAR);
      arf_mul_ui(step, step, found ? 128 : (ulong)(101 + i % 50), precision, ARF_RND_NEAR);
      arf_mul_2exp_si(step, step, -8);
      arf_add(arb_midref(w), lo, step, precision, ARF_RND_NEAR);
    }
  }
  arb_mul_si(w, w, sign, precision);
  return close && balance_of_level(l, balance, slope, w, precision);
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

/* Sets the offset at which q |l'| = w fraction, |l'| being a + b (time) in the piece. */
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

/* Makes w exact: the balance is linear in w here, and one Newton step from any point of the branch ends on the root. */
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
  bool exact = steady_lift(&lifted, l, NULL, &zero, &ring) && series_rational_coefficient(w, &lifted.w, 0);
  if (exact)
    exact_offsets(l, w);
  return exact;
}

/* Finds the branches for w = 0: c is then of the order of eps, and 0 throughout if F1 = F2. Returns NULL, or the reason
 * why no series exists. */
static const char *limit_from_ends(struct limit *l, int sign)
{
  series_set_si(&l->w, 0);
  for (int k = 0; k < 2; k++)
    if (l->phase[k].shape->pieces[0].jump)
      return "l' jumps where a phase begins: the steady states may fill an interval";
  const char *why = branch_from_ends(&l->branch[0], &l->phase[0], -sign, sign);
  return why ? why : branch_from_ends(&l->branch[1], &l->phase[1], sign, -sign);
}

/* Finds the level w of this sign with zero balance. Returns false unless it crosses the curves as in its branches. */
static bool limit_from_level(struct limit *l, const struct scallop_gait *gait, int sign, slong precision)
{
  SCOPED(arb, w, eps);
  if (!approach_limit(l, w, sign, precision))
    return false;
  if (scallop_gait_is_rational(gait) && limit_is_linear(l)) {
    if (!make_exact(l, w))
      return false; /* GCOVR_EXCL_LINE: balls too wide */
  } else if (limit_follow(l, w, eps, precision))
    series_set_ball(&l->w, w);
  else
    return false; /* GCOVR_EXCL_LINE: balls too wide */
  series_coefficient(w, &l->w, 0, precision);
  return !limit_holds(l, w, w, eps, precision);
}

static void set_constants(struct limit *l, const struct scallop_rational_crawler *crawler)
{
  for (int k = 0; k < 2; k++)
    phase_constants_set(&l->phase[k], crawler, (enum scallop_phase_kind)k);
  l->at_rest = fmpq_is_zero(l->phase[0].beta[1]);
  const bool halves = fmpq_cmp(l->phase[0].fraction, l->phase[1].fraction) == 0;
  /* for halves w is of the order of eps, and the branches for -eps differ */
  l->even = !halves && scallop_gait_is_reversible(crawler->gait);
  l->returns = l->at_rest || (halves && scallop_gait_mirrors(crawler->gait));
}

enum scallop_status limit_find(struct limit *l, const struct scallop_rational_crawler *crawler, slong precision,
                               const char **why)
{
  const char *none = not_expandable(crawler, 1, precision);
  if (none)
    return refused_for(SCALLOP_EDOMAIN, none, why);
  set_constants(l, crawler);
  const int difference = fmpq_sgn(l->phase[0].beta[1]),
            sign = difference * fmpq_cmp(l->phase[0].fraction, l->phase[1].fraction);
  if (sign == 0)
    none = limit_from_ends(l, difference);
  else if (!limit_from_level(l, crawler->gait, sign > 0 ? 1 : -1, precision))
    return refused_for(SCALLOP_EUNDECIDED, "in the limit T -> 0 a body touches v = 0 without turning, or almost", why);
  return none ? refused_for(SCALLOP_EDOMAIN, none, why) : SCALLOP_OK;
}
