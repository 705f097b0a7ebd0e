#include "numerics/event/regular.h"

#include <math.h>
#include <stddef.h>

enum { STEPS = 24 };

/* The steady velocity for T -> 0 when it is small against |l'|: only a place to begin. */
static double first_guess(const struct scallop_scaled *s)
{
  const struct scallop_shape *e = &s->gait->phase[SCALLOP_EXTENSION];
  const struct scallop_shape *c = &s->gait->phase[SCALLOP_CONTRACTION];
  double a = s->fraction[SCALLOP_EXTENSION], b = s->fraction[SCALLOP_CONTRACTION];
  double spread_e = 2 * a * a * fabs(1 / e->l0 - 1 / e->lT), spread_c = 2 * b * b * fabs(1 / c->l0 - 1 / c->lT);
  double driven = s->delta * (a - b);
  double forward = s->f1 * spread_e / s->mu2 + s->f2 * spread_c / s->mu1;
  double backward = s->f2 * spread_e / s->mu1 + s->f1 * spread_c / s->mu2;
  return driven / (driven > 0 ? forward : backward);
}

/* The tangent of |l'| at offset x of a piece, in the direction of growing x. */
static struct tangent tangent_at(const struct scallop_piece *p, double x)
{
  double velocity, acceleration;
  piece_rates(p, x, &velocity, &acceleration);
  double slope = law_sense(p) * p->direction * acceleration;
  return (struct tangent){ slope, p->direction * velocity - slope * x };
}

struct aim {             /* of one phase                                                                        */
  double first, last;    /* factors of the curves of the two crossings                                  */
  double between, after; /* c' between the crossings, and minus c' after them                           */
  double before;         /* minus c' before them                                                        */
  double t, u;           /* the crossings                                                               */
};

static struct aim aim_of(const struct scallop_scaled *s, enum scallop_phase_kind kind, bool first, double side)
{
  const double fraction = s->fraction[kind], eps = s->eps * (fraction * fraction), q = first ? s->mu2 : s->mu1;
  return (struct aim){ .first = q,
                       .last = side > 0 ? q
                               : first  ? -s->mu1
                                        : -s->mu2,
                       .between = (first ? s->delta : -s->delta) * eps,
                       .after = side * eps,
                       .before = eps };
}

/* Puts the tangents at the crossings just found. Returns true if they are so small a step away from those before that
 * the tangents touch at the crossings, to all digits, and have the slopes there, which the multiplier needs. */
static bool touch(const struct scallop_shape *shape, double t, double u, struct aim *aim, struct tangents *tangents)
{
  *tangents = (struct tangents){ tangent_at(&shape->pieces[0], t), tangent_at(&shape->pieces[shape->count - 1], u) };
  double up = aim->first * tangents->first.slope, down = aim->last * tangents->last.slope;
  double margin = fmin(step_margin(down, -aim->between), step_margin(down, aim->after));
  bool last = step_is_last(t - aim->t, t, step_margin(up, aim->between)) && step_is_last(u - aim->u, u, margin);
  aim->t = t;
  aim->u = u;
  return last;
}

static bool crosses_delicately(const struct scallop_shape *shape, const struct aim *aim, const struct tangents *at)
{
  return is_delicate(aim->first * at->first.slope, -aim->before, aim->between, aim->first * shape->l0)
         || is_delicate(-aim->last * at->last.slope, aim->between, -aim->after, aim->last * shape->lT);
}

void regular_modes(bool forward, double side, struct scallop_modes modes[2])
{
  const struct scallop_mode to[2] = { { -1, -1 }, { 1, 1 } }, apart[2] = { { -1, 1 }, { 1, -1 } };
  const bool middle = forward == (side > 0); /* the direction between the phases */
  modes[0].count = modes[1].count = 3;
  modes[0].kept[0] = modes[1].kept[2] = to[forward];
  modes[0].kept[1] = apart[0];
  modes[1].kept[1] = apart[1];
  modes[0].kept[2] = modes[1].kept[0] = to[middle];
}

bool regular_solve(const struct scallop_scaled *s, double side, struct regular *r, struct scallop_work *work)
{
  const struct scallop_shape *phase = s->gait->phase;
  const double driven = period_driven(s->gait, s->fraction[SCALLOP_EXTENSION]);
  const bool forward = regular_is_forward(s, driven, side);
  struct tangents tangents[2] = { regular_ends(&phase[0]), regular_ends(&phase[1]) };
  struct aim aim[2] = { aim_of(s, SCALLOP_EXTENSION, forward, side),
                        aim_of(s, SCALLOP_CONTRACTION, side > 0 ? !forward : forward, side) };
  bool ramps = phase[0].ramps && phase[1].ramps, last = ramps;
  work->periods = 1;
  for (int i = 0; i < STEPS; i++) {
    bool valid = side > 0 ? regular_steady(s, driven, 1, &tangents[0], &tangents[1], r)
                          : regular_steady(s, driven, -1, &tangents[0], &tangents[1], r);
    if (!valid || !regular_is_inside(&phase[0], r->t[0], r->u[0]) || !regular_is_inside(&phase[1], r->t[1], r->u[1]))
      return false;
    work->events = 4;
    if (last) {
      r->delicate = !ramps
                    && (crosses_delicately(&phase[0], &aim[0], &tangents[0])
                        || crosses_delicately(&phase[1], &aim[1], &tangents[1]));
      return true;
    }
    last = touch(&phase[0], r->t[0], r->u[0], &aim[0], &tangents[0]);
    last &= touch(&phase[1], r->t[1], r->u[1], &aim[1], &tangents[1]);
    work->gait_evaluations += 4;
    work->root_iterations++;
  }
  return false;
}

enum regular_outcome regular_begin(const struct scallop_scaled *s, double *guess)
{
  const struct scallop_shape *phase = s->gait->phase;
  const double a = s->fraction[SCALLOP_EXTENSION], b = s->fraction[SCALLOP_CONTRACTION];
  const double driven = period_driven(s->gait, a);
  *guess = 0;
  if (!phase[0].concave || !phase[1].concave) {
    *guess = first_guess(s);
    return REGULAR_NOT;
  }
  const double e = -phase[0].pieces[0].direction * phase[0].lT, c = -phase[1].pieces[0].direction * phase[1].lT;
  if (!regular_may_be(s, SCALLOP_CONTRACTION, driven, c, s->eps * (b * b)))
    return CONTRACTION_HOLDS;
  return regular_may_be(s, SCALLOP_EXTENSION, driven, e, s->eps * (a * a)) ? REGULAR_MAY_BE : EXTENSION_HOLDS;
}
