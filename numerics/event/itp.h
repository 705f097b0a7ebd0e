/* The root of a function in a bracket, by values alone and in hardly more of them than halving takes. Not public. */
#ifndef SCALLOP_NUMERICS_EVENT_ITP_H
#define SCALLOP_NUMERICS_EVENT_ITP_H

#include "numerics/event/root.h"

/* The root of f between a and b, finite, of one sign or 0, in either order, by the ITP method: regula falsi, its point
 * moved towards the middle of the bracket and kept so near to it that the bracket shrinks as fast as by halving.
 * Source: Oliveira & Takahashi, "An enhancement of the bisection method average performance preserving minmax
 * optimality", ACM TOMS 47(1), 2020, with their k1 = 0.2/|b - a|, k2 = 2, n0 = 1.
 *
 * Ends where f is 0 or the ends of the bracket are next to each other, and returns that of them with the smaller |f|.
 * Where f has the same sign at a and b, so that one of the values is rounding, that of a and b with the smaller |f|.
 *
 * f is evaluated at most ceil(log2(|b - a|/ulp)) + 5 times, with the ulp of the smaller of |a| and |b|: halving, both
 * ends, and three to spare. That is 57 where b = 2 a, and 1079 where a = 0 and b = 1. f need not be monotone, or
 * continuous; its slope is not used. */
double itp_root(root_function *f, const void *context, double a, double b);

#endif
