/* Zeros in ball arithmetic: the part of the certified solver that proves where something becomes 0 first, or that it
 * does not. Private to numerics/certified/. Times s run from 0 to 1 over a phase; l' and its derivatives are signed. */
#ifndef SCALLOP_NUMERICS_CERTIFIED_ENCLOSE_H
#define SCALLOP_NUMERICS_CERTIFIED_ENCLOSE_H

#include "model/exact/scoped.h"

/* l', l'' or l''' (order 0, 1, 2) over all of the ball s, as the law of this piece has it. */
void scallop_enclose_gait(arb_t value, const struct scallop_piece *piece, const arb_t s, int order, slong precision);

/* The offset at time s; s and the offset may be one ball. */
void scallop_enclose_offset(arb_t u, const struct scallop_piece *piece, const arb_t s, slong precision);

/* The time at which a piece ends, rounded once */
void scallop_enclose_end(arb_t s, const struct scallop_piece *piece, slong precision);

/* f(s) = constant + slope s + factor l'(s) for order 0, with l'' for order 1. */
struct scallop_track {
  const struct scallop_piece *piece;
  int order;
  arb_t constant, slope, factor;
};
#define TRACK_PARTS(of) of(arb, s->constant) of(arb, s->slope) of(arb, s->factor)
SCOPED_PARTS(scallop_track, struct scallop_track, TRACK_PARTS)

/* How f leaves its start: from a value that is not 0, from 0 with a slope, from 0 with slope 0. */
enum scallop_departure { SCALLOP_APART, SCALLOP_FROM_ZERO, SCALLOP_FROM_ZERO_FLAT };

struct scallop_stretch { /* (begin, end], whatever the true begin in its ball is; just after it f has this sign */
  const arb_struct *begin, *end;
  int sign;
  enum scallop_departure departure;
};

/* Finds the first zero of f in a stretch. SCALLOP_NONE and CROSSES are proven; at a crossing *zero encloses the zero,
 * and the slope of f provably has the other sign. GRAZES: f comes too close to 0 for a decision at this precision;
 * AT_END: it may be 0 at the end itself. */
enum scallop_found { SCALLOP_NONE, SCALLOP_CROSSES, SCALLOP_GRAZES, SCALLOP_AT_END };
enum scallop_found scallop_first_zero(arb_t zero, const struct scallop_track *f, const struct scallop_stretch *stretch,
                                      slong precision);

#endif
