/* The steady state with the regular modes: each phase begins and ends with both bodies moving one way, and in between
 * one of them turns back and forth, never stuck. Inline and without a branch: vector instructions solve rows of
 * crawlers. Not public.
 *
 * |l'| is concave in each phase, from 0 to 0. Then curve 0 is crossed exactly twice: |l'| lies above the line that c
 * follows between them and below it outside. If |l'| is replaced by its tangents at the two crossings, s t + k from the
 * start and s' u + k' from the end, then, with c the velocity of the centre of mass in L/tau, q |l'| the curve, f the
 * friction of the body that turns and beta = (F_turns - F_other)/(F1 + F2),
 *     t1 = (c_start - q k)/(q s + eps)                           the first crossing
 *     dT = (q (s t1 + k) + beta eps (1 - t1) - q k')/(q s' + beta eps)   the last one, from the end
 *     c_end = (q s' - eps) dT + q k'
 * All is linear in the start velocity of the period, also the balance of impulses
 *     beta (2 alpha - 1) = 2 f_e alpha (t1 + dT)_e + 2 f_c (1 - alpha) (t1 + dT)_c.
 * For |l'| made of two straight lines this is the answer; otherwise it is a step of Newton's method for all four
 * crossings and the velocity at once. With side = -1 both bodies change their direction in a phase: at the last
 * crossing the curve, the friction and c' afterwards belong to the other body, with the opposite sign. */
#ifndef SCALLOP_NUMERICS_EVENT_REGULAR_H
#define SCALLOP_NUMERICS_EVENT_REGULAR_H

#include "model/sine.h"
#include "numerics/event/motion.h"

struct tangent { /* of |l'|, as slope * time + offset; time from the start or back from the end                */
  double slope, offset;
};

/* Returns the tangent of (pi/2) sin(pi x). */
SCALLOP_INLINE struct tangent regular_sine(double x)
{
  const double pi = 3.14159265358979323846;
  double sine, cosine;
  sine_of_half_turn(x, &sine, &cosine);
  double slope = 0.5 * pi * pi * cosine;
  return (struct tangent){ slope, 0.5 * pi * sine - slope * x };
}

struct tangents { /* of one phase, at the first and at the last crossing                                         */
  struct tangent first, last;
};

struct regular_phase {
  double q, q_last;                        /* factors of the curves of the two crossings, the last one with its sign */
  double eps, between, after;              /* minus c' before, c' between, and minus c' after the crossings          */
  double f, f_last, share, weight;         /* f of the two crossings, their ratio, and f times the fraction        */
  double up, down, up_offset, down_offset; /* the tangents of the curves: of |l'|, times q                       */
  double inverse;                          /* 1/(down + between)                                                 */
  double t_start, t_slope;                 /* t1 = t_start + t_slope c, for c at the start                        */
  double u_start, u_slope;                 /* dT = u_start + u_slope c                                           */
  double c, t, u, c_end;                   /* at the start, the crossings, and at the end                        */
};

/* The two phases, each reflected if it begins backward */
struct regular_system {
  struct regular_phase e, c;
  double side;  /* +1 if the motion ends each phase in the direction in which it begins it, -1 if in the other one */
  double sign;  /* +1 if the extension begins forward                                                          */
  double drive; /* half of the mean impulse, in the direction of the start                                     */
  double alpha, b, ratio;
};

struct regular {
  double c_start, c_mid, c_end; /* in L/T                                                                      */
  double travel, multiplier, balance;
  double size;   /* of the parts of travel, at most                                                  */
  bool delicate; /* as in struct period_motion                                                              */
};

/* Sets the constants of a phase; first: body 1 turns first. */
SCALLOP_INLINE void regular_phase_of(struct regular_phase *p, const struct scallop_scaled *s, int first, double side,
                                     double fraction)
{
  p->eps = s->eps * (fraction * fraction);
  p->after = side * p->eps;
  p->between = (first ? s->delta : -s->delta) * p->eps;
  p->q = first ? s->mu2 : s->mu1;
  p->q_last = side > 0 ? p->q : first ? -s->mu1 : -s->mu2;
  p->f = first ? s->f1 : s->f2;
  p->f_last = side > 0 ? p->f : first ? -s->f2 : -s->f1;
  p->share = side > 0 ? 1 : p->f_last / p->f;
  p->weight = p->f * fraction;
}

/* driven: 2 alpha - 1 as the gait has it. */
SCALLOP_INLINE void regular_system_of(const struct scallop_scaled *s, double driven, double side,
                                      struct regular_system *r)
{
  int forward = side > 0 ? s->delta * driven > 0 : s->delta < 0; /* then body 1 turns first in the extension */
  r->side = side;
  r->sign = forward ? 1 : -1;
  r->alpha = s->fraction[SCALLOP_EXTENSION];
  r->b = s->fraction[SCALLOP_CONTRACTION];
  regular_phase_of(&r->e, s, forward, side, r->alpha);
  regular_phase_of(&r->c, s, side > 0 ? !forward : forward, side, r->b);
  r->c.weight *= side;
  r->ratio = side * (r->b / r->alpha);
  r->drive = 0.5 * (r->sign * s->delta) * driven;
}

SCALLOP_INLINE void regular_meets(struct regular_phase *p, const struct tangents *tangents)
{
  p->up = p->q * tangents->first.slope;
  p->down = p->q_last * tangents->last.slope;
  p->up_offset = p->q * tangents->first.offset;
  p->down_offset = p->q_last * tangents->last.offset;
  p->inverse = 1 / (p->down + p->between);
  double climb = (p->up - p->between) * p->inverse;
  p->t_slope = 1 / (p->up + p->eps);
  p->t_start = -p->up_offset * p->t_slope;
  p->u_slope = climb * p->t_slope;
  p->u_start = (p->between + (p->up_offset - p->down_offset)) * p->inverse + climb * p->t_start;
}

/* Follows the phase from c at its start. Returns whether these are the modes. */
SCALLOP_INLINE int regular_run(struct regular_phase *p, double c, double side)
{
  p->c = c;
  p->t = p->t_start + p->t_slope * c;
  p->u = p->u_start + p->u_slope * c;
  p->c_end = (p->down - p->after) * p->u + p->down_offset;
  return (p->t > 0) & (p->u > 0) & (p->up > p->between) & (side * p->down > side * p->after);
}

/* Solves for the times with |l'| replaced by its tangents. Returns whether these are the modes, if every time lies
 * where its tangent is meant. */
SCALLOP_INLINE int regular_times(struct regular_system *r, const struct tangents *extension,
                                 const struct tangents *contraction)
{
  struct regular_phase *e = &r->e, *c = &r->c;
  regular_meets(e, extension);
  regular_meets(c, contraction);
  double across = e->down - e->after;
  double turned_c = (c->t_slope + c->share * c->u_slope) * r->ratio; /* by the velocity at the end of the extension */
  double at_zero = r->drive - e->weight * (e->t_start + e->share * e->u_start)
                   - c->weight
                         * ((c->t_start + c->share * c->u_start) + turned_c * (across * e->u_start + e->down_offset));
  double start = at_zero
                 / (e->weight * (e->t_slope + e->share * e->u_slope) + c->weight * turned_c * (across * e->u_slope));
  int valid = regular_run(e, start, r->side);
  return valid & regular_run(c, e->c_end * r->ratio, r->side);
}

/* Of one phase: how far the centre of mass comes, and the size of that at most; shear = d c_end / d c - 1 and stretch =
 * d c_end / d c, each without a subtraction. */
struct regular_travel {
  double way, size, shear, stretch;
};

SCALLOP_INLINE struct regular_travel regular_travel(const struct regular_phase *p, double side)
{
  double t = p->t, u = p->u, y = p->up * t + p->up_offset, z = p->down * u + p->down_offset;
  double first = -2 * p->f * p->eps * p->t_slope, last = -2 * p->f_last * p->eps * p->inverse;
  return (struct regular_travel){
    .way = 0.5 * ((p->c + y) * t + (y + z) * (1 - t - u) + (z + p->c_end) * u),
    .size = 0.5 * ((p->c + y) * t + (y + side * z) * (1 - t - u) + side * (z + p->c_end) * u),
    .shear = first + last + first * last,
    .stretch = (p->up - p->between) * p->t_slope * ((p->down - p->after) * p->inverse),
  };
}

/* Computes the results from the times. Returns whether the start velocity has the direction that the modes need. */
SCALLOP_INLINE int regular_result(const struct regular_system *r, struct regular *out)
{
  const struct regular_phase *e = &r->e, *c = &r->c;
  const struct regular_travel of_e = regular_travel(e, r->side), of_c = regular_travel(c, r->side);
  double near_1 = 1 + (of_e.shear + of_c.shear + of_e.shear * of_c.shear);
  out->multiplier = near_1 > 0.5 ? near_1 : of_e.stretch * of_c.stretch;
  /* if the map shrinks the error of its argument, its value is better */
  double better = out->multiplier < 0.5 ? r->side * c->c_end * (r->alpha / r->b) : e->c;
  out->c_start = r->sign * (better / r->alpha);
  out->c_mid = r->sign * ((e->c_end + of_e.stretch * (better - e->c)) / r->alpha);
  out->c_end = r->sign * (r->side * c->c_end / r->b);
  out->travel = r->sign * (of_e.way + r->side * of_c.way);
  out->size = of_e.size + of_c.size;
  out->balance = r->sign * 2 * (r->drive - e->weight * (e->t + e->share * e->u) - c->weight * (c->t + c->share * c->u));
  return better > 0;
}

/* The tangents at the two ends of a phase: of two straight ramps they are all. */
SCALLOP_INLINE struct tangents regular_ends(const struct scallop_shape *shape)
{
  return (struct tangents){ { shape->pieces[0].direction * shape->l0, 0 },
                            { -shape->pieces[0].direction * shape->lT, 0 } };
}

/* Returns whether a step may be the last: a larger one is not, unless the line almost touches the curve. */
SCALLOP_INLINE int regular_is_near(double x, double before)
{
  double step = x - before;
  return (step < 0 ? -step : step) < 1e-6 * before;
}

/* Returns whether the crossings are so close to the points of contact t and u that new tangents touch at the crossings
 * to all digits, and have the slopes there that the multiplier needs. */
SCALLOP_INLINE int regular_settles(const struct regular_phase *p, double t, double u)
{
  double before_u = step_margin(p->down, -p->between), after_u = step_margin(p->down, p->after);
  double margin = before_u < after_u ? before_u : after_u;
  return step_is_last(p->t - t, p->t, step_margin(p->up, p->between), SMALL_STEP)
         & step_is_last(p->u - u, p->u, margin, SMALL_STEP);
}

/* Returns a margin, < 0 if a crossing is delicate; starts, ends: slopes of |l'| at the ends of the phase. */
SCALLOP_INLINE double regular_delicate_margin(const struct regular_phase *p, double starts, double ends)
{
  double first = delicate_margin(p->up, -p->eps, p->between, p->q * starts);
  double last = delicate_margin(-p->down, p->between, -p->after, p->q_last * ends);
  return first < last ? first : last;
}

/* Returns whether no body sticks at the end of a phase; slope: of |l'| there; eps: of the phase. */
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

/* Writes the modes of both phases: ++ -+ ++ | ++ +- ++, or backward -- -+ -- | -- +- --; side = -1:
 * ++ -+ -- | -- +- ++, or -- -+ ++ | ++ +- --. */
void regular_modes(bool forward, double side, struct scallop_modes modes[2]);

enum regular_outcome {
  REGULAR_MAY_BE,
  REGULAR_BELL, /* the same, for regular_solve_bell                                                     */
  REGULAR_NOT,
  CONTRACTION_STICKS, /* a body may stick to the end of the contraction                                   */
  EXTENSION_STICKS    /* of the extension only                                                              */
};

/* Returns what to look for first. Sets *guess to a velocity to begin a search at, if it is finite. */
enum regular_outcome regular_begin(const struct scallop_scaled *scaled, double *guess);

/* Solves for the steady state with the modes of regular_modes, of a gait that is concave in both phases. Returns false
 * if it has other modes, or rounding hides them; r->c_start is then a velocity to begin a search at, if it is finite.
 * Sets what it takes in *work. */
bool regular_solve(const struct scallop_scaled *scaled, double side, struct regular *r, struct scallop_work *work);

/* The same of a gait with a bell in one phase or both; then without a velocity to begin a search at. */
bool regular_solve_bell(const struct scallop_scaled *scaled, double side, struct regular *r, struct scallop_work *work);

#endif
