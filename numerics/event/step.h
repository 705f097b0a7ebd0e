/* When Newton's method for the crossings of a line with a curve ends. Not public. */
#ifndef SCALLOP_NUMERICS_EVENT_STEP_H
#define SCALLOP_NUMERICS_EVENT_STEP_H

#include <float.h>

/* How far two slopes that meet are from being the same, in parts of their size */
static inline double step_margin(double steep, double slope)
{
  return fabs(steep - slope) / (fabs(steep) + fabs(slope));
}

/* A step so small beside the root x, at least one inflection or end of x away, that the next would show only rounding:
 * the error is then about step^2/(margin x), and rounding that of x over margin. */
static inline bool step_is_last(double step, double x, double margin)
{
  double small = 1e-9 * margin, rounding = 8 * DBL_EPSILON / margin;
  return fabs(step) <= (small > rounding ? small : rounding) * x;
}

#endif
