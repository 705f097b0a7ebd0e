/* The general-purpose rival: one period of the crawler by a library ODE solver, GSL's odeiv2, with
 * adaptive steps and with the changes of mode located on the way. It is what a careful user would
 * write who has the equation of motion and a good library, and not the exact solver. It is here to be
 * compared with: the rest of numerics/ never uses it. Unlike the rest it allocates, when
 * it is made. It never prints and holds no state between calls.
 *
 *     x1'' = -(m2/M) l'' - (F1 s1 + F2 s2)/M,   x2' = x1' + l'        (the paper, section 2)
 *
 * is integrated in (x1, x1') over each smooth piece of the gait. Where a body's velocity is found to
 * have changed sign, the step is taken again up to the zero (Newton's method on the length of the step,
 * kept inside a bracket), and the forces decide whether the body reverses, goes on or sticks. The motion
 * of a stuck body needs no integration: x1' = 0, or x1' = -l'. */
#ifndef SCALLOP_NUMERICS_RIVALS_ODEIV_H
#define SCALLOP_NUMERICS_RIVALS_ODEIV_H

#include "numerics/rivals/rival.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Embedded Runge-Kutta pairs, Fehlberg 4(5), 6 evaluations a step, and Prince-Dormand 8(9), 13; and Adams's multistep
 * method of variable order 1 to 12, which starts anew after each event. A multistep method cannot take a step again
 * that is already in its memory: where an event is located Prince-Dormand takes the step, as the step control
 * allows. */
enum scallop_odeiv_stepper { SCALLOP_ODEIV_RKF45, SCALLOP_ODEIV_RK8PD, SCALLOP_ODEIV_MSADAMS };

/* Everything that needs memory, to be made once and used for any number of periods, by one thread at a
 * time. make returns NULL if stepper is not one of the list or memory is short; destroy takes NULL. */
struct scallop_odeiv;
struct scallop_odeiv *scallop_odeiv_make(enum scallop_odeiv_stepper stepper);
void scallop_odeiv_destroy(struct scallop_odeiv *odeiv);

/* One period from start velocity v0 of both bodies: extension, then contraction, as scallop_period. Any consistent
 * units; v0 finite; DBL_EPSILON <= tolerance <= 0.1. The error that each step may make is tolerance * (1 + |y|), y
 * being x1/L and x1' tau/L (tau the duration of the phase), so the tolerance is relative to L and L/tau and not to a
 * velocity that passes through zero. Events are located to a velocity of tolerance/10 or to rounding. Worst error seen
 * in a velocity: 4.5 tolerance (L/(T min(alpha, 1 - alpha)) + |v|), Adams's method 160 times that unit (at 1e-12; 40 at
 * 1e-4), and T times that in the displacement; tests/numerics/rivals/test_integrators.c holds both to a bound. So for
 * alpha near 0 or 1 it answers for few digits of a velocity of order L/T: a velocity that is small beside L/tau is lost
 * in the steps. SCALLOP_EDOMAIN: a bad crawler, v0 or tolerance. SCALLOP_ERANGE: a scaled quantity or a result over- or
 * underflows. SCALLOP_ECONVERGE: the step size shrank to nothing, or a million steps were not enough: the tolerance is
 * too near rounding. *period is untouched on failure. */
enum scallop_status scallop_odeiv_run(struct scallop_odeiv *odeiv, const struct scallop_crawler *crawler, double v0,
                                      double tolerance, struct scallop_rival_period *period);

/* The same in one call, with make and destroy inside. Also SCALLOP_EDOMAIN for a stepper that is not one
 * of the list, and SCALLOP_ECONVERGE when memory is short. */
enum scallop_status scallop_odeiv_period(const struct scallop_crawler *crawler, double v0,
                                         enum scallop_odeiv_stepper stepper, double tolerance,
                                         struct scallop_rival_period *period);

/* The same as a rival, which asks for patience at each step. NULL: memory is short, or stepper or tolerance is not what
 * the calls above allow. */
struct scallop_rival *scallop_odeiv_rival(enum scallop_odeiv_stepper stepper, double tolerance);

#ifdef __cplusplus
}
#endif

#endif
