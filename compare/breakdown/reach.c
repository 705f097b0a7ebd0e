#include <float.h>
#include <math.h>

#include "compare/breakdown/motion.h"
#include "model/golden.h"
#include "compare/text/digits.h"

/* Places: T = natural time times 2^(k/PER_OCTAVE - OCTAVES): between two of these an error is taken to have one maximum
 * at most. As T -> 0 it is what it is at FARTHEST. */
enum { PER_OCTAVE = 16, OCTAVES = 128, MIDDLE = OCTAVES * PER_OCTAVE, FARTHEST = 128 };
_Static_assert(STUDY_PLACES == 2 * MIDDLE + 1, "what a study keeps are these");

/* The one beyond which nothing changes */
static int last_place(const struct motion *m)
{
  double beyond = PER_OCTAVE * log2(motion_last_time(m) / motion_natural_time(m));
  return MIDDLE + (int)fmin(fmax(ceil(beyond), -MIDDLE), MIDDLE);
}

/* Where searches towards T = 0 begin */
static int middle_place(const struct motion *m) { return last_place(m) < MIDDLE ? last_place(m) : MIDDLE; }

struct look { /* at the error, series/exact - 1 */
  double T, error;
  double excess; /* |error| - tolerance, rounded once: it has all its digits also where |error| is near the tolerance */
  int side;      /* of the tolerance, where that is proven: -1 below, 1 not; else 0 */
  struct answer exact; /* in binary128 */
};

static struct look look_beside(const struct comparison *c, double T, const arb_t exact)
{
  struct look look = { T, NAN, NAN, .side = 0 };
  SCOPED(arb, x, tolerance);
  series_item_value(x, &c->item, c->study, T);
  if (arb_is_zero(exact) && arb_is_finite(x))
    look.error = look.excess = INFINITY;
  relative_error(x, exact, BREAKDOWN_BITS);
  if (!arb_is_finite(x))
    return look;
  look.error = arf_get_d(arb_midref(x), ARF_RND_NEAR);
  arb_set_d(tolerance, c->tolerance);
  arb_abs(x, x);
  arb_sub(x, x, tolerance, BREAKDOWN_BITS);
  look.excess = arf_get_d(arb_midref(x), ARF_RND_NEAR);
  look.side = arb_is_negative(x) ? -1 : arb_is_nonnegative(x);
  return look;
}

/* known: the answer there, or NULL */
static struct look look_at(const struct comparison *c, double T, const struct answer *known)
{
  struct answer here;
  SCOPED(arb, exact, low);
  if (!known)
    motion_in_wide(&c->study->motion, T, &here);
  const struct answer *answer = known ? known : &here;
  arb_set_d(exact, answer->value[c->item.quantity].high);
  arb_set_d(low, answer->value[c->item.quantity].low);
  arb_add(exact, exact, low, BREAKDOWN_BITS);
  struct look look = look_beside(c, T, exact);
  look.exact = *answer;
  return look;
}

static struct look look_at_place(const struct comparison *c, int place)
{
  struct study_place *kept = &c->study->places[place];
  double T = motion_natural_time(&c->study->motion) * exp2((double)(place - MIDDLE) / PER_OCTAVE);
  if (!kept->known)
    motion_in_wide(&c->study->motion, T, &kept->exact);
  kept->known = true;
  return look_at(c, T, &kept->exact);
}

double comparison_error(const struct comparison *c, double T) { return look_at(c, T, NULL).error; }

bool comparison_is_proven(const struct comparison *c, double T)
{
  enum { DIGITS = 40, MOST_PIECES = 32 };
  const struct motion *m = &c->study->motion;
  const struct scallop_shape *phase = m->crawler.gait->phase;
  bool proven = phase[0].count <= MOST_PIECES && phase[1].count <= MOST_PIECES;
  for (int side = -1; side <= 1 && proven; side += 2) {
    const double beside = T * (1 + side * 0x1p-50);
    const struct motion at = motion_at(m, beside);
    SCOPED(ball_answer, a);
    answer_of_doubles(&a, &at, DIGITS);
    const arb_struct *exact = a.value[c->item.quantity];
    proven = exact && look_beside(c, beside, exact).side == side;
  }
  return proven;
}

static double exact_of(const struct comparison *c, const struct look *look)
{
  return look->exact.value[c->item.quantity].high;
}

/* |error| < tolerance at low, not at high: the last double between them at which it is. Beyond a zero of the exact
 * value the error is without bound. */
static double crossing(const struct comparison *c, const struct look *low, double high)
{
  double below = low->T;
  for (double T; halfway(&T, below, high);) {
    const struct look look = look_at(c, T, NULL);
    bool is_below = look.excess < 0 && exact_of(c, low) * exact_of(c, &look) >= 0;
    *(is_below ? &below : &high) = T;
  }
  return below;
}

static double minus_size(void *comparison, double T) { return -fabs(comparison_error(comparison, T)); }

/* Does the error rise above the tolerance at a peak around the middle one of three? *T: there. */
static bool peaks_above(const struct comparison *c, const struct look *before, const struct look *here,
                        const struct look *after, double *T)
{
  double size = fabs(here->error);
  if (!(size >= fabs(before->error) && size >= fabs(after->error) && size > c->tolerance / 16))
    return false;
  struct comparison of = *c;
  *T = golden_least(minus_size, &of, before->T, after->T, 1e-8 * after->T);
  return fabs(comparison_error(c, *T)) >= c->tolerance;
}

/* From here down the error stays below the tolerance, and hardly changes beside what is left to that: as near to its
 * limit for T -> 0 it is several octaves in a row, for it may pass that value elsewhere. -1: the limit is not below the
 * tolerance. */
static int lowest_place(const struct comparison *c)
{
  enum { ENOUGH = 3 };
  static const double SMALL = 1.0 / 64;
  double limit = look_at_place(c, FARTHEST).excess;
  int settled = 0, place = middle_place(&c->study->motion);
  while (settled < ENOUGH && place > FARTHEST) {
    place -= PER_OCTAVE;
    settled = fabs(look_at_place(c, place).excess - limit) < SMALL * fabs(limit) ? settled + 1 : 0;
  }
  return limit < 0 ? place + (ENOUGH - 1) * PER_OCTAVE : -1;
}

double comparison_limit(const struct comparison *c)
{
  double limit = fabs(look_at_place(c, FARTHEST).error), above = fabs(look_at_place(c, FARTHEST + PER_OCTAVE).error);
  return limit > 1e-14 && fabs(above - limit) <= DBL_EPSILON * limit ? limit : NAN;
}

struct search {
  const struct comparison *comparison;
  double reach;             /* INFINITY: not found yet */
  struct look before, here; /* the last two looks, in the order of T */
};

/* From here to there by way of every change of modes between: there the error can have a corner, and a peak as sharp as
 * that. Between two looks that are left it has one peak at most. */
static void go_over(struct search *s, const struct look *there)
{
  static const double narrow = 1e-11;
  const struct comparison *c = s->comparison;
  double T = sqrt(s->here.T) * sqrt(there->T);
  if (s->reach < INFINITY)
    return;
  if (there->T - s->here.T > narrow * there->T && !same_modes(s->here.exact.modes, there->exact.modes)) {
    const struct look middle = look_at(c, T, NULL);
    go_over(s, &middle);
    go_over(s, there);
    return;
  }
  if (peaks_above(c, &s->before, &s->here, there, &T))
    s->reach = crossing(c, &s->before, T);
  else if (!(there->excess < 0) || exact_of(c, &s->here) * exact_of(c, there) < 0)
    s->reach = crossing(c, &s->here, there->T);
  s->before = s->here;
  s->here = *there;
}

double comparison_reach(const struct comparison *c)
{
  struct search s = { .comparison = c, .reach = INFINITY, .before.error = NAN };
  int first = lowest_place(c), last = last_place(&c->study->motion);
  if (first < 0)
    return isnan(look_at_place(c, middle_place(&c->study->motion)).error) ? NAN : 0;
  s.here = look_at_place(c, first);
  for (int place = first; place < last && s.reach == INFINITY; place++) {
    const struct look next = look_at_place(c, place + 1);
    go_over(&s, &next);
  }
  return s.reach;
}
