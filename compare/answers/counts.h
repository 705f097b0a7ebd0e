/* What a run of scenes really did: `run --stats` prints it. Each is counted where a scene asks for it; what other
 * commands do is not. */
#ifndef SCALLOP_COMPARE_ANSWERS_COUNTS_H
#define SCALLOP_COMPARE_ANSWERS_COUNTS_H

#include "numerics/numerics.h"

enum count {
  COUNT_POINTS,
  COUNT_ONSETS,     /* longest periods without sticking; the phases of the bisection are not counted */
  COUNT_STEADY,     /* steady states in double */
  COUNT_PHASES,     /* phases in double */
  COUNT_FORMULAS,   /* evaluations of the paper's */
  COUNT_EXPANSIONS, /* series derived */
  COUNT_SUMS,       /* of derived series at a T */
  COUNT_CERTIFIED,  /* steady states and phases in ball arithmetic */
  COUNT_TRAJECTORIES,
  COUNT_SAMPLES, /* of trajectories */
  COUNT_ORDERS,  /* fitted */
  COUNT_COMMANDS,
  COUNT_ROWS, /* written by scenes */
  COUNT_PLOTS,
  COUNT_PLANNED,
  COUNT_GAITS = COUNT_PLANNED, /* made; the two that are built in are not */
  COUNT_ROOT_ITERATIONS,       /* within steady states and phases, closed forms not counted */
  COUNT_GAIT_EVALUATIONS,      /* of l' and l'' where they are not linear */
  COUNT_CERTIFIED_DIGITS,      /* of all certified solutions together */
  COUNTS
};

void count_add(enum count what, long n);
void count_work(const struct scallop_work *work);
long count_of(enum count what);
/* "steady", "root_iterations", ... */
const char *count_name(enum count what);

#endif
