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

struct aim { /* of one phase                                                                        */
  double q, between,
      outside; /* of the body that turns: its curve; c' between the crossings, minus c' before and after */
  double t, u; /* the crossings                                                                    */
};

/* The tangents at the crossings just found; true: so small a step away from those before that the tangents touch at the
 * crossings, to all digits, and have the slopes there, which the multiplier needs. */
static bool touch(const struct scallop_shape *shape, double t, double u, struct aim *aim, struct tangents *tangents)
{
  *tangents = (struct tangents){ tangent_at(&shape->pieces[0], t), tangent_at(&shape->pieces[shape->count - 1], u) };
  double up = aim->q * tangents->first.slope, down = aim->q * tangents->last.slope;
  double margin = fmin(step_margin(down, -aim->between), step_margin(down, aim->outside));
  bool last = step_is_last(t - aim->t, t, step_margin(up, aim->between)) && step_is_last(u - aim->u, u, margin);
  aim->t = t;
  aim->u = u;
  return last;
}

static bool crosses_delicately(const struct scallop_shape *shape, const struct aim *aim, const struct tangents *at)
{
  return is_delicate(aim->q * at->first.slope, -aim->outside, aim->between, aim->q * shape->l0)
         || is_delicate(-aim->q * at->last.slope, aim->between, -aim->outside, aim->q * shape->lT);
}

void regular_modes(bool forward, struct scallop_modes modes[2])
{
  for (int phase = 0; phase < 2; phase++) {
    struct scallop_mode *kept = modes[phase].kept;
    modes[phase].count = 3;
    kept[0] = kept[2] = forward ? (struct scallop_mode){ 1, 1 } : (struct scallop_mode){ -1, -1 };
    kept[1] = phase == SCALLOP_EXTENSION ? (struct scallop_mode){ -1, 1 } : (struct scallop_mode){ 1, -1 };
  }
}

enum regular_outcome regular_solve(const struct scallop_scaled *s, struct regular *r, struct scallop_work *work)
{
  const struct scallop_shape *phase = s->gait->phase;
  double alpha = s->fraction[SCALLOP_EXTENSION], driven = period_driven(s->gait, alpha);
  if (!phase[0].concave || !phase[1].concave) {
    r->c_start = first_guess(s);
    return REGULAR_NOT;
  }
  struct tangents tangents[2] = { regular_ends(&phase[0]), regular_ends(&phase[1]) };
  double b = s->fraction[SCALLOP_CONTRACTION], eps_e = s->eps * (alpha * alpha), eps_c = s->eps * (b * b);
  r->c_start = 0;
  if (!regular_may_be(s, SCALLOP_CONTRACTION, driven, tangents[1].last.slope, eps_c))
    return CONTRACTION_HOLDS;
  if (!regular_may_be(s, SCALLOP_EXTENSION, driven, tangents[0].last.slope, eps_e))
    return EXTENSION_HOLDS;
  bool forward = s->delta * driven > 0;
  double beta = forward ? s->delta : -s->delta;
  struct aim aim[2] = { { .q = forward ? s->mu2 : s->mu1, .between = beta * eps_e, .outside = eps_e },
                        { .q = forward ? s->mu1 : s->mu2, .between = -beta * eps_c, .outside = eps_c } };
  bool ramps = phase[0].ramps && phase[1].ramps, last = ramps;
  work->periods = 1;
  for (int i = 0; i < STEPS; i++) {
    bool valid = regular_steady(s, driven, &tangents[0], &tangents[1], r);
    if (!valid || !regular_is_inside(&phase[0], r->t[0], r->u[0]) || !regular_is_inside(&phase[1], r->t[1], r->u[1]))
      return REGULAR_NOT;
    work->events = 4;
    if (last) {
      r->delicate = !ramps
                    && (crosses_delicately(&phase[0], &aim[0], &tangents[0])
                        || crosses_delicately(&phase[1], &aim[1], &tangents[1]));
      return REGULAR_FOUND;
    }
    last = touch(&phase[0], r->t[0], r->u[0], &aim[0], &tangents[0]);
    last &= touch(&phase[1], r->t[1], r->u[1], &aim[1], &tangents[1]);
    work->gait_evaluations += 4;
    work->root_iterations++;
  }
  return REGULAR_NOT;
}
