/* The arithmetic floor: the cost of a steady state without any check. */
#ifndef SCALLOP_BENCH_FLOOR_H
#define SCALLOP_BENCH_FLOOR_H

#include "model/model.h"

struct floor_result {
  double froude, v_start, v_mid, displacement, mean_velocity, multiplier;
};

/* The steady state of a crawler with the quadratic gait and the modes ++ -+ ++ | ++ +- ++, F1 > F2 and alpha > 1/2 or
 * both the other way round: the numbers of scallop_steady, from a closed form written out by hand. Checks nothing;
 * wrong for any other crawler. */
void floor_steady(const struct scallop_crawler *crawler, struct floor_result *result);

#endif
