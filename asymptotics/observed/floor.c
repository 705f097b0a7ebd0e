#include "asymptotics/observed/floor.h"

#include <math.h>
#include <stdlib.h>

#include "asymptotics/observed/points.h"

/* A tail is a floor if its overall order is below this, or below this share of the steeper orders before it. */
static const double FLAT = 0.5;
/* Without an order of at least this anywhere there is no floor to look for. */
static const double STEEP = 0.1;
/* Errors as small as this are near the roundoff of a quantity of order 1: a floor there is none of the method's, and where five errors are
 * larger the order is theirs. */
static const double ROUNDOFF = 1e-11, NEAR_ROUNDOFF = 1e-12;
/* An error this many times above a rough floor is off by less than a trend can show. */
static const double FAR_ABOVE = 1000;
/* As a part of the largest error. A rough floor may be this high, too: tolerances of solvers, single precision. */
static const double ROUGH = 1e-6;
/* The largest error of a plateau over its smallest: roundoff jumps. */
static const double SMOOTH = 1.5, VERY_SMOOTH = 1.2;
/* A floor is believed if the finest error is this many times what the orders before it would have made of it. */
static const double HELD_UP = 1.5;
/* An error this many times above a floor that is only seen is off by a few percent. */
static const double ABOVE_FLOOR = 30;
/* A trend takes so many points; so many are the begin of a floor. */
enum { LEAST = 4, BEGINS = 3 };

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

/* From onset on the errors no longer fall, though they did before. */
static int onset_before(const struct scallop_order_point *points, int count)
{
  double steep = steepness(points, count);
  int first = points_next(points, count, 0), last = points_last(points, count);
  if (last <= 0 || steep < STEEP)
    return -1;
  double flat = FLAT * fmin(1, steep);
  int onset = points_next(points, count, first + 1);
  while (onset < last
         && !(points_slope(&points[onset], &points[points_next(points, count, onset + 1)]) < flat
              && points_slope(&points[onset], &points[last]) < flat))
    onset = points_next(points, count, onset + 1);
  return onset < last ? onset : -1;
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

/* A floor from onset on: false if the verdict is that it is a plateau. */
static bool judge_floor(struct judged *j, int onset)
{
  double least = INFINITY, most = 0, before = INFINITY, level = 0; /* level: where it begins; roundoff may grow from there */
  int rows = 0;
  bool falling = true, rough = false; /* slower and slower; up and down */
  for (int i = onset; i < j->count; i++)
    if (is_used(j->points, i)) {
      double err = fabs(j->points[i].err);
      rough = rough || err > least;
      falling = falling && err <= least && (rows < 2 || before - least >= least - err);
      before = least;
      least = fmin(least, err);
      most = fmax(most, err);
      level = rows++ < BEGINS ? most : level;
    }
  double largest = points_largest(j->points, j->count);
  for (int i = 0; i < j->count; i++)
    if (is_used(j->points, i) && (i >= onset || fabs(j->points[i].err) < ABOVE_FLOOR * level))
      j->points[i].use = SCALLOP_ORDER_FLOOR;
  j->near_floor = fmax(j->near_floor, rough ? FAR_ABOVE * level : 0);
  if (level <= ROUNDOFF * fmax(1, largest))
    return true;
  bool high = level > ROUGH * largest;
  bool smooth = most <= (high ? SMOOTH : VERY_SMOOTH) * least || (falling && before <= VERY_SMOOTH * least);
  smooth = smooth && (high || rows > 2);
  if (!smooth && !(high && points_count(SCALLOP_ORDER_USED, j->points, j->count, 0) <= rows))
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
