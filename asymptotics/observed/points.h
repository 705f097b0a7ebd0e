/* Points of a table of h and err: their order, and which of them can be judged. A point is used unless something here
 * leaves it out. */
#ifndef SCALLOP_ASYMPTOTICS_OBSERVED_POINTS_H
#define SCALLOP_ASYMPTOTICS_OBSERVED_POINTS_H

#include <stdbool.h>

#include "asymptotics/observed/order.h"

/* An error this many times above its noise is wrong by under 1 %, its logarithm by under 0.01. */
#define POINTS_ABOVE_NOISE 100.0

/* Compares two doubles, neither nan, for qsort. */
int points_by_size(const void *a, const void *b);

/* Sorts by falling h. False: an h is not positive, not finite or repeated, an err not finite, or a noise negative or
 * nan. */
bool points_sort(struct scallop_order_point *points, int count);
/* Sets the order between each point and the next. */
void points_note_pairwise(struct scallop_order_point *points, int count);

/* The order between two points whose errors are not 0. */
double points_slope(const struct scallop_order_point *a, const struct scallop_order_point *b);
/* The first used point from i on, or count. */
int points_next(const struct scallop_order_point *points, int count, int i);
/* The last used point before end, or -1. */
int points_last(const struct scallop_order_point *points, int end);
/* How many points from first on are of this use. */
int points_count(enum scallop_order_use use, const struct scallop_order_point *points, int count, int first);
/* The largest |err|. */
double points_largest(const struct scallop_order_point *points, int count);
bool points_noise_is_known(const struct scallop_order_point *points, int count);

/* Sets the use of all points: zeros, and errors too near their known noise. Once an error has met its noise, so have
 * all finer ones. */
void points_leave_out_noise(struct scallop_order_point *points, int count);
void points_leave_out_first(struct scallop_order_point *points, int first, enum scallop_order_use why);
void points_leave_out_before_sign_change(struct scallop_order_point *points, int count);

/* Makes errors of values: points[i].err holds value(h_i), noise the rounding error of the value if it is known. Three
 * refinements give one order, from (v1 - v2)/(v2 - v3) = (h1^p - h2^p)/(h2^p - h3^p), which needs no constant ratio. On
 * return the points hold the differences v_i - v_{i+1}, rescaled to errors; the finest is spent, and *count is what is
 * left. A value is not known better than to half an ulp, nor to less than the smallest difference where others are
 * 0. */
void points_from_values(struct scallop_order_point *points, int *count);
/* The order that three values give, or nan. */
double points_order_of_three(const struct scallop_order_point *values);

/* The grid convergence index and the asymptotic ratio of sorted values, as order.h gives them: nan unless there are
 * three that converge. */
void points_grid_convergence(const struct scallop_order_point *values, int count, double expected, double *gci,
                             double *asymptotic_ratio);

#endif
