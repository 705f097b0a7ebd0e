/* A phase of two ramps (ramps.h) in which one body turns and turns back, or is held to the end, at once or after it has
 * turned. The same arithmetic as ramps.c, operation for operation, but inline and without a branch, so that many
 * crawlers can be solved in a row by vector instructions. Not public.
 *
 * Where a body is held to the end of a phase both bodies are then at rest, so the next phase is known, and the one
 * after it: if this comes to rest again the period is closed, and that is the steady state.
 *
 * What it saves, as in ramps.h (else a search by ramps.c, and a walk for the ways of the bodies): 1575 for 2345 for a
 * steady state with stick-slip, 1121 for 1686 in a batch.
 */
#ifndef SCALLOP_NUMERICS_EVENT_HELD_H
#define SCALLOP_NUMERICS_EVENT_HELD_H

#include <math.h>

#include "model/scaling.h"
#include "numerics/event/ramps.h"

struct held_phase {
  double c_end;
  double travel, size; /* of the centre of mass: how far it comes, and the magnitudes of the parts of that */
  double way1, way2, size1, size2; /* the same of the bodies: it is no work for those who do not look                 */
  double starts, ends;             /* signs of c after the start and before the end: starts 0 from rest             */
  double stuck;                    /* 1: the body does not turn, but is held from where it stops, to the end        */
  double margin;                   /* > 0: the motion is of this kind                                               */
  double grip;                     /* of friction on the body at the end: held where >= 0                           */
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
  /* how far the centre of mass comes: sliding straight; turning, then held or crossing; riding all the way */
  double d = r->top - t, left = r->rest - u, first_way = 0.5 * (c0 + y) * t;
  double turned_way = first_way + 0.5 * ((y + top) * d + (top + z) * left);
  double turned_size = first_way + 0.5 * ((y + fabs(top)) * d + (fabs(top) + fabs(z)) * left);
  double glued = 0.5 * r->down * (u * u),
         ridden = q0 * 0.5 * (r->up * (d * (r->top + t)) + r->down * (r->rest * r->rest));
  double held_way = (above ? q0 : -q1) * glued, crossed_way = 0.5 * (z + c_end) * u;
  double crossed_size = 0.5 * (fabs(z) + fabs(c_end)) * u, last_way = crosses ? crossed_way : held_way;
  double last_size = crosses ? crossed_size : fabs(held_way);
  double centre = turns ? turned_way + last_way : first_way + ridden;
  double centre_size = turns ? turned_size + last_size : first_way + ridden;
  /* and the body that is on its curve at the end, whose parts are small if it hardly moves: a triangle until it comes
   * to rest, another one or two until it does again, and a last one; the other body is |l| ahead or behind */
  double push0 = eps * (plain ? s->f1 : s->f2), push1 = eps * (plain ? s->f2 : s->f1); /* as body_slope of walk.h */
  double own_up = steep - push0, own_below = r->up * q1 - push1;                       /* see there */
  double slope_up = fabs(own_up) < fabs(between) ? own_up + push1 : steep - between;
  double slope_below = fabs(own_below) < fabs(between) ? own_below + push0 : r->up * q1 + between;
  double v = above ? -slope_up * d : r->up * t + slope_below * d, v_first = above ? 0 : r->up * t;
  double one = 0.5 * (c0 + v_first) * t, two = turns ? 0.5 * ((v_first + v) * d + v * left) : 0;
  double pulled = above ? (slope - push0) - push1 : (slope + push1) + push0;
  double last = crosses ? 0.5 * pulled * (u * u) : 0, near = one + two + last, near_size = one + fabs(two) + fabs(last);
  double first = above ? near : near - 1, second = above ? near + 1 : near;
  double first_size = above ? near_size : near_size + 1, second_size = above ? near_size + 1 : near_size;
  double turning = held_least(top + r->up * q1 * r->top, held_least(u, r->rest - u));
  double riding = held_least(grip, between + fall);
  return (struct held_phase){ .c_end = sign * c_end + 0.0,
                              .travel = sign * centre,
                              .size = centre_size,
                              .way1 = sign * (plain ? first : second),
                              .way2 = sign * (plain ? second : first),
                              .size1 = plain ? first_size : second_size,
                              .size2 = plain ? second_size : first_size,
                              .starts = c != 0 ? sign : 0,
                              .ends = sign * side,
                              .stuck = turns ? 0.0 : 1.0,
                              .margin = held_least(r->top - t, turns ? turning : riding),
                              .grip = grip };
}

struct held {
  double c_start, c_mid, travel, size; /* as in struct period                                                    */
  double way1, way2, size1, size2;     /* as above, over the period                                              */
  double margin;                       /* > 0: this is the steady state                                          */
  double starts[2], ends[2], stuck[2], grip[2]; /* of each phase, as above                                  */
};

/* order: +1 if friction holds a body to the end of the contraction, -1 if of the extension. The phase that is followed
 * by rest comes second, and the first begins at rest. Multiplier and balance are 0. */
SCALLOP_INLINE void held_steady(const struct scaling *s, double alpha, double order, const struct ramps *e,
                                const struct ramps *c, struct held *out)
{
  int plain = order > 0;
  double b = 1 - alpha, x1 = plain ? alpha : b, x2 = plain ? b : alpha;
  struct ramps r1 = { plain ? e->up : c->up, plain ? e->down : c->down, plain ? e->top : c->top,
                      plain ? e->rest : c->rest };
  struct ramps r2 = { plain ? c->up : e->up, plain ? c->down : e->down, plain ? c->top : e->top,
                      plain ? c->rest : e->rest };
  struct held_phase p1 = held_phase(s, x1, order, &r1, 0);
  double between = p1.c_end / x1;
  struct held_phase p2 = held_phase(s, x2, -order, &r2, between * x2);
  out->c_start = plain ? 0 : between;
  out->c_mid = plain ? between : 0;
  int rests = p1.stuck + p2.stuck > 1 && p1.ends == -p2.ends; /* the same body in both phases */
  out->travel = rests ? 0 : p1.travel + p2.travel;
  out->size = rests ? 0 : p1.size + p2.size;
  out->way1 = p1.way1 + p2.way1;
  out->way2 = p1.way2 + p2.way2;
  out->size1 = p1.size1 + p2.size1;
  out->size2 = p1.size2 + p2.size2;
  out->margin = held_least(held_least(p1.margin, p2.margin), p2.grip);
  out->starts[0] = plain ? p1.starts : p2.starts;
  out->starts[1] = plain ? p2.starts : p1.starts;
  out->ends[0] = plain ? p1.ends : p2.ends;
  out->ends[1] = plain ? p2.ends : p1.ends;
  out->stuck[0] = plain ? p1.stuck : p2.stuck;
  out->stuck[1] = plain ? p2.stuck : p1.stuck;
  out->grip[0] = plain ? p1.grip : p2.grip;
  out->grip[1] = plain ? p2.grip : p1.grip;
}

/* The modes, the regime and the changes of mode of such a steady state, from starts, ends, stuck and grip of its
 * phases. */
enum scallop_regime held_regime(const double starts[2], const double ends[2], const double stuck[2]);
void held_modes(const double starts[2], const double ends[2], const double stuck[2], const double grip[2],
                struct scallop_modes modes[2]);

#endif
