/* Where a period begins, for all that solve one. Not public. */
#ifndef SCALLOP_NUMERICS_EVENT_START_H
#define SCALLOP_NUMERICS_EVENT_START_H

#include <float.h>
#include <math.h>

#include "model/model.h"

/* Neither the start velocity nor the time in which friction may undo it is lost in the scaling. */
static inline bool start_is_kept(double v0, double c0, double eps)
{
  return v0 == 0 || (fabs(c0) < DBL_MAX && fabs(c0) / (64 * (1 + eps)) > 0);
}

/* The crawler and its start velocity in units of L and T. SCALLOP_EDOMAIN: a bad crawler, or v0 not finite;
 * SCALLOP_ERANGE: scaling overflows, or loses v0. */
static inline enum scallop_status start_scaled(const struct scallop_crawler *crawler, double v0,
                                               struct scallop_scaled *scaled, double *c0)
{
  enum scallop_status status = scallop_scale(crawler, scaled);
  if (status != SCALLOP_OK)
    return status;
  if (!isfinite(v0))
    return SCALLOP_EDOMAIN;
  *c0 = v0 / scaled->velocity;
  return start_is_kept(v0, *c0, scaled->eps) ? SCALLOP_OK : SCALLOP_ERANGE;
}

#endif
