/* The root of a monotone and convex (or concave) function on an interval. Not public. */
#ifndef SCALLOP_ROOT_H
#define SCALLOP_ROOT_H

/* f(u), and its derivative in *slope. */
typedef double root_function(const void *context, double u, double *slope);

/* The root of f between a and b to the last digit f can resolve. Needs: f monotone and without a
 * change of curvature between a and b, f(a) and f(b) of opposite sign or zero.
 * Method: Newton from the end where f f'' > 0, from which it converges monotonically; where f is
 * nearly flat at the root (grazing) and Newton turns linear, GSL's Brent solver, then one Newton step. */
double root_between(root_function *f, const void *context, double a, double b);

#endif
