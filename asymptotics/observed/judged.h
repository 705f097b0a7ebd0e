/* A table of h and err while it is judged: what the files of this folder share. Not public. */
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

/* points.c: sorts all points by falling h; or by use, after it has been changed. */
void points_sort_by_h(struct judged *j);
void points_sort_by_use(struct judged *j);
/* Leaves out the first of the used points. */
void points_leave_out(struct judged *j, int first, enum scallop_order_use why);
/* The order between two points whose errors are not 0. */
double points_slope(const struct scallop_order_point *a, const struct scallop_order_point *b);
/* The one with so many below it of x[0..count), which becomes sorted. */
double points_ranked(double *x, int count, int rank);

/* values.c: makes errors of sorted values: points[i].err holds value(h_i), noise its rounding error if announced. On
 * return the points hold the differences v_i - v_{i+1}, rescaled to errors; the finest is spent, and j->count is what
 * is left, 0 of fewer than three. Sets the grid convergence index and the asymptotic ratio, as order.h gives them. */
void points_from_values(struct judged *j, bool announced);

/* floor.c: looks for a floor, unless the noise of the table is announced, and leaves out the points on it and near it.
 * False: the floor decides, and the verdict is set. */
bool floor_judge(struct judged *j, bool announced);
/* Leaves out what is near a floor or the roundoff of doubles, where there are enough others, and takes the rest in
 * again. False: there is nothing to leave out. */
bool floor_leave_out_near(struct judged *j);

/* What points can be, beside their use: faults. */
enum { POINT_NAN = SCALLOP_ORDER_BEFORE_SIGN_CHANGE + 1, POINT_INFINITE, POINT_NOT_POSITIVE, POINT_BAD_NOISE };
/* The words go to result->reason; what does not fit is cut off. */
void reason_add(const struct judged *j, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* How many points from first on are of this use, or have this fault. */
int reason_count(const struct judged *j, int first, int what);
/* " in row 4", " in rows 2, 5 and 7 to 9": these points, the first few of them; in the order in which they stand. */
void reason_add_rows(const struct judged *j, int first, int what);
/* "NaN in row 4; h <= 0 in rows 1 and 2": the faults, or else the uses of what is left out, each behind the word
 * before, from the second one behind between. True: there are such points. */
bool reason_add_all(const struct judged *j, bool faults, const char *before, const char *between);
/* "1.97, 1.95, 1.90": the orders between neighbours that are used, the last few of them. */
void reason_add_orders(const struct judged *j);

/* trend.c: how log|err| depends on x = log h over a run of used points: on a line, or on a line and a bend.
 *
 * The bends: a second term, err = C h^p (1 + c h^q) with the best c, of which q > 0 dies away as h -> 0 (p is the
 * limit) and q < 0 takes over; and what changes as slowly as a logarithm, a multiple of x^2 or of log|log h|. The bend
 * is taken for real if it explains so much more than it leaves that scatter would do so once in 200 times (F test), the
 * local order changes by more than a little, and the rounding of printed errors does not explain it. */
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

/* Of the used points from first on, three or more. */
struct trend trend_from(const struct judged *j, int first);

/* student.c: the t > 0 with P(|T| <= t) = share, for 0 < share < 1 and dof >= 1 degrees of freedom: to 2e-14 t, and
 * beyond 200 degrees of freedom, for share <= 0.999, to 4e-10 t. */
double student_quantile(double share, long dof);

#endif
