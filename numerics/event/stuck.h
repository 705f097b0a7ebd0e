/* The steady state in which a body sticks to the end of a phase, in closed form. |l'| rises along one straight line and
 * falls along another (the quadratic gait). Inline and without a branch, for vector instructions; concave.h has the
 * same motions for any concave |l'|, and defines the mirror. Not public. */
#ifndef SCALLOP_NUMERICS_EVENT_STUCK_H
#define SCALLOP_NUMERICS_EVENT_STUCK_H

#include <math.h>
#include <stddef.h>

#include "numerics/event/motion.h"

struct ramps {
  double up, down;  /* |l'| = up t until t = top, then down (1 - t)                                       */
  double top, rest; /* rest = 1 - top                                                                    */
};

/* Returns the ramps of a shape that has them (shape->ramps). */
static inline struct ramps ramps_of(const struct scallop_shape *shape)
{
  const struct scallop_piece *a = &shape->pieces[0], *b = &shape->pieces[1];
  return (struct ramps){ a->direction * a->acceleration, -b->direction * b->acceleration, a->end, b->begin };
}

SCALLOP_INLINE double least_of(double a, double b) { return a < b ? a : b; }

struct ramp_phase {
  double side;   /* +1: c ends at or above 0, -1: below                                           */
  double turns;  /* 0: the body does not turn, but is stuck from where it stops, to the end       */
  double spare;  /* of friction on the body at the end: it is stuck there if this is >= 0         */
  double margin; /* > 0: the motion is of this kind                                               */
  double c_end;
  double way, size;     /* of the centre of mass: how far it comes, and the magnitudes of the parts of that */
  double own, own_size; /* way and size of the body that turns last, or is stuck                         */
};

/* c: at the start, >= 0 */
SCALLOP_INLINE struct ramp_phase ramp_phase(const struct line *l, const struct ramps *r, double c)
{
  double eps = l->eps, between = l->between, steep = r->up * l->q0, below = r->up * l->q1;
  double t = c / (steep + eps), y = steep * t;
  int turns = steep > between;
  double top = turns ? y + between * (r->top - t) : steep * r->top, end = top + (turns ? between : 0) * r->rest;
  int above = end > 0;
  double side = above ? 1 : -1, q = above ? l->q0 : -l->q1, fall = r->down * q, u = end / (between + fall);
  double z = fall * u, spare = eps - side * fall, apart = top + below * r->top;
  int crosses = spare < 0, early = apart < 0; /* early: the other body stops while |l'| rises still */
  double stops = (y - between * t) / (-between - below);
  double c_end = crosses ? z - side * eps * u : 0;
  /* how far the centre of mass comes: sliding straight; turning, then stuck or crossing; riding all the way */
  double d = early ? stops - t : r->top - t, at = early ? -below * stops : top;
  double left = early ? 0 : r->rest - u, first = 0.5 * (c + y) * t;
  double turned = first + 0.5 * ((y + at) * d + (at + z) * left);
  double turned_size = first + 0.5 * ((y + fabs(at)) * d + (fabs(at) + fabs(z)) * left);
  double ridden = first + l->q0 * 0.5 * (r->up * (d * (r->top + t)) + r->down * (r->rest * r->rest));
  double stuck = q * (early ? 1 - 0.5 * r->up * (stops * stops) : 0.5 * r->down * (u * u));
  double crossed = 0.5 * (z + c_end) * u;
  double last_size = crosses ? 0.5 * (fabs(z) + fabs(c_end)) * u : fabs(stuck);
  /* and the body that is on its curve at the end (small parts if it hardly moves): a triangle until it comes to rest,
   * another one or two until it does again, and a last one; own_...: as body_slope in walk_state.h */
  double push0 = eps * l->f_first, push1 = eps * l->f_second, own_up = steep - push0, own_below = below - push1;
  double slope_up = fabs(own_up) < fabs(between) ? own_up + push1 : steep - between;
  double slope_below = fabs(own_below) < fabs(between) ? own_below + push0 : below + between;
  double v_first = above ? 0 : r->up * t, v = above ? -slope_up * d : early ? 0 : r->up * t + slope_below * d;
  double one = 0.5 * (c + v_first) * t, two = turns ? 0.5 * ((v_first + v) * d + v * left) : 0;
  double pulled = above ? (fall - push0) - push1 : (fall + push1) + push0;
  double three = crosses ? 0.5 * pulled * (u * u) : 0;
  double turning = early ? least_of(stops - t, spare) : least_of(apart, least_of(u, r->rest - u));
  double riding = least_of(spare, between + r->down * l->q0);
  return (struct ramp_phase){ .side = side,
                              .turns = turns,
                              .spare = spare,
                              .margin = least_of(r->top - t, turns ? turning : riding),
                              .c_end = c_end,
                              .way = turns ? turned + (crosses ? crossed : stuck) : ridden,
                              .size = turns ? turned_size + last_size : ridden,
                              .own = one + two + three,
                              .own_size = one + fabs(two) + fabs(three) };
}

/* A phase, not reflected */
struct stuck_phase {
  double c_end, travel, size;      /* of the centre of mass                                                      */
  double way1, way2, size1, size2; /* of the bodies                                                              */
  double margin, spare, ends, turns, course;
};

/* fraction: of the period; direction: of l', +1 or -1; c: velocity of the centre of mass at the start, in L/tau. */
SCALLOP_INLINE struct stuck_phase stuck_phase(const struct scallop_scaled *s, double fraction, double direction,
                                              const struct ramps *r, double c)
{
  double sign = mirror_of(direction, s->delta, c);
  int plain = direction * sign > 0;
  const struct phase_input in = phase_input_of(s, NULL, fraction);
  const struct line line = line_of(&in, plain);
  const struct ramp_phase p = ramp_phase(&line, r, fabs(c));
  int above = p.side > 0; /* then it is the body that turned first; the other one is |l| = 1 ahead, or behind */
  double first = above ? p.own : p.own - 1, second = above ? p.own + 1 : p.own;
  double first_size = above ? p.own_size : p.own_size + 1, second_size = above ? p.own_size + 1 : p.own_size;
  return (struct stuck_phase){ .c_end = sign * p.c_end + 0.0, /* no -0 */
                               .travel = sign * p.way,
                               .size = p.size,
                               .way1 = sign * (plain ? first : second),
                               .way2 = sign * (plain ? second : first),
                               .size1 = plain ? first_size : second_size,
                               .size2 = plain ? second_size : first_size,
                               .margin = p.margin,
                               .spare = p.spare,
                               .ends = sign * p.side,
                               .turns = p.turns,
                               .course = course_of(c != 0 ? sign : 0, sign * p.side, p.turns, p.spare >= 0) };
}

/* When a body has stuck to the end of a phase, both are at rest. Therefore the next two phases are known; if the second
 * comes to rest again, the period is closed. */
struct stuck {
  double c_start, c_mid;
  double travel, size; /* as in struct period after period_sum_up                               */
  double margin;       /* > 0: this is the steady state                                         */
  double course[2];    /* of each phase                                                         */
};

/* order: +1 if a body sticks to the end of the contraction, -1 if of the extension. The phase that is followed by rest
 * comes second, and the first begins at rest. Multiplier and balance are 0. */
SCALLOP_INLINE void stuck_steady(const struct scallop_scaled *s, double order, const struct ramps *e,
                                 const struct ramps *c, struct stuck *out)
{
  int plain = order > 0;
  double a = s->fraction[SCALLOP_EXTENSION], b = s->fraction[SCALLOP_CONTRACTION], x1 = plain ? a : b,
         x2 = plain ? b : a;
  const struct ramps r1 = { plain ? e->up : c->up, plain ? e->down : c->down, plain ? e->top : c->top,
                            plain ? e->rest : c->rest };
  const struct ramps r2 = { plain ? c->up : e->up, plain ? c->down : e->down, plain ? c->top : e->top,
                            plain ? c->rest : e->rest };
  const struct stuck_phase p1 = stuck_phase(s, x1, order, &r1, 0);
  double between = p1.c_end / x1;
  const struct stuck_phase p2 = stuck_phase(s, x2, -order, &r2, between * x2);
  int rests = p1.turns + p2.turns == 0 && p1.ends == -p2.ends; /* one body in both phases */
  out->c_start = plain ? 0 : between;
  out->c_mid = plain ? between : 0;
  double travel = rests ? 0 : p1.travel + p2.travel, size = rests ? 0 : p1.size + p2.size;
  int cancels = period_cancels(travel, size, 0);
  double size1 = cancels ? p1.size1 + p2.size1 : size, size2 = cancels ? p1.size2 + p2.size2 : size;
  double way1 = p1.way1 + p2.way1, way2 = p1.way2 + p2.way2, best = least_of(size1, size);
  travel = size1 < size ? way1 : travel;
  out->travel = size2 < best ? way2 : travel;
  out->size = least_of(size2, best);
  out->margin = least_of(least_of(p1.margin, p2.margin), p2.spare);
  out->course[0] = plain ? p1.course : p2.course;
  out->course[1] = plain ? p2.course : p1.course;
}

#endif
