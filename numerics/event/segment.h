/* Segments of a piece, in each of which a walk (walk.h) measures its times from one origin. Not public.
 *
 * A piece of a spline, or a dwell, can be as short as 1e-8 of the phase. A time in such a piece keeps its digits only
 * if it is measured from a knot of the piece, and not from an end of the phase:
 *     a dwell, a piece of a spline           one segment, measured from where the piece begins
 *     one that ends with l' = 0              two segments of equal length; the second is measured from the end
 *     a piece of a spline, cut at half time  one segment, measured from its knot
 *     any other piece                        one segment, the piece itself */
#ifndef SCALLOP_NUMERICS_EVENT_SEGMENT_H
#define SCALLOP_NUMERICS_EVENT_SEGMENT_H

#include <math.h>

#include "model/model.h"

struct segment {
  const struct scallop_piece *given; /* the piece as the gait has it: begins and ends at offsets that are exact   */
  const struct scallop_piece *piece; /* the segment; its offsets u are from `origin`                              */
  double origin, turn;               /* u is at offset origin + turn u of the piece that is given                 */
  bool continues;                    /* a second segment follows                                                 */
  struct scallop_piece part;
  struct scallop_law law;
};

static inline bool segment_is_spline(const struct scallop_piece *p)
{
  const struct scallop_law *law = p->law;
  return !p->linear && law && law->kind == SCALLOP_LAW_BERNSTEIN && law->degree == 2 && law->bernstein.more_count == 0
         && law->bernstein.implied == 1;
}

/* Measures from the knot that the law calls near, or from its far knot. Knots are multiples of 2^-53, therefore their
 * differences are exact. */
static inline void segment_from_knot(struct segment *segment, bool far)
{
  const struct scallop_bernstein_law *given = &segment->given->law->bernstein;
  struct scallop_bernstein_law *law = &segment->law.bernstein;
  bool forward = (segment->given->anchor == SCALLOP_FROM_START) != far;
  segment->law = *segment->given->law;
  segment->law.base = 0;
  segment->origin = far ? given->far : given->near;
  segment->turn = far ? -1 : 1;
  law->b[0] = given->b[far ? 2 : 0];
  law->b[2] = given->b[far ? 0 : 2];
  law->near = 0;
  law->far = given->far - given->near;
  segment->part = *segment->given;
  segment->part.law = &segment->law;
  segment->part.anchor = forward ? SCALLOP_FROM_START : SCALLOP_FROM_END;
  segment->part.begin = segment->turn * (segment->given->begin - segment->origin);
  segment->part.end = segment->turn * (segment->given->end - segment->origin);
  segment->piece = &segment->part;
}

static inline void segment_first(struct segment *segment, const struct scallop_piece *given)
{
  segment->given = segment->piece = given;
  segment->origin = 0;
  segment->turn = 1;
  segment->continues = false;
  if (given->direction == 0) {
    segment->part = *given;
    segment->origin = given->begin;
    segment->part.begin = 0;
    segment->part.end = given->end - given->begin;
    segment->piece = &segment->part;
  } else if (segment_is_spline(given)) {
    double length = given->law->bernstein.far - given->law->bernstein.near;
    bool whole = fabs(given->end - given->begin) == length;
    segment_from_knot(segment, whole && given->anchor == SCALLOP_FROM_END);
    segment->continues = whole && given->law->bernstein.b[given->anchor == SCALLOP_FROM_START ? 2 : 0] == 0;
    if (segment->continues)
      segment->part.end = length / 2;
  }
}

static inline void segment_second(struct segment *segment)
{
  segment->continues = false;
  segment_from_knot(segment, segment->given->anchor == SCALLOP_FROM_START);
  segment->part.begin = segment->law.bernstein.far - segment->law.bernstein.far / 2;
}

#endif
