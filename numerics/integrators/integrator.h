/* The general-purpose integrators behind one interface: the usual choice for an equation of motion without the exact
 * solver. They exist for comparison: the rest of numerics/ never uses them.
 *
 * An integrator is a period map, v0 -> the velocities and the displacement after one period from start velocity v0.
 * Its steady state is found as usual: by simulating periods until they repeat, or as the root of the map. Integrators
 * allocate, when they are made; they print nothing and hold no state between calls. */
#ifndef SCALLOP_NUMERICS_INTEGRATORS_INTEGRATOR_H
#define SCALLOP_NUMERICS_INTEGRATORS_INTEGRATOR_H

#include "numerics/numerics.h"

#ifdef __cplusplus
extern "C" {
#endif

/* An integrator calls `lasts` before each step and each period; if false, it gives up with SCALLOP_ESTOPPED. NULL
 * instead of the struct: no limit. */
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
  /* One period: extension, then contraction, from start velocity v0 of both bodies, any finite number. SCALLOP_EDOMAIN:
   * a bad crawler or v0; SCALLOP_ERANGE: a scaled quantity or a result over- or underflows; SCALLOP_ECONVERGE: the
   * method gave up (for example, its step shrank to nothing); SCALLOP_ESTOPPED: patience did. *period is untouched on
   * failure. */
  enum scallop_status (*period)(struct scallop_integrator *self, const struct scallop_crawler *crawler, double v0,
                                const struct scallop_patience *patience, struct scallop_integrator_period *period);
  void (*destroy)(struct scallop_integrator *self);
};
void scallop_integrator_destroy(struct scallop_integrator *integrator); /* takes NULL */

struct scallop_integrator_steady {
  double v_start, displacement; /* displacement: nan if not one period was done                        */
  long periods;                 /* solved                                                              */
  long root_iterations;         /* 0 for a simulation                                                  */
  long steps, evaluations, events;
};

/* Simulates periods from start velocity v0 until the distance that is left to the steady state is at most tolerance *
 * (L/T + |v|), and the last change of v no more than that. The distance is estimated as change m/(1 - m), with m the
 * ratio of the last two changes of v, one more rounding error counted in; a change is over a stride of 1, then 2, 4, 8
 * ... periods, 16 changes of each, because for small 1 - m a single period changes v too little to determine m. v moves
 * by a constant as long as friction alone brakes (m = 1): that is no reason to end. So the number of periods grows as
 * log(1/tolerance)/(1 - multiplier), that is as 1/T^2 for T -> 0, and without patience nothing else limits it.
 * tolerance >= 0. It is the distance to the fixed point of the integrator's own map; this point is off by the error of
 * a period over 1 - multiplier. If the map's noise exceeds the tolerance, the end is SCALLOP_OK too, at the noise: when
 * a period or a stride returns exactly its start velocity, or when the changes have altered their sign 8 times (changes
 * of the motion itself never do). v_start is the last v_end; displacement belongs to the last period, from nearly that
 * velocity. SCALLOP_STOPPED: patience ended it (*steady has the state then; an unfinished period is not counted).
 * SCALLOP_EDOMAIN: a bad crawler, v0 or tolerance. Others: the period's. *steady is untouched below zero. */
enum scallop_status scallop_integrator_simulate(struct scallop_integrator *integrator,
                                                const struct scallop_crawler *crawler, double v0, double tolerance,
                                                const struct scallop_patience *patience,
                                                struct scallop_integrator_steady *steady);

/* The root of v_end - v_start by GSL's Brent solver (gsl_set_error_handler_off must have been called), bracketed by
 * 1.01 times the velocities at which l' could still turn a body round, until the bracket is no wider than tolerance *
 * (L/T + |v|), or DBL_EPSILON for a tolerance below that. tolerance >= 0. What one period changes is 1 - multiplier,
 * O(T^2) for T -> 0: the error of the root is the error of the period divided by this. If the map's noise is larger
 * than the tolerance allows, the root is one of several that the noise makes. v_start is a velocity that was tried,
 * displacement belongs to its period. SCALLOP_ECONVERGE: memory is short; or at an end of the bracket the map does not
 * slow the crawler down, as friction must: its error is larger than the effect of friction in a period, and it does not
 * determine the steady state. SCALLOP_STOPPED: patience ended it; *steady has the state then, v_start and displacement
 * nan before both ends are known. Others as above. */
enum scallop_status scallop_integrator_root(struct scallop_integrator *integrator,
                                            const struct scallop_crawler *crawler, double tolerance,
                                            const struct scallop_patience *patience,
                                            struct scallop_integrator_steady *steady);

/* ---- The integrators that locate events. If a body's velocity has changed sign, the step is repeated up to the zero,
 * and the forces decide whether the body reverses, continues or sticks; the motion of a stuck body needs no
 * integration, x1' = 0 or x1' = -l'. Between events
 *
 *     x1'' = -(m2/M) l'' - (F1 s1 + F2 s2)/M,   x2' = x1' + l'        (the paper, section 2)
 *
 * is integrated in (x1, x1') over each smooth piece of the gait, with the error tolerance * (1 + |y|) allowed to each
 * step, y being x1/L and x1' tau/L, tau the duration of the phase: so the tolerance is relative to L and L/tau, and a
 * velocity that is small beside L/tau is lost in the steps. DBL_EPSILON <= tolerance <= 0.1. Each step checks patience.
 * SCALLOP_ECONVERGE: the step size shrank to nothing, or a million steps were not enough: the tolerance is too near
 * rounding. tests/numerics/integrators/test_integrators.c holds the worst errors to bounds. */

/* GSL's odeiv2: embedded Runge-Kutta pairs, Fehlberg 4(5), 6 evaluations a step, and Prince-Dormand 8(9), 13. Events
 * are located by Newton's method on the length of the step, kept inside a bracket, to a velocity of tolerance/10 or to
 * rounding. Worst error seen in a velocity: 4.5 tolerance (L/(T min(alpha, 1 - alpha)) + |v|), and T times that in the
 * displacement. NULL: a bad argument, or memory is short. */
enum scallop_odeiv_stepper { SCALLOP_ODEIV_RKF45, SCALLOP_ODEIV_RK8PD };
struct scallop_integrator *scallop_odeiv_integrator(enum scallop_odeiv_stepper stepper, double tolerance);

/* SUNDIALS CVODE: Adams's method of variable order and step, with its own root finder for the events. It restarts at
 * each event and at each piece of the gait, and never steps over the end of one; its tolerance is in the root mean
 * square. Worst error seen in a velocity: 180 tolerance (L/(T min(alpha, 1 - alpha)) + |v|) at 1e-12, 15 at 1e-4, and T
 * times that in the displacement. NULL: a bad tolerance, memory is short, or the program was built without SUNDIALS
 * (scallop_has_cvode). */
bool scallop_has_cvode(void);
struct scallop_integrator *scallop_cvode_integrator(double tolerance);

/* ---- Coulomb friction smoothed: the equation of motion is then ordinary and stiff, and a stiff solver integrates it
 * without locating events. With c the velocity of the centre of mass (numerics.h),
 *
 *     c' = -(F1 tanh(v1/v_delta) + F2 tanh(v2/v_delta))/M,   v1 = c - (m2/M) l',   v2 = c + (m1/M) l',   X' = c
 *
 * is integrated in (c, X) over each piece of the gait with the analytic Jacobian (l'' and no higher derivative) by
 * GSL's backward differentiation of order 1 to 5 (msbdf). It restarts at each piece, as l'' may jump there.
 *
 * delta > 0: v_delta in units of L/T, T the period. DBL_EPSILON <= tolerance <= 0.1: a step may make the error
 * tolerance * (1 + |y|), y being X/L and c tau/L, tau the duration of the phase. NULL: an argument outside of that, or
 * memory is short. Each step checks patience. Of the period's statuses: SCALLOP_ERANGE also if v_delta tau/L
 * underflows, or the stiffness, tau^2 (F1 + F2)/(M L) over that, overflows; SCALLOP_ECONVERGE: a step shrank to
 * nothing, or a million were not enough. evaluations: of the equation and of its Jacobian. GSL's error handler must be
 * off (gsl_set_error_handler_off).
 *
 * Errors of v_end in L/T and of the displacement in L over one period from the exact steady start, measured over 100
 * crawlers with ratios up to 25, eps = T^2 (F1 + F2)/(M L) up to 60, alpha from 0.05 to 0.95;
 * tests/numerics/integrators/test_smoothed.c holds them to bounds:
 *   of the model: at most 3.2 delta if the bodies slide (0.002 delta for half of the crawlers: it is a fraction of
 *     eps delta), and at most (1.3 + ln(1/delta)/4) delta in stick-slip: first order up to a logarithm. A body about to
 *     be released creeps at v_delta artanh(force/friction), and is (v_delta/4) ln(1/v_delta) ahead when it goes. No
 *     logarithm where l'' is constant in each piece, as in the quadratic gait: there it is released by a jump of l''.
 *   of the solver: no status reports that it dominates. The tolerance has to be far below delta, as a stuck body's
 *     friction is known no better than its velocity over v_delta. If it is not, the call succeeds and the answer is
 *     wrong: by 1e-3 to 1e-2 in stick-slip at delta = 1e-6, tolerance = 1e-8. tolerance <= 1e-6 delta leaves the error
 *     of the model, down to delta = 1e-8; 300 to 1500 steps. It gives up in stick-slip if the tolerance is 100 delta: 2
 *     crawlers of 200, after a million steps.
 * No step is longer than 1/32 of a phase: a longer one might leap over a crossing. */
struct scallop_integrator *scallop_smoothed_integrator(double delta, double tolerance);

/* Inside one phase: the motion from start velocity v0, at the times samples[i].t since the phase began; a step ends at
 * each. samples: count of them, times rising, from 0 to the duration of the phase. integrator: one of the above. A
 * sample gets x1, x2, xC, v1, v2 and l; x1 = 0 and x2 = l at the start of the phase, and positions are good to the
 * tolerance and an ulp of L. At a jump of l' the velocities before the jump count. SCALLOP_EDOMAIN also for bad times.
 * Else the statuses of the period; below zero the samples so far have been taken. */
enum scallop_status scallop_smoothed_phase(struct scallop_integrator *integrator, const struct scallop_crawler *crawler,
                                           enum scallop_phase_kind kind, double v0,
                                           const struct scallop_patience *patience, struct scallop_sample *samples,
                                           int count);

/* ---- Moreau and Jean's time stepping: it steps over events without locating them. One step of the velocity c of the
 * centre of mass (numerics.h) is the implicit Euler step with the set-valued sign, Sgn(0) = [-1, 1],
 *
 *     c_new + h (F1 Sgn(c_new - (m2/M) l') + F2 Sgn(c_new + (m1/M) l'))/M  contains  c_old,
 *
 * with l' at the end of the step, and the path follows from the theta rule, X_new = X_old + h (c_old + c_new)/2. The
 * inclusion is monotone and piecewise linear in one unknown, so it is solved in closed form: no iteration, no
 * tolerance, and a stuck body is exactly at rest. The displacement of the geometric centre equals the displacement in
 * X, as l returns. Sources: J. J. Moreau, "Unilateral contact and dry friction in finite freedom dynamics", 1988; M.
 * Jean, Comput. Methods Appl. Mech. Eng. 177 (1999) 235; V. Acary and B. Brogliato, "Numerical methods for nonsmooth
 * dynamical systems", 2008, chapter 10.
 *
 * steps equal steps a phase, 1 <= steps <= 2^53. NULL: an argument outside of that, or memory is short. Every 256 steps
 * check patience. evaluations: of l'. Never SCALLOP_ECONVERGE. First order, and that from the crossings alone: in the
 * step in which a body turns, friction has the sign of the end for the whole step. So the error lies anywhere below its
 * bound, by where in the step that happens, and does not fall smoothly. Worst seen in 10000 periods, in v_end in L/T
 * and in the displacement in L: 1.8 eps/steps, eps = T^2 (F1 + F2)/(M L); tests/numerics/integrators/test_moreau.c
 * holds both to 2 eps/steps. Rounding adds up to 1e-16 (1 + |c| T/L) steps, and overtakes that at about 1e8 steps. */
struct scallop_integrator *scallop_moreau_integrator(long steps);

#ifdef __cplusplus
}
#endif

#endif
