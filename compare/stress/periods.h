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
#include "compare/stress/families.h"
#include "model/exact/scoped.h"

/* Two certified phases, the second from the middle of the ball that the first ends in. */
struct ball_period {
  fmpq_t v_mid; /* the start velocity of the contraction */
  arb_t v_end, displacement;
  struct scallop_modes modes[2];
};
#define BALL_PERIOD_PARTS(of) of(fmpq, s->v_mid) of(arb, s->v_end) of(arb, s->displacement)
SCOPED_PARTS(ball_period, struct ball_period, BALL_PERIOD_PARTS)
SCOPED_KIND(ball_answer, struct ball_answer)

/* False: not certified to so many digits; *why is the reason. */
bool ball_period_solve(struct ball_period *period, const struct scallop_rational_crawler *crawler, const fmpq_t v_start,
                       long digits, const char **why);

/* The middle of a ball; 0 where the ball holds 0. */
struct scallop_wide ball_middle(const arb_t x);
void ball_middle_exact(fmpq_t middle, const arb_t x);

enum { END_X, END_V, TRAJECTORY_ENDS };

bool trajectory_in_double(const struct stress_case *stressed, struct scallop_wide end[TRAJECTORY_ENDS]);
/* False: not certified, or the modes are not the same for all velocities of the trajectory. */
bool trajectory_in_balls(const struct stress_case *stressed, struct scallop_wide end[TRAJECTORY_ENDS]);

#endif
