/* Long trajectories: where millions of periods end, in double and as a closed form in balls. Needs FLINT.
 *
 * With v* the steady start velocity, lambda the multiplier and D(v) the displacement over a period from v, a motion that keeps its modes
 * obeys v_n - v* = lambda^n d exactly where l' is made of ramps, d = v_0 - v*, and D is then a quadratic polynomial. So
 *
 *     x_n = n D(v*) + B d (1 - lambda^n)/(1 - lambda) + C d^2 (1 - lambda^(2 n))/(1 - lambda^2),
 *
 * B and C from D(v* - d), D(v*) and D(v* + d). For other gaits that holds but for terms of order d^3 and, in v_n, d^2: d is then no more
 * than the rounding of v* to a double. */
#ifndef SCALLOP_STRESS_TRAJECTORY_H
#define SCALLOP_STRESS_TRAJECTORY_H

#include "compare/stress/families.h"

enum { END_X, END_V, TRAJECTORY_ENDS };

bool trajectory_in_double(const struct stress_case *stressed, struct scallop_wide end[TRAJECTORY_ENDS]);
/* False: not certified, or the modes are not the same for all velocities of the trajectory. */
bool trajectory_in_balls(const struct stress_case *stressed, struct scallop_wide end[TRAJECTORY_ENDS]);

#endif
