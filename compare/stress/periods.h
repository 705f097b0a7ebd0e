/* Long trajectories: where millions of periods end.
 *
 * With v* the steady start velocity, lambda the multiplier and D(v) the displacement over a period from v, a motion
 * that keeps its modes obeys v_n - v* = lambda^n d exactly where l' is made of ramps, d = v_0 - v*, and D is then a
 * quadratic polynomial, D(v) = D(v*) + B (v - v*) + C (v - v*)^2. So
 *
 *     x_n = n D(v*) + B d (1 - lambda^n)/(1 - lambda) + C d^2 (1 - lambda^(2 n))/(1 - lambda^2),
 *
 * B and C from periods that begin |d| below and above v*. For other gaits that holds but for terms of order d^3 and, in
 * v_n, d^2: d is then no more than the rounding of v* to a double. All of it in binary128. */
#ifndef SCALLOP_COMPARE_STRESS_PERIODS_H
#define SCALLOP_COMPARE_STRESS_PERIODS_H

#include "compare/stress/stress.h"

/* The end of a trajectory: x as Q_DXC, v as Q_V_END; there are no other numbers. False: no answer; of the closed form
 * where the modes are not the same for all velocities of the trajectory. */
bool trajectory_in_double(const struct stress_case *stressed, struct answer *end);
bool trajectory_closed_form(const struct stress_case *stressed, struct answer *end);

#endif
