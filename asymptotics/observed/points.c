#include "asymptotics/observed/points.h"

#include <math.h>
#include <stdlib.h>

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
  if (count > 0)
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

int points_last(const struct scallop_order_point *points, int end)
{
  int last = end - 1;
  while (last >= 0 && points[last].use != SCALLOP_ORDER_USED)
    last--;
  return last;
}

int points_next(const struct scallop_order_point *points, int count, int i)
{
  while (i < count && points[i].use != SCALLOP_ORDER_USED)
    i++;
  return i;
}

bool points_noise_is_known(const struct scallop_order_point *points, int count)
{
  for (int i = 0; i < count; i++)
    if (points[i].noise > 0)
      return true;
  return false;
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
