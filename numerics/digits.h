/* Steady states with fewer digits, for pictures: without the second computation in wider arithmetic of numbers that
 * rounding has spoilt. Not public. */
#ifndef SCALLOP_NUMERICS_DIGITS_H
#define SCALLOP_NUMERICS_DIGITS_H

#include "numerics/numerics.h"

enum digits {
  ALL_DIGITS,
  WITHOUT_MULTIPLIER, /* the multiplier may be wrong if it depends on the last digit of the velocity */
  PICTURE_DIGITS      /* and displacements that are small by cancellation by a few ulp of L */
};

/* As scallop_steady and scallop_steady_batch. */
enum scallop_status steady_in(const struct scallop_crawler *crawler, enum digits digits,
                              struct scallop_steady_result *result);
long steady_batch_in(const struct scallop_crawlers *crawlers, const struct scallop_steady_states *states,
                     enum digits digits, int threads);

#endif
