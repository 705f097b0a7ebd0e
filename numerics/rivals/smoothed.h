/* A rival (rival.h): Coulomb friction smoothed, so that the equation of motion is an ordinary, stiff one, which a
 * library's stiff solver integrates without an event to locate. With c the velocity of the centre of mass (numerics.h),
 *
 *     c' = -(F1 tanh(v1/v_delta) + F2 tanh(v2/v_delta))/M,   v1 = c - (m2/M) l',   v2 = c + (m1/M) l',   X' = c
 *
 * is integrated in (c, X) over each piece of the gait with the analytic Jacobian, which needs l'' and no higher
 * derivative. The method starts anew at each piece, as l'' may jump there. */
#ifndef SCALLOP_NUMERICS_RIVALS_SMOOTHED_H
#define SCALLOP_NUMERICS_RIVALS_SMOOTHED_H

#include "numerics/rivals/rival.h"

#ifdef __cplusplus
extern "C" {
#endif

/* GSL's implicit steppers: backward differentiation of order 1 to 5, the Bader-Deuflhard extrapolation of the
 * semi-implicit midpoint rule, and the Gauss method of order 4. */
enum scallop_smoothed_stepper { SCALLOP_SMOOTHED_MSBDF, SCALLOP_SMOOTHED_BSIMP, SCALLOP_SMOOTHED_RK4IMP };

/* delta > 0: v_delta in units of L/T, T the period. DBL_EPSILON <= tolerance <= 0.1: a step may make the error
 * tolerance * (1 + |y|), y being X/L and c tau/L, tau the duration of the phase. NULL: an argument outside of that, or
 * memory is short. Patience is asked at each step. Of the period's statuses: SCALLOP_ERANGE also where v_delta tau/L
 * underflows, or the stiffness, tau^2 (F1 + F2)/(M L) over that, overflows; SCALLOP_ECONVERGE: a step shrank to
 * nothing, or a million were not enough. evaluations: of the equation and of its Jacobian. GSL's error handler must be
 * off (gsl_set_error_handler_off).
 *
 * Errors of v_end in L/T and of the displacement in L over one period from the exact steady start, measured over 100
 * crawlers with ratios up to 25, eps = T^2 (F1 + F2)/(M L) up to 60, alpha from 0.05 to 0.95;
 * tests/numerics/rivals/test_smoothed.c holds them to bounds:
 *   of the model: at most 3.2 delta where the bodies slide (0.002 delta for half of the crawlers: it is a fraction of
 *     eps delta), and at most (1.3 + ln(1/delta)/4) delta in stick-slip: first order but for a logarithm. A body about
 *     to be released creeps at v_delta artanh(force/friction), and is (v_delta/4) ln(1/v_delta) ahead when it goes. No
 *     logarithm where l'' is constant in each piece, as in the quadratic gait: there it is released by a jump of l''.
 *   of the solver: nothing tells that it dominates. The tolerance has to be far below delta, as a stuck body's
 *     friction is known no better than its velocity over v_delta. Where it is not, the call succeeds and the answer is
 *     wrong: by 1e-3 to 1e-2 for msbdf in stick-slip at delta = 1e-6, tolerance = 1e-8.
 *       msbdf   tolerance <= 1e-6 delta leaves the error of the model, down to delta = 1e-8; 300 to 1500 steps, 0.1 to
 *               1 ms. It gives up in stick-slip where the tolerance is 100 delta: 2 crawlers of 200, after a million
 *               steps.
 *       bsimp   the same down to delta = 1e-3, at two or three times the time. Below, some crossings are leapt over
 *               whatever the tolerance: of 60 crawlers the worst error stays at 8e-4, nine in ten are within 20 delta
 *               in sliding at delta = 1e-5.
 *       rk4imp  within 4 delta down to delta = 1e-3. Below, the worst error stays at 3e-3 whatever the tolerance: the
 *               estimate is the difference of one step from two of half the length, and both see a jump that is near
 *               the middle at the middle. The method does not damp: in stick-slip the number of its steps grows as
 *               1/delta, and from delta = 1e-6 on it gives up on some crawlers after a million.
 * bsimp gives up where |c| tau/L is above 1e150, as it squares it.
 * No step is longer than 1/32 of a phase, or bsimp and rk4imp leap over crossings at delta = 1e-2 already, with errors
 * of up to 0.1. */
struct scallop_rival *scallop_smoothed_rival(enum scallop_smoothed_stepper stepper, double delta, double tolerance);

/* Inside one phase: the motion from start velocity v0, at the given times since the phase began, where steps are made
 * to end. times: count of them, rising, from 0 to the duration of the phase. rival: one of the above. A sample has t,
 * x1, x2, xC, v1, v2 and l; x1 = 0 and x2 = l where the phase begins, and positions are good to the tolerance and an
 * ulp of L. Where l' jumps the velocities are those before the jump. Return false from sampler to end early:
 * SCALLOP_STOPPED. SCALLOP_EDOMAIN also for bad times. Else the statuses of the period; below zero the samples so far
 * have been given. */
enum scallop_status scallop_smoothed_phase(struct scallop_rival *rival, const struct scallop_crawler *crawler,
                                           enum scallop_phase_kind kind, double v0,
                                           const struct scallop_patience *patience, const double *times, int count,
                                           scallop_sampler *sampler, void *context);

#ifdef __cplusplus
}
#endif

#endif
