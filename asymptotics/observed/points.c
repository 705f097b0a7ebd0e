#include "asymptotics/observed/points.h"

#include <math.h>
#include <stdlib.h>

/* A tail is a floor if its overall order is below this, or below this share of the steeper orders before it. */
static const double FLAT = 0.5;
/* Without an order of at least this anywhere there is no floor to look for. */
static const double STEEP = 0.1;

const char *scallop_order_use_text(enum scallop_order_use use)
{
  static const char *const text[] = { "used", "zero", "floor", "coarse", "before-sign-change" };
  return text[use];
}

int points_by_size(const void *a, const void *b)
{
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

static int by_falling_h(const void *a, const void *b)
{
  double x = ((const struct scallop_order_point *)a)->h, y = ((const struct scallop_order_point *)b)->h;
  return x < y ? 1 : x > y ? -1 : 0;
}

double points_slope(const struct scallop_order_point *a, const struct scallop_order_point *b)
{
  return log(fabs(a->err) / fabs(b->err)) / log(a->h / b->h);
}

bool points_sort(struct scallop_order_point *points, int count)
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
void points_leave_out_noise(struct scallop_order_point *points, int count)
{
  bool met = false;
  for (int i = 0; i < count; i++) {
    points[i].use = SCALLOP_ORDER_USED;
    met |= points[i].noise > 0 && fabs(points[i].err) <= POINTS_ABOVE_NOISE * points[i].noise;
    if (points[i].err == 0)
      points[i].use = SCALLOP_ORDER_ZERO;
    else if (met)
      points[i].use = SCALLOP_ORDER_FLOOR;
  }
}

int points_next(const struct scallop_order_point *points, int count, int i)
{
  while (i < count && points[i].use != SCALLOP_ORDER_USED)
    i++;
  return i;
}

/* The upper quartile of the pairwise orders: how steep the table is where it is steep. */
double points_steepness(const struct scallop_order_point *points, int count)
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

bool points_noise_is_known(const struct scallop_order_point *points, int count)
{
  for (int i = 0; i < count; i++)
    if (points[i].noise > 0)
      return true;
  return false;
}

/* From onset on the errors no longer fall, though they did before. */
int points_floor_onset(const struct scallop_order_point *points, int count)
{
  double steep = points_steepness(points, count);
  int first = points_next(points, count, 0), last = count - 1;
  while (last > 0 && points[last].use != SCALLOP_ORDER_USED)
    last--;
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

double points_leave_out_floor(struct scallop_order_point *points, int count, int onset)
{
  double level = 0;
  for (int i = onset; i < count; i++)
    if (points[i].use == SCALLOP_ORDER_USED)
      level = fmax(level, fabs(points[i].err));
  for (int i = 0; i < count; i++)
    if (points[i].use == SCALLOP_ORDER_USED && (i >= onset || fabs(points[i].err) < POINTS_ABOVE_FLOOR * level))
      points[i].use = SCALLOP_ORDER_FLOOR;
  return level;
}

void points_leave_out_first(struct scallop_order_point *points, int count, enum scallop_order_use why)
{
  for (int i = 0; i < count; i++)
    if (points[i].use == SCALLOP_ORDER_USED)
      points[i].use = why;
}

void points_leave_out_before_sign_change(struct scallop_order_point *points, int count)
{
  int change = -1, before = -1;
  for (int i = points_next(points, count, 0); i < count; i = points_next(points, count, i + 1)) {
    if (before >= 0 && (points[i].err < 0) != (points[before].err < 0))
      change = i;
    before = i;
  }
  points_leave_out_first(points, change, SCALLOP_ORDER_BEFORE_SIGN_CHANGE);
}

void points_note_pairwise(struct scallop_order_point *points, int count)
{
  for (int i = 0; i < count; i++)
    points[i].pairwise = i + 1 < count && points[i].err != 0 && points[i + 1].err != 0
                             ? points_slope(&points[i], &points[i + 1])
                             : NAN;
}

int points_count(enum scallop_order_use use, const struct scallop_order_point *points, int count, int first)
{
  int n = 0;
  for (int i = first; i < count; i++)
    n += points[i].use == use;
  return n;
}

double points_largest(const struct scallop_order_point *points, int count)
{
  double most = 0;
  for (int i = 0; i < count; i++)
    most = fmax(most, fabs(points[i].err));
  return most;
}
