/* Counts of the computations for the rows of sheets, for --stats. Each is counted when a column requests it; commands
 * without sheets count nothing. */
#ifndef SCALLOP_COMPARE_POINTS_COUNTS_H
#define SCALLOP_COMPARE_POINTS_COUNTS_H

#include <stdbool.h>

#include "numerics/numerics.h"

enum count {
  COUNT_POINTS,
  COUNT_ONSETS,     /* longest periods without sticking; the phases of the bisection are not counted */
  COUNT_STEADY,     /* steady states in double */
  COUNT_PHASES,     /* phases in double */
  COUNT_FORMULAS,   /* evaluations of formulas of the paper or of a formula file */
  COUNT_EXPANSIONS, /* series derived */
  COUNT_SUMS,       /* sums of derived series */
  COUNT_CERTIFIED,  /* steady states and phases in ball arithmetic */
  COUNT_TRAJECTORIES,
  COUNT_SAMPLES, /* rows of trajectories */
  COUNT_ORDERS,  /* fitted orders */
  COUNT_COMMANDS,
  COUNT_ROWS, /* rows of sheets */
  COUNT_PLOTS,
  COUNT_GAITS,            /* gaits made, without the two built-in ones */
  COUNT_ROOT_ITERATIONS,  /* of steady states and phases, without closed forms */
  COUNT_GAIT_EVALUATIONS, /* of nonlinear l' and l'' */
  COUNT_CERTIFIED_DIGITS, /* sum over all certified solutions */
  COUNTS
};

/* True if the counts are printed: points are then solved one by one, because the batch call counts nothing. */
extern bool counts_are_printed;
void count_add(enum count what, long n);
void count_work(const struct scallop_work *work);
/* Prints the counts to standard error. */
void counts_print(void);

#endif
