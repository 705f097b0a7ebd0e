/* The root of a monotone and convex (or concave) function on an interval. Not public. */
#ifndef SCALLOP_ROOT_H
#define SCALLOP_ROOT_H

/* f(u), and its derivative in *slope. */
typedef double root_function(const void *context, double u, double *slope);

struct root_end {
  double u, f, slope;
};

/* The root of f between a and b to the last digit f can resolve. Needs: f monotone and without a
 * change of curvature between a and b, f(a) and f(b) of opposite sign or zero.
 * Method: a Newton step from the end where f f'' > 0, from which it cannot overshoot; then cubic
 * interpolation of the inverse function through the last two points and their slopes. Where f is nearly
 * flat at the root (grazing) and this is slow, GSL's Brent solver, and a last Newton step. */
double root_between(root_function *f, const void *context, struct root_end a, struct root_end b);

#endif
