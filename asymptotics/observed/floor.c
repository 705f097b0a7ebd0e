#include "asymptotics/observed/floor.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/observed/points.h"

/* A tail is a floor if its overall order is below this, or below this share of the steeper orders before it: the
 * second one of the middle one of the last FEW orders, where the rows are so far apart that noise makes none. */
static const double FLAT = 0.5, FLATTER = 0.35, APART = 1.2;
/* Without an order of at least this anywhere there is no floor to look for. */
static const double STEEP = 0.1;
/* Errors as small as this are near the roundoff of a quantity of order 1: a floor there is none of the method's, and
 * where five errors are larger the order is theirs. */
static const double ROUNDOFF = 1e-11, NEAR_ROUNDOFF = 1e-12;
/* As a part of the largest error. A rough floor may be this high, too: tolerances of solvers, single precision. */
static const double ROUGH = 1e-6;
/* A plateau: C h^p + D fits to this, relatively (C h^p + D h^q to this: no floor); the three finest errors differ by
 * this factor; or, of few rows, those at the floor, by the second one where it is low: roundoff jumps. */
static const double FITS = 0.1, FITS_WELL = 0.05, LEVEL = 1.03, SMOOTH = 1.5, VERY_SMOOTH = 1.2;
/* A floor is believed if the finest error is this many times what the orders before it would have made of it. */
static const double HELD_UP = 1.5;
/* An error this many times above a floor is off by less than a trend can show; by a few percent; by more, and where
 * no others are left it counts with less weight. */
static const double FAR_ABOVE = 1000, ABOVE_FLOOR = 30, NEAR_FLOOR = 3;
static const double LEAST_POWER = 0.5, MOST_POWER = 12, MOST_LOWER = 4, NEXT_POWER = 1.02;
/* A trend takes LEAST points; BEGINS are the begin of a floor; BEFORE it so many are fitted; ENOUGH of them are far
 * above it. */
enum { LEAST = 4, BEGINS = 3, BEFORE = 4, ENOUGH = 5, FEW = 5, MOST_FITTED = 512 };

static bool is_used(const struct scallop_order_point *p, int i) { return p[i].use == SCALLOP_ORDER_USED; }
static bool is_floor(const struct scallop_order_point *p, int i) { return p[i].use == SCALLOP_ORDER_FLOOR; }
static bool is_zero(const struct scallop_order_point *p, int i) { return p[i].use == SCALLOP_ORDER_ZERO; }

/* The upper quartile of the pairwise orders: how steep the table is where it is steep. */
static double steepness(const struct scallop_order_point *points, int count)
{
  enum { MOST = 512 };
  double slopes[MOST];
  int n = 0;
  for (int i = points_next(points, count, 0), j; i < count && n < MOST; i = j) {
    j = points_next(points, count, i + 1);
    if (j < count)
      slopes[n++] = points_slope(&points[i], &points[j]);
  }
  if (n == 0)
    return 0;
  qsort(slopes, (size_t)n, sizeof *slopes, points_by_size);
  return slopes[(3 * n) / 4];
}

/* The middle one of the last FEW slopes, 0 for fewer */
static double middle_of(const double slopes[FEW], int count)
{
  double sorted[FEW];
  if (count < FEW)
    return 0;
  memcpy(sorted, slopes, sizeof sorted);
  qsort(sorted, FEW, sizeof *sorted, points_by_size);
  return sorted[FEW / 2];
}

/* From onset on the errors no longer fall, though they did before. */
static int onset_before(const struct scallop_order_point *points, int count)
{
  double steep = steepness(points, count);
  int first = points_next(points, count, 0), last = points_last(points, count);
  if (last <= 0 || steep < STEEP)
    return -1;
  double before[FEW];
  int slopes = 0;
  for (int i = first, next; i < last; i = next) {
    next = points_next(points, count, i + 1);
    double slope = points_slope(&points[i], &points[next]);
    double flat = fmax(FLAT * fmin(1, steep), FLATTER * middle_of(before, slopes));
    if (i > first && slope < flat && points_slope(&points[i], &points[last]) < flat)
      return i;
    before[slopes % FEW] = slope;
    slopes = points[i].h > APART * points[next].h ? slopes + 1 : 0;
  }
  return -1;
}

/* Is what the points before end meet from onset on more than a pair of neighbours that noise brought together? */
static bool holds_up(const struct judged *j, int onset, int end)
{
  int last = points_last(j->points, end);
  double steep = steepness(j->points, onset + 1), fallen = points_slope(&j->points[onset], &j->points[last]);
  return (steep - fallen) * log(j->points[onset].h / j->points[last].h) > log(HELD_UP);
}

/* Where a floor begins, or -1. A rough one may have its finest point far down by chance. */
static int find_floor(const struct judged *j)
{
  for (int end = j->count; end == j->count || (end == j->count - 1 && end > LEAST); end--) {
    int onset = onset_before(j->points, end);
    if (onset >= 0 && holds_up(j, onset, end))
      return onset;
  }
  return -1;
}

/* What C h^p + D h^q with C, D > 0 and the best p > q leaves of the relative errors (root mean square), from a few
 * rows before onset on. NAN: too few rows to tell; INFINITY: D h^q is less than half of the finest error. */
static double misfit_of(const struct judged *j, int onset, double q)
{
  const struct scallop_order_point *p = j->points, *finest = &p[points_last(p, j->count)];
  int first = onset;
  for (int k = 0; k < BEFORE && points_last(p, first) >= 0; k++)
    first = points_last(p, first);
  const double n = points_count(SCALLOP_ORDER_USED, p, j->count, first);
  if (n < BEFORE + 1 || n > MOST_FITTED)
    return NAN;
  double best = INFINITY;
  for (double power = q + LEAST_POWER; power <= MOST_POWER; power *= NEXT_POWER) {
    double cc = 0, cd = 0, dd = 0, c = 0, d = 0;
    for (int i = first; i < j->count; i = points_next(p, j->count, i + 1)) {
      double x = p[i].h / finest->h, constant = pow(x, q) / fabs(p[i].err), falling = pow(x, power) / fabs(p[i].err);
      cc += falling * falling;
      cd += falling * constant;
      dd += constant * constant;
      c += falling;
      d += constant;
    }
    double C = (c * dd - d * cd) / (cc * dd - cd * cd), D = (d * cc - c * cd) / (cc * dd - cd * cd);
    if (C > 0 && D > fabs(finest->err) / 2)
      best = fmin(best, sqrt(fmax(0, n - C * c - D * d) / n));
  }
  return best;
}

/* How many used rows before end are at least so large */
static int count_above(const struct judged *j, int end, double least)
{
  int above = 0;
  for (int i = 0; i < end; i++)
    above += is_used(j->points, i) && fabs(j->points[i].err) >= least;
  return above;
}

/* The largest of the used errors from first on over the smallest */
static double spread(const struct judged *j, int first)
{
  double least = INFINITY, most = 0;
  for (int i = points_next(j->points, j->count, first); i < j->count; i = points_next(j->points, j->count, i + 1)) {
    least = fmin(least, fabs(j->points[i].err));
    most = fmax(most, fabs(j->points[i].err));
  }
  return most / least;
}

/* A floor from onset on: false if the verdict is that it is a plateau. */
static bool judge_floor(struct judged *j, int onset)
{
  double least = INFINITY, level = 0, largest = points_largest(j->points, j->count);
  int rows = 0, third = points_last(j->points, points_last(j->points, points_last(j->points, j->count)));
  bool rough = false, dense = pow(APART, j->count - 1) * j->points[j->count - 1].h > j->points[0].h;
  for (int i = onset; i < j->count; i = points_next(j->points, j->count, i + 1)) {
    double err = fabs(j->points[i].err);
    rough = rough || err > least;
    least = fmin(least, err);
    level = rows++ < BEGINS ? fmax(level, err) : level; /* where it begins: roundoff may grow from there */
  }
  bool high = level > ROUGH * largest, near_roundoff = level <= ROUNDOFF * fmax(1, largest), smooth = false;
  if (!near_roundoff) {
    double misfit = dense ? NAN : misfit_of(j, onset, 0);
    smooth = misfit < FITS || (third >= 0 && !dense && spread(j, third) <= LEVEL)
             || (high ? isnan(misfit) && spread(j, onset) <= SMOOTH : rows > 2 && spread(j, onset) <= VERY_SMOOTH);
  }
  /* a term of lower order that takes over is no floor */
  for (double q = 0.5; !rough && !smooth && !near_roundoff && q <= MOST_LOWER; q += 0.5)
    if (misfit_of(j, onset, q) < FITS_WELL)
      return true;
  bool few = !near_roundoff && !smooth && !dense && count_above(j, onset, ABOVE_FLOOR * level) < ENOUGH;
  for (int i = 0; i < j->count; i++)
    if (is_used(j->points, i) && (i >= onset || fabs(j->points[i].err) < (few ? NEAR_FLOOR : ABOVE_FLOOR) * level))
      j->points[i].use = SCALLOP_ORDER_FLOOR;
  j->level = rough && !dense ? level : 0;
  j->near_floor = fmax(j->near_floor, rough ? FAR_ABOVE * level : 0);
  int enough = !high ? 0 : dense ? rows + 1 : LEAST;
  if (near_roundoff || (!smooth && points_count(SCALLOP_ORDER_USED, j->points, j->count, 0) >= enough))
    return true;
  j->result->verdict = smooth ? SCALLOP_ORDER_PLATEAU : SCALLOP_ORDER_FLOOR_LIMITED;
  reason_add(j, "err stops falling near %.2g", least);
  reason_add_rows(j, is_floor, onset, j->count - 1);
  reason_add(j, smooth  ? ": a plateau far above roundoff"
                : rough ? ": a rough floor, with too few rows above"
                        : ": a floor, with too few rows above");
  return false;
}

bool floor_judge(struct judged *j, bool announced)
{
  j->near_floor = announced ? 0 : NEAR_ROUNDOFF;
  int onset = announced ? -1 : find_floor(j);
  return onset < 0 || judge_floor(j, onset);
}

bool floor_leave_out_near(struct judged *j)
{
  int above = 0, near = 0;
  for (int i = 0; i < j->count; i++)
    if (!is_floor(j->points, i) && !is_zero(j->points, i))
      *(fabs(j->points[i].err) >= j->near_floor ? &above : &near) += 1;
  if (above < LEAST || near == 0)
    return false;
  for (int i = 0; i < j->count; i++)
    if (!is_floor(j->points, i) && !is_zero(j->points, i))
      j->points[i].use = fabs(j->points[i].err) >= j->near_floor ? SCALLOP_ORDER_USED : SCALLOP_ORDER_FLOOR;
  *j->result->reason = '\0';
  return true;
}
