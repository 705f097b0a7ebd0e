#include "numerics/event/concave.h"

#include <math.h>
#include <stddef.h>

#include "numerics/event/ramps.h"
#include "numerics/event/root.h"

enum { STEPS = 30 };

struct meeting { /* of a line with a curve                                                        */
  double x;      /* when: from the start, or back from the end                                    */
  double height; /* of |l'| there                                                                  */
  double slope;  /* of |l'| there, in the direction of growing x                                    */
};

/* |l'| at offset m->x of a piece. */
static void look(const struct scallop_piece *p, struct meeting *m, struct scallop_work *work)
{
  double velocity, acceleration;
  piece_rates(p, m->x, &velocity, &acceleration);
  m->height = p->direction * velocity;
  m->slope = law_sense(p) * p->direction * acceleration;
  work->gait_evaluations++;
}

/* The first x > 0 with a + b x = q |l'(x)|, a > 0. The difference is convex, so Newton's method comes from 0 and does
 * not overshoot. ends: slope of |l'| at 0; last: the end of the piece. False: it is not in the piece. */
static bool meet(const struct scallop_piece *p, double a, double b, double q, double ends, double last,
                 struct meeting *m, struct scallop_work *work)
{
  double step = a / (q * ends - b);
  m->x = 0;
  double margin = 1; /* of the last look */
  for (int i = 0; i < STEPS; i++) {
    bool near = fabs(step) <= root_step(margin) * m->x;
    m->x += step;
    if (!(m->x > 0 && m->x < last))
      return false;
    look(p, m, work);
    work->root_iterations++;
    if (near)
      return true;
    step = (a + b * m->x - q * m->height) / (q * m->slope - b);
    margin = fabs(q * m->slope - b) / (fabs(q * m->slope) + fabs(b));
  }
  return false; /* GCOVR_EXCL_LINE: convex, so Newton's method is there before that; the walk takes over if not */
}

/* From c above the curves to curve 0; from rest at once. */
static bool turn(const struct line *l, const struct scallop_shape *shape, double c, struct meeting *m,
                 struct scallop_work *work)
{
  const struct scallop_piece *p = &shape->pieces[0];
  double ends = p->direction * shape->l0;
  *m = (struct meeting){ .slope = ends };
  if (c > 0 && !meet(p, c, -l->eps, l->q0, ends, p->end, m, work))
    return false;
  return l->q0 * m->slope > l->between && (c > 0 || l->between > -l->q1 * ends);
}

/* From there to the curve on whose side c would end, at `end`. */
static bool turn_back(const struct line *l, const struct scallop_shape *shape, double end, struct meeting *m,
                      struct scallop_work *work)
{
  const struct scallop_piece *p = &shape->pieces[shape->count - 1];
  double side = end > 0 ? 1 : -1, q = end > 0 ? l->q0 : l->q1, ends = -p->direction * shape->lT;
  if (!(q * ends > l->eps))
    return false;
  return meet(p, side * end, -side * l->between, q, ends, p->begin, m, work) && q * m->slope > l->eps;
}

/* The shear of a crossing, added to that of those before (motion.c) */
static double sheared(double slope, double eps, double x) { return slope + x + eps * x * slope; }

static bool is_near(double a, double b) { return fabs(a - b) < 0x1p-5 * (fabs(a) + fabs(b)); }

bool concave_solve(const struct motion_input *in, double c0, struct motion *motion)
{
  bool rear_is_1 = in->shape->pieces[0].direction > 0, forward = c0 >= 0;
  const struct line l = line_of(in, rear_is_1 == forward);
  double sign = forward ? 1 : -1, c = fabs(c0);
  struct scallop_work work = { .events = 2 };
  struct meeting first, last;
  if (!turn(&l, in->shape, c, &first, &work))
    return false;
  double y = l.q0 * first.height, end = y + l.between * (1 - first.x);
  if (end == 0 || !turn_back(&l, in->shape, end, &last, &work))
    return false;
  bool above = end > 0;
  double z = above ? l.q0 * last.height : -l.q1 * last.height, c_end = z + (above ? -l.eps : l.eps) * last.x;
  double extra = above ? -2 * l.f_first * last.x : 2 * l.f_second * last.x;
  double x = -2 * l.f_first / (l.eps + l.q0 * first.slope);
  double x_last = above ? -2 * l.f_first / (l.between + l.q0 * last.slope)
                        : 2 * l.f_second / (l.between - l.q1 * last.slope);
  double steep = l.q0 * first.slope, fall = (above ? l.q0 : -l.q1) * last.slope; /* d c_after / d c_before, twice */
  double stretch = (l.between - steep) / (-l.eps - steep) * ((above ? -l.eps : l.eps) + fall) / (l.between + fall);
  double level = 0x1p-5 * fabs(in->shape->l0);
  bool delicate = first.slope < level || last.slope < level || is_near(steep, l.between) || is_near(-fall, l.between)
                  || is_near(fall, above ? l.eps : -l.eps);
  unsigned trail = (1 + BETWEEN) | (unsigned)(1 + (above ? ABOVE : BELOW)) << TRAIL_BITS;
  trail = c > 0 ? trail << TRAIL_BITS | (1 + ABOVE) : trail;
  double between = 1 - first.x - last.x;
  double travel = sign * 0.5 * ((c + y) * first.x + (y + z) * between + (z + c_end) * last.x);
  double size = 0.5 * ((c + y) * first.x + (y + fabs(z)) * between + (fabs(z) + fabs(c_end)) * last.x);
  *motion = (struct motion){ .c_end = sign * c_end + 0.0, /* no -0 */
                             .travel = travel,
                             .size = size,
                             .extra_impulse = sign * (extra - 2 * l.f_first * first.x),
                             .slope = sheared(x, l.eps, x_last),
                             .stretch = stretch,
                             .delicate = delicate,
                             .first_switch = c > 0 ? first.x : 1 - last.x,
                             .last_switch = last.x,
                             .work = work,
                             .trail = forward ? trail : trail_mirrored(trail) };
  return true;
}
