#include <math.h>
#include <stdlib.h>

#include "compare/text/halfway.h"
#include "compare/breakdown/motion.h"
#include "compare/breakdown/reach.h"

/* T = natural time times 2^(k/PER_OCTAVE): between two of these an error is taken to have one maximum at most. */
enum { PER_OCTAVE = 16, OCTAVES = 128, PLACES = 2 * OCTAVES * PER_OCTAVE + 1, MIDDLE = OCTAVES * PER_OCTAVE };

struct exact_cache {
  double natural;
  int last; /* the place beyond which nothing changes                                         */
  enum { NOT_YET, IN_DOUBLE, IN_WIDE } how[PLACES];
  struct answer place[PLACES];
};

struct exact_cache *exact_cache_new(const struct motion *motion)
{
  struct exact_cache *cache = calloc(1, sizeof *cache);
  if (!cache)
    return NULL;
  cache->natural = motion_natural_time(motion);
  double beyond = PER_OCTAVE * log2(motion_last_time(motion) / cache->natural);
  cache->last = MIDDLE + (int)fmin(fmax(ceil(beyond), -MIDDLE), MIDDLE);
  return cache;
}

static double time_at(const struct exact_cache *cache, int place)
{
  return cache->natural * exp2((double)(place - MIDDLE) / PER_OCTAVE);
}

struct error {
  double value;  /* series/exact - 1                                                             */
  double excess; /* |value| - tolerance, rounded once: it has all its digits also where |value| is near the tolerance */
};

static struct error plain_error(double value, double tolerance) { return (struct error){ value, fabs(value) - tolerance }; }

static struct error error_beside(const struct comparison *c, double T, const arb_t exact, double tolerance, slong precision)
{
  struct error error = plain_error(NAN, tolerance);
  arb_t value, limit;
  arb_init(value);
  arb_init(limit);
  series_item_value(value, &c->item, c->expansions, T, precision);
  arb_sub(value, value, exact, precision);
  if (arb_is_zero(value)) {
    error = plain_error(0, tolerance);
  } else if (arb_is_zero(exact)) {
    error = plain_error(arb_is_finite(value) ? INFINITY : NAN, tolerance);
  } else {
    arb_div(value, value, exact, precision);
    if (arb_is_finite(value)) {
      error.value = arf_get_d(arb_midref(value), ARF_RND_NEAR);
      arb_set_d(limit, tolerance);
      arb_abs(value, value);
      arb_sub(value, value, limit, precision);
      error.excess = arf_get_d(arb_midref(value), ARF_RND_NEAR);
    }
  }
  arb_clear(limit);
  arb_clear(value);
  return error;
}

double comparison_error_beside(const struct comparison *c, double T, const arb_t exact, slong precision)
{
  return error_beside(c, T, exact, 0, precision).value;
}

static struct error error_of(const struct comparison *c, double T, const struct answer *e, double tolerance)
{
  const struct scallop_wide *value = &e->value[c->item.which.quantity];
  arb_t exact, low;
  if (e->status < 0 || !isfinite(value->high))
    return plain_error(NAN, tolerance);
  arb_init(exact);
  arb_init(low);
  arb_set_d(exact, value->high);
  arb_set_d(low, value->low);
  arb_add(exact, exact, low, BREAKDOWN_BITS);
  struct error error = error_beside(c, T, exact, tolerance, BREAKDOWN_BITS);
  arb_clear(exact);
  arb_clear(low);
  return error;
}

static struct error error_in_wide(const struct comparison *c, double T, double tolerance)
{
  struct answer e;
  motion_in_wide(c->motion, T, &e);
  return error_of(c, T, &e, tolerance);
}

double comparison_error(const struct comparison *c, double T) { return error_in_wide(c, T, 0).value; }

int comparison_certified_side(const struct comparison *c, double T, double tolerance, long digits)
{
  const struct motion at = motion_at(c->motion, T);
  struct ball_answer exact;
  arb_t error, limit;
  int side = 0;
  ball_answer_init(&exact);
  arb_init(error);
  arb_init(limit);
  if (answer_of_doubles(&exact, &at, digits) && exact.value[c->item.which.quantity]) {
    const arb_struct *value = exact.value[c->item.which.quantity];
    series_item_value(error, &c->item, c->expansions, T, BREAKDOWN_BITS);
    arb_sub(error, error, value, BREAKDOWN_BITS);
    arb_abs(error, error);
    arb_set_d(limit, tolerance);
    arb_mul(limit, limit, value, BREAKDOWN_BITS);
    arb_abs(limit, limit);
    side = arb_lt(error, limit) ? -1 : arb_ge(error, limit) ? 1 : 0;
  }
  arb_clear(error);
  arb_clear(limit);
  ball_answer_clear(&exact);
  return side;
}

struct look { /* at the error from afar                                                          */
  double T;
  struct error error;
  struct answer exact;
};

/* A double leaves many digits of the error, and of its distance from the tolerance. */
static bool is_plain(const struct error *e)
{
  static const double PLAIN = 1e-6;
  return fabs(e->value) > PLAIN && fabs(e->excess) > PLAIN;
}

/* In double where that is enough. Returns how. */
static int look_at(struct look *look, const struct comparison *c, double T, double tolerance)
{
  const struct motion at = motion_at(c->motion, T);
  look->T = T;
  answer_in_double(&look->exact, &at);
  look->error = error_of(c, T, &look->exact, tolerance);
  if (is_plain(&look->error))
    return IN_DOUBLE;
  motion_in_wide(c->motion, T, &look->exact);
  look->error = error_of(c, T, &look->exact, tolerance);
  return IN_WIDE;
}

/* The same at one of the places, from what is known there. */
static void look_at_place(struct look *look, const struct comparison *c, int place, double tolerance)
{
  struct exact_cache *cache = c->cache;
  double T = time_at(cache, place);
  if (cache->how[place] != NOT_YET) {
    *look = (struct look){ T, error_of(c, T, &cache->place[place], tolerance), cache->place[place] };
    if (is_plain(&look->error) || cache->how[place] == IN_WIDE)
      return;
  }
  cache->how[place] = look_at(look, c, T, tolerance);
  cache->place[place] = look->exact;
}

static double error_at(const struct comparison *c, int place)
{
  struct look look;
  look_at_place(&look, c, place, 0);
  return look.error.value;
}

/* Searches towards T = 0 begin here. */
static int middle_place(const struct comparison *c) { return MIDDLE < c->cache->last ? MIDDLE : c->cache->last; }

/* log(|error|/tolerance). Where the error changes less than T does, more digits than a double of the error has are needed to tell where
 * it reaches the tolerance. */
static double level(const struct comparison *c, double T, double tolerance, bool flat)
{
  struct error e = error_in_wide(c, T, tolerance);
  return flat ? log1p(e.excess / tolerance) : log(fabs(e.value) / tolerance);
}

/* |error| < tolerance at low, not at high: the double between them at which it no longer is. Along log T the logarithm of the error is nearly
 * straight, so that regula falsi (Illinois) takes a few steps; halving where the error has no logarithm. */
static double crossing(const struct comparison *c, double low, double high, double tolerance)
{
  enum { STEPS = 200 };
  double at_low = level(c, low, tolerance, false), at_high = level(c, high, tolerance, false);
  bool flat = at_high - at_low < log(high / low) / 2;
  if (flat)
    at_low = level(c, low, tolerance, true), at_high = level(c, high, tolerance, true);
  int side = 0;
  for (int i = 0; i < STEPS && nextafter(low, high) < high; i++) {
    double width = high / low - 1, share = at_low / (at_low - at_high);
    bool straight = isfinite(at_low) && isfinite(at_high) && i % 8 != 7;
    double T = straight ? low * exp(log1p(width) * share) : low * sqrt(1 + width);
    if (width < 0x1p-48) /* one ulp inside the side that is near */
      T = share < 0.5 ? fmax(T, nextafter(low, high)) : fmin(T, nextafter(high, low));
    if (!(T > low && T < high))
      T = low + (high - low) / 2;
    double at = level(c, T, tolerance, flat);
    if (at < 0) {
      at_high = side < 0 ? at_high / 2 : at_high;
      low = T, at_low = at, side = -1;
    } else { /* or it is no number: the exact motion has no such value there */
      at_low = side > 0 ? at_low / 2 : at_low;
      high = T, at_high = at, side = 1;
    }
  }
  return low;
}

/* The largest |error| between two times, by golden section; *T: where. */
static double peak_between(const struct comparison *c, double a, double b, double *T)
{
  const double golden = 0.6180339887498949;
  double left = b - golden * (b - a), right = a + golden * (b - a);
  double at_left = fabs(comparison_error(c, left)), at_right = fabs(comparison_error(c, right));
  while (b - a > 1e-8 * b)
    if (at_left > at_right) {
      b = right, right = left, at_right = at_left;
      left = b - golden * (b - a);
      at_left = fabs(comparison_error(c, left));
    } else {
      a = left, left = right, at_left = at_right;
      right = a + golden * (b - a);
      at_right = fabs(comparison_error(c, right));
    }
  *T = at_left > at_right ? left : right;
  return fmax(at_left, at_right);
}

/* Does the error rise above the tolerance at a peak around the middle one of three? *T: there. */
static bool peaks_above(const struct comparison *c, const struct look *before, const struct look *here,
                        const struct look *after, double tolerance, double *T)
{
  double size = fabs(here->error.value);
  if (!(size >= fabs(before->error.value) && size >= fabs(after->error.value) && size > tolerance / 16))
    return false;
  return peak_between(c, before->T, after->T, T) >= tolerance;
}

/* Does the exact value change its sign between the two? There it is 0, and the relative error without bound. */
static bool passes_zero(const struct comparison *c, const struct look *a, const struct look *b)
{
  enum quantity_id q = c->item.which.quantity;
  return a->exact.value[q].high * b->exact.value[q].high < 0;
}

static double exact_in_wide(const struct comparison *c, double T)
{
  struct answer e;
  motion_in_wide(c->motion, T, &e);
  return e.value[c->item.which.quantity].high;
}

/* The last T before the exact value is 0, to a double. */
static double zero_between(const struct comparison *c, double low, double high)
{
  double sign = copysign(1, exact_in_wide(c, low));
  for (double T; halfway(&T, low, high);)
    *(sign * exact_in_wide(c, T) > 0 ? &low : &high) = T;
  return low;
}

/* From here down the error only goes on towards its limit for T -> 0, in steps that fall as a power of T does, and stays below the
 * tolerance; -1: it stays above, or does not settle. At every octave down the step must be small beside what is left to the tolerance,
 * several times in a row: one small step may lie across a turn of the error. */
static int lowest_place(const struct comparison *c, double tolerance)
{
  static const double NOISE = 1e-25; /* above all that is left of binary128 */
  static const double LESS = 0.75, SMALL = 1.0 / 64, STILL = 1e-6;
  enum { DOWN = PER_OCTAVE, ENOUGH = 3 };
  struct look above, here;
  double last = INFINITY;
  int settled = 0;
  look_at_place(&above, c, middle_place(c), tolerance);
  for (int place = middle_place(c) - DOWN; place >= 0; place -= DOWN) {
    look_at_place(&here, c, place, tolerance);
    if (fabs(here.error.value) < NOISE)
      return place;
    double left = fabs(here.error.excess), step = fabs(above.error.excess - here.error.excess);
    if (!(above.error.value * here.error.value > 0))
      step = INFINITY;
    if (step <= NOISE)
      return here.error.excess < 0 ? place : -1;
    settled = step < SMALL * left && (step < LESS * last || step < STILL * left) ? settled + 1 : 0;
    if (settled == ENOUGH)
      return here.error.excess < 0 ? place + (ENOUGH - 1) * DOWN : -1;
    last = step;
    above = here;
  }
  return -1;
}

double comparison_limit(const struct comparison *c)
{
  enum { DOWN = PER_OCTAVE };
  double last = NAN;
  for (int place = middle_place(c); place >= DOWN; place -= DOWN) {
    double here = fabs(error_at(c, place));
    if (here < 1e-14)
      return NAN;
    if (here > 0.999999 * last && here < 1.000001 * last)
      return here;
    last = here;
  }
  return NAN;
}

struct search {
  const struct comparison *comparison;
  double tolerance, reach;  /* found: the answer                                                    */
  struct look before, here; /* the last two looks, in the order of T                               */
  bool begun, found;
};

static void end_between(struct search *s, double low, double high)
{
  s->found = true;
  s->reach = crossing(s->comparison, low, high, s->tolerance);
}

/* Goes on to the next look: between the last one and this the error has one peak at most. */
static void go_on(struct search *s, const struct look *next)
{
  const struct comparison *c = s->comparison;
  double T;
  if (s->begun && peaks_above(c, &s->before, &s->here, next, s->tolerance, &T)) {
    end_between(s, s->before.T, T);
  } else if (passes_zero(c, &s->here, next)) {
    T = zero_between(c, s->here.T, next->T);
    if (fabs(comparison_error(c, T)) < s->tolerance) { /* no double lies on the slope beside it */
      s->found = true;
      s->reach = T;
    } else
      end_between(s, s->here.T, T);
  } else if (!(next->error.excess < 0)) {
    end_between(s, s->here.T, next->T);
  }
  s->begun = true;
  s->before = s->here;
  s->here = *next;
}

/* From here to there by way of every change of modes between: there the error can have a corner, and a peak as sharp as that. */
static void go_over(struct search *s, const struct look *there)
{
  static const double narrow = 1e-11;
  struct look middle;
  if (s->found)
    return;
  double T = sqrt(s->here.T) * sqrt(there->T);
  bool close = there->T - s->here.T <= narrow * there->T || !(T > s->here.T && T < there->T);
  if (close || same_modes(s->here.exact.modes, there->exact.modes)) {
    go_on(s, there);
    return;
  }
  look_at(&middle, s->comparison, T, s->tolerance);
  go_over(s, &middle);
  go_over(s, there);
}

double comparison_reach(const struct comparison *c, double tolerance)
{
  struct search s = { .comparison = c, .tolerance = tolerance, .reach = INFINITY };
  int first = lowest_place(c, tolerance);
  if (first < 0)
    return isnan(error_at(c, middle_place(c))) ? NAN : 0;
  look_at_place(&s.here, c, first, tolerance);
  for (int place = first; place < c->cache->last && !s.found; place++) {
    struct look next;
    look_at_place(&next, c, place + 1, tolerance);
    go_over(&s, &next);
  }
  return s.reach;
}

/* tolerance = 0: the error at T of the crawler; else the reach */
static double of_crawler(const struct scallop_crawler *crawler, const struct breakdown_series *series, double tolerance)
{
  const struct motion motion = { .of = OF_STEADY, .crawler = *crawler };
  struct expansions e;
  struct comparison c = { &motion, &e, { .name = NULL }, NULL };
  bool found = false;
  double result = NAN;
  if (scallop_crawler_check(crawler, NULL) != SCALLOP_OK)
    return NAN;
  expansions_init(&e, &motion, series->source == FROM_DERIVED ? series->order : 6, BREAKDOWN_BITS);
  while (!found && series_item_next(&c.item, &e, series->quantity, series->order)) {
    /* of two formulas of the paper for one quantity the simpler: (27) is (26) with L_kin */
    const struct scallop_formula *f = c.item.formula;
    found = c.item.which.source == series->source && (!f || f->steady != scallop_text_steady_velocity_l0_lT);
  }
  if (found && tolerance == 0)
    result = comparison_error(&c, crawler->T);
  else if (found && (c.cache = exact_cache_new(&motion)))
    result = comparison_reach(&c, tolerance);
  free(c.cache);
  expansions_clear(&e);
  return result;
}

double breakdown_error(const struct scallop_crawler *crawler, const struct breakdown_series *series)
{
  return of_crawler(crawler, series, 0);
}

double breakdown_reach(const struct scallop_crawler *crawler, const struct breakdown_series *series, double tolerance)
{
  return of_crawler(crawler, series, tolerance);
}
