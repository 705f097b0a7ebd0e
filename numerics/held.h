/* A phase of two ramps (ramps.h) in which no body is held while |l'| rises: one may turn, turn back, or be held to the end.
 * The same arithmetic as ramps.c, operation for operation, but inline and without a branch, so that many crawlers can be
 * solved in a row by vector instructions. Not public.
 *
 * Where a body is held to the end of a phase both bodies are then at rest, so the next phase is known, and the one after it: if
 * this comes to rest again the period is closed, and that is the steady state.
 */
#ifndef SCALLOP_HELD_H
#define SCALLOP_HELD_H

#include <math.h>

#include "model/scaling.h"
#include "numerics/ramps.h"

struct held_phase {
  double c_end, travel;
  double starts, ends; /* signs of c after the start and before the end: starts 0 from rest             */
  double margin;       /* > 0: the motion is of this kind                                               */
  double grip;         /* of friction on the body at the end: held where >= 0                           */
};

SCALLOP_INLINE double held_least(double a, double b) { return a < b ? a : b; }

/* fraction: of the period; direction: of l', +1 or -1; c: velocity of the centre of mass at the start, in L/tau. */
SCALLOP_INLINE struct held_phase held_phase(const struct scaling *s, double fraction, double direction,
                                            const struct ramps *r, double c)
{
  double eps = s->eps * (fraction * fraction), sign = c >= 0 ? 1 : -1, c0 = fabs(c);
  int plain = direction * sign > 0;
  double q0 = plain ? s->mu2 : s->mu1, q1 = plain ? s->mu1 : s->mu2, between = eps * (plain ? s->delta : -s->delta);
  double steep = r->up * q0, t = c0 / (steep + eps), y = steep * t;
  double top = y + between * (r->top - t), end = top + between * r->rest;
  int above = end > 0;
  double side = above ? 1 : -1, slope = r->down * (above ? q0 : -q1), u = end / (between + slope), z = slope * u;
  double grip = eps - side * slope;
  int crosses = grip < 0;
  double c_end = crosses ? z - side * eps * u : 0;
  double travel = 0.5 * (c0 + y) * t;
  travel += 0.5 * (y + top) * (r->top - t);
  travel += 0.5 * (top + z) * (r->rest - u);
  travel += crosses ? 0.5 * (z + c_end) * u : (above ? q0 : -q1) * (0.5 * r->down * (u * u));
  return (struct held_phase){ .c_end = sign * c_end + 0.0,
                              .travel = sign * travel,
                              .starts = c != 0 ? sign : 0,
                              .ends = sign * side,
                              .margin = held_least(held_least(r->top - t, steep - between),
                                                   held_least(top + r->up * q1 * r->top, held_least(u, r->rest - u))),
                              .grip = grip };
}

/* The modes of such a phase. */
static inline void held_modes(enum scallop_phase_kind kind, int starts, int ends, bool held, struct scallop_modes *modes)
{
  struct scallop_mode *m = modes->kept,
                      opposite = kind == SCALLOP_EXTENSION ? (struct scallop_mode){ -1, 1 } : (struct scallop_mode){ 1, -1 };
  if (starts != 0)
    *m++ = (struct scallop_mode){ (signed char)starts, (signed char)starts };
  *m++ = opposite;
  *m = (struct scallop_mode){ (signed char)ends, (signed char)ends };
  if (held && opposite.s1 != ends) /* it is the other body that goes on */
    m->s1 = 0;
  else if (held)
    m->s2 = 0;
  modes->count = (int)(m - modes->kept) + 1;
}

#endif
