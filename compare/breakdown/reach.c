/* Reach of a series: the first T at which its error is not below a tolerance. */
#include <float.h>
#include <math.h>

#include "compare/breakdown/motion.h"
#include "model/golden.h"
#include "compare/text/digits.h"

/* Places: T = natural time times 2^(k/PER_OCTAVE - OCTAVES). An error is assumed to have at most one maximum between
 * neighbours, and at FARTHEST its limit for T -> 0. */
enum { PER_OCTAVE = 16, OCTAVES = 128, MIDDLE = OCTAVES * PER_OCTAVE, FARTHEST = 128 };
_Static_assert(STUDY_PLACES == 2 * MIDDLE + 1, "a study has an answer for each place");

/* Returns the place beyond which modes do not change. */
static int last_place(const struct motion *m)
{
  double beyond = PER_OCTAVE * log2(motion_last_time(m) / motion_natural_time(m));
  return MIDDLE + (int)fmin(fmax(ceil(beyond), -MIDDLE), MIDDLE);
}

/* Returns the place from which searches towards T = 0 begin. */
static int middle_place(const struct motion *m) { return last_place(m) < MIDDLE ? last_place(m) : MIDDLE; }

struct sample { /* of the error, series/exact - 1 */
  double T, error;
  double excess;       /* |error| - tolerance, rounded once, hence accurate near 0 too */
  int side;            /* proven side of the tolerance: -1 below, 1 not below; 0: not proven */
  struct answer exact; /* in binary128 */
};

static struct sample sample_against(const struct comparison *c, double T, const arb_t exact)
{
  struct sample sample = { T, NAN, NAN, .side = 0 };
  SCOPED(arb, x, tolerance);
  series_item_value(x, &c->item, c->study, T);
  if (arb_is_zero(exact) && arb_is_finite(x))
    sample.error = sample.excess = INFINITY;
  relative_error(x, exact, BREAKDOWN_BITS);
  if (!arb_is_finite(x))
    return sample;
  sample.error = arf_get_d(arb_midref(x), ARF_RND_NEAR);
  arb_set_d(tolerance, c->tolerance);
  arb_abs(x, x);
  arb_sub(x, x, tolerance, BREAKDOWN_BITS);
  sample.excess = arf_get_d(arb_midref(x), ARF_RND_NEAR);
  sample.side = arb_is_negative(x) ? -1 : arb_is_nonnegative(x);
  return sample;
}

/* Samples the error at T. known: the answer at T, or NULL */
static struct sample sample_at(const struct comparison *c, double T, const struct answer *known)
{
  struct answer here;
  SCOPED(arb, exact, low);
  if (!known)
    motion_in_wide(&c->study->motion, T, &here);
  const struct answer *answer = known ? known : &here;
  arb_set_d(exact, answer->value[c->item.quantity].high);
  arb_set_d(low, answer->value[c->item.quantity].low);
  arb_add(exact, exact, low, BREAKDOWN_BITS);
  struct sample sample = sample_against(c, T, exact);
  sample.exact = *answer;
  return sample;
}

static struct sample sample_at_place(const struct comparison *c, int place)
{
  struct study_place *kept = &c->study->places[place];
  double T = motion_natural_time(&c->study->motion) * exp2((double)(place - MIDDLE) / PER_OCTAVE);
  if (!kept->known)
    motion_in_wide(&c->study->motion, T, &kept->exact);
  kept->known = true;
  return sample_at(c, T, &kept->exact);
}

double comparison_error(const struct comparison *c, double T) { return sample_at(c, T, NULL).error; }

bool comparison_is_proven(const struct comparison *c, double T)
{
  enum { DIGITS = 40, MAX_PIECES = 32 };
  const struct motion *m = &c->study->motion;
  const struct scallop_shape *phase = m->crawler.gait->phase;
  bool proven = phase[0].count <= MAX_PIECES && phase[1].count <= MAX_PIECES;
  for (int side = -1; side <= 1 && proven; side += 2) {
    const double beside = T * (1 + side * 0x1p-50);
    const struct motion at = motion_at(m, beside);
    SCOPED(ball_answer, a);
    answer_of_doubles(&a, &at, DIGITS);
    const arb_struct *exact = a.value[c->item.quantity];
    proven = exact && sample_against(c, beside, exact).side == side;
  }
  return proven;
}

static double exact_of(const struct comparison *c, const struct sample *sample)
{
  return sample->exact.value[c->item.quantity].high;
}

/* Returns the last T in [low, high) at which |error| < tolerance, to the double; this holds at low and not at high. A
 * zero of the exact value counts as a crossing: the error has no bound near it. */
static double find_crossing(const struct comparison *c, const struct sample *low, double high)
{
  double below = low->T;
  for (double T; halfway(&T, below, high);) {
    const struct sample sample = sample_at(c, T, NULL);
    bool is_below = sample.excess < 0 && exact_of(c, low) * exact_of(c, &sample) >= 0;
    *(is_below ? &below : &high) = T;
  }
  return below;
}

static double minus_size(void *comparison, double T) { return -fabs(comparison_error(comparison, T)); }

/* Returns true if the error exceeds the tolerance at a peak near the middle one of three samples; *T: of the peak. */
static bool peaks_above(const struct comparison *c, const struct sample *before, const struct sample *here,
                        const struct sample *after, double *T)
{
  double size = fabs(here->error);
  if (!(size >= fabs(before->error) && size >= fabs(after->error) && size > c->tolerance / 16))
    return false;
  struct comparison of = *c;
  *T = golden_least(minus_size, &of, before->T, after->T, 1e-8 * after->T);
  return fabs(comparison_error(c, *T)) >= c->tolerance;
}

/* Returns a place below which the error stays below the tolerance; -1 if its limit for T -> 0 is not below it. From
 * there down the error is close to its limit, relative to the margin, at several octaves in a row: one is not enough,
 * since the error may cross the value of its limit elsewhere. */
static int lowest_place(const struct comparison *c)
{
  enum { ENOUGH = 3 };
  static const double SMALL = 1.0 / 64;
  double limit = sample_at_place(c, FARTHEST).excess;
  int settled = 0, place = middle_place(&c->study->motion);
  while (settled < ENOUGH && place > FARTHEST) {
    place -= PER_OCTAVE;
    settled = fabs(sample_at_place(c, place).excess - limit) < SMALL * fabs(limit) ? settled + 1 : 0;
  }
  return limit < 0 ? place + (ENOUGH - 1) * PER_OCTAVE : -1;
}

double comparison_limit(const struct comparison *c)
{
  double limit = fabs(sample_at_place(c, FARTHEST).error);
  double above = fabs(sample_at_place(c, FARTHEST + PER_OCTAVE).error);
  return limit > 1e-14 && fabs(above - limit) <= DBL_EPSILON * limit ? limit : NAN;
}

struct scan {
  const struct comparison *comparison;
  double reach;               /* INFINITY: not yet found */
  struct sample before, here; /* the last two samples, in the order of T */
};

/* Advances the scan to the next sample, by bisection at changes of modes: at these the error can have a corner, and a
 * sharp peak. Between the resulting samples it has at most one peak. */
static void advance(struct scan *s, const struct sample *next)
{
  static const double narrow = 1e-11;
  const struct comparison *c = s->comparison;
  double T = sqrt(s->here.T) * sqrt(next->T);
  if (s->reach < INFINITY)
    return;
  if (next->T - s->here.T > narrow * next->T && !same_modes(s->here.exact.modes, next->exact.modes)) {
    const struct sample middle = sample_at(c, T, NULL);
    advance(s, &middle);
    advance(s, next);
    return;
  }
  if (peaks_above(c, &s->before, &s->here, next, &T))
    s->reach = find_crossing(c, &s->before, T);
  else if (!(next->excess < 0) || exact_of(c, &s->here) * exact_of(c, next) < 0)
    s->reach = find_crossing(c, &s->here, next->T);
  s->before = s->here;
  s->here = *next;
}

double comparison_reach(const struct comparison *c)
{
  struct scan s = { .comparison = c, .reach = INFINITY, .before.error = NAN };
  int first = lowest_place(c), last = last_place(&c->study->motion);
  if (first < 0)
    return isnan(sample_at_place(c, middle_place(&c->study->motion)).error) ? NAN : 0;
  s.here = sample_at_place(c, first);
  for (int place = first; place < last && s.reach == INFINITY; place++) {
    const struct sample next = sample_at_place(c, place + 1);
    advance(&s, &next);
  }
  return s.reach;
}
