/* How log|err| depends on x = log h over a run of used points: on a line, or on a line and one term that bends it.
 *
 * The terms: h^q with q > 0, which dies away as h -> 0 (the line is the limit); h^q with q < 0, which takes over (a term of another order is
 * on its way in); and what changes as slowly as a logarithm, x^2 and log|log h|. The bend is taken for real if it explains so much more
 * than it leaves that scatter would do so once in 200 times (F test), the local order changes by more than a little, and the rounding of
 * printed errors does not explain it. */
#ifndef SCALLOP_TREND_H
#define SCALLOP_TREND_H

#include "asymptotics/observed/order.h"

enum trend_kind { TREND_STRAIGHT, TREND_SETTLING, TREND_LEAVING, TREND_CREEPING };

struct trend {
  enum trend_kind kind;
  bool rounded; /* rounding of the printed errors is all that separates them from the line */
  int points;
  double slope, half_width;            /* of the line alone, with its 95 % confidence interval                  */
  double limit, limit_half_width;      /* of the line beside the term                                           */
  double coarsest_order, finest_order; /* local, by the line and the term; the slope where it is straight       */
};

/* Of the used points[first..count), of which there are three or more. */
struct trend trend_of(const struct scallop_order_point *points, int count, int first);

#endif
