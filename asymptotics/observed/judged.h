/* A table of h and err while it is judged, and what the files of this folder know of it. */
#ifndef SCALLOP_ASYMPTOTICS_OBSERVED_JUDGED_H
#define SCALLOP_ASYMPTOTICS_OBSERVED_JUDGED_H

#include "asymptotics/observed/order.h"

/* An error this many times above its noise is wrong by under 1 %, its logarithm by under 0.01. */
#define POINTS_ABOVE_NOISE 100.0
/* A trend takes so many points; orders of long tables are sorted so many at a time. */
enum { LEAST_TREND = 4, MOST_SORTED = 512 };

/* The used points are p[0..used), by falling h; then come those that are left out, use by use. */
struct judged {
  struct scallop_order_point *p;
  int count, used;
  const struct scallop_order_wanted *wanted;
  struct scallop_order_result *result;
  double near_floor; /* errors below are of no use to a trend, where there are enough others */
  double level;      /* of a rough floor to which the used errors come close, else 0          */
};

/* Sorts by falling h. False: an h is not positive, not finite or repeated, an err not finite, or a noise negative or
 * nan. */
bool points_sort(struct scallop_order_point *points, int count);
/* Sorts by use, after it has been changed. */
void points_sort_by_use(struct judged *j);
/* Leaves out the first of the used points. */
void points_leave_out(struct judged *j, int first, enum scallop_order_use why);
/* The order between two points whose errors are not 0. */
double points_slope(const struct scallop_order_point *a, const struct scallop_order_point *b);
/* The one with so many below it of x[0..count), which becomes sorted. */
double points_ranked(double *x, int count, int rank);

/* values.c: makes errors of sorted values: points[i].err holds value(h_i), noise its rounding error if announced. Three
 * refinements give one order, from (v1 - v2)/(v2 - v3) = (h1^p - h2^p)/(h2^p - h3^p), which needs no constant ratio. On
 * return the points hold the differences v_i - v_{i+1}, rescaled to errors; the finest is spent, and *count is what is
 * left, 0 of fewer than three. A value is not known better than to half an ulp, nor to less than the smallest
 * difference where others are 0. Sets the grid convergence index and the asymptotic ratio, as order.h gives them. */
void points_from_values(struct judged *j, bool announced);

/* floor.c: floors are where errors that fell no longer fall. A rough one is roundoff, or the tolerance of a solver: the
 * points on it and near it are left out. A smooth one far above roundoff is a plateau: the table converges to something
 * else, and that is its verdict. Looks for one, unless the noise of the table is announced. False: it decides, and the
 * verdict is set. */
bool floor_judge(struct judged *j, bool announced);
/* Leaves out what is near a floor or the roundoff of doubles, where there are enough others, and takes the rest in
 * again. False: there is nothing to leave out. */
bool floor_leave_out_near(struct judged *j);

/* reason.c: what points can be, beside their use: faults. */
enum { POINT_NAN = SCALLOP_ORDER_BEFORE_SIGN_CHANGE + 1, POINT_INFINITE, POINT_NOT_POSITIVE, POINT_BAD_NOISE };
/* The words go to result->reason; what does not fit is cut off. */
void reason_add(const struct judged *j, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* How many points from first on are of this use, or have this fault. */
int reason_count(const struct judged *j, int first, int what);
/* " in row 4", " in rows 2, 5 and 7 to 9": these points, the first few of them; in the order in which they stand. */
void reason_add_rows(const struct judged *j, int first, int what);
/* "NaN in row 4; h <= 0 in rows 1 and 2": the faults, or else the uses of what is left out, each behind the word
 * before, from the second one behind between. Returns the word that would come before the next one. */
const char *reason_add_all(const struct judged *j, bool faults, const char *before, const char *between);
/* "1.97, 1.95, 1.90": the orders between neighbours that are used, the last few of them. */
void reason_add_orders(const struct judged *j);

#endif
