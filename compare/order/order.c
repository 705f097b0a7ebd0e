#include "compare/order/order.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_sort.h>

#include "compare/text/halfway.h"

/* An error this many times above its noise is wrong by under 1 %, its logarithm by under 0.01. */
static const double ABOVE_NOISE = 100;
/* The same against a floor that is only seen, not known. */
static const double ABOVE_FLOOR = 30;
/* A tail is a floor if its overall order is below this, or below this share of the steeper orders before it. */
static const double FLAT = 0.5;
/* Without an order of at least this anywhere there is no floor to look for. */
static const double STEEP = 0.1;
/* A floor this high against the largest error is no roundoff: if it holds as many points as the fit, what
 * the table converges to is not the answer, and the order on the way there decides nothing. */
static const double HIGH_FLOOR = 1e-6;
/* Pairwise orders that leave an interval wider than this on either side have not settled. */
static const double SETTLED = 0.5;
/* The longest run whose interval is no wider than this on either side is taken, and failing that the narrowest. */
static const double FINE = 0.02;
/* A fit uses at least so many points where there are as many: three can lie on a line by chance. */
enum { LEAST = 4 };

const char *order_use_text(enum order_use use)
{
  static const char *const text[] = { "used", "zero", "floor", "coarse", "before-sign-change" };
  return text[use];
}

static int by_falling_h(const void *a, const void *b)
{
  double x = ((const struct order_point *)a)->h, y = ((const struct order_point *)b)->h;
  return x < y ? 1 : x > y ? -1 : 0;
}

static double slope_between(const struct order_point *a, const struct order_point *b)
{
  return log(fabs(a->err) / fabs(b->err)) / log(a->h / b->h);
}

/* Sorts, unless a point is impossible. */
static bool sorted(struct order_point *points, int count)
{
  for (int i = 0; i < count; i++)
    if (!isfinite(points[i].h) || !(points[i].h > 0) || !isfinite(points[i].err) || !(points[i].noise >= 0))
      return false;
  qsort(points, (size_t)count, sizeof *points, by_falling_h);
  for (int i = 1; i < count; i++)
    if (points[i].h == points[i - 1].h)
      return false;
  return true;
}

/* Zeros, and errors too near their known noise. Once an error has met its noise, so have all finer ones. */
static void leave_out_noise(struct order_point *points, int count)
{
  bool met = false;
  for (int i = 0; i < count; i++) {
    points[i].use = ORDER_USED;
    met |= points[i].noise > 0 && fabs(points[i].err) <= ABOVE_NOISE * points[i].noise;
    if (points[i].err == 0)
      points[i].use = ORDER_ZERO;
    else if (met)
      points[i].use = ORDER_FLOOR;
  }
}

static int next_used(const struct order_point *points, int count, int i)
{
  while (i < count && points[i].use != ORDER_USED)
    i++;
  return i;
}

/* The upper quartile of the pairwise orders: how steep the table is where it is steep. */
static double steepness(const struct order_point *points, int count)
{
  enum { MOST = 512 };
  double slopes[MOST];
  int n = 0;
  for (int i = next_used(points, count, 0), j; i < count && n < MOST; i = j) {
    j = next_used(points, count, i + 1);
    if (j < count)
      slopes[n++] = slope_between(&points[i], &points[j]);
  }
  if (n == 0)
    return 0;
  gsl_sort(slopes, 1, (size_t)n);
  return slopes[(3 * n) / 4];
}

static bool noise_is_known(const struct order_point *points, int count)
{
  for (int i = 0; i < count; i++)
    if (points[i].noise > 0)
      return true;
  return false;
}

/* A floor that nobody announced: from some point on the errors no longer fall, though they did before.
 * Returns its level, or 0. */
static double leave_out_floor(struct order_point *points, int count)
{
  double steep = steepness(points, count);
  int first = next_used(points, count, 0), last = count - 1;
  while (last > 0 && points[last].use != ORDER_USED)
    last--;
  if (last <= 0 || steep < STEEP)
    return 0;
  double flat = FLAT * fmin(1, steep), level = 0;
  int onset = next_used(points, count, first + 1);
  while (onset < last
         && !(slope_between(&points[onset], &points[next_used(points, count, onset + 1)]) < flat
              && slope_between(&points[onset], &points[last]) < flat))
    onset = next_used(points, count, onset + 1);
  if (onset >= last)
    return 0;
  for (int i = onset; i < count; i++)
    if (points[i].use == ORDER_USED)
      level = fmax(level, fabs(points[i].err));
  for (int i = 0; i < count; i++)
    if (points[i].use == ORDER_USED && (i >= onset || fabs(points[i].err) < ABOVE_FLOOR * level))
      points[i].use = ORDER_FLOOR;
  return level;
}

static void leave_out_first(struct order_point *points, int count, enum order_use why)
{
  for (int i = 0; i < count; i++)
    if (points[i].use == ORDER_USED)
      points[i].use = why;
}

static void leave_out_before_sign_change(struct order_point *points, int count)
{
  int change = -1, before = -1;
  for (int i = next_used(points, count, 0); i < count; i = next_used(points, count, i + 1)) {
    if (before >= 0 && (points[i].err < 0) != (points[before].err < 0))
      change = i;
    before = i;
  }
  leave_out_first(points, change, ORDER_BEFORE_SIGN_CHANGE);
}

struct line {
  double slope, half_width;
};

/* Least squares of log|err| over log h on the used points from first on, and the half-width of the interval. */
static struct line fit_line(const struct order_point *points, int count, int first)
{
  double n = 0, x = 0, y = 0, xx = 0, xy = 0, residual = 0, spread = 0, earliest = NAN, latest = NAN;
  for (int i = first; i < count; i++)
    if (points[i].use == ORDER_USED) {
      n++;
      x += log(points[i].h);
      y += log(fabs(points[i].err));
    }
  x /= n;
  y /= n;
  for (int i = first; i < count; i++)
    if (points[i].use == ORDER_USED) {
      double dx = log(points[i].h) - x;
      xx += dx * dx;
      xy += dx * (log(fabs(points[i].err)) - y);
    }
  struct line line = { .slope = xy / xx };
  for (int i = first; i < count; i++)
    if (points[i].use == ORDER_USED) {
      double r = log(fabs(points[i].err)) - y - line.slope * (log(points[i].h) - x);
      residual += r * r;
      int j = next_used(points, count, i + 1);
      if (j < count) {
        double p = slope_between(&points[i], &points[j]);
        spread = fmax(spread, fabs(p - line.slope));
        earliest = isnan(earliest) ? p : earliest;
        latest = p;
      }
    }
  line.half_width = fmax(gsl_cdf_tdist_Pinv(0.975, n - 2) * sqrt(residual / (n - 2) / xx), spread + fabs(latest - earliest));
  return line;
}

static int count_of(enum order_use use, const struct order_point *points, int count, int first)
{
  int n = 0;
  for (int i = first; i < count; i++)
    n += points[i].use == use;
  return n;
}

static void note_pairwise(struct order_point *points, int count)
{
  for (int i = 0; i < count; i++)
    points[i].pairwise = i + 1 < count && points[i].err != 0 && points[i + 1].err != 0
                             ? slope_between(&points[i], &points[i + 1])
                             : NAN;
}

static enum order_state too_few(const struct order_point *points, int count)
{
  int floor = count_of(ORDER_FLOOR, points, count, 0), zero = count_of(ORDER_ZERO, points, count, 0);
  bool exact = zero + floor == count && count >= 3;
  for (int i = 0; i < count; i++)
    exact &= fabs(points[i].err) <= points[i].noise;
  return exact ? ORDER_EXACT : floor > 0 ? ORDER_FLOOR_LIMITED : ORDER_INSUFFICIENT;
}

static double largest(const struct order_point *points, int count)
{
  double most = 0;
  for (int i = 0; i < count; i++)
    most = fmax(most, fabs(points[i].err));
  return most;
}

/* announced: the noise of the points is all there is, and no other floor is looked for. */
static struct order_fit estimate(struct order_point *points, int count, bool announced)
{
  struct order_fit fit = { .state = ORDER_INVALID, .order = NAN, .lo = NAN, .hi = NAN };
  if (!sorted(points, count))
    return fit;
  note_pairwise(points, count);
  leave_out_noise(points, count);
  double floor = announced ? 0 : leave_out_floor(points, count);
  leave_out_before_sign_change(points, count);
  if (count_of(ORDER_USED, points, count, 0) < 3) {
    fit.state = too_few(points, count);
    return fit;
  }
  struct line best = { .half_width = INFINITY };
  int start = 0, all = count_of(ORDER_USED, points, count, 0), least = all < LEAST ? all : LEAST;
  for (int first = 0; best.half_width > FINE && count_of(ORDER_USED, points, count, first) >= least; first++) {
    struct line line = fit_line(points, count, first);
    if (points[first].use == ORDER_USED && line.half_width < best.half_width) {
      best = line;
      start = first;
    }
  }
  leave_out_first(points, start, ORDER_COARSE);
  fit.state = best.half_width <= SETTLED ? ORDER_FITTED : ORDER_NOT_ASYMPTOTIC;
  fit.order = best.slope;
  fit.lo = best.slope - best.half_width;
  fit.hi = best.slope + best.half_width;
  fit.used = count_of(ORDER_USED, points, count, 0);
  if (fit.state == ORDER_FITTED && floor > HIGH_FLOOR * largest(points, count)
      && count_of(ORDER_FLOOR, points, count, 0) >= fit.used)
    fit.state = ORDER_FLOOR_LIMITED;
  return fit;
}

struct order_fit order_estimate(struct order_point *points, int count)
{
  return estimate(points, count, noise_is_known(points, count));
}

/* (h1^p - h2^p)/(h2^p - h3^p) with h1 > h2 > h3: rises with p from log(h1/h2)/log(h2/h3) at p = 0. */
static double difference_ratio(double p, double h1, double h2, double h3)
{
  double a = log(h1 / h2), b = log(h2 / h3);
  return p == 0 ? a / b : exp(p * a) * -expm1(-p * a) / -expm1(-p * b);
}

static double order_of_three(const struct order_point *p)
{
  double ratio = (p[0].err - p[1].err) / (p[1].err - p[2].err);
  double low = -50, high = 50;
  if (!(ratio > 0) || !isfinite(ratio))
    return NAN;
  for (double mid; halfway(&mid, low, high);) /* the ratio is monotone in p */
    *(difference_ratio(mid, p[0].h, p[1].h, p[2].h) < ratio ? &low : &high) = mid;
  return low;
}

/* What the differences of values that are doubles are wrong by, and where a difference is 0 what the values are resolved to: no
 * difference other than 0 is smaller than that. */
static void note_noise(struct order_point *values, int count)
{
  double least = INFINITY;
  bool repeated = false;
  for (int i = 0; i + 1 < count; i++) {
    double difference = fabs(values[i].err - values[i + 1].err);
    repeated |= difference == 0;
    least = difference > 0 ? fmin(least, difference) : least;
  }
  double resolved = repeated && isfinite(least) ? least * ABOVE_FLOOR / ABOVE_NOISE : 0;
  for (int i = 0; i < count; i++)
    values[i].noise = fmax(DBL_EPSILON / 2 * fabs(values[i].err), resolved / 2);
}

static bool is_above_noise(const struct order_point *values)
{
  return fabs(values[0].err - values[1].err) > ABOVE_NOISE * (values[0].noise + values[1].noise);
}

/* The middle one of the orders that three values each give, or 1 */
static double middle_order(const struct order_point *values, int count)
{
  enum { MOST = 512 };
  double orders[MOST];
  int n = 0;
  for (int i = 0; i + 2 < count && n < MOST; i++) {
    double here = is_above_noise(&values[i]) && is_above_noise(&values[i + 1]) ? order_of_three(&values[i]) : NAN;
    if (isfinite(here) && fabs(here) < 49)
      orders[n++] = here;
  }
  if (n == 0)
    return 1;
  gsl_sort(orders, 1, (size_t)n);
  return orders[n / 2];
}

struct order_fit order_estimate_values(struct order_point *points, int *count)
{
  bool announced = noise_is_known(points, *count);
  if (*count < 3 || !sorted(points, *count)) {
    *count = *count < 3 ? 0 : *count;
    return estimate(points, *count, announced);
  }
  if (!announced)
    note_noise(points, *count);
  double p = middle_order(points, *count);
  --*count;
  /* v_i - v_{i+1} = C (h_i^p - h_{i+1}^p): divided by 1 - (h_{i+1}/h_i)^p it is C h_i^p */
  for (int i = 0; i < *count; i++) {
    double share = -expm1(-p * log(points[i].h / points[i + 1].h));
    points[i].err = (points[i].err - points[i + 1].err) / share;
    points[i].noise = (points[i].noise + points[i + 1].noise) / fabs(share);
  }
  struct order_fit fit = estimate(points, *count, announced);
  if (fit.state == ORDER_EXACT) /* values that stay the same: of their error nothing is known */
    fit.state = ORDER_FLOOR_LIMITED;
  return fit;
}

const char *order_state_text(enum order_state state)
{
  static const char *const text[] = { "fitted", "invalid", "insufficient", "floor-limited", "not-asymptotic", "exact" };
  return text[state];
}

const char *order_verdict_text(enum order_verdict verdict)
{
  static const char *const text[] = { "pass",           "too-low",      "too-high", "floor-limited",
                                      "not-asymptotic", "insufficient", "invalid" };
  return text[verdict];
}

enum order_verdict order_judge(const struct order_fit *fit, double expected, double tolerance)
{
  static const enum order_verdict unfitted[] = { [ORDER_INVALID] = ORDER_VERDICT_INVALID,
                                                 [ORDER_INSUFFICIENT] = ORDER_VERDICT_INSUFFICIENT,
                                                 [ORDER_EXACT] = ORDER_PASS,
                                                 [ORDER_FLOOR_LIMITED] = ORDER_VERDICT_FLOOR_LIMITED,
                                                 [ORDER_NOT_ASYMPTOTIC] = ORDER_VERDICT_NOT_ASYMPTOTIC };
  if (fit->state != ORDER_FITTED)
    return unfitted[fit->state];
  double off = fit->order - expected, half_width = fit->hi - fit->order;
  if (half_width > tolerance && fabs(off) <= half_width + tolerance)
    return ORDER_VERDICT_NOT_ASYMPTOTIC;
  return off < -tolerance ? ORDER_TOO_LOW : off > tolerance ? ORDER_TOO_HIGH : ORDER_PASS;
}
