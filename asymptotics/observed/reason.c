#include "asymptotics/observed/reason.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/observed/points.h"

enum { MOST_ROWS = 6, MOST_ORDERS = 5 };

void reason_add(const struct judged *j, const char *format, ...)
{
  size_t used = strlen(j->result->reason);
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(j->result->reason + used, SCALLOP_ORDER_REASON - used, format, arguments);
  va_end(arguments);
}

int reason_count(const struct judged *j, reason_picks *picks, int first, int last)
{
  int picked = 0;
  for (int i = first; i <= last; i++)
    picked += picks(j->points, i);
  return picked;
}

/* The last of the points from i on that are picked and whose rows follow each other in one direction */
static int end_of_range(const struct judged *j, reason_picks *picks, int i, int last)
{
  long step = i < last ? j->points[i + 1].row - j->points[i].row : 0;
  while (labs(step) == 1 && i < last && picks(j->points, i + 1) && j->points[i + 1].row - j->points[i].row == step)
    i++;
  return i;
}

void reason_add_rows(const struct judged *j, reason_picks *picks, int first, int last)
{
  int left = reason_count(j, picks, first, last), written = 0;
  reason_add(j, left == 1 ? " in row" : " in rows");
  for (int i = first, end; i <= last && written < MOST_ROWS; i = end + 1) {
    end = i;
    if (!picks(j->points, i))
      continue;
    end = end_of_range(j, picks, i, last);
    left -= end - i + 1;
    long from = j->points[i].row, to = j->points[end].row;
    reason_add(j, "%s %ld", written == 0 ? "" : left == 0 ? " and" : ",", from < to ? from : to);
    if (end > i)
      reason_add(j, end == i + 1 ? (left == 0 && written == 0 ? " and %ld" : ", %ld") : " to %ld",
                 from < to ? to : from);
    written++;
  }
  if (left > 0)
    reason_add(j, " and %d more", left);
}

void reason_add_orders(const struct judged *j)
{
  int first = j->count, wanted = MOST_ORDERS + 1;
  while (first > 0 && wanted > 0)
    wanted -= j->points[--first].use == SCALLOP_ORDER_USED;
  const char *between = "";
  for (int i = points_next(j->points, j->count, first), k; i < j->count; i = k, between = ", ") {
    k = points_next(j->points, j->count, i + 1);
    if (k < j->count)
      reason_add(j, "%s%.3g", between, points_slope(&j->points[i], &j->points[k]));
  }
}
