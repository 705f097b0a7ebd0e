/* The root of a monotone and convex (or concave) function on an interval. Not public. */
#ifndef SCALLOP_NUMERICS_EVENT_ROOT_H
#define SCALLOP_NUMERICS_EVENT_ROOT_H

#include <float.h>

/* f(u), and its derivative in *slope. */
typedef double root_function(const void *context, double u, double *slope);

struct root_end {
  double u, f, slope;
};

/* The root of f between a and b to the last digit f can resolve. Needs: f monotone and without a
 * change of curvature between a and b, f(a) and f(b) of opposite sign or zero.
 * Method: a Newton step from the end where f f'' > 0, from which it cannot overshoot; then cubic
 * interpolation of the inverse function through the last two points and their slopes. Where f is nearly
 * flat at the root (grazing) and this is slow, the ITP method (itp.h), and a last Newton step. */
double root_between(root_function *f, const void *context, struct root_end a, struct root_end b);

/* A step of Newton's method so small beside the root x, at least one inflection or end of x away, that the next would
 * show only rounding: the error is then about step^2/(margin x), and rounding that of x over margin. margin: how far
 * the slopes that meet there are from being the same, in parts of their size. */
static inline double root_step(double margin)
{
  double small = 1e-9 * margin, rounding = 8 * DBL_EPSILON / margin;
  return small > rounding ? small : rounding;
}

#endif
