/* Where a period begins, for all that solve one. Not public. */
#ifndef SCALLOP_START_H
#define SCALLOP_START_H

#include <math.h>

#include "model/model.h"

/* The crawler and its start velocity in units of L and T. SCALLOP_EDOMAIN: a bad crawler, or v0 not finite; SCALLOP_ERANGE: scaling
 * overflows, or loses v0. */
static inline enum scallop_status start_scaled(const struct scallop_crawler *crawler, double v0,
                                               struct scallop_scaled *scaled, double *c0)
{
  enum scallop_status status = scallop_scale(crawler, scaled);
  if (status != SCALLOP_OK)
    return status;
  if (!isfinite(v0))
    return SCALLOP_EDOMAIN;
  *c0 = v0 / scaled->velocity;
  return isfinite(*c0) && (*c0 != 0 || v0 == 0) ? SCALLOP_OK : SCALLOP_ERANGE;
}

#endif
