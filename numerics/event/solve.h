/* A phase, a period and a steady state in double alone; numerics.c mends by wider arithmetic what these doubt. Not public. */
#ifndef SCALLOP_SOLVE_H
#define SCALLOP_SOLVE_H

#include "numerics/numerics.h"

struct doubt {
  double
      left; /* what cancellation has left of the parts that a displacement is the sum of: < 1 if it is to be mended, else 1 */
  bool delicate; /* the multiplier depends on where in the last digit the start velocity lies          */
};

/* As scallop_phase, scallop_period and scallop_steady. */
enum scallop_status solve_phase(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0,
                                struct scallop_phase_result *result, struct doubt *doubt);
enum scallop_status solve_period(const struct scallop_crawler *crawler, double v0, struct scallop_period_result *result,
                                 struct doubt *doubt);
enum scallop_status solve_steady(const struct scallop_crawler *crawler, struct scallop_steady_result *result,
                                 struct doubt *doubt);

#endif
