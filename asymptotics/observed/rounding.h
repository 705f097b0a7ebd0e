/* What errors were rounded to when a table was printed. */
#ifndef SCALLOP_ASYMPTOTICS_OBSERVED_ROUNDING_H
#define SCALLOP_ASYMPTOTICS_OBSERVED_ROUNDING_H

#include "asymptotics/observed/order.h"

/* Decimals with few digits: digits of the longest, and what is 1 in the last place of the smallest. unit 0: doubles. */
struct rounding {
  int digits;
  double unit;
};

/* Of the used points from first on. */
struct rounding rounding_of(const struct scallop_order_point *points, int count, int first);
/* Half a unit of the last place of err, as a part of it: of so many digits, or of so many decimals, whichever is
 * more. */
double rounding_share(const struct rounding *rounding, double err);

#endif
