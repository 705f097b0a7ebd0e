/* The radius of convergence of the derived series: the branch is continued to complex T, and the branch points nearest
 * to T = 0 are found and proven. docs/background/theory.md has the method. Needs FLINT; prints nothing, has no state.
 */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_SINGULARITY_H
#define SCALLOP_ASYMPTOTICS_DERIVED_SINGULARITY_H

#include "asymptotics/asymptotics.h"
#include "model/exact/ball.h"
#include "model/exact/flint_complex.h"

/* Quantities with a series: AFTER_FIRST_PHASE is v_mid of a steady state, v_end of a phase; LAST_CROSSING dT of a
 * phase, or t1. */
enum continued_value { AT_START, AFTER_FIRST_PHASE, TRAVEL, LAST_CROSSING, CONTINUED_VALUES };

/* Proven: all values are analytic functions for |T| < low (its lower end, INFINITY: everywhere). If found, the straight
 * continuation from 0 meets a branch point at T^power = place, |place| = T^power; values with shows[] are not analytic
 * there, therefore the radius of convergence of their series is between low and T. low and T are the same ball unless
 * the proof ended early. */
struct scallop_singularity {
  slong power; /* 2 for the steady state, 1 for a phase                                               */
  arb_t low, T;
  bool found;
  bool even; /* another branch point is at -place */
  acb_t place;
  bool shows[CONTINUED_VALUES];
};
void scallop_singularity_init(struct scallop_singularity *s);
void scallop_singularity_clear(struct scallop_singularity *s);

/* Computes the singularity of the steady state. Statuses as scallop_expand_steady. Takes about a second. */
enum scallop_status scallop_steady_singularity(struct scallop_singularity *s,
                                               const struct scallop_rational_crawler *crawler, slong precision,
                                               const char **why);
/* Computes the singularity of the first `crossings` changes of mode, or of all if fewer exist. Statuses as
 * scallop_expand_phase. */
enum scallop_status scallop_phase_singularity(struct scallop_singularity *s,
                                              const struct scallop_rational_crawler *crawler,
                                              enum scallop_phase_kind kind, const fmpq_t v0, int crossings,
                                              slong precision, const char **why);

#endif
