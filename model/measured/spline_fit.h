/* Least-squares splines with a penalty on the third differences of their coefficients (fit.h). */
#ifndef SCALLOP_MODEL_MEASURED_SPLINE_FIT_H
#define SCALLOP_MODEL_MEASURED_SPLINE_FIT_H

#include "model/measured/fit.h"

/* Writes the knots of the spline of kind SCALLOP_FIT_SMOOTH or SCALLOP_FIT_PHASES, at most FIT_SEGMENTS + 8, and
 * sets what fit has not chosen yet. Returns the count of knots, 0 on failure. */
int spline_fit(struct scallop_knot *knots, struct fit *fit, const struct samples *samples);

#endif
