/* The general-purpose rivals behind one interface: what people use who have the equation of motion and a good library,
 * and not the exact solver. They are here to be compared with: the rest of numerics/ never uses them.
 *
 * A rival is a period map, v0 -> the velocities and the displacement after one period from start velocity v0. Its
 * steady state is found as its user would find it: by simulating periods until they repeat, or as the root of
 * the map. Rivals allocate, when they are made; they print nothing and hold no state between calls.
 */
#ifndef SCALLOP_RIVAL_H
#define SCALLOP_RIVAL_H

#include "numerics/numerics.h"

/* Asked again and again while a rival works; false: it gives up with SCALLOP_ESTOPPED. NULL instead of it: it may take as long as
 * it takes. */
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
  /* One period: extension, then contraction, from start velocity v0 of both bodies, any finite number. SCALLOP_EDOMAIN: a bad
   * crawler or v0; SCALLOP_ERANGE: a scaled quantity or a result over- or underflows; SCALLOP_ECONVERGE: the method gave
   * up (its step shrank to nothing, say); SCALLOP_ESTOPPED: patience did. *period is untouched on failure. */
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

/* Simulates periods from start velocity v0 until the distance that is left to the steady state, estimated as change m/(1 - m)
 * with m the ratio of the last two changes of v_start, is at most tolerance * (L/T + |v|). The number of periods
 * grows as log(1/tolerance)/(1 - multiplier), so as 1/T^2 for T -> 0.
 * SCALLOP_STOPPED: patience ended it (*steady is where it stood). Other statuses: the period's; *steady untouched. */
enum scallop_status scallop_rival_simulate(struct scallop_rival *rival, const struct scallop_crawler *crawler, double v0,
                                           double tolerance, const struct scallop_patience *patience,
                                           struct scallop_rival_steady *steady);

/* The root of v_end - v_start by GSL's Brent solver, bracketed by velocities beyond those that l' and friction can drive,
 * until the bracket is narrower than tolerance * (L/T + |v|), or the map's own noise ends it. What one
 * period changes is 1 - multiplier, O(T^2) for T -> 0: this divides the error of the period by that. Statuses as above. */
enum scallop_status scallop_rival_root(struct scallop_rival *rival, const struct scallop_crawler *crawler, double tolerance,
                                       const struct scallop_patience *patience, struct scallop_rival_steady *steady);

#endif
