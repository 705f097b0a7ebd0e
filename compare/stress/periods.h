/* Periods from a given start velocity in balls, and long trajectories: where millions of periods end. Needs FLINT.
 *
 * With v* the steady start velocity, lambda the multiplier and D(v) the displacement over a period from v, a motion
 * that keeps its modes obeys v_n - v* = lambda^n d exactly where l' is made of ramps, d = v_0 - v*, and D is then a
 * quadratic polynomial. So
 *
 *     x_n = n D(v*) + B d (1 - lambda^n)/(1 - lambda) + C d^2 (1 - lambda^(2 n))/(1 - lambda^2),
 *
 * B and C from D(v* - d), D(v*) and D(v* + d). For other gaits that holds but for terms of order d^3 and, in v_n, d^2:
 * d is then no more than the rounding of v* to a double. */
#ifndef SCALLOP_COMPARE_STRESS_PERIODS_H
#define SCALLOP_COMPARE_STRESS_PERIODS_H

#include "compare/answers/answer_flint.h"
#include "compare/stress/stress.h"
#include "model/exact/scoped.h"

/* The middle of a ball; 0 where the ball holds 0. */
struct scallop_wide ball_middle(const arb_t x);

/* Two certified phases, the second from the middle of the ball that the first ends in; first has the modes of both.
 * False: one of them is not certified. */
bool period_in_balls(struct ball_answer *first, struct ball_answer *second, arb_t displacement,
                     const struct scallop_rational_crawler *crawler, const fmpq_t v_start);

/* The end of a trajectory: x as Q_DXC, v as Q_V_END; there are no other numbers. False: no answer; in balls where it is
 * not certified, or the modes are not the same for all velocities of the trajectory. */
bool trajectory_in_double(const struct stress_case *stressed, struct answer *end);
bool trajectory_in_balls(const struct stress_case *stressed, struct answer *end);

#endif
