/* The steady state with the regular modes: each phase begins and ends with both bodies moving one way, and in between
 * one of them turns back and forth, never held. Inline and without a branch, so that many crawlers can be solved in a
 * row by vector instructions. Not public.
 *
 * For phases whose |l'| is concave, from 0 to 0. Then the first and the last crossing of curve 0 are all there is: |l'|
 * lies above the line that c follows between them and below it outside. If |l'| is replaced by its tangents at the two
 * crossings, s t + k from the start and s u + k from the end, then, with c the velocity of the centre of mass in L/tau,
 * q |l'| the curve, f the friction of the body that turns and beta = (F_turns - F_other)/(F1 + F2),
 *     t1 = (c_start - q k)/(q s + eps)                           the first crossing
 *     dT = (q (s t1 + k) + beta eps (1 - t1) - q k')/(q s' + beta eps)   the last one, from the end
 *     c_end = (q s' - eps) dT + q k'
 * so that all is linear in the start velocity of the period, and so is the balance of impulses
 *     beta (2 alpha - 1) = 2 f_e alpha (t1 + dT)_e + 2 f_c (1 - alpha) (t1 + dT)_c.
 * Where |l'| is made of two straight ramps this is the answer; elsewhere it is a step of Newton's method for all four
 * crossings and the velocity at once.
 *
 * Without it a search, period by period, would give the same answers; `make instructions` counts what it saves.
 */
#ifndef SCALLOP_NUMERICS_EVENT_REGULAR_H
#define SCALLOP_NUMERICS_EVENT_REGULAR_H

#include "numerics/event/motion.h"

struct tangent { /* of |l'|, as slope * time + offset; time from the start or back from the end                */
  double slope, offset;
};

struct tangents { /* of one phase, at the first and at the last crossing                                         */
  struct tangent first, last;
};

struct regular_phase {
  double up, down, up_offset, down_offset; /* the curves' tangents: q times those of |l'|, and the last one's sign */
  double after, between;                   /* minus c' after, and c' between the crossings                       */
  double t_start, t_slope;                 /* t1 = t_start + t_slope c, for c at the start                        */
  double u_start, u_slope;                 /* dT likewise                                                        */
  double shear, stretch;                   /* d c_end / d c - 1, and d c_end / d c, each without a subtraction       */
  double share;                            /* of dT in the impulse, beside t1                                   */
  double t, u, travel, size, c_end;        /* for the c of regular_run                                           */
};

struct regular {
  double c_start, c_mid, c_end; /* in L/T                                                                      */
  double travel, multiplier, balance;
  double size;       /* of the parts of travel, at most                                              */
  bool delicate;     /* as in struct motion                                                          */
  double t[2], u[2]; /* the crossings of each phase, from its start and back from its end          */
};

/* first: body 1 is the one that turns first. side: +1 if the same body turns back, -1 if the other one turns too. */
SCALLOP_INLINE void regular_prepare(struct regular_phase *p, const struct scallop_scaled *s,
                                    const struct tangents *tangents, int first, double side, double eps)
{
  double q = first ? s->mu2 : s->mu1, q_last = side > 0 ? q : first ? -s->mu1 : -s->mu2;
  double f = first ? s->f1 : s->f2, f_last = side > 0 ? f : first ? -s->f2 : -s->f1;
  p->up = q * tangents->first.slope;
  p->down = q_last * tangents->last.slope;
  p->up_offset = q * tangents->first.offset;
  p->down_offset = q_last * tangents->last.offset;
  p->after = side * eps;
  p->between = (first ? s->delta : -s->delta) * eps;
  double share = 1 / (p->down + p->between), climb = (p->up - p->between) * share;
  p->t_slope = 1 / (p->up + eps);
  p->t_start = -p->up_offset * p->t_slope;
  p->u_slope = climb * p->t_slope;
  double first_shear = -2 * f * eps * p->t_slope, last_shear = -2 * f_last * eps * share;
  p->shear = first_shear + last_shear + first_shear * last_shear;
  p->stretch = (p->up - p->between) * p->t_slope * ((p->down - p->after) * share);
  p->u_start = (p->between + (p->up_offset - p->down_offset)) * share + climb * p->t_start;
  p->share = side > 0 ? 1 : f_last / f;
}

/* Follows the phase from c at its start. Returns whether these are the modes. */
SCALLOP_INLINE int regular_run(struct regular_phase *p, double c, double side)
{
  double t = p->t_start + p->t_slope * c, u = p->u_start + p->u_slope * c;
  double y = p->up * t + p->up_offset, z = p->down * u + p->down_offset;
  p->t = t;
  p->u = u;
  p->c_end = (p->down - p->after) * u + p->down_offset;
  p->travel = 0.5 * ((c + y) * t + (y + z) * (1 - t - u) + (z + p->c_end) * u);
  p->size = 0.5 * ((c + y) * t + (y + side * z) * (1 - t - u) + side * (z + p->c_end) * u);
  return (t > 0) & (u > 0) & (p->up > p->between) & (side * p->down > side * p->after);
}

/* Whether the bodies move forward where the extension begins; body 1 turns first then. */
SCALLOP_INLINE int regular_is_forward(const struct scallop_scaled *s, double driven, double side)
{
  return side > 0 ? s->delta * driven > 0 : s->delta < 0;
}

/* driven: 2 alpha - 1 as the gait has it. side: +1 if the motion ends each phase in the direction in which it begins
 * it, -1 if in the other one. Returns whether these are the modes, if every time lies where its tangent is meant. */
SCALLOP_INLINE int regular_steady(const struct scallop_scaled *s, double driven, double side,
                                  const struct tangents *extension, const struct tangents *contraction,
                                  struct regular *out)
{
  int forward = regular_is_forward(s, driven, side); /* else it is seen in a mirror */
  double alpha = s->fraction[SCALLOP_EXTENSION], b = s->fraction[SCALLOP_CONTRACTION], sign = forward ? 1 : -1;
  int again = side > 0 ? !forward : forward; /* whether body 1 turns first in the contraction */
  struct regular_phase e, c;
  regular_prepare(&e, s, extension, forward, side, s->eps * (alpha * alpha));
  regular_prepare(&c, s, contraction, again, side, s->eps * (b * b));
  double ratio = side * (b / alpha), across = e.down - e.after;
  double f_e = (forward ? s->f1 : s->f2) * alpha, f_c = side * ((again ? s->f1 : s->f2) * b);
  double turned_c = (c.t_slope + c.share * c.u_slope) * ratio; /* by the velocity at the end of the extension */
  double drive = 0.5 * (sign * s->delta) * driven;
  double at_zero = drive - f_e * (e.t_start + e.share * e.u_start)
                   - f_c * ((c.t_start + c.share * c.u_start) + turned_c * (across * e.u_start + e.down_offset));
  double start = at_zero / (f_e * (e.t_slope + e.share * e.u_slope) + f_c * turned_c * (across * e.u_slope));
  int valid = regular_run(&e, start, side);
  valid &= regular_run(&c, e.c_end * ratio, side);
  double near_1 = 1 + (e.shear + c.shear + e.shear * c.shear);
  out->multiplier = near_1 > 0.5 ? near_1 : e.stretch * c.stretch;
  /* where the map shrinks the error of its argument, its value is better */
  double better = out->multiplier < 0.5 ? side * c.c_end * (alpha / b) : start;
  valid &= better > 0;
  out->c_start = sign * (better / alpha);
  out->c_mid = sign * ((e.c_end + e.stretch * (better - start)) / alpha);
  out->c_end = sign * (side * c.c_end / b);
  out->travel = sign * (e.travel + side * c.travel);
  out->size = e.size + c.size;
  out->balance = sign * 2 * (drive - f_e * (e.t + e.share * e.u) - f_c * (c.t + c.share * c.u));
  out->t[0] = e.t;
  out->u[0] = e.u;
  out->t[1] = c.t;
  out->u[1] = c.u;
  return valid;
}

/* The tangents at the two ends of a phase: of two straight ramps they are all. */
SCALLOP_INLINE struct tangents regular_ends(const struct scallop_shape *shape)
{
  return (struct tangents){ { shape->pieces[0].direction * shape->l0, 0 },
                            { -shape->pieces[0].direction * shape->lT, 0 } };
}

/* Whether no body is held where |l'| falls to 0 at the end of a phase: slope, of |l'| there; eps, of the phase. */
SCALLOP_INLINE int regular_may_be(const struct scallop_scaled *s, enum scallop_phase_kind kind, double driven,
                                  double slope, double eps)
{
  int forward = s->delta * driven > 0;
  return slope * (forward == (kind == SCALLOP_EXTENSION) ? s->mu2 : s->mu1) > eps;
}

/* The crossings lie where their tangents are meant: in the first and in the last piece. */
SCALLOP_INLINE int regular_is_inside(const struct scallop_shape *shape, double t, double u)
{
  return (t < shape->pieces[0].end) & (u < shape->pieces[shape->count - 1].begin);
}

/* Extension and contraction: ++ -+ ++ | ++ +- ++, or backward -- -+ -- | -- +- --; side: -1: ++ -+ -- | -- +- ++, or
 * -- -+ ++ | ++ +- --. */
void regular_modes(bool forward, double side, struct scallop_modes modes[2]);

enum regular_outcome {
  REGULAR_MAY_BE,
  REGULAR_NOT,
  CONTRACTION_HOLDS, /* friction may hold a body to the end of the contraction                            */
  EXTENSION_HOLDS    /* of the extension only                                                              */
};

/* Tells what to look for first, and a velocity to begin a search at, if it is finite. */
enum regular_outcome regular_begin(const struct scallop_scaled *scaled, double *guess);

/* Solves for the steady state with the modes of regular_modes, of a gait that is concave in both phases. Returns false
 * if it has other modes, or is too hard to tell; r->c_start is then a velocity to begin a search at, if it is finite.
 * Sets what it takes in *work. */
bool regular_solve(const struct scallop_scaled *scaled, double side, struct regular *r, struct scallop_work *work);

#endif
