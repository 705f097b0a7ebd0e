/* What was computed for the rows of sheets: --stats prints it. Each is counted where a column asks for it; what
 * commands without sheets do is not. */
#ifndef SCALLOP_COMPARE_POINTS_COUNTS_H
#define SCALLOP_COMPARE_POINTS_COUNTS_H

#include <stdbool.h>

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
  COUNT_ROWS, /* of sheets, written */
  COUNT_PLOTS,
  COUNT_GAITS,            /* made; the two that are built in are not */
  COUNT_ROOT_ITERATIONS,  /* within steady states and phases, closed forms not counted */
  COUNT_GAIT_EVALUATIONS, /* of l' and l'' where they are not linear */
  COUNT_CERTIFIED_DIGITS, /* of all certified solutions together */
  COUNTS
};

/* Are they printed? Then points are solved one by one, as the batch call counts nothing. */
extern bool counts_are_wanted;
void count_add(enum count what, long n);
void count_work(const struct scallop_work *work);
/* All of them, on standard error */
void counts_print(void);

#endif
