/* The reason of a verdict, in words */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/observed/judged.h"

enum { MOST_ROWS = 6, MOST_ORDERS = 5 };

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

/* The last of the points from i on that are picked and whose rows follow each other in one direction */
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

const char *reason_add_all(const struct judged *j, bool faults, const char *before, const char *between)
{
  static const char *const words[] = {
    [SCALLOP_ORDER_ZERO] = "err is 0",
    [SCALLOP_ORDER_FLOOR] = "roundoff",
    [SCALLOP_ORDER_COARSE] = "not yet in the trend",
    [SCALLOP_ORDER_BEFORE_SIGN_CHANGE] = "before a change of sign",
    [POINT_NAN] = "NaN",
    [POINT_INFINITE] = "an infinite number",
    [POINT_NOT_POSITIVE] = "h <= 0",
    [POINT_BAD_NOISE] = "noise < 0 or NaN",
  };
  const int last = faults ? POINT_BAD_NOISE : SCALLOP_ORDER_BEFORE_SIGN_CHANGE;
  for (int what = faults ? POINT_NAN : SCALLOP_ORDER_ZERO; what <= last; what++)
    if (reason_count(j, 0, what) > 0) {
      reason_add(j, "%s%s", before, words[what]);
      reason_add_rows(j, 0, what);
      before = between;
    }
  return before;
}

void reason_add_orders(const struct judged *j)
{
  int first = j->used > MOST_ORDERS ? j->used - MOST_ORDERS - 1 : 0;
  for (int i = first; i + 1 < j->used; i++)
    reason_add(j, "%s%.3g", i == first ? "" : ", ", points_slope(&j->p[i], &j->p[i + 1]));
}
