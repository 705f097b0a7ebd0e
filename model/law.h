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

/* Returns |l'| at offset `to` minus |l'| at offset `from`, for a Bernstein law, to a few ulp of (to - from) max
 * |l''|, however near the offsets are to each other. */
double law_rise(const struct scallop_law *law, double from, double to);

#endif
