#include "numerics/event/motion.h"

#include <math.h>
#include <stddef.h>

#include "model/root.h"
#include "model/sine.h"

static inline real walk_velocity(const struct scallop_piece *p) { return p->velocity; }
static inline real walk_acceleration(const struct scallop_piece *p) { return p->acceleration; }

static inline void walk_curve(const struct scallop_piece *p, real u, real *velocity, real *acceleration)
{
  piece_rates(p, u, velocity, acceleration);
}

static inline real walk_when(const struct scallop_piece *p, real a) { return p->curve->when(p, a); }

/* Integrates |l'| or its slope by Gauss's rule with four points, for differences of integrals that are much smaller
 * than the integrals. */
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

static inline real walk_pi(void) { return 3.14159265358979323846; }
static inline real walk_peak(const struct scallop_shape *shape) { return shape->peak; }
static inline real walk_steepest(const struct scallop_shape *shape, bool at_end)
{
  return at_end ? -shape->pieces[shape->count - 1].direction * shape->lT : shape->pieces[0].direction * shape->l0;
}
#define walk_near(piece, start, a, b, q) (start)
static inline void walk_quickly(const struct scallop_piece *p, real x, real *velocity, real *acceleration)
{
  real s, c;
  if (!law_is_sine(p)) {
    piece_rates(p, x, velocity, acceleration);
    return;
  }
  sine_of_half_turn(x, &s, &c);
  *velocity = p->velocity * s;
  *acceleration = p->acceleration * c;
}

#include "numerics/event/solve.h"

bool short_cut(const struct phase_input *input, double c_0, struct period_motion *motion)
{
  return concave_phase(input, c_0, motion);
}

struct walker walker_of(const struct scallop_scaled *s)
{
  struct walker walker = { .fraction = { s->fraction[0], s->fraction[1] },
                           .eps = s->eps,
                           .driven = period_driven(s->gait, s->fraction[SCALLOP_EXTENSION]),
                           .gait = s->gait };
  for (int kind = 0; kind < 2; kind++)
    walker.phase[kind] = phase_input_of(s, &s->gait->phase[kind], s->fraction[kind]);
  return walker;
}

double motion_left(const struct scallop_shape *shape, const struct period_motion *motion)
{
  double c = fabs(motion->c_end);
  return !shape->ramps && c < 0x1p-3 * motion->furthest ? c / motion->furthest : 1;
}

void period_result(const struct walker *walker, const struct period *p, struct scallop_period_result *result)
{
  *result = (struct scallop_period_result){ .v_start = p->c_start,
                                            .v_mid = p->c_mid,
                                            .v_end = p->c_end,
                                            .displacement = p->travel,
                                            .multiplier = period_multiplier(walker, p),
                                            .balance = p->forgets ? (p->c_end - p->c_start) / walker->eps : p->balance,
                                            .regime = period_regime(p),
                                            .modes = { p->phase[0].modes, p->phase[1].modes } };
}

void course_modes(enum scallop_phase_kind kind, double course, struct scallop_modes *modes)
{
  const int code = (int)course;
  const signed char starts = (signed char)((code & COURSE_STARTS) - 1), ends = code & COURSE_ENDS ? 1 : -1;
  const signed char apart = kind == SCALLOP_EXTENSION ? -1 : 1;   /* direction of body 1 in opposite motion */
  const bool stuck = code & COURSE_STUCK, second = apart == ends; /* second: body 2 changes direction last */
  int count = 0;
  modes->kept[count] = (struct scallop_mode){ starts, starts };
  count += starts != 0;
  modes->kept[count] = (struct scallop_mode){ apart, (signed char)-apart };
  count += course_turns(course);
  modes->kept[count++] = (struct scallop_mode){ stuck && !second ? 0 : ends, stuck && second ? 0 : ends };
  modes->kept[count] = (struct scallop_mode){ ends, ends };
  count += (code & COURSE_RELEASED) != 0;
  modes->count = count;
}

/* Returns at-rest if one body, rear in one phase and front in the other, is stuck throughout; else stick-slip. */
enum scallop_regime course_regime(const double course[2])
{
  const double down = course_of(0, -1, 0, true), up = course_of(0, 1, 0, true);
  bool never_moves = (course[0] == down && course[1] == up) || (course[0] == up && course[1] == down);
  return never_moves ? SCALLOP_AT_REST : SCALLOP_STICK_SLIP;
}
