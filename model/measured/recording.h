/* Rows of t and l, in any order and of any number of periods, as samples of one period. */
#ifndef SCALLOP_MODEL_MEASURED_RECORDING_H
#define SCALLOP_MODEL_MEASURED_RECORDING_H

#include "model/measured/fit.h"

struct recording {
  struct samples samples;           /* in units of the period, from start on, and of the range, from low on */
  double start, period, low, range; /* of t and of l */
  bool folded;                      /* it lasts longer than a period */
  char understood[160];             /* how many rows, how many periods of which length */
};

/* Where l repeats itself after a lag, the rows are folded into one period, which is refined until a smooth curve leaves
 * least. Else the last row is the first one a period later (to 1e-9 of the range of l), or one step before it. period >
 * 0: that is it. Rows at one time give their mean. NULL, or what is wrong; the caller frees samples.at in any case. */
const char *recording_of(struct recording *recording, const double *t, const double *l, int count, double period);

#endif
