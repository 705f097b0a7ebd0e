/* A phase of two ramps (ramps.h) in which one body turns and turns back, or is held to the end, at once or after it has turned.
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
  double stuck;        /* 1: the body does not turn, but is held from where it stops, to the end        */
  double margin;       /* > 0: the motion is of this kind                                               */
  double grip;         /* of friction on the body at the end: held where >= 0                           */
};

SCALLOP_INLINE double held_least(double a, double b) { return a < b ? a : b; }

/* fraction: of the period; direction: of l', +1 or -1; c: velocity of the centre of mass at the start, in L/tau. */
SCALLOP_INLINE struct held_phase held_phase(const struct scaling *s, double fraction, double direction,
                                            const struct ramps *r, double c)
{
  double eps = s->eps * (fraction * fraction), c0 = fabs(c), drive = c != 0 ? c : direction * s->delta;
  double sign = drive >= 0 ? 1 : -1; /* seen in a mirror where it is -1, as in ramps.c */
  int plain = direction * sign > 0;
  double q0 = plain ? s->mu2 : s->mu1, q1 = plain ? s->mu1 : s->mu2, between = eps * (plain ? s->delta : -s->delta);
  double steep = r->up * q0, t = c0 / (steep + eps), y = steep * t, fall = r->down * q0;
  int turns = steep > between;
  double top = turns ? y + between * (r->top - t) : steep * r->top, end = top + between * r->rest;
  int above = turns ? end > 0 : 1;
  double side = above ? 1 : -1, slope = r->down * (above ? q0 : -q1), u = end / (between + slope), z = slope * u;
  double grip = eps - side * slope;
  int crosses = grip < 0;
  double c_end = crosses ? z - side * eps * u : 0;
  double travel = 0.5 * (c0 + y) * t, ride = travel + q0 * (0.5 * r->up * (r->top - t) * (r->top + t));
  travel += 0.5 * (y + top) * (r->top - t);
  travel += 0.5 * (top + z) * (r->rest - u);
  travel += crosses ? 0.5 * (z + c_end) * u : (above ? q0 : -q1) * (0.5 * r->down * (u * u));
  ride += q0 * (0.5 * r->down * (r->rest * r->rest));
  double turning = held_least(top + r->up * q1 * r->top, held_least(u, r->rest - u));
  double riding = held_least(grip, between + fall);
  return (struct held_phase){ .c_end = sign * c_end + 0.0,
                              .travel = sign * (turns ? travel : ride),
                              .starts = c != 0 ? sign : 0,
                              .ends = sign * side,
                              .stuck = turns ? 0.0 : 1.0,
                              .margin = held_least(r->top - t, turns ? turning : riding),
                              .grip = grip };
}

/* The modes of such a phase, with starts, ends and whether the body is stuck or held at the end. */
static inline void held_modes(enum scallop_phase_kind kind, int starts, int ends, bool stuck, bool held,
                              struct scallop_modes *modes)
{
  struct scallop_mode *m = modes->kept, opposite = { -1, 1 };
  if (kind == SCALLOP_CONTRACTION)
    opposite = (struct scallop_mode){ 1, -1 };
  if (starts != 0)
    *m++ = (struct scallop_mode){ (signed char)starts, (signed char)starts };
  if (!stuck)
    *m++ = opposite;
  *m = (struct scallop_mode){ (signed char)ends, (signed char)ends };
  if (held && opposite.s1 != ends) /* it is the other body that goes on */
    m->s1 = 0;
  else if (held)
    m->s2 = 0;
  modes->count = (int)(m - modes->kept) + 1;
}

#endif
