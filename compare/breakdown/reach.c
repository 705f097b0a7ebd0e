#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "compare/breakdown/reach.h"
#include "compare/text/halfway.h"
#include "numerics/event/itp.h"

/* T = natural time times 2^(k/PER_OCTAVE): between two of these an error is taken to have one maximum at most. */
enum { PER_OCTAVE = 16, OCTAVES = 128, PLACES = 2 * OCTAVES * PER_OCTAVE + 1, MIDDLE = OCTAVES * PER_OCTAVE };

struct exact {
  enum { NOT_YET, IN_DOUBLE, IN_WIDE } how;
  struct answer answer;
};
struct exact_cache {
  double natural;
  int middle, last; /* the places where searches towards T = 0 begin, and beyond which nothing changes */
  struct exact place[PLACES];
};

struct exact_cache *exact_cache_new(const struct motion *motion)
{
  struct exact_cache *cache = calloc(1, sizeof *cache);
  if (!cache)
    return NULL;
  cache->natural = motion_natural_time(motion);
  double beyond = PER_OCTAVE * log2(motion_last_time(motion) / cache->natural);
  cache->last = MIDDLE + (int)fmin(fmax(ceil(beyond), -MIDDLE), MIDDLE);
  cache->middle = cache->last < MIDDLE ? cache->last : MIDDLE;
  return cache;
}

struct error {
  double value;  /* series/exact - 1                                                             */
  double excess; /* |value| - tolerance, rounded once: it has all its digits also where |value| is near the tolerance */
  int side;      /* of the tolerance, where that is proven: -1 below, 1 not; else 0 */
};

static struct error error_beside(const struct comparison *c, double T, const arb_t exact, slong precision)
{
  struct error error = { NAN, NAN, 0 };
  SCOPED(arb, x, tolerance);
  series_item_value(x, &c->item, c->expansions, T, precision);
  arb_sub(x, x, exact, precision);
  if (arb_is_zero(x) || arb_is_zero(exact)) {
    error.value = arb_is_zero(x) ? 0 : arb_is_finite(x) ? INFINITY : NAN;
    error.excess = error.value - c->tolerance;
  } else {
    arb_div(x, x, exact, precision);
    if (arb_is_finite(x)) {
      error.value = arf_get_d(arb_midref(x), ARF_RND_NEAR);
      arb_set_d(tolerance, c->tolerance);
      arb_abs(x, x);
      arb_sub(x, x, tolerance, precision);
      error.excess = arf_get_d(arb_midref(x), ARF_RND_NEAR);
      error.side = arb_is_negative(x) ? -1 : arb_is_nonnegative(x);
    }
  }
  return error;
}

double comparison_error_beside(const struct comparison *c, double T, const arb_t exact, slong precision)
{
  return error_beside(c, T, exact, precision).value;
}

static struct error error_of(const struct comparison *c, double T, const struct answer *a)
{
  const struct scallop_wide *value = &a->value[c->item.quantity];
  if (a->status < 0 || !isfinite(value->high))
    return (struct error){ NAN, NAN, 0 };
  SCOPED(arb, exact, low);
  arb_set_d(exact, value->high);
  arb_set_d(low, value->low);
  arb_add(exact, exact, low, BREAKDOWN_BITS);
  return error_beside(c, T, exact, BREAKDOWN_BITS);
}

static struct error error_in_wide(const struct comparison *c, double T)
{
  struct answer a;
  motion_in_wide(c->expansions->motion, T, &a);
  return error_of(c, T, &a);
}

double comparison_error(const struct comparison *c, double T) { return error_in_wide(c, T).value; }

int comparison_certified_side(const struct comparison *c, double T, long digits)
{
  const struct motion at = motion_at(c->expansions->motion, T);
  SCOPED(ball_answer, exact);
  bool solved = answer_of_doubles(&exact, &at, digits) && exact.value[c->item.quantity];
  return solved ? error_beside(c, T, exact.value[c->item.quantity], BREAKDOWN_BITS).side : 0;
}

struct look { /* at the error from afar                                                          */
  double T;
  struct error error;
  struct answer exact;
};

/* In double where that leaves many digits of the error, and of its distance from the tolerance. known: what is known
 * there. */
static struct look look_at(const struct comparison *c, double T, struct exact *known)
{
  static const double PLAIN = 1e-6;
  const struct motion at = motion_at(c->expansions->motion, T);
  if (known->how == NOT_YET) {
    answer_in_double(&known->answer, &at);
    known->how = IN_DOUBLE;
  }
  struct error error = error_of(c, T, &known->answer);
  if (known->how == IN_DOUBLE && !(fabs(error.value) > PLAIN && fabs(error.excess) > PLAIN)) {
    motion_in_wide(c->expansions->motion, T, &known->answer);
    known->how = IN_WIDE;
    error = error_of(c, T, &known->answer);
  }
  return (struct look){ T, error, known->answer };
}

static struct look look_at_place(const struct comparison *c, int place)
{
  struct exact_cache *cache = c->cache;
  return look_at(c, cache->natural * exp2((double)(place - MIDDLE) / PER_OCTAVE), &cache->place[place]);
}

struct rise {
  const struct comparison *comparison;
  /* the error changes less than T does: a double of it has too few digits to tell where it reaches the tolerance */
  bool flat;
};

/* The logarithm of |error|/tolerance, within bounds: as if it were above where the exact motion has no such value. */
static double level(const void *context, double T, double *slope)
{
  static const double most = 40;
  const struct rise *r = context;
  double tolerance = r->comparison->tolerance;
  struct error e = error_in_wide(r->comparison, T);
  *slope = 0; /* of no use */
  return fmax(fmin(r->flat ? log1p(e.excess / tolerance) : log(fabs(e.value) / tolerance), most), -most);
}

/* |error| < tolerance at low, not at high: the last double between them at which it is. */
static double crossing(const struct comparison *c, double low, double high)
{
  struct rise r = { c, false };
  double slope;
  r.flat = level(&r, high, &slope) - level(&r, low, &slope) < log(high / low) / 2;
  double T = itp_root(level, &r, low, high);
  while (T > low && !(level(&r, T, &slope) < 0))
    T = nextafter(T, low);
  return T;
}

/* Where |error| is largest between two times, by golden section. */
static double peak_between(const struct comparison *c, double a, double b)
{
  const double golden = 0.6180339887498949;
  while (b - a > 1e-8 * b) {
    double left = b - golden * (b - a), right = a + golden * (b - a);
    if (fabs(comparison_error(c, left)) > fabs(comparison_error(c, right)))
      b = right;
    else
      a = left;
  }
  return a + (b - a) / 2;
}

/* Does the error rise above the tolerance at a peak around the middle one of three? *T: there. */
static bool peaks_above(const struct comparison *c, const struct look *before, const struct look *here,
                        const struct look *after, double *T)
{
  double size = fabs(here->error.value);
  if (!(size >= fabs(before->error.value) && size >= fabs(after->error.value) && size > c->tolerance / 16))
    return false;
  *T = peak_between(c, before->T, after->T);
  return fabs(comparison_error(c, *T)) >= c->tolerance;
}

static double exact_in_wide(const struct comparison *c, double T)
{
  struct answer a;
  motion_in_wide(c->expansions->motion, T, &a);
  return a.value[c->item.quantity].high;
}

/* The last T before the exact value is 0, to a double. */
static double zero_between(const struct comparison *c, double low, double high)
{
  double sign = copysign(1, exact_in_wide(c, low));
  for (double T; halfway(&T, low, high);)
    *(sign * exact_in_wide(c, T) > 0 ? &low : &high) = T;
  return low;
}

/* From here down the error only goes on towards its limit for T -> 0, in steps that fall as a power of T does, and
 * stays below the tolerance; -1: it stays above, or does not settle. At every octave down the step must be small beside
 * what is left to the tolerance, several times in a row: one small step may lie across a turn of the error. */
static int lowest_place(const struct comparison *c)
{
  static const double NOISE = 1e-25; /* above all that is left of binary128 */
  static const double LESS = 0.75, SMALL = 1.0 / 64, STILL = 1e-6;
  enum { ENOUGH = 3 };
  struct error above = look_at_place(c, c->cache->middle).error;
  double last = INFINITY;
  int settled = 0;
  for (int place = c->cache->middle - PER_OCTAVE; place >= 0; place -= PER_OCTAVE) {
    struct error here = look_at_place(c, place).error;
    if (fabs(here.value) < NOISE)
      return place;
    double left = fabs(here.excess), step = fabs(above.excess - here.excess);
    if (!(above.value * here.value > 0))
      step = INFINITY;
    settled = step < SMALL * left && (step < LESS * last || step < STILL * left) ? settled + 1 : 0;
    if (step <= NOISE || settled == ENOUGH)
      return here.excess >= 0 ? -1 : step <= NOISE ? place : place + (ENOUGH - 1) * PER_OCTAVE;
    last = step;
    above = here;
  }
  return -1;
}

double comparison_limit(const struct comparison *c)
{
  double last = NAN;
  for (int place = c->cache->middle; place >= PER_OCTAVE; place -= PER_OCTAVE) {
    double here = fabs(look_at_place(c, place).error.value);
    if (here < 1e-14)
      return NAN;
    if (fabs(here - last) <= DBL_EPSILON * here) /* the steps fall as a power of T does */
      return here;
    last = here;
  }
  return NAN;
}

struct search {
  const struct comparison *comparison;
  double reach;             /* INFINITY: not found yet */
  struct look before, here; /* the last two looks, in the order of T */
  bool begun;
};

/* Goes on to the next look: between the last one and this the error has one peak at most. */
static void go_on(struct search *s, const struct look *next)
{
  const struct comparison *c = s->comparison;
  enum quantity_id q = c->item.quantity;
  double T;
  if (s->begun && peaks_above(c, &s->before, &s->here, next, &T)) {
    s->reach = crossing(c, s->before.T, T);
  } else if (s->here.exact.value[q].high * next->exact.value[q].high < 0) { /* 0 between: the error is without bound */
    T = zero_between(c, s->here.T, next->T);
    bool steep = fabs(comparison_error(c, T)) < c->tolerance; /* no double lies on the slope beside it */
    s->reach = steep ? T : crossing(c, s->here.T, T);
  } else if (!(next->error.excess < 0)) {
    s->reach = crossing(c, s->here.T, next->T);
  }
  s->begun = true;
  s->before = s->here;
  s->here = *next;
}

/* From here to there by way of every change of modes between: there the error can have a corner, and a peak as sharp as
 * that. */
static void go_over(struct search *s, const struct look *there)
{
  static const double narrow = 1e-11;
  struct exact unknown = { .how = NOT_YET };
  if (s->reach < INFINITY)
    return;
  double T = sqrt(s->here.T) * sqrt(there->T);
  bool close = there->T - s->here.T <= narrow * there->T || !(T > s->here.T && T < there->T);
  if (close || same_modes(s->here.exact.modes, there->exact.modes)) {
    go_on(s, there);
    return;
  }
  const struct look middle = look_at(s->comparison, T, &unknown);
  go_over(s, &middle);
  go_over(s, there);
}

double comparison_reach(const struct comparison *c)
{
  struct search s = { .comparison = c, .reach = INFINITY };
  int first = lowest_place(c);
  if (first < 0)
    return isnan(look_at_place(c, c->cache->middle).error.value) ? NAN : 0;
  s.here = look_at_place(c, first);
  for (int place = first; place < c->cache->last && s.reach == INFINITY; place++) {
    const struct look next = look_at_place(c, place + 1);
    go_over(&s, &next);
  }
  return s.reach;
}
