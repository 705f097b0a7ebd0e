/* The exact motion over a phase whose |l'| rises along one straight line and falls along another, from rest to rest:
 * the quadratic gait. What motion.c finds by walking from event to event is here a tree of closed forms, one division
 * an event; and nothing is rounded that motion.c keeps. Not public.
 *
 * Without it concave.c and motion.c would give the same answers; `make instructions` counts what it saves.
 */
#ifndef SCALLOP_NUMERICS_EVENT_RAMPS_H
#define SCALLOP_NUMERICS_EVENT_RAMPS_H

#include "numerics/event/motion.h"

struct ramps {
  double up, down;  /* |l'| = up t until t = top, then down (1 - t)                                       */
  double top, rest; /* rest = 1 - top                                                                    */
};

/* The regions and curves of motion.c on which c lies in turn, in short: state + 1 in three bits each, the first one
 * lowest. */
enum trail_state { ABOVE, BETWEEN, BELOW, HELD_ABOVE /* on curve 0 */, HELD_BELOW /* on curve 1 */ };
enum { TRAIL_BITS = 3, TRAIL_MASK = 7 };
unsigned trail_mirrored(unsigned trail);
void trail_modes(unsigned trail, enum scallop_phase_kind kind, struct scallop_modes *modes);

/* What c meets, in units of the phase, seen in a mirror where c starts below 0: curve 0 is c = q0 |l'|, curve 1 is c =
 * -q1 |l'|. */
struct line {
  double q0, q1, eps, between; /* c' is -eps, between, eps in regions 0, 1, 2                            */
  double f_first, f_second;    /* of the body that turns first, and of the other, over F1 + F2           */
};

/* plain: body 1 is the one that turns first. */
static inline struct line line_of(const struct motion_input *in, bool plain)
{
  const struct scallop_scaled *s = in->scaled;
  return (struct line){ .q0 = plain ? s->mu2 : s->mu1,
                        .q1 = plain ? s->mu1 : s->mu2,
                        .eps = in->eps,
                        .between = in->eps * (plain ? s->delta : -s->delta),
                        .f_first = plain ? s->f1 : s->f2,
                        .f_second = plain ? s->f2 : s->f1 };
}

/* For a shape that has them (shape->ramps). */
static inline struct ramps ramps_of(const struct scallop_shape *shape)
{
  const struct scallop_piece *a = &shape->pieces[0], *b = &shape->pieces[1];
  return (struct ramps){ a->direction * a->acceleration, -b->direction * b->acceleration, a->end, b->begin };
}

/* As motion_solve, without a visitor; the modes come as motion->trail. False: something touches or meets exactly,
 * within rounding, which is for motion_solve to judge; *motion is then of no use. */
bool ramps_solve(const struct motion_input *input, double c0, struct motion *motion);

#endif
