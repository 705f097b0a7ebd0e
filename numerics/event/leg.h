/* The legs of a piece: the parts of it in which a walk (walk.h) measures its times from one place. Not public.
 *
 * A piece of a spline, or a dwell, can be as short as 1e-8 of the phase. A time in such a piece keeps its digits only
 * if it is measured from a knot of the piece, and not from an end of the phase:
 *     a dwell, a piece of a spline           one leg, measured from where the piece begins
 *     one that ends with l' = 0              two legs of equal length; the second is measured from where the piece ends
 *     a piece of a spline, cut at half time  one leg, measured from its knot
 *     any other piece                        one leg, the piece itself */
#ifndef SCALLOP_NUMERICS_EVENT_LEG_H
#define SCALLOP_NUMERICS_EVENT_LEG_H

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

/* From the knot that the law calls near, or the one that it calls far. Knots are multiples of 2^-53, and so differences
 * of them exact. */
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
    leg->goes_on = whole && given->law->bernstein.b[given->anchor == SCALLOP_FROM_START ? 2 : 0] == 0;
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
