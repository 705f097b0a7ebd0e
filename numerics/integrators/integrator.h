/* General-purpose integrators behind one interface, for comparison with the exact solver. A user with the
 * equation of motion and a good library would take them. The rest of numerics/ never uses them.
 *
 * An integrator is a period map: from the start velocity v0 it computes the velocities and the displacement after one
 * period. Its steady state is found as its user would find it: by simulating periods until they repeat, or as the root
 * of the map. Integrators allocate memory when they are made; they print nothing and hold no state between calls. */
#ifndef SCALLOP_NUMERICS_INTEGRATORS_INTEGRATOR_H
#define SCALLOP_NUMERICS_INTEGRATORS_INTEGRATOR_H

#include "numerics/numerics.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A function that an integrator calls before each step and each period: it returns whether to continue. If it returns
 * false, a period ends with SCALLOP_ESTOPPED, and a search for the steady state with SCALLOP_STOPPED. A NULL pointer
 * instead of the struct sets no limit. */
struct scallop_patience {
  bool (*lasts)(void *context);
  void *context;
};

struct scallop_integrator_period {
  double v_mid, v_end; /* velocity after the extension and after the contraction                  */
  double displacement; /* of the geometric centre over the period                                 */
  long steps;          /* steps tried: accepted, rejected, and taken again to locate an event     */
  long evaluations;    /* of the equation of motion, and so of the gait                           */
  long events;         /* changes of mode that were located; 0 for methods that know no events    */
};

struct scallop_integrator {
  /* Solves one period, extension then contraction, from start velocity v0 of both bodies, any finite number. On failure
   * *period is unchanged. SCALLOP_EDOMAIN: a bad crawler or v0; SCALLOP_ERANGE: a scaled quantity or a result overflows
   * or underflows; SCALLOP_ECONVERGE: the method gave up, for instance because its step shrank to nothing;
   * SCALLOP_ESTOPPED: patience ended it. */
  enum scallop_status (*period)(struct scallop_integrator *self, const struct scallop_crawler *crawler, double v0,
                                const struct scallop_patience *patience, struct scallop_integrator_period *period);
  void (*destroy)(struct scallop_integrator *self);
};
void scallop_integrator_destroy(struct scallop_integrator *integrator); /* NULL is allowed */

struct scallop_integrator_steady {
  double v_start, displacement; /* displacement: nan if no period was completed                        */
  long periods;                 /* solved                                                              */
  long root_iterations;         /* 0 for a simulation                                                  */
  long steps, evaluations, events;
};

/* Simulates periods from start velocity v0. It ends when the estimated distance to the steady state and the last change
 * of v are both at most tolerance * (L/T + |v|), tolerance >= 0. Here steady state means the fixed point of the
 * integrator's own map; it differs from the exact steady state by the error of a period over 1 - multiplier.
 *
 * Let m be the ratio of the last two changes of v. The estimate is change m/(1 - m), with one rounding error added to
 * the change. A change is taken over a stride of 1, then 2, 4, 8, ... periods, with 16 changes of each stride, because
 * a single period changes v too little to determine m if 1 - m is small. While friction alone slows the crawler, v
 * changes by a constant (m = 1), and the simulation continues. The number of periods grows as log(1/tolerance)/(1 -
 * multiplier), that is as 1/T^2 for T -> 0; only patience limits it.
 *
 * If the rounding noise of the map exceeds the tolerance, the simulation ends at the noise, with SCALLOP_OK too: when a
 * period or a stride returns the same v that it was given, or when the changes have altered their sign 8 times. The
 * changes of the motion itself keep their sign.
 *
 * v_start is the last v_end; displacement belongs to the last period, whose start velocity was nearly v_start.
 * SCALLOP_STOPPED: patience ended it, and *steady has the state of the last complete period. SCALLOP_EDOMAIN: a bad
 * crawler, v0 or tolerance. Other statuses are those of the period. If the status is negative, *steady is unchanged. */
enum scallop_status scallop_integrator_simulate(struct scallop_integrator *integrator,
                                                const struct scallop_crawler *crawler, double v0, double tolerance,
                                                const struct scallop_patience *patience,
                                                struct scallop_integrator_steady *steady);

/* Finds the root of v_end - v_start by GSL's Brent solver; the caller must have called gsl_set_error_handler_off. The
 * first bracket is 1.01 times the velocities at which l' can still reverse a body. The search ends when the bracket is
 * no wider than tolerance * (L/T + |v|), tolerance >= 0, with DBL_EPSILON for a smaller tolerance. One period changes v
 * by a part 1 - multiplier of its distance from the root, O(T^2) for T -> 0; so the root has the error of the period
 * divided by this number. If the noise of the map exceeds the tolerance, the result is one of several roots due to
 * noise. v_start is a velocity that was tried, and displacement belongs to its period.
 *
 * SCALLOP_ECONVERGE: memory is short; or at an end of the bracket the map does not slow the crawler down, as friction
 * must. In the second case the error of the map exceeds the effect of friction in a period, and the map contains no
 * information about the steady state. SCALLOP_STOPPED: patience ended it; *steady has the state reached, with v_start
 * and displacement nan until both ends of the bracket are known. Other statuses as above. */
enum scallop_status scallop_integrator_root(struct scallop_integrator *integrator,
                                            const struct scallop_crawler *crawler, double tolerance,
                                            const struct scallop_patience *patience,
                                            struct scallop_integrator_steady *steady);

/* ---- Integrators that locate events. If the velocity of a body has changed its sign in a step, the step is repeated
 * up to the zero, and the forces decide whether the body reverses, continues or sticks. The motion with a stuck body
 * needs no integration: x1' = 0 or x1' = -l'. Between events
 *
 *     x1'' = -(m2/M) l'' - (F1 s1 + F2 s2)/M,   x2' = x1' + l'        (the paper, section 2)
 *
 * is integrated in (x1, x1') over each smooth piece of the gait; s1 and s2 are the directions of the bodies. A step may
 * have the error tolerance * (1 + |y|), where y is x1/L or x1' tau/L, and tau is the duration of the phase. So the
 * tolerance is relative to L and L/tau, and a velocity far below L/tau has no relative accuracy. DBL_EPSILON <=
 * tolerance <= 0.1. Patience is asked at each step. SCALLOP_ECONVERGE: the step shrank to nothing, or a million steps
 * were not enough; the tolerance is then too close to rounding. The worst errors below are measured;
 * tests/numerics/integrators/test_integrators.c tests them against bounds. */

/* GSL's odeiv2, embedded Runge-Kutta pairs: Fehlberg 4(5) with 6 evaluations in a step, and Prince-Dormand 8(9) with
 * 13. Newton's method for the length of the step, kept inside a bracket, locates events to a velocity of tolerance/10
 * or to rounding. Largest error measured in a velocity: 4.5 tolerance (L/(T min(alpha, 1 - alpha)) + |v|); in the
 * displacement T times this number. Returns NULL for a bad argument, or if memory is short. */
enum scallop_odeiv_stepper { SCALLOP_ODEIV_RKF45, SCALLOP_ODEIV_RK8PD };
struct scallop_integrator *scallop_odeiv_integrator(enum scallop_odeiv_stepper stepper, double tolerance);

/* SUNDIALS CVODE: Adams's method of variable order and step, whose own root finder locates the events. It restarts at
 * each event and at each piece of the gait, and never steps over the end of a piece; its tolerance applies to the root
 * mean square. Largest error measured in a velocity: 180 tolerance (L/(T min(alpha, 1 - alpha)) + |v|) at tolerance
 * 1e-12, and 15 instead of 180 at 1e-4; in the displacement T times this number. Returns NULL for a bad tolerance, if
 * memory is short, or if scallop_has_cvode returns false: the program was built without SUNDIALS. */
bool scallop_has_cvode(void);
struct scallop_integrator *scallop_cvode_integrator(double tolerance);

/* ---- Smoothed Coulomb friction: the equation of motion becomes an ordinary, stiff one, and a stiff solver integrates
 * it without locating events. With the velocity c of the centre of mass (numerics.h) and its position X,
 *
 *     c' = -(F1 tanh(v1/v_delta) + F2 tanh(v2/v_delta))/M,   v1 = c - (m2/M) l',   v2 = c + (m1/M) l',   X' = c
 *
 * is integrated in (c, X) over each piece of the gait by GSL's backward differentiation of order 1 to 5 (msbdf), with
 * the analytic Jacobian; this needs l'' and no higher derivative. The integration restarts at each piece, because l''
 * may jump there. No step is longer than 1/32 of a phase, to prevent that a step misses a change of sign.
 *
 * delta > 0 is v_delta in units of L/T, T the period. DBL_EPSILON <= tolerance <= 0.1: a step may have the error
 * tolerance * (1 + |y|), where y is X/L or c tau/L, and tau is the duration of the phase. Returns NULL for an argument
 * outside these domains, or if memory is short. Patience is asked at each step. Statuses of the period: SCALLOP_ERANGE
 * also if v_delta tau/L underflows, or if the stiffness, tau^2 (F1 + F2)/(M L) divided by v_delta tau/L, overflows;
 * SCALLOP_ECONVERGE: a step shrank to nothing, or a million steps were not enough. evaluations counts those of the
 * equation and of its Jacobian. GSL's error handler must be off (gsl_set_error_handler_off).
 *
 * Errors of v_end in units of L/T and of the displacement in units of L, after one period from the exact steady start
 * velocity. They were measured over 100 crawlers with ratios up to 25, eps = T^2 (F1 + F2)/(M L) up to 60, and alpha
 * from 0.05 to 0.95; tests/numerics/integrators/test_smoothed.c tests them against bounds.
 *
 * - The error of the model is at most 3.2 delta if the bodies slide (at most 0.002 delta for half of these crawlers:
 * the error is a fraction of eps delta), and at most (1.3 + ln(1/delta)/4) delta in stick-slip. The logarithm is due to
 * a body about to be released: it creeps at v_delta artanh(force/friction), and is (v_delta/4) ln(1/v_delta) ahead when
 * it is released. If l'' is constant in each piece, as in the quadratic gait, a jump of l'' releases the body, and
 * there is no logarithm.
 * - The error of the solver can dominate without any indication. The tolerance must be far below delta, because the
 * friction of a stuck body is as uncertain as its velocity over v_delta. Otherwise the call succeeds with a wrong
 * result: in stick-slip with delta = 1e-6 and tolerance = 1e-8 the error is 1e-3 to 1e-2. With tolerance <= 1e-6 delta
 * the error of the model dominates, down to delta = 1e-8, with 300 to 1500 steps. With tolerance = 100 delta the solver
 * gave up in stick-slip for 2 crawlers of 200, after a million steps. */
struct scallop_integrator *scallop_smoothed_integrator(double delta, double tolerance);

/* Computes the motion inside one phase from start velocity v0, at the times samples[i].t since the start of the phase;
 * steps end at these times. samples: count of them, with increasing times from 0 to the duration of the phase.
 * integrator: one made by scallop_smoothed_integrator. Each sample gets x1, x2, xC, v1, v2 and l, with x1 = 0 and x2 =
 * l at the start of the phase. Positions are accurate to the tolerance and an ulp of L. If l' jumps, the velocities are
 * those before the jump. SCALLOP_EDOMAIN also for bad times; other statuses are those of the period. If the status is
 * negative, the samples before the failure are written. */
enum scallop_status scallop_smoothed_phase(struct scallop_integrator *integrator, const struct scallop_crawler *crawler,
                                           enum scallop_phase_kind kind, double v0,
                                           const struct scallop_patience *patience, struct scallop_sample *samples,
                                           int count);

/* ---- Moreau and Jean's time stepping, which steps over events without locating them. A step h changes the velocity c
 * of the centre of mass (numerics.h) by the implicit Euler method with the set-valued sign, Sgn(0) = [-1, 1],
 *
 *     c_new + h (F1 Sgn(c_new - (m2/M) l') + F2 Sgn(c_new + (m1/M) l'))/M  contains  c_old,
 *
 * with l' at the end of the step, and its position X by the theta rule, X_new = X_old + h (c_old + c_new)/2. The
 * inclusion is monotone and piecewise linear in one unknown. So its solution has a closed form, without iteration or
 * tolerance, and a stuck body is exactly at rest. Over a period the displacement of the geometric centre is the change
 * of X, because l returns. Sources: J. J. Moreau, "Unilateral contact and dry friction in finite freedom dynamics",
 * 1988; M. Jean, Comput. Methods Appl. Mech. Eng. 177 (1999) 235; V. Acary and B. Brogliato, "Numerical methods for
 * nonsmooth dynamical systems", 2008, chapter 10.
 *
 * steps: number of equal steps in a phase, 1 <= steps <= 2^53. Returns NULL for a number outside this domain, or if
 * memory is short. Patience is asked every 256 steps. evaluations counts those of l'. The status is never
 * SCALLOP_ECONVERGE.
 *
 * The method is of first order. The error comes from the steps in which a body reverses: there friction has the sign of
 * the end for the whole step. So the error depends on where in the step the body reverses; it does not fall smoothly
 * with h, only its bound does. Largest error measured in 10000 periods, in v_end in units of L/T and in the
 * displacement in units of L: 1.8 eps/steps, eps = T^2 (F1 + F2)/(M L); tests/numerics/integrators/test_moreau.c tests
 * both against 2 eps/steps. Rounding adds up to 1e-16 (1 + |c| T/L) steps, and exceeds the first error from about 1e8
 * steps on. */
struct scallop_integrator *scallop_moreau_integrator(long steps);

#ifdef __cplusplus
}
#endif

#endif
