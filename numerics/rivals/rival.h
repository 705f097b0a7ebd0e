/* The general-purpose rivals behind one interface: what people use who have the equation of motion and a good library,
 * and not the exact solver. They are here to be compared with: the rest of numerics/ never uses them.
 *
 * A rival is a period map, v0 -> the velocities and the displacement after one period from start velocity v0. Its
 * steady state is found as its user would find it: by simulating periods until they repeat, or as the root of
 * the map. Rivals allocate, when they are made; they print nothing and hold no state between calls.
 */
#ifndef SCALLOP_NUMERICS_RIVALS_RIVAL_H
#define SCALLOP_NUMERICS_RIVALS_RIVAL_H

#include "numerics/numerics.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Asked before each step and each period while a rival works; false: it gives up with SCALLOP_ESTOPPED. NULL instead of
 * it: it may take as long as it takes. */
struct scallop_patience {
  bool (*lasts)(void *context);
  void *context;
};

struct scallop_rival_period {
  double v_mid, v_end; /* velocity after the extension and after the contraction                  */
  double displacement; /* of the geometric centre over the period                                 */
  long steps;          /* steps tried: accepted, rejected, and taken again to locate an event     */
  long evaluations;    /* of the equation of motion, and so of the gait                           */
  long events;         /* changes of mode that were located; 0 for methods that know no events    */
};

struct scallop_rival {
  /* One period: extension, then contraction, from start velocity v0 of both bodies, any finite number. SCALLOP_EDOMAIN:
   * a bad crawler or v0; SCALLOP_ERANGE: a scaled quantity or a result over- or underflows; SCALLOP_ECONVERGE: the
   * method gave up (its step shrank to nothing, say); SCALLOP_ESTOPPED: patience did. *period is untouched on
   * failure. */
  enum scallop_status (*period)(struct scallop_rival *self, const struct scallop_crawler *crawler, double v0,
                                const struct scallop_patience *patience, struct scallop_rival_period *period);
  void (*destroy)(struct scallop_rival *self);
};
void scallop_rival_destroy(struct scallop_rival *rival); /* takes NULL */

struct scallop_rival_steady {
  double v_start, displacement; /* displacement: nan if not one period was done                        */
  long periods;                 /* solved                                                              */
  long root_iterations;         /* 0 for a simulation                                                  */
  long steps, evaluations, events;
};

/* Simulates periods from start velocity v0 until the distance that is left to the steady state is at most tolerance *
 * (L/T + |v|), and the last change of v no more than that. The distance is estimated as change m/(1 - m), with m the
 * ratio of the last two changes of v, one more rounding error counted in; a change is over a stride of 1, then 2, 4, 8
 * ... periods, 16 changes of each, because where 1 - m is small a single period changes v too little to tell m by. v
 * moves by a constant as long as friction alone brakes (m = 1): that is no reason to end. So the number of periods
 * grows as log(1/tolerance)/(1 - multiplier), that is as 1/T^2 for T -> 0, and without patience nothing else limits it.
 * tolerance >= 0. It is the distance to the fixed point of the rival's own map, which is off by the error of its period
 * over 1 - multiplier. Where the map's noise does not allow the tolerance, the end is SCALLOP_OK all the same, at the
 * noise: when a period or a stride gives back the very v that it was given, or when the changes have altered their sign
 * 8 times, which those of the motion itself never do. v_start is the last v_end; displacement is that of the last
 * period, which began nearly there. SCALLOP_STOPPED: patience ended it (*steady is where it stood; a period that was
 * not finished is not counted). SCALLOP_EDOMAIN: a bad crawler, v0 or tolerance. Others: the period's. *steady is
 * untouched below zero. */
enum scallop_status scallop_rival_simulate(struct scallop_rival *rival, const struct scallop_crawler *crawler,
                                           double v0, double tolerance, const struct scallop_patience *patience,
                                           struct scallop_rival_steady *steady);

/* The root of v_end - v_start by GSL's Brent solver (gsl_set_error_handler_off must have been called), bracketed by
 * 1.01 times the velocities at which l' could still turn a body round, until the bracket is no wider than tolerance *
 * (L/T + |v|), or DBL_EPSILON for a tolerance below that. tolerance >= 0. What one period changes is 1 - multiplier,
 * O(T^2) for T -> 0: this divides the error of the period by that. Where the map's noise is larger than the tolerance
 * allows, the root is one of those that the noise makes. v_start is a velocity that was tried, and displacement that of
 * its period. SCALLOP_ECONVERGE: at an end of the bracket the map does not slow the crawler down, as friction must: its
 * error is larger than what friction does in a period, and it says nothing of the steady state. SCALLOP_STOPPED:
 * patience ended it; *steady is where it stood, v_start and displacement nan while not both ends are known. Others as
 * above. */
enum scallop_status scallop_rival_root(struct scallop_rival *rival, const struct scallop_crawler *crawler,
                                       double tolerance, const struct scallop_patience *patience,
                                       struct scallop_rival_steady *steady);

#ifdef __cplusplus
}
#endif

#endif
