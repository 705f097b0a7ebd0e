#include "numerics/event/motion.h"

#include <math.h>
#include <stddef.h>

#include "model/law.h"
#include "numerics/event/ramps.h"
#include "numerics/event/root.h"

typedef double real;

static inline real walk_velocity(const struct scallop_piece *p) { return p->velocity; }
static inline real walk_acceleration(const struct scallop_piece *p) { return p->acceleration; }

static inline void walk_curve(const struct scallop_piece *p, real u, real *velocity, real *acceleration)
{
  piece_rates(p, u, velocity, acceleration);
}

static inline real walk_when(const struct scallop_piece *p, real a) { return p->curve->when(p, a); }

/* Gauss's rule with four points: of |l'| or of its slope, where the differences of their integrals are small beside
 * these. */
static real short_sum(const struct scallop_piece *p, real (*of)(const struct scallop_piece *, real), real from, real to)
{
  static const double node[2] = { 0.33998104358485626480, 0.86113631159405257522 };
  static const double weight[2] = { 0.65214515486254614263, 0.34785484513745385737 };
  double middle = (from + to) / 2, half = fabs(to - from) / 2, sum = 0;
  for (int i = 0; i < 2; i++)
    sum += weight[i] * (of(p, middle - node[i] * half) + of(p, middle + node[i] * half));
  return p->direction * sum * half;
}

/* Then the rule is off by at most a sixteenth of an ulp for the sinusoidal gait. */
static bool is_short(real from, real to) { return fabs(to - from) < 0x1p-5 * fmax(from, to); }

static real walk_way(const struct scallop_piece *p, real from, real to)
{
  if (is_short(from, to))
    return short_sum(p, p->curve->velocity, from, to);
  return fabs(p->curve->length(p, to) - p->curve->length(p, from));
}

static real walk_rise(const struct scallop_piece *p, real from, real to)
{
  if (p->law && p->law->kind == SCALLOP_LAW_BERNSTEIN)
    return law_rise(p->law, from, to);
  if (!is_short(from, to))
    return p->direction * (p->curve->velocity(p, to) - p->curve->velocity(p, from));
  double forward = (to > from) == (p->anchor == SCALLOP_FROM_START) ? 1 : -1;
  return forward * short_sum(p, p->curve->acceleration, from, to);
}

struct walk;
static void walk_show(const struct walk *w, real u, real c);
#include "numerics/event/walk.h"

struct audience {
  scallop_visitor *visit;
  void *context;
};

static void walk_show(const struct walk *w, real u, real c)
{
  const struct audience *audience = w->audience;
  bool glued = w->stuck >= 0;
  struct scallop_interval interval = { .piece = w->leg.given,
                                       .u_begin = given_offset(w, w->u),
                                       .u_end = given_offset(w, u),
                                       .mode = mode_now(w),
                                       .c_begin = w->c,
                                       .c_end = c,
                                       .c_slope = glued ? 0 : w->slope[w->region],
                                       .glue = glued ? w->curve[w->stuck] * w->piece->direction : 0,
                                       .x_begin = w->out->way[0] + (w->many ? w->carried.way[0].total : 0) };
  audience->visit(audience->context, &interval);
}

void motion_modes(const struct motion *motion, enum scallop_phase_kind kind, struct scallop_modes *modes)
{
  if (motion->trail)
    trail_modes(motion->trail, kind, modes);
  else
    *modes = motion->modes;
}

double motion_left(const struct scallop_shape *shape, const struct motion *motion)
{
  double c = fabs(motion->c_end);
  return !shape->ramps && c < 0x1p-3 * motion->furthest ? c / motion->furthest : 1;
}

static struct walk_input walk_input_of(const struct motion_input *in)
{
  const struct scallop_scaled *s = in->scaled;
  return (struct walk_input){ in->shape, s->mu1, s->mu2, s->f1, s->f2, s->delta, in->eps, in->base };
}

double motion_level(const struct motion_input *in, double c, double near)
{
  const struct walk_input input = walk_input_of(in);
  return walk_level(&input, c, near);
}

static void solve(const struct motion_input *in, double c0, struct audience *audience, struct motion *motion,
                  struct motion_ways *ways)
{
  const struct walk_input input = walk_input_of(in);
  struct walk_result r;
  walk_phase(&input, c0, audience, &motion->modes, &r);
  motion->c_end = r.c_end + 0.0; /* no -0 */
  motion->travel = r.way[0];
  motion->size = r.size[0];
  motion->extra_impulse = r.extra_impulse;
  motion->slope = r.slope;
  motion->stretch = r.stretch;
  motion->furthest = r.furthest;
  motion->forgets = r.forgets;
  motion->delicate = r.delicate;
  motion->sticks = r.sticks;
  motion->never_moved[0] = r.never_moved[0];
  motion->never_moved[1] = r.never_moved[1];
  motion->first_switch = r.first_switch;
  motion->last_switch = r.last_switch;
  motion->work = r.work;
  motion->trail = 0;
  for (int i = 0; ways && i < 3; i++) {
    ways->way[i] = r.way[i];
    ways->size[i] = r.size[i];
  }
  for (int i = 0; ways && i < 2; i++)
    ways->path[i] = r.path[i];
}

void motion_solve(const struct motion_input *in, double c0, struct motion *motion, scallop_visitor *visit,
                  void *context)
{
  struct audience audience = { visit, context };
  solve(in, c0, visit ? &audience : NULL, motion, NULL);
}

void motion_solve_ways(const struct motion_input *in, double c0, struct motion *motion, struct motion_ways *ways)
{
  solve(in, c0, NULL, motion, ways);
}
