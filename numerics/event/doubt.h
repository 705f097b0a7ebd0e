/* A phase, a period and a steady state in double alone; numerics.c mends by wider arithmetic what these doubt. Not
 * public. */
#ifndef SCALLOP_NUMERICS_EVENT_DOUBT_H
#define SCALLOP_NUMERICS_EVENT_DOUBT_H

#include "numerics/numerics.h"

struct doubt {
  /* < 1: so much of the parts of a displacement is left after cancellation that wider arithmetic is needed; else 1 */
  double left;
  /* a change of the start velocity by less than an ulp changes the multiplier */
  bool delicate;
  bool amplified; /* left is of a velocity: rounding of times, or of what friction has taken, is many ulp of it */
};

/* As scallop_phase, scallop_period and scallop_steady. */
enum scallop_status solve_phase(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0,
                                struct scallop_phase_result *result, struct doubt *doubt);
enum scallop_status solve_period(const struct scallop_crawler *crawler, double v0, struct scallop_period_result *result,
                                 struct doubt *doubt);
enum scallop_status solve_steady(const struct scallop_crawler *crawler, struct scallop_steady_result *result,
                                 struct doubt *doubt);

#endif
