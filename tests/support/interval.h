/* An interval of a phase (struct scallop_interval) as functions of its offset u, and how one follows the other.
 * Header-only. */
#ifndef SCALLOP_TESTS_SUPPORT_INTERVAL_H
#define SCALLOP_TESTS_SUPPORT_INTERVAL_H

#include <stdbool.h>
#include <stddef.h>

#include "numerics/numerics.h"

static inline double sense(const struct scallop_interval *i) { return i->piece->anchor == SCALLOP_FROM_START ? 1 : -1; }
static inline double duration(const struct scallop_interval *i) { return sense(i) * (i->u_end - i->u_begin); }
static inline double length(const struct scallop_interval *i, double u) { return i->piece->curve->length(i->piece, u); }
static inline double rate(const struct scallop_interval *i, double u) { return i->piece->curve->velocity(i->piece, u); }
static inline double bend(const struct scallop_interval *i, double u)
{
  return i->piece->curve->acceleration(i->piece, u);
}
static inline bool glued(const struct scallop_interval *i) { return i->mode.s1 == 0 || i->mode.s2 == 0; }

/* The impulse of friction, whose force is `sliding` while both slide. A stuck body is held with what its own velocity 0
 * and the other one's Newton's law leave, -mu_other l'' - friction of the other. */
static inline double friction_impulse(const struct scallop_interval *i, const double mu[2], double sliding)
{
  double change = rate(i, i->u_end) - rate(i, i->u_begin);
  return i->mode.s1 == 0 ? mu[1] * change : i->mode.s2 == 0 ? -mu[0] * change : sliding * duration(i);
}

static inline bool follows(const struct scallop_interval *b, const struct scallop_interval *a)
{
  if (b->piece == a->piece)
    return a->u_end == b->u_begin;
  return b->piece == a->piece + 1 && a->u_end == a->piece->end && b->u_begin == b->piece->begin;
}

/* What is wrong with their order: they cover the phase, from x = 0, and in each a body slides for some time; NULL:
 * nothing. */
static inline const char *disorder(const struct scallop_interval *first, int count, const struct scallop_shape *shape)
{
  const struct scallop_interval *last = first + count - 1;
  if (count < 1 || first->piece != shape->pieces || first->u_begin != first->piece->begin || first->x_begin != 0)
    return "the first does not begin with the phase";
  if (last->piece != shape->pieces + shape->count - 1 || last->u_end != last->piece->end)
    return "the last does not end with the phase";
  for (const struct scallop_interval *i = first; i <= last; i++)
    if (!(duration(i) > 0) || (i->mode.s1 == 0 && i->mode.s2 == 0) || (i > first && !follows(i, i - 1)))
      return "one is empty, at rest or does not follow the one before it";
  return NULL;
}

#endif
