/* The points of a table: their order, and which of them are used. */
#include <math.h>
#include <stdlib.h>

#include "asymptotics/observed/judged.h"

const char *scallop_order_use_text(enum scallop_order_use use)
{
  static const char *const text[] = { "used", "zero", "floor", "coarse", "before-sign-change" };
  return text[use];
}

static int by_falling_h(const void *a, const void *b)
{
  double x = ((const struct scallop_order_point *)a)->h, y = ((const struct scallop_order_point *)b)->h;
  return x < y ? 1 : x > y ? -1 : 0;
}

static int by_use(const void *a, const void *b)
{
  int uses = (int)((const struct scallop_order_point *)a)->use - (int)((const struct scallop_order_point *)b)->use;
  return uses != 0 ? uses : by_falling_h(a, b);
}

static int by_size(const void *a, const void *b)
{
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
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

void points_sort_by_use(struct judged *j)
{
  if (j->count > 0)
    qsort(j->p, (size_t)j->count, sizeof *j->p, by_use);
  for (j->used = 0; j->used < j->count && j->p[j->used].use == SCALLOP_ORDER_USED;)
    j->used++;
}

void points_leave_out(struct judged *j, int first, enum scallop_order_use why)
{
  for (int i = 0; i < first; i++)
    j->p[i].use = why;
  points_sort_by_use(j);
}

double points_slope(const struct scallop_order_point *a, const struct scallop_order_point *b)
{
  return log(fabs(a->err) / fabs(b->err)) / log(a->h / b->h);
}

double points_ranked(double *x, int count, int rank)
{
  qsort(x, (size_t)count, sizeof *x, by_size);
  return x[rank];
}
