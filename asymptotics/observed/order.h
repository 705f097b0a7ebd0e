/* The observed order of a table of h and err, and a verdict on an expected order: err ~ C h^p as h -> 0.
 *
 *     struct scallop_order_point points[] = { { .h = 0.1, .err = 0.011 }, { .h = 0.05, .err = 0.0026 },
 *                                             { .h = 0.025, .err = 6.3e-4 }, { .h = 0.0125, .err = 1.57e-4 } };
 *     struct scallop_order_wanted wanted = { .order = 2, .tolerance = 0.1 };
 *     struct scallop_order_result result;
 *     int count = 4;
 *     scallop_order(points, &count, &wanted, &result);
 *     printf("%s: %s\n", scallop_order_verdict_text(result.verdict), result.reason);
 *
 * docs/reference/order.md has the rules of the verdict, and measured rates of right and wrong verdicts. */
#ifndef SCALLOP_ASYMPTOTICS_OBSERVED_ORDER_H
#define SCALLOP_ASYMPTOTICS_OBSERVED_ORDER_H

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Use of a point, or the reason why it is left out */
enum scallop_order_use {
  SCALLOP_ORDER_USED,
  SCALLOP_ORDER_ZERO,
  SCALLOP_ORDER_FLOOR,
  SCALLOP_ORDER_COARSE,
  SCALLOP_ORDER_BEFORE_SIGN_CHANGE
};
const char *scallop_order_use_text(enum scallop_order_use use); /* returns "used", "zero", ... */

/* A row of the table */
struct scallop_order_point {
  double h;                   /* > 0                                                                    */
  double err;                 /* signed                                                                 */
  double noise;               /* rounding error of err if known, else 0 */
  long row;                   /* number of the point in a reason: a row of a table; 0: its index, from 1 */
  double pairwise;            /* out: order between this point and the next finer one; nan for the last */
  enum scallop_order_use use; /* out                                                                    */
};

/* The expected order and the tolerance */
struct scallop_order_wanted {
  double order;     /* expected order; nan: no expectation, the order is only measured */
  double tolerance; /* > 0: largest difference from the expected order, and largest half-width of the interval */
  bool at_least;    /* a higher order passes, too */
  bool values;      /* err has values; each three refinements yield one order (Richardson) */
};

enum scallop_order_verdict {
  SCALLOP_ORDER_PASS,
  SCALLOP_ORDER_MEASURED, /* no order was expected                                                          */
  SCALLOP_ORDER_TOO_LOW,
  SCALLOP_ORDER_TOO_HIGH,
  SCALLOP_ORDER_DRIFTING,      /* the local orders change with h, without a recognizable limit */
  SCALLOP_ORDER_SCATTERED,     /* the errors scatter too much for the tolerance                                   */
  SCALLOP_ORDER_PLATEAU,       /* the errors stop falling, far above roundoff                                     */
  SCALLOP_ORDER_FLOOR_LIMITED, /* too few errors are above a rough floor                                          */
  SCALLOP_ORDER_INSUFFICIENT,  /* fewer than three usable points                                                  */
  SCALLOP_ORDER_INVALID        /* h not positive, repeated or not finite; err not finite; noise negative */
};
const char *scallop_order_verdict_text(enum scallop_order_verdict verdict); /* returns "pass", "measured", ... */

/* The kind of the interval [low, high] */
enum scallop_order_interval {
  SCALLOP_ORDER_NO_INTERVAL,
  /* 95 % confidence interval of the order, including a second term C h^(p + 1) or higher hidden by the scatter */
  SCALLOP_ORDER_CONFIDENCE,
  /* 95 % confidence interval of the slope of log|err| over log h; also of the order if the errors are C h^p with
   * independent scatter of one relative size */
  SCALLOP_ORDER_SLOPE,
  /* limit of the local order, plus or minus the largest of its distances from the local order at the finest h, from the
   * limit without the coarsest point and from the limits of equally good bends, and of its 95 % half-width */
  SCALLOP_ORDER_LIMIT,
  SCALLOP_ORDER_PAIRWISE /* the pairwise orders from the smallest to the largest */
};
const char *scallop_order_interval_text(enum scallop_order_interval interval); /* returns "limit", "pairwise", ... */

enum { SCALLOP_ORDER_REASON = 400 };

/* The verdict, the order and its interval */
struct scallop_order_result {
  enum scallop_order_verdict verdict;
  double order, low, high; /* nan: unknown */
  enum scallop_order_interval interval;
  int used; /* count of points that determine the order */
  /* For values, from the three finest, with f1 the finest, r21 = h2/h1 and p from (f3 - f2)/(f2 - f1) (ASME V&V 20);
   * nan if they do not converge monotonically. gci = 1.25 |f2 - f1|/(|f1| (r21^q - 1)) with q = p; asymptotic_ratio =
   * gci_32/(r21^q gci_21) with q the expected order. Without an expected order q = p, and the ratio is |f1/f2| for any
   * values. */
  double gci, asymptotic_ratio;
  /* Reason of the verdict, one line in words */
  char reason[SCALLOP_ORDER_REASON];
};

/* Sorts points[0..*count) by falling h, sets the use of each, and judges. Values are replaced by the differences of
 * neighbours, rescaled to errors, and *count decreases by one. Allocates nothing. */
void scallop_order(struct scallop_order_point *points, int *count, const struct scallop_order_wanted *wanted,
                   struct scallop_order_result *result);

#ifdef __cplusplus
}
#endif

#endif
