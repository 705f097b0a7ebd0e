/* Functions shared by the files of this folder, on a table of h and err that is judged. Not public. */
#ifndef SCALLOP_ASYMPTOTICS_OBSERVED_JUDGED_H
#define SCALLOP_ASYMPTOTICS_OBSERVED_JUDGED_H

#include "asymptotics/observed/order.h"

/* Ratio of an error to its noise above which the error is accurate to 1 %, and its logarithm to 0.01 */
#define POINTS_ABOVE_NOISE 100.0
/* Fewest points of a trend; most orders that are sorted, of a longer table in parts */
enum { LEAST_TREND = 4, MOST_SORTED = 512 };

/* The used points are p[0..used), by falling h. The points that are left out follow, grouped by use. */
struct judged {
  struct scallop_order_point *p;
  int count, used;
  const struct scallop_order_wanted *wanted;
  struct scallop_order_result *result;
  double near_floor; /* errors below are excluded from a trend if enough others exist */
  double level;      /* of a rough floor near the used errors, else 0 */
};

/* points.c: sort all points by falling h, or by use after a change of use. */
void points_sort_by_h(struct judged *j);
void points_sort_by_use(struct judged *j);
/* Leaves out the used points p[0..first). */
void points_leave_out(struct judged *j, int first, enum scallop_order_use why);
/* Returns the order between two points with errors other than 0. */
double points_slope(const struct scallop_order_point *a, const struct scallop_order_point *b);
/* Returns the element of this rank, from 0, of x[0..count), and sorts x. */
double points_ranked(double *x, int count, int rank);

/* values.c: converts sorted values to errors: points[i].err has value(h_i), noise its rounding error if announced. On
 * return the points have the differences v_i - v_{i+1}, rescaled to errors, without the finest point; j->count is their
 * number, 0 for fewer than three values. Sets the grid convergence index and the asymptotic ratio (order.h). */
void points_from_values(struct judged *j, bool announced);

/* floor.c: looks for a floor, unless the noise of the table is announced, and leaves out the points on it and near it.
 * Returns false if the floor decides; the verdict is then set. */
bool floor_judge(struct judged *j, bool announced);
/* Leaves out the points near a floor or near the roundoff of doubles if enough others exist, and includes the rest
 * again. Returns false if no point is left out. */
bool floor_leave_out_near(struct judged *j);

/* Faults of points, beside their use */
enum { POINT_NAN = SCALLOP_ORDER_BEFORE_SIGN_CHANGE + 1, POINT_INFINITE, POINT_NOT_POSITIVE, POINT_BAD_NOISE };
/* Appends to result->reason, truncated if it is full. */
void reason_add(const struct judged *j, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* Returns the count of points from first on with this use or fault. */
int reason_count(const struct judged *j, int first, int what);
/* Appends the rows of these points, at most the first few, in their order: " in row 4", " in rows 2, 5 and 7 to 9". */
void reason_add_rows(const struct judged *j, int first, int what);
/* Appends the faults, or else the uses of the points that are left out, each after the word `before`, separated by
 * `between`: "NaN in row 4; h <= 0 in rows 1 and 2". Returns true if such points exist. */
bool reason_add_all(const struct judged *j, bool faults, const char *before, const char *between);
/* Appends the last few orders between used neighbours: "1.97, 1.95, 1.90". */
void reason_add_orders(const struct judged *j);

/* trend.c: log|err| as a function of x = log h over a run of used points: a line, or a line with a bend.
 *
 * The bends: a second term, err = C h^p (1 + c h^q) with the best c, vanishing for q > 0 as h -> 0 (p is the limit) and
 * dominant for q < 0; and terms that change as slowly as a logarithm, a multiple of x^2 or of log|log h|. A bend is
 * accepted if scatter would explain as much only once in 200 times (F test), the local order changes noticeably, and
 * rounding of printed errors does not explain it. */
enum trend_kind { TREND_STRAIGHT, TREND_SETTLING, TREND_LEAVING, TREND_CREEPING };

struct trend {
  enum trend_kind kind;
  bool rounded;       /* the rounding of the printed errors explains all differences from the line */
  bool finest_is_off; /* all points except the finest are on the line */
  int points;
  double slope, half_width;            /* of the line alone, with the half-width of its 95 % confidence interval */
  double low, high;                    /* union of the 95 % confidence intervals with second terms h^1 to h^4 */
  double limit, limit_half_width;      /* as h -> 0; the half-width includes the finest order and other good bends */
  double coarsest_order, finest_order; /* local, from the line and the term; the slope of a straight line */
};

/* Returns the trend of the used points from first on, at least three. */
struct trend trend_from(const struct judged *j, int first);

/* student.c: returns the t > 0 with P(|T| <= t) = share, for 0 < share < 1 and dof >= 1 degrees of freedom: to 2e-14 t;
 * above 200 degrees of freedom, for share <= 0.999, to 4e-10 t. */
double student_quantile(double share, long dof);

#endif
