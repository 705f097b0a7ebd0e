/* The observed order of a table of h and err: err ~ C h^p as h -> 0.
 *
 * Method. Points are sorted by falling h. What cannot be judged is left out, each for a stated reason:
 * zeros, points at a roundoff floor, points before a change of sign, and points at large h where the
 * pairwise orders have not settled. Over what is left, log|err| is fitted by a line in log h; of all
 * runs of points that end at the finest usable one, the longest with a fine interval is taken. The
 * interval is the 95 % confidence interval of the slope, or what the pairwise orders of the run spread
 * and drift if that is wider: a trend towards the limit is not noise, and a fit alone does not see it.
 */
#ifndef SCALLOP_ESTIMATE_H
#define SCALLOP_ESTIMATE_H

#include "asymptotics/observed/order.h"

enum order_state {
  ORDER_FITTED,
  ORDER_INVALID,        /* h not positive, repeated or not finite; err not finite                    */
  ORDER_INSUFFICIENT,   /* fewer than three usable points                                            */
  ORDER_FLOOR_LIMITED,  /* fewer than three usable points, the others being at a roundoff floor; or as
                           many points as were fitted at a floor far above roundoff                  */
  ORDER_NOT_ASYMPTOTIC, /* the pairwise orders do not settle                                         */
  ORDER_EXACT           /* at least three errors, each zero or within its noise                      */
};

const char *order_state_text(enum order_state state);

struct order_fit {
  enum order_state state;
  double order, lo, hi; /* fitted, and its interval; nan unless there were three usable points        */
  int used;
};

/* Sorts points[0..count) and estimates. Allocates nothing. */
struct order_fit order_estimate(struct scallop_order_point *points, int count);

/* Values instead of errors: points[i].err holds value(h_i), noise the rounding error of the value if it is known. Three refinements
 * give one order, from (v1 - v2)/(v2 - v3) = (h1^p - h2^p)/(h2^p - h3^p), which needs no constant ratio. On return the points hold
 * the differences v_i - v_{i+1}, rescaled to errors; the finest is spent, and *count is what is left. A value is not known better
 * than to half an ulp, nor to less than the smallest difference where others are 0, and a floor above that is looked for unless
 * the noise is known. Never ORDER_EXACT. */
struct order_fit order_estimate_values(struct scallop_order_point *points, int *count);

enum order_verdict {
  ORDER_PASS,
  ORDER_TOO_LOW,
  ORDER_TOO_HIGH,
  ORDER_VERDICT_FLOOR_LIMITED,
  ORDER_VERDICT_NOT_ASYMPTOTIC,
  ORDER_VERDICT_INSUFFICIENT,
  ORDER_VERDICT_INVALID
};
const char *order_verdict_text(enum order_verdict verdict);

/* The fit against an expected order, with the given tolerance > 0. Pass: the order lies within it, and the
 * interval is no wider than it on either side; or there is no error at all (ORDER_EXACT). A wider interval that reaches it is not-asymptotic. */
enum order_verdict order_judge(const struct order_fit *fit, double expected, double tolerance);

#endif
