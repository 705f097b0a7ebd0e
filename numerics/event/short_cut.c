#include "numerics/event/short_cut.h"

void course_modes(enum scallop_phase_kind kind, double course, struct scallop_modes *modes)
{
  const int code = (int)course;
  const signed char starts = (signed char)((code & COURSE_STARTS) - 1), ends = code & COURSE_ENDS ? 1 : -1;
  const signed char apart = kind == SCALLOP_EXTENSION ? -1 : 1; /* the direction of body 1 where they are opposite */
  const bool held = code & COURSE_HELD, second = apart == ends; /* the one whose direction changes at last */
  int count = 0;
  modes->kept[count] = (struct scallop_mode){ starts, starts };
  count += starts != 0;
  modes->kept[count] = (struct scallop_mode){ apart, (signed char)-apart };
  count += course_turns(course);
  modes->kept[count] = (struct scallop_mode){ held && !second ? 0 : ends, held && second ? 0 : ends };
  modes->count = count + 1;
}

/* One body is stuck throughout: the same in both phases, which is at the rear in one and in front in the other. */
enum scallop_regime course_regime(const double course[2])
{
  const double down = course_of(0, -1, 0, true), up = course_of(0, 1, 0, true);
  bool never_moves = (course[0] == down && course[1] == up) || (course[0] == up && course[1] == down);
  return never_moves ? SCALLOP_AT_REST : SCALLOP_STICK_SLIP;
}

/* The crossings of a body that turns and turns back: when, what c is there, and the slope of the curve; of the last one
 * back from the end, on curve 0 where c ends above 0, else on curve 1. */
struct crossings {
  double t, y, steep;
  double u, z, fall;
  bool above;
};

/* What a body that turns back and is not held comes to, but for the way */
static void turn(const struct line *l, double sign, double c, const struct crossings *x, struct motion *m)
{
  double last_extra = x->above ? -2 * l->f_first : 2 * l->f_second, after = x->above ? -l->eps : l->eps;
  double shear = -2 * l->f_first / (l->eps + x->steep), last_shear = last_extra / (l->between + x->fall);
  m->c_end = sign * (x->z + after * x->u) + 0.0; /* no -0 */
  m->extra_impulse = sign * (last_extra * x->u - 2 * l->f_first * x->t);
  m->slope = shear + (last_shear + l->eps * last_shear * shear);
  m->stretch = (l->between - x->steep) / (-l->eps - x->steep) * (after + x->fall) / (l->between + x->fall);
  m->first_switch = c > 0 ? x->t : 1 - x->u;
  m->last_switch = x->u;
  m->forgets = m->sticks = m->never_moved[0] = m->never_moved[1] = m->delicate = false;
  m->work.events = 2;
}

/* What a body that stops at the first time and, where it turns, is held from `u` before the end comes to */
static void hold(double c, double t, double u, bool turns, bool first_is_1, struct motion *m)
{
  bool never = !turns && c == 0;
  m->c_end = 0;
  m->first_switch = never ? NAN : c > 0 ? t : 1 - u;
  m->last_switch = never ? NAN : turns ? u : 1 - t;
  m->forgets = m->sticks = true;
  m->never_moved[0] = never && first_is_1;
  m->never_moved[1] = never && !first_is_1;
  m->delicate = false;
  m->work.events = turns ? 2 : 1;
}

/* The body that turned goes on and the other one, which strong friction has brought to rest on the way up, is held from
 * then on to the end: p is of no use after the first crossing. */
static bool is_caught(const struct line *l, const struct ramps *r, double c, struct ramp_phase *p)
{
  double steep = r->up * l->q1, meets = (p->y - l->between * p->t) / (-l->between - steep);
  double way = 1 - 0.5 * r->up * (meets * meets); /* of |l'| from then on */
  if (!(p->t < meets && meets < r->top && p->steep > l->between && r->down * l->q1 <= l->eps))
    return false;
  double first = 0.5 * (c + p->y) * p->t, z = -steep * meets, lag = meets - p->t;
  p->u = 1 - meets;
  p->side = -1;
  p->turns = 1;
  p->grip = l->eps - r->down * l->q1;
  p->way = first + 0.5 * (p->y + z) * lag - l->q1 * way;
  p->size = first + 0.5 * (p->y - z) * lag + l->q1 * way;
  return true;
}

static bool solve_ramps(const struct phase_input *in, double c_0, struct motion *motion)
{
  int direction = in->shape->pieces[0].direction;
  const struct ramps ramps = ramps_of(in->shape);
  double sign = c_0 >= 0 ? 1 : -1, c = fabs(c_0);
  struct line line = line_of(in, direction * sign > 0);
  struct ramp_phase p = ramp_phase(&line, &ramps, c);
  if (!(p.margin > 0) && c_0 == 0) { /* held where it rests: then the mirror tells which body is */
    sign = mirror_of(direction, in->delta, c_0);
    line = line_of(in, direction * sign > 0);
    p = ramp_phase(&line, &ramps, c);
  }
  if (!(p.margin > 0) && !is_caught(&line, &ramps, c, &p))
    return false;
  bool held = p.grip >= 0;
  const struct crossings x = { p.t, p.y, p.steep, p.u, p.z, p.fall, p.side > 0 };
  if (held)
    hold(c, p.t, p.u, p.turns > 0, direction * sign > 0, motion);
  else
    turn(&line, sign, c, &x, motion);
  motion->way[0] = sign * p.way;
  motion->size[0] = p.size;
  course_modes(direction > 0 ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION,
               course_of(c != 0 ? sign : 0, sign * p.side, p.turns, held), &motion->modes);
  return true;
}

struct meeting { /* of a line with a curve                                                        */
  double x;      /* when: from the start, or back from the end                                    */
  double height; /* of |l'| there                                                                  */
  double slope;  /* of |l'| there, in the direction of growing x                                    */
};

/* The first x > 0 with a + b x = q |l'(x)|, a > 0. The difference is convex, so Newton's method comes from 0 and does
 * not overshoot. ends: slope of |l'| at 0; last: the end of the piece. False: it is not in the piece. */
static bool meet(const struct scallop_piece *p, double a, double b, double q, double ends, double last,
                 struct meeting *m, struct scallop_work *work)
{
  enum { STEPS = 30 };
  double step = a / (q * ends - b), margin = 1; /* of the last look */
  m->x = 0;
  for (int i = 0; i < STEPS; i++) {
    bool is_last = step_is_last(step, m->x, margin);
    m->x += step;
    if (!(m->x > 0 && m->x < last))
      return false;
    double velocity, acceleration;
    piece_rates(p, m->x, &velocity, &acceleration);
    m->height = p->direction * velocity;
    m->slope = law_sense(p) * p->direction * acceleration;
    work->gait_evaluations++;
    work->root_iterations++;
    if (is_last)
      return true;
    step = (a + b * m->x - q * m->height) / (q * m->slope - b);
    margin = step_margin(q * m->slope, b);
  }
  return false; /* GCOVR_EXCL_LINE: convex, so Newton's method is there before that; the walk takes over if not */
}

/* From c above the curves to curve 0; from rest at once. */
static bool meet_first(const struct line *l, const struct scallop_shape *shape, double c, struct meeting *m,
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
static bool meet_last(const struct line *l, const struct scallop_shape *shape, double end, struct meeting *m,
                      struct scallop_work *work)
{
  const struct scallop_piece *p = &shape->pieces[shape->count - 1];
  double side = end > 0 ? 1 : -1, q = end > 0 ? l->q0 : l->q1, ends = -p->direction * shape->lT;
  if (!(q * ends > l->eps))
    return false;
  return meet(p, side * end, -side * l->between, q, ends, p->begin, m, work) && q * m->slope > l->eps;
}

static bool solve_concave(const struct phase_input *in, double c_0, struct motion *motion)
{
  const struct scallop_shape *shape = in->shape;
  int direction = shape->pieces[0].direction;
  double sign = c_0 >= 0 ? 1 : -1, c = fabs(c_0);
  const struct line l = line_of(in, direction * sign > 0);
  struct meeting first, last;
  if (!meet_first(&l, shape, c, &first, &motion->work))
    return false;
  double y = l.q0 * first.height, end = y + l.between * (1 - first.x);
  if (end == 0 || !meet_last(&l, shape, end, &last, &motion->work))
    return false;
  bool above = end > 0;
  double side = above ? 1 : -1, q = above ? l.q0 : -l.q1, z = q * last.height;
  const struct crossings x = { first.x, y, l.q0 * first.slope, last.x, z, q * last.slope, above };
  turn(&l, sign, c, &x, motion);
  double between = 1 - x.t - x.u, c_end = fabs(motion->c_end);
  motion->way[0] = sign * 0.5 * ((c + y) * x.t + (y + z) * between + (z + side * c_end) * x.u);
  motion->size[0] = 0.5 * ((c + y) * x.t + (y + fabs(z)) * between + (fabs(z) + c_end) * x.u);
  motion->delicate = is_delicate(x.steep, -l.eps, l.between, l.q0 * shape->l0)
                     || is_delicate(-x.fall, l.between, -side * l.eps, q * shape->lT);
  course_modes(direction > 0 ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION,
               course_of(c != 0 ? sign : 0, sign * side, 1, false), &motion->modes);
  return true;
}

bool short_cut(const struct phase_input *in, double c_0, struct motion *motion)
{
  motion->short_cut = true;
  motion->furthest = 0;
  motion->work = (struct scallop_work){ 0 };
  return in->shape->ramps ? solve_ramps(in, c_0, motion) : in->shape->concave && solve_concave(in, c_0, motion);
}
