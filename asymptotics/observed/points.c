/* The points of a table: their order, their use, and their description in a reason. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/observed/judged.h"

enum { MOST_ROWS = 6, MOST_ORDERS = 5 };

const char *scallop_order_use_text(enum scallop_order_use use)
{
  static const char *const text[] = { "used", "zero", "floor", "coarse", "before-sign-change" };
  return text[use];
}

/* Compares by h; nan comes last. */
static int by_falling_h(const void *a, const void *b)
{
  double x = ((const struct scallop_order_point *)a)->h, y = ((const struct scallop_order_point *)b)->h;
  return x < y ? 1 : x > y ? -1 : (isnan(x) != 0) - (isnan(y) != 0);
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

void points_sort_by_h(struct judged *j)
{
  if (j->count > 0)
    qsort(j->p, (size_t)j->count, sizeof *j->p, by_falling_h);
}

void points_sort_by_use(struct judged *j)
{
  if (j->count > 0)
    qsort(j->p, (size_t)j->count, sizeof *j->p, by_use);
  j->used = reason_count(j, 0, SCALLOP_ORDER_USED);
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

void reason_add(const struct judged *j, const char *format, ...)
{
  size_t used = strlen(j->result->reason);
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(j->result->reason + used, SCALLOP_ORDER_REASON - used, format, arguments);
  va_end(arguments);
}

static bool is(const struct scallop_order_point *p, int what)
{
  switch (what) {
  case POINT_NAN: return isnan(p->err) || isnan(p->h);
  case POINT_INFINITE: return isinf(p->err) || isinf(p->h);
  case POINT_NOT_POSITIVE: return p->h <= 0;
  case POINT_BAD_NOISE: return !(p->noise >= 0);
  default: return (int)p->use == what;
  }
}

int reason_count(const struct judged *j, int first, int what)
{
  int picked = 0;
  for (int i = first; i < j->count; i++)
    picked += is(&j->p[i], what);
  return picked;
}

/* Returns the last of the selected points from i on with consecutive rows in one direction. */
static int end_of_range(const struct judged *j, int i, int what)
{
  long step = i + 1 < j->count ? j->p[i + 1].row - j->p[i].row : 0;
  while (labs(step) == 1 && i + 1 < j->count && is(&j->p[i + 1], what) && j->p[i + 1].row - j->p[i].row == step)
    i++;
  return i;
}

void reason_add_rows(const struct judged *j, int first, int what)
{
  int left = reason_count(j, first, what), written = 0;
  reason_add(j, left == 1 ? " in row" : " in rows");
  for (int i = first, end; i < j->count && written < MOST_ROWS; i = end + 1) {
    end = i;
    if (!is(&j->p[i], what))
      continue;
    end = end_of_range(j, i, what);
    left -= end - i + 1;
    long from = j->p[i].row, to = j->p[end].row;
    reason_add(j, "%s %ld", written == 0 ? "" : left == 0 ? " and" : ",", from < to ? from : to);
    if (end > i)
      reason_add(j, end == i + 1 ? (left == 0 && written == 0 ? " and %ld" : ", %ld") : " to %ld",
                 from < to ? to : from);
    written++;
  }
  if (left > 0)
    reason_add(j, " and %d more", left);
}

bool reason_add_all(const struct judged *j, bool faults, const char *before, const char *between)
{
  static const char *const words[] = {
    /* by use, then by fault */
    "used", "err is 0",           "roundoff", "not yet in the trend", "before a change of sign",
    "NaN",  "an infinite number", "h <= 0",   "noise < 0 or NaN"
  };
  const int first = faults ? (int)POINT_NAN : (int)SCALLOP_ORDER_ZERO;
  const int last = faults ? (int)POINT_BAD_NOISE : (int)SCALLOP_ORDER_BEFORE_SIGN_CHANGE;
  bool any = false;
  for (int what = first; what <= last; what++)
    if (reason_count(j, 0, what) > 0) {
      reason_add(j, "%s%s", any ? between : before, words[what]);
      reason_add_rows(j, 0, what);
      any = true;
    }
  return any;
}

void reason_add_orders(const struct judged *j)
{
  int first = j->used > MOST_ORDERS ? j->used - MOST_ORDERS - 1 : 0;
  for (int i = first; i + 1 < j->used; i++)
    reason_add(j, "%s%.3g", i == first ? "" : ", ", points_slope(&j->p[i], &j->p[i + 1]));
}
