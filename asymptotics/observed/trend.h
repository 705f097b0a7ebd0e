/* How log|err| depends on x = log h over a run of used points: on a line, or on a line and a bend.
 *
 * The bends: a second term, err = C h^p (1 + c h^q) with the best c, of which q > 0 dies away as h -> 0 (p is the
 * limit) and q < 0 takes over; and what changes as slowly as a logarithm, a multiple of x^2 or of log|log h|. The bend
 * is taken for real if it explains so much more than it leaves that scatter would do so once in 200 times (F test), the
 * local order changes by more than a little, and the rounding of printed errors does not explain it. */
#ifndef SCALLOP_ASYMPTOTICS_OBSERVED_TREND_H
#define SCALLOP_ASYMPTOTICS_OBSERVED_TREND_H

#include "asymptotics/observed/order.h"

enum trend_kind { TREND_STRAIGHT, TREND_SETTLING, TREND_LEAVING, TREND_CREEPING };

struct trend {
  enum trend_kind kind;
  bool rounded;       /* rounding of the printed errors is all that separates them from the line */
  bool finest_is_off; /* but for the finest point, they are on the line */
  int points;
  double slope, half_width;            /* of the line alone, with its 95 % confidence interval                  */
  double low, high;                    /* the 95 % confidence intervals with second terms h^1 to h^4, together   */
  double limit, limit_half_width;      /* as h -> 0; the half-width spans the finest order and other good bends  */
  double coarsest_order, finest_order; /* local, by the line and the term; the slope where it is straight       */
};

/* Of three or more points by falling h. level: of a rough floor, by which errors are off; 0 for none. */
struct trend trend_of(const struct scallop_order_point *points, int count, double level);

#endif
