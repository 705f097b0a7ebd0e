/* The gait of a periodic curve: phases from its minimum to its maximum and back, in units of the crawler. */
#ifndef SCALLOP_MODEL_MEASURED_CURVE_GAIT_H
#define SCALLOP_MODEL_MEASURED_CURVE_GAIT_H

#include "model/measured/fit.h"

struct curve_gait {
  struct scallop_spline spline;
  double L, alpha; /* range of the curve, fraction of its period from minimum to maximum */
};

/* Makes the gait. Returns NULL, or the reason of the failure. name is kept. */
const char *gait_of_curve(struct curve_gait *gait, const struct curve *curve, const char *name);
void curve_gait_free(struct curve_gait *gait);

#endif
