/* Rows of t and l, in any order and of any number of periods, as samples of one period. */
#ifndef SCALLOP_MODEL_MEASURED_RECORDING_H
#define SCALLOP_MODEL_MEASURED_RECORDING_H

#include "model/measured/fit.h"

struct recording {
  struct samples samples;           /* in units of the period, from start on, and of the range of l, from low on */
  double start, period, low, range; /* of t and of l */
  bool folded;                      /* the recording is longer than a period */
  char understood[160];             /* description: count of rows, count and length of periods */
};

/* Reads a recording as one period. If l repeats itself after a lag, the rows are folded into one period. It minimizes
 * the residual of a smooth curve. Otherwise the last row repeats the first (to 1e-9 of the range of l), or is one step
 * before. period > 0: the period. Rows at the same time are replaced by their mean. Returns NULL, or the reason of the
 * failure; the caller frees samples.at in any case. */
const char *recording_of(struct recording *recording, const double *t, const double *l, int count, double period);

#endif
