/* The reason of a verdict, in words. */
#ifndef SCALLOP_ASYMPTOTICS_OBSERVED_REASON_H
#define SCALLOP_ASYMPTOTICS_OBSERVED_REASON_H

#include "asymptotics/observed/order.h"

typedef bool reason_picks(const struct scallop_order_point *points, int i);

/* A table and its verdict, while it is judged. The words go to result->reason; what does not fit is cut off. */
struct judged {
  struct scallop_order_point *points;
  int count;
  const struct scallop_order_wanted *wanted;
  struct scallop_order_result *result;
  double near_floor; /* errors below are of no use to a trend, where there are enough others */
  double level;      /* of a rough floor to which the used errors come close, else 0          */
};

void reason_add(const struct judged *j, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* " in row 4", " in rows 2, 5 and 7 to 9": the points from first to last that are picked, the first few of them. */
void reason_add_rows(const struct judged *j, reason_picks *picks, int first, int last);
/* How many points from first to last are picked. */
int reason_count(const struct judged *j, reason_picks *picks, int first, int last);
/* "1.97, 1.95, 1.90": the orders between neighbours that are used, the last few of them. */
void reason_add_orders(const struct judged *j);

#endif
