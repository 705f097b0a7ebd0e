#include "asymptotics/observed/estimate.h"

#include <math.h>

#include "asymptotics/observed/points.h"
#include "asymptotics/observed/student.h"

/* A floor this high against the largest error is no roundoff: if it holds as many points as the fit, what
 * the table converges to is not the answer, and the order on the way there decides nothing. */
static const double HIGH_FLOOR = 1e-6;
/* Pairwise orders that leave an interval wider than this on either side have not settled. */
static const double SETTLED = 0.5;
/* The longest run whose interval is no wider than this on either side is taken, and failing that the narrowest. */
static const double FINE = 0.02;
/* A fit uses at least so many points where there are as many: three can lie on a line by chance. */
enum { LEAST = 4 };

struct line {
  double slope, half_width;
};

/* Least squares of log|err| over log h on the used points from first on, and the half-width of the interval. */
static struct line fit_line(const struct scallop_order_point *points, int count, int first)
{
  double n = 0, x = 0, y = 0, xx = 0, xy = 0, residual = 0, spread = 0, earliest = NAN, latest = NAN;
  for (int i = first; i < count; i++)
    if (points[i].use == SCALLOP_ORDER_USED) {
      n++;
      x += log(points[i].h);
      y += log(fabs(points[i].err));
    }
  x /= n;
  y /= n;
  for (int i = first; i < count; i++)
    if (points[i].use == SCALLOP_ORDER_USED) {
      double dx = log(points[i].h) - x;
      xx += dx * dx;
      xy += dx * (log(fabs(points[i].err)) - y);
    }
  struct line line = { .slope = xy / xx };
  for (int i = first; i < count; i++)
    if (points[i].use == SCALLOP_ORDER_USED) {
      double r = log(fabs(points[i].err)) - y - line.slope * (log(points[i].h) - x);
      residual += r * r;
      int j = points_next(points, count, i + 1);
      if (j < count) {
        double p = points_slope(&points[i], &points[j]);
        spread = fmax(spread, fabs(p - line.slope));
        earliest = isnan(earliest) ? p : earliest;
        latest = p;
      }
    }
  line.half_width = fmax(student_quantile(0.95, (long)n - 2) * sqrt(residual / (n - 2) / xx),
                         spread + fabs(latest - earliest));
  return line;
}

static enum order_state too_few(const struct scallop_order_point *points, int count)
{
  int floor = points_count(SCALLOP_ORDER_FLOOR, points, count, 0), zero = points_count(SCALLOP_ORDER_ZERO, points, count, 0);
  bool exact = zero + floor == count && count >= 3;
  for (int i = 0; i < count; i++)
    exact &= fabs(points[i].err) <= points[i].noise;
  return exact ? ORDER_EXACT : floor > 0 ? ORDER_FLOOR_LIMITED : ORDER_INSUFFICIENT;
}

/* announced: the noise of the points is all there is, and no other floor is looked for. */
static struct order_fit estimate(struct scallop_order_point *points, int count, bool announced)
{
  struct order_fit fit = { .state = ORDER_INVALID, .order = NAN, .lo = NAN, .hi = NAN };
  if (!points_sort(points, count))
    return fit;
  points_note_pairwise(points, count);
  points_leave_out_noise(points, count);
  int onset = announced ? -1 : points_floor_onset(points, count);
  double floor = onset < 0 ? 0 : points_leave_out_floor(points, count, onset);
  points_leave_out_before_sign_change(points, count);
  if (points_count(SCALLOP_ORDER_USED, points, count, 0) < 3) {
    fit.state = too_few(points, count);
    return fit;
  }
  struct line best = { .half_width = INFINITY };
  int start = 0, all = points_count(SCALLOP_ORDER_USED, points, count, 0), least = all < LEAST ? all : LEAST;
  for (int first = 0; best.half_width > FINE && points_count(SCALLOP_ORDER_USED, points, count, first) >= least; first++) {
    struct line line = fit_line(points, count, first);
    if (points[first].use == SCALLOP_ORDER_USED && line.half_width < best.half_width) {
      best = line;
      start = first;
    }
  }
  points_leave_out_first(points, start, SCALLOP_ORDER_COARSE);
  fit.state = best.half_width <= SETTLED ? ORDER_FITTED : ORDER_NOT_ASYMPTOTIC;
  fit.order = best.slope;
  fit.lo = best.slope - best.half_width;
  fit.hi = best.slope + best.half_width;
  fit.used = points_count(SCALLOP_ORDER_USED, points, count, 0);
  if (fit.state == ORDER_FITTED && floor > HIGH_FLOOR * points_largest(points, count)
      && points_count(SCALLOP_ORDER_FLOOR, points, count, 0) >= fit.used)
    fit.state = ORDER_FLOOR_LIMITED;
  return fit;
}

struct order_fit order_estimate(struct scallop_order_point *points, int count)
{
  return estimate(points, count, points_noise_is_known(points, count));
}

struct order_fit order_estimate_values(struct scallop_order_point *points, int *count)
{
  bool announced = points_noise_is_known(points, *count);
  points_from_values(points, count);
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
