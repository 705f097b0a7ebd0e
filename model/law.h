/* Functions shared by the pieces of a gait and their laws (struct scallop_law), and the curve of a Bernstein law,
 * evaluated in long double. Not public. */
#ifndef SCALLOP_MODEL_LAW_H
#define SCALLOP_MODEL_LAW_H

#include "model/model.h"

extern const struct scallop_curve law_curve_bernstein;

/* Returns du/dtime of the offset u of a piece: +1 from the start of the phase, -1 from its end. */
static inline int law_sense(const struct scallop_piece *piece) { return piece->anchor == SCALLOP_FROM_START ? 1 : -1; }

static inline bool law_is_sine(const struct scallop_piece *piece)
{
  return piece->law && piece->law->kind == SCALLOP_LAW_SINE;
}

/* Returns true if |l'| is the same function of the offset. */
bool law_same(const struct scallop_law *a, const struct scallop_law *b);

/* Follows the sign of the second derivative of |l'| through a phase. part: 0 at first. Returns false where it has been
 * positive, then negative, then positive, and is negative again. */
static inline bool law_is_bell(int *part, long double bend)
{
  if (bend > 0 && *part == 1)
    *part = 2;
  else if (bend < 0 && *part == 0)
    *part = 1;
  return bend >= 0 || *part == 1;
}

/* Returns |l'| at offset `to` minus |l'| at offset `from`, for a Bernstein law, to a few ulp of (to - from) max
 * |l''|, however near the offsets are to each other. */
double law_rise(const struct scallop_law *law, double from, double to);

#endif
