/* A motion as a function of T: of a steady state the period, of one phase from velocity v0 its duration. T of the
 * crawler in it is not used, and parameters are the doubles they are. */
#ifndef SCALLOP_COMPARE_BREAKDOWN_MOTION_H
#define SCALLOP_COMPARE_BREAKDOWN_MOTION_H

#include "compare/answers/answer.h"

/* The motion at T. A phase is the half of a period: its duration is then exactly T. */
struct motion motion_at(const struct motion *motion, double T);
/* The answer in binary128 at T. A displacement that is 0 in double is 0. */
bool motion_in_wide(const struct motion *motion, double T, struct answer *answer);

/* Is it a quantity of this motion that has a series? */
bool motion_has(const struct motion *motion, enum quantity_id quantity);
/* The duration at which the Froude number is 1, and the Froude number. */
double motion_natural_time(const struct motion *motion);
double motion_froude(const struct motion *motion, double T);
/* Beyond this T nothing changes any more: the body with the larger friction rests for good. */
double motion_last_time(const struct motion *motion);

#endif
