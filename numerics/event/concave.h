/* Solution of a phase without a walk, one text for every floating type: a part of solve.h. Not public.
 *
 * |l'| is concave and 0 at both ends of the phase. By symmetry c starts at or above 0: a motion that starts below, or
 * leaves rest downwards, is reflected: curve 0 and curve 1, region 0 and region 2 change places (walk_state.h defines
 * curves and regions). Then c meets curve 0 once while |l'| rises, and continues
 *     along curve 0, if the body sticks there, or
 *     in the convex region 1. Therefore c leaves it exactly once: through curve 0 if it would end above 0, else through
 *     curve 1.
 * There the body reverses again, or sticks until |l'| falls too steeply for friction, or to the end. As |l'| falls ever
 * more steeply, no other event follows. Crossings are roots of a convex function: Newton's method does not overshoot.
 *
 * Motions of another kind, or too near to one, are left to the walk. Before including this file define
 *
 *     walk_quickly(piece, x, &velocity, &acceleration)    l' and l'' of a curved piece, not next to its peak
 *     walk_near(piece, start, a, b, q)    a place to begin Newton's method in a curved piece: start, or one nearer to
 *                                         the root of a + b x = q |l'(x)|
 *     SMALL_STEP, SMALL_THIRD_STEP        a relative step with its square, or third power, below rounding
 *     walk_pi(), walk_peak(shape), walk_steepest(shape, at_end)    of curved pieces: max |l'|, and its slope at an end
 */
#include <math.h>
#include <stddef.h>

struct meeting { /* of a line with a curve                                                        */
  real x;        /* when: from the start, or back from the end                                    */
  real level;    /* of the curve there: q |l'|                                                    */
  real slope;    /* of the curve there, in the direction of growing x                             */
  real covered;  /* integral of |l'| from the start, or to the end, of a plain shape               */
};

/* Returns |l'| and its slope, in the direction of growing x. */
static inline struct rates concave_rates(const struct scallop_piece *p, real x, struct scallop_work *work)
{
  real velocity, acceleration;
  walk_quickly(p, x, &velocity, &acceleration);
  work->gait_evaluations++;
  return (struct rates){ p->direction * velocity, law_sense(p) * p->direction * acceleration };
}

/* Returns the slope of |l'| at the beginning, or back from the end. */
static inline real concave_slope(const struct scallop_shape *shape, bool at_end)
{
  const struct scallop_piece *p = &shape->pieces[at_end ? shape->count - 1 : 0];
  return p->linear ? p->direction * law_sense(p) * walk_acceleration(p) : walk_steepest(shape, at_end);
}

/* Returns a step of Newton's method for a + b x = q |l'(x)| from x; of Halley's for a sine, as |l'| gives its second
 * derivative. Sets *margin for step_is_last. */
static inline real concave_step(const struct scallop_piece *p, real a, real b, real q, real x,
                                const struct rates *there, real *margin)
{
  const real slope = q * there->rate - b, step = (a + b * x - q * there->speed) / slope;
  *margin = step_margin(q * there->rate, b);
  if (!law_is_sine(p))
    return step;
  const real bend = 1 - step * (q * there->speed * (walk_pi() * walk_pi() / 2)) / slope;
  return 2 * bend > 1 ? step / bend : step;
}

/* Returns |l'|, its slope and its integral from the anchor, a small step further along a sine. */
static inline struct meeting concave_sine(real x, real q, struct rates there, real step)
{
  const real square = walk_pi() * walk_pi(), half = step / 2;
  const real speed = there.speed + step * (there.rate - square * there.speed * half);
  const real rate = there.rate - square * step * (there.speed + there.rate * half);
  const real sine = speed / (walk_pi() / 2), cosine = rate / (square / 2);
  return (struct meeting){ x + step, q * speed, q * rate, sine * sine / (2 + 2 * cosine) };
}

/* Finds x > 0 with a + b x = q |l'(x)| in a curved piece, from a start on its convex side, with the first step given.
 * Returns false if it is not in the piece before `last`. */
static bool concave_meet_curve(const struct scallop_piece *p, real a, real b, real q, real start, real step, real last,
                               struct meeting *m, struct scallop_work *work)
{
  enum { STEPS = 30 };
  const bool sine = law_is_sine(p);
  struct rates there = { 0, 0 };
  real x = walk_near(p, start, a, b, q), margin = 1; /* of the last look */
  if (x == start) {                                  /* one step without a look */
    x += step;
    step = 0;
  }
  for (int i = 0; i < STEPS && x > 0 && x < last; i++) {
    const bool is_last = step_is_last(step, x, margin, SMALL_STEP) && i > 0;
    there = concave_rates(p, x, work);
    if (is_last) {
      *m = (struct meeting){ x, q * there.speed, q * there.rate, 0 };
      return true;
    }
    work->root_iterations++;
    step = concave_step(p, a, b, q, x, &there, &margin);
    if (sine && step_is_last(step, x, margin, SMALL_THIRD_STEP)) {
      *m = concave_sine(x, q, there, step);
      return m->x > 0 && m->x < last;
    }
    x += step;
  }
  return false;
}

/* Finds that x in any piece; in a straight one the first step ends at the root, and the start is 0. */
static inline bool concave_meet(const struct scallop_piece *p, real a, real b, real q, real start, real step, real last,
                                struct meeting *m, struct scallop_work *work)
{
  if (!p->linear)
    return concave_meet_curve(p, a, b, q, start, step, last, m, work);
  const real rate = p->direction * law_sense(p) * walk_acceleration(p), slope = q * rate;
  *m = (struct meeting){ step, slope * step, slope, (real)0.5 * rate * (step * step) };
  return step > 0 && step < last;
}

/* Returns the integral of |l'| between two offsets of a piece; less, more: from the anchor to the nearer and to the
 * farther one. */
static real concave_covers(const struct scallop_piece *p, real near, real far, real less, real more)
{
  if (p->linear)
    return (real)0.5 * magnitude(walk_acceleration(p)) * ((far - near) * (far + near));
  return far - near < far / 32 ? walk_way(p, near, far) : more - less;
}

/* Returns whether stuck bodies are followed here: in a polynomial the walk measures times from the nearest knot. */
static inline bool concave_is_plain(const struct scallop_shape *shape)
{
  const struct scallop_piece *p = shape->pieces;
  return shape->ramps || (shape->count == 2 && law_is_sine(&p[0]) && law_is_sine(&p[1]));
}

/* A straight line between two others, of one piece or more: |l'| at its ends, its slope in time, and how long it lasts;
 * 0: the shape is not made of three lines */
struct middle {
  real begins, ends, slope, lasts;
};
static struct middle concave_middle(const struct scallop_shape *shape)
{
  const struct scallop_piece *p = shape->pieces, *last = &p[shape->count - 1];
  bool lines = shape->count > 2 && p->linear && last->linear;
  for (int i = 1; lines && i < shape->count - 1; i++)
    lines = p[i].linear && p[i].acceleration == p[1].acceleration;
  if (!lines)
    return (struct middle){ .lasts = 0 };
  return (struct middle){ .begins = magnitude(walk_acceleration(p)) * p->end,
                          .ends = magnitude(walk_acceleration(last)) * last->begin,
                          .slope = p[1].direction * walk_acceleration(&p[1]),
                          .lasts = 1 - last->begin - (real)p->end };
}

/* Returns max |l'| of a plain shape, where its pieces meet. */
static inline real concave_peak(const struct scallop_shape *shape)
{
  const struct scallop_piece *first = &shape->pieces[0];
  return first->linear ? magnitude(walk_acceleration(first)) * first->end : walk_peak(shape);
}

/* Follows c from the first crossing through region 1 to where it leaves it. Returns false if the walk must do it. */
static bool concave_leave(const struct line *l, const struct scallop_shape *shape, struct passage *k,
                          struct scallop_work *work)
{
  const struct scallop_piece *first = &shape->pieces[0], *last = &shape->pieces[shape->count - 1];
  const real top = first->end;
  struct meeting m;
  k->at_top = k->y + l->between * (top - k->t);
  const real end = k->at_top + l->between * (1 - top);
  k->side = end > 0 ? 1 : -1;
  const real q = end > 0 ? l->q0 : l->q1;
  const struct middle middle = concave_middle(shape);
  const real peak = middle.lasts > 0 ? middle.begins : concave_is_plain(shape) ? concave_peak(shape) : INFINITY;
  const real beyond = k->side * k->at_top - q * peak;
  k->early = beyond > 0;
  if (end == 0)
    return false;
  if (!k->early && middle.lasts > 0 && k->side * (k->at_top + l->between * middle.lasts) > q * middle.ends) {
    const real after = -beyond / (k->side * l->between - q * middle.slope);
    k->early = k->in_middle = true;
    k->x = top + after;
    k->z = q * (middle.begins + middle.slope * after);
    k->fall = -q * middle.slope;
    return after > 0 && after < middle.lasts;
  }
  if (!k->early) {
    const real ends = q * concave_slope(shape, true), a = k->side * end, b = -k->side * l->between;
    if (!concave_meet(last, a, b, q, 0, a / (ends - b), last->begin, &m, work))
      return false;
    k->fall = m.slope;
  } else {
    const real b = k->side * l->between, a = k->side * (k->y - l->between * k->t);
    const real rises = q * concave_slope(shape, false), step = first->linear ? a / (rises - b) : -beyond / b;
    if (!concave_meet(first, a, b, q, first->linear ? 0 : top, step, top, &m, work))
      return false;
    if (!(m.x > k->t) || 16 * magnitude(m.slope - b) < magnitude(m.slope) + magnitude(b)) /* it grazes the curve */
      return false;
    k->fall = -m.slope;
  }
  k->x = m.x;
  k->z = m.level;
  k->x_covered = m.covered;
  return true;
}

/* Follows a body that is stuck from the offset k->x on, to the end or to its release. Returns false as above. */
static bool concave_stick(const struct line *l, const struct scallop_shape *shape, struct passage *k,
                          struct scallop_work *work)
{
  const struct scallop_piece *last = &shape->pieces[shape->count - 1];
  const real q = k->side > 0 ? l->q0 : l->q1, ends = q * concave_slope(shape, true);
  const struct middle middle = concave_middle(shape);
  if (!concave_is_plain(shape) && !(middle.lasts > 0))
    return false;
  k->released = ends > l->eps;
  k->u = k->w = k->u_covered = 0;
  if (k->early && -q * middle.slope > l->eps) /* released in the middle */
    return false; /* GCOVR_EXCL_LINE: where the middle falls, in skewed gaits, it falls more slowly than |l'| rises */
  if (!k->released)
    return true;
  k->u = last->linear ? last->begin : walk_when(last, -last->direction * (l->eps / q));
  if (!(k->u > 0 && k->u <= last->begin && (k->early || k->u < k->x)))
    return false;
  if (last->linear) {
    k->w = q * (concave_slope(shape, true) * k->u);
    k->u_covered = concave_covers(last, 0, k->u, 0, 0);
  } else {
    const struct meeting m = concave_sine(k->u, q, concave_rates(last, k->u, work), 0);
    k->w = m.level;
    k->u_covered = m.covered;
  }
  return true;
}

/* Sets impulse and derivative of the map, for a phase in which no body sticks. */
static void concave_turn(const struct line *l, const struct scallop_shape *shape, const struct passage *k,
                         struct period_motion *m)
{
  const bool above = k->side > 0;
  const real last_extra = above ? -2 * l->f_first : 2 * l->f_second, after = above ? -l->eps : l->eps;
  const real fall = k->side * k->fall, shear = -2 * l->f_first / (l->eps + k->steep);
  const real last_shear = last_extra / (l->between + fall);
  m->extra_impulse = k->sign * (last_extra * k->u - 2 * l->f_first * k->t);
  m->slope = shear + (last_shear + l->eps * last_shear * shear);
  m->stretch = (l->between - k->steep) / (-l->eps - k->steep) * (after + fall) / (l->between + fall);
  m->delicate = !shape->pieces[0].linear
                && (is_delicate(k->steep, -l->eps, l->between, l->q0 * concave_slope(shape, false))
                    || is_delicate(-fall, l->between, after, (above ? l->q0 : l->q1) * concave_slope(shape, true)));
}

struct concave_parts {      /* how far the centre of mass comes, seen in the mirror, and the sizes of that */
  real before, before_size; /* until it leaves region 1                                         */
  real stuck, after;
};

static struct concave_parts concave_parts(const struct scallop_shape *shape, const struct passage *k)
{
  const struct scallop_piece *first = &shape->pieces[0], *last = &shape->pieces[shape->count - 1];
  const real top = first->end, z = k->side * k->z, begin = (real)0.5 * (k->c + k->y) * k->t;
  struct concave_parts parts = { begin, begin, 0, (real)0.5 * (k->w + k->end) * k->u };
  if (k->turns && k->early) {
    parts.before += (real)0.5 * (k->y + z) * (k->x - k->t);
    parts.before_size += (real)0.5 * (k->y + k->z) * (k->x - k->t);
  } else if (k->turns) {
    const real d = top - k->t, left = 1 - top - k->x, at_top = magnitude(k->at_top);
    parts.before += (real)0.5 * ((k->y + k->at_top) * d + (k->at_top + z) * left);
    parts.before_size += (real)0.5 * ((k->y + at_top) * d + (at_top + k->z) * left);
  }
  if (k->sticks && k->early) {
    const struct middle middle = concave_middle(shape);
    const real from = k->in_middle ? middle.begins + middle.slope * (k->x - top) : middle.begins;
    parts.stuck = (real)0.5 * (from + middle.ends) * (middle.lasts - (k->in_middle ? k->x - top : 0))
                  + (k->in_middle ? 0 : concave_covers(first, k->x, top, k->x_covered, 0.5))
                  + concave_covers(last, k->u, last->begin, k->u_covered, 0.5);
  } else if (k->sticks)
    parts.stuck = concave_covers(last, k->u, k->x, k->u_covered, k->x_covered);
  return parts;
}

/* Sets the times of the first and of the last change of mode. */
static void concave_switches(const struct passage *k, struct period_motion *m)
{
  const real never = k->released ? 1 - k->u : NAN, leaves = k->early ? k->x : 1 - k->x;
  const real stops = k->turns ? (k->early ? 1 - k->x : k->x) : k->c > 0 ? 1 - k->t : NAN;
  m->first_switch = k->c > 0 ? k->t : k->turns ? leaves : never;
  m->last_switch = k->released ? k->u : stops;
}

/* Follows the phase from velocity c_0 through its crossings. Returns false if that is left to the walk. */
static bool concave_path(const struct phase_input *in, real c_0, struct line *l, struct passage *k,
                         struct scallop_work *work)
{
  const struct scallop_shape *shape = in->shape;
  const int direction = shape->pieces[0].direction;
  const real starts = concave_slope(shape, false);
  struct meeting first = { .slope = 0 };
  k->sign = c_0 >= 0 ? 1 : -1;
  k->c = magnitude(c_0);
  *l = line_of(in, direction * k->sign > 0);
  if (k->c == 0 && l->between <= -l->q1 * starts) { /* stuck at rest: the mirror image has the right body */
    k->sign = -1;
    *l = line_of(in, direction * k->sign > 0);
  }
  first.slope = l->q0 * starts;
  if (k->c > 0
      && !concave_meet(&shape->pieces[0], k->c, -l->eps, l->q0, 0, k->c / (first.slope + l->eps), shape->pieces[0].end,
                       &first, work))
    return false;
  k->t_covered = k->x_covered = first.covered;
  k->t = k->x = first.x;
  k->y = k->z = first.level;
  k->steep = first.slope;
  k->turns = k->steep > l->between;
  k->side = 1;
  k->early = true;
  k->in_middle = false;
  k->fall = -k->steep;
  if (k->turns && !concave_leave(l, shape, k, work))
    return false;
  k->sticks = k->fall <= l->eps;
  k->released = false;
  k->u = k->x;
  k->w = k->z;
  k->u_covered = k->x_covered;
  if (k->sticks ? !concave_stick(l, shape, k, work) : k->early)
    return false;
  k->end = k->w - l->eps * k->u;
  return true;
}

/* Solves the phase from velocity c_0 as motion_walk does, but sets only the way of the centre of mass. Returns false if
 * the phase is of another kind; *m is then undefined. */
static bool concave_phase(const struct phase_input *in, real c_0, struct period_motion *m)
{
  const struct scallop_shape *shape = in->shape;
  const int direction = shape->pieces[0].direction;
  const struct passage *k = &m->passage;
  struct line l;
  m->work = (struct scallop_work){ 0 };
  if (!shape->concave || !concave_path(in, c_0, &l, &m->passage, &m->work))
    return false;
  const struct concave_parts parts = concave_parts(shape, k);
  const real q = k->side > 0 ? l.q0 : l.q1;
  const bool never = !k->turns && k->c == 0 && !k->released, plain = direction * k->sign > 0;
  m->short_cut = true;
  m->furthest = 0;
  m->c_end = k->sign * (k->side * k->end) + 0; /* no -0 */
  m->way[0] = k->sign * (parts.before + k->side * (q * parts.stuck + parts.after));
  m->size[0] = parts.before_size + (q * parts.stuck + parts.after);
  m->forgets = m->sticks = k->sticks;
  m->never_moved[0] = never && plain;
  m->never_moved[1] = never && !plain;
  m->extra_impulse = m->slope = m->stretch = 0;
  m->delicate = false;
  if (!k->sticks)
    concave_turn(&l, shape, k, m);
  concave_switches(k, m);
  m->work.events = 1 + k->turns + k->released;
  course_modes(direction > 0 ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION,
               course_of(k->c != 0 ? (double)k->sign : 0, (double)(k->sign * k->side), k->turns, k->sticks)
                   + (k->released ? COURSE_RELEASED : 0),
               &m->modes);
  return true;
}

/* Sets the ways of the bodies, and their sizes, for a plain shape that concave_phase has solved. */
static void concave_bodies(const struct phase_input *in, struct period_motion *m)
{
  const struct passage *k = &m->passage;
  const struct scallop_piece *first = &in->shape->pieces[0], *last = &in->shape->pieces[1];
  const bool plain = first->direction * k->sign > 0, above = k->side > 0;
  const struct line l = line_of(in, plain);
  const struct concave_parts parts = concave_parts(in->shape, k);
  const real tail = k->u_covered;
  real covered = k->t_covered; /* before it leaves region 1 */
  if (k->turns)
    covered += k->early ? concave_covers(first, k->t, k->x, k->t_covered, k->x_covered)
                        : concave_covers(first, k->t, first->end, k->t_covered, 0.5)
                              + concave_covers(last, k->x, last->begin, k->x_covered, 0.5);
  for (int j = 0; j < 2; j++) {
    const int body = (j == 0) == plain ? 1 : 2;
    const real q = j == 0 ? -l.q0 : l.q1, moves = (j == 0) == above ? 0 : parts.stuck;
    m->way[body] = k->sign
                   * ((parts.before + q * covered) + (j == 0 ? -1 : 1) * moves + (k->side * parts.after + q * tail));
    m->size[body] = (parts.before_size + magnitude(q) * covered) + moves + (parts.after + magnitude(q) * tail);
  }
}
