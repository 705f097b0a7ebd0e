/* The legs of a piece, from which a walk (walk.h) measures its times. Not public.
 *
 * A piece of a spline, or a dwell, may be 1e-8 of the phase long, anywhere in it. What friction does in it is known to as many digits as times
 * are relative to its length: so they are measured from a knot of the piece, and not from an end of the phase. A leg of a dwell, and one of a
 * piece of a spline, is measured from where the piece begins, where after a rise velocities are small, and decay in as short a time. The last
 * piece of a phase has a second leg, from its middle on, measured from the end of the phase. A piece of a spline that is cut at half of the
 * phase is measured from the knot that it has. Any other piece is one leg, as it is. */
#ifndef SCALLOP_LEG_H
#define SCALLOP_LEG_H

#include <math.h>

#include "model/model.h"

struct leg {
  const struct scallop_piece *given; /* the piece as the gait has it: begins and ends at offsets that are exact   */
  const struct scallop_piece *piece; /* the leg: a part of it, whose offsets u are measured from `origin`         */
  double origin, turn;               /* u is at offset origin + turn u of the piece that is given                 */
  bool goes_on;                      /* there is a second leg                                                   */
  struct scallop_piece part;
  struct scallop_law law;
};

static inline bool leg_is_spline(const struct scallop_piece *p)
{
  const struct scallop_law *law = p->law;
  return !p->linear && law && law->kind == SCALLOP_LAW_BERNSTEIN && law->degree == 2 && law->bernstein.more_count == 0
         && law->bernstein.implied == 1;
}

/* From the knot that the law calls near, or the one that it calls far. Knots are multiples of 2^-53, and so differences of them exact. */
static inline void leg_from_knot(struct leg *leg, bool far)
{
  const struct scallop_bernstein_law *given = &leg->given->law->bernstein;
  struct scallop_bernstein_law *law = &leg->law.bernstein;
  bool forward = (leg->given->anchor == SCALLOP_FROM_START) != far;
  leg->law = *leg->given->law;
  leg->law.base = 0;
  leg->origin = far ? given->far : given->near;
  leg->turn = far ? -1 : 1;
  law->b[0] = given->b[far ? 2 : 0];
  law->b[2] = given->b[far ? 0 : 2];
  law->near = 0;
  law->far = given->far - given->near;
  leg->part = *leg->given;
  leg->part.law = &leg->law;
  leg->part.anchor = forward ? SCALLOP_FROM_START : SCALLOP_FROM_END;
  leg->part.begin = leg->turn * (leg->given->begin - leg->origin);
  leg->part.end = leg->turn * (leg->given->end - leg->origin);
  leg->piece = &leg->part;
}

static inline void leg_first(struct leg *leg, const struct scallop_piece *given)
{
  leg->given = leg->piece = given;
  leg->origin = 0;
  leg->turn = 1;
  leg->goes_on = false;
  if (given->direction == 0) {
    leg->part = *given;
    leg->origin = given->begin;
    leg->part.begin = 0;
    leg->part.end = given->end - given->begin;
    leg->piece = &leg->part;
  } else if (leg_is_spline(given)) {
    double length = given->law->bernstein.far - given->law->bernstein.near;
    bool whole = fabs(given->end - given->begin) == length;
    leg_from_knot(leg, whole && given->anchor == SCALLOP_FROM_END);
    leg->goes_on = whole && given->end == 0;
    if (leg->goes_on)
      leg->part.end = length / 2;
  }
}

static inline void leg_second(struct leg *leg)
{
  leg->goes_on = false;
  leg_from_knot(leg, leg->given->anchor == SCALLOP_FROM_START);
  leg->part.begin = leg->law.bernstein.far - leg->law.bernstein.far / 2;
}

#endif
