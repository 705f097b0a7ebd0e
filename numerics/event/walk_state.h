/* Part of walk.h: the state of a walk, and its progress within one mode. */
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "model/law.h"
#include "numerics/event/segment.h"

struct rates {
  real speed, rate; /* |l'| and d|l'|/dt */
};

static inline bool is_plateau(const struct scallop_piece *p) { return p->linear && p->acceleration == 0; }

/* Returns the level of a curve over a plateau of l', if c is no further from the level than `near`; else 0. Friction
 * changes c in a phase by eps at most, perhaps less than rounding of c. If c is counted from the level, this change
 * keeps its digits, because the level minus the curve is exactly 0 on the plateau. */
SOLVE real walk_level(const struct phase_input *in, real c, real near)
{
  for (int i = 0; i < in->shape->count; i++) {
    const struct scallop_piece *p = &in->shape->pieces[i];
    if (!is_plateau(p) || p->direction == 0)
      continue;
    real q = (p->direction > 0) == (c > 0) ? in->mu2 : in->mu1,
         level = (c > 0 ? q : -q) * (p->direction * walk_velocity(p));
    if (c - level <= near && level - c <= near)
      return level;
  }
  return 0;
}

/* Sums over more pieces keep what rounding drops. */
enum { WALK_FEW_PIECES = 4 };

/* Over one piece the plane of (time, c) has three regions, divided by two curves. With `front` the
 * body that l' drives forward and `rear` the other:
 *
 *     region 0   both forward                                        slope -eps
 *     curve 0    rear stuck,  c =  mu_front |l'|
 *     region 1   rear backward, front forward (opposite motion)      slope  eps (f_rear - f_front)
 *     curve 1    front stuck, c = -mu_rear |l'|
 *     region 2   both backward                                       slope  eps
 *
 * Region j lies above curve j and region j + 1 below it.
 *
 * Where l' is 0 the curves meet at c = 0 and region 1 ends: a node. A motion that reaches a node within a phase through
 * region 1, or along a curve, has exactly c = 0 there. In a dwell, while l' stays 0, both curves are c = 0; on them
 * both bodies are at rest. */
struct walk {
  const struct phase_input *in;
  struct segment segment;
  const struct scallop_piece *piece;
  scallop_visitor *visit; /* is shown each interval of constant mode, or NULL                        */
  void *context;
  real sense;           /* +1: u runs with time, -1: against it                                    */
  real curve[2];        /* c on a curve divided by |l'|                                            */
  real slope[3];        /* of c in each region                                                     */
  real push[2];         /* of friction on c: f eps of the rear and of the front body               */
  real pull[2];         /* of a linear l' on the body of curve j, beyond c: -curve[j] d|l'|/dt     */
  real extra[3];        /* what a region adds to extra_impulse per unit of time                    */
  real u, c;            /* where we are                                                            */
  real rest;            /* c minus in->base, more accurate than c unless base is 0                  */
  real line_rest, lost; /* rest at the start of the line that c follows, and what rounding dropped of it    */
  real line_time;       /* since then                                                              */
  bool many;            /* pieces: then out holds the sums of one piece, carried over to these:           */
  struct {
    struct sum way[3], path[2], extra_impulse;
  } carried;
  bool node;              /* the piece ends at a node within the phase                               */
  real v[2];              /* velocity of the rear and of the front body there: c - curve[j] |l'|     */
  struct rates here, end; /* there, and at the end of the piece                                      */
  int region;             /* 0, 1, 2; meaningless while stuck                                        */
  int stuck;              /* the curve that c is glued to, or -1                                     */
  int passed;             /* a curve that c has left for the rest of the piece, or -1                */
  int left;               /* curve of the body released last, if c has met no curve since and is near it; or -1 */
  bool turned;            /* the mode may have changed since it was last noted                       */
  struct period_motion *out;
};

static inline real given_offset(const struct walk *w, real u) { return w->segment.origin + w->segment.turn * u; }

static inline struct rates rates_at(const struct walk *w, real u)
{
  const struct scallop_piece *p = w->piece;
  if (p->linear)
    return (struct rates){ p->direction * (walk_velocity(p) + walk_acceleration(p) * (w->sense * u)),
                           p->direction * walk_acceleration(p) };
  real velocity, acceleration;
  w->out->work.gait_evaluations++;
  walk_curve(p, u, &velocity, &acceleration);
  return (struct rates){ p->direction * velocity, p->direction * acceleration };
}

static struct scallop_mode mode_now(const struct walk *w)
{
  signed char rear = (signed char)(w->region == 0 ? 1 : -1), front = (signed char)(w->region == 2 ? -1 : 1);
  if (w->stuck >= 0 && w->piece->direction == 0)
    return (struct scallop_mode){ 0, 0 };
  if (w->stuck >= 0) {
    rear = (signed char)(w->stuck == 0 ? 0 : -1);
    front = (signed char)(w->stuck == 0 ? 1 : 0);
  }
  return w->piece->direction > 0 ? (struct scallop_mode){ rear, front } : (struct scallop_mode){ front, rear };
}

/* Records the mode that begins at u, unless it equals the previous mode. */
static void note_mode(const struct walk *w, struct scallop_mode mode)
{
  struct period_motion *out = w->out;
  struct scallop_modes *modes = &out->modes;
  real at = given_offset(w, w->u);
  real passed = w->segment.given->anchor == SCALLOP_FROM_START ? at : 1 - at;
  real left = w->segment.given->anchor == SCALLOP_FROM_START ? 1 - at : at;
  if (modes->count > 0) {
    int last = modes->count < SCALLOP_MODES_KEPT ? modes->count - 1 : SCALLOP_MODES_KEPT - 1;
    if (modes->kept[last].s1 == mode.s1 && modes->kept[last].s2 == mode.s2)
      return;
    if (modes->count == 1)
      out->first_switch = passed;
    out->last_switch = left;
  }
  out->sticks |= mode.s1 == 0 || mode.s2 == 0;
  out->never_moved[0] &= mode.s1 == 0;
  out->never_moved[1] &= mode.s2 == 0;
  /* the last place always holds the current mode */
  modes->kept[modes->count < SCALLOP_MODES_KEPT ? modes->count : SCALLOP_MODES_KEPT - 1] = mode;
  modes->count++;
}

/* c minus the velocity v of a curve */
static inline real above(const struct walk *w, real rest, real v) { return (w->in->base - v) + rest; }

/* Moves to u, with that rest and l' as in there. The caller updates the sums. */
static inline void advance(struct walk *w, real u, real rest, const struct rates *there)
{
  w->u = u;
  w->rest = rest;
  w->c = w->in->base + rest;
  w->here = *there;
}

static void show(const struct walk *w, real u, real c)
{
  const struct scallop_interval interval = {
    .piece = w->segment.given,
    .u_begin = (double)given_offset(w, w->u),
    .u_end = (double)given_offset(w, u),
    .mode = mode_now(w),
    .c_begin = (double)w->c,
    .c_end = (double)c, /* GCOVR_EXCL_LINE: no instruction of its own, and so no count, where real is double */
    .c_slope = w->stuck >= 0 ? 0 : (double)w->slope[w->region],
    .glue = w->stuck < 0 ? 0 : (double)(w->curve[w->stuck] * w->piece->direction),
    .x_begin = (double)(w->out->way[0] + (w->many ? w->carried.way[0].total : 0))
  };
  w->visit(w->context, &interval);
}

/* The mode of now lasts until u, where c is the velocity. */
static inline void last(struct walk *w, real u, real c)
{
  if (u == w->u)
    return;
  if (w->turned)
    note_mode(w, mode_now(w));
  w->turned = false;
  if (w->visit && sizeof(real) == sizeof(double)) /* intervals are in double */
    show(w, u, c);
}

/* size: of the parts that x is the sum of */
static inline void come(struct walk *w, int i, real x, real size)
{
  w->out->way[i] += x;
  w->out->size[i] += size;
}

static inline void body_comes(struct walk *w, int j, real x, real size)
{
  int body = (j == 0) == (w->piece->direction > 0) ? 1 : 2;
  come(w, body, x, size);
  w->out->path[body - 1] += magnitude(x);
}

static void carry(struct sum *sum, real *x)
{
  sum_add(sum, *x);
  *x = 0;
}

static void carry_over(struct walk *w)
{
  for (int i = 0; i < 3; i++)
    carry(&w->carried.way[i], &w->out->way[i]);
  for (int i = 0; i < 2; i++)
    carry(&w->carried.path[i], &w->out->path[i]);
  carry(&w->carried.extra_impulse, &w->out->extra_impulse);
}

/* Returns the integral of |l'| from here to u. */
static inline real covers(const struct walk *w, real u, const struct rates *there)
{
  return w->piece->linear ? (w->here.speed + there->speed) / 2 * (w->sense * (u - w->u)) : walk_way(w->piece, w->u, u);
}

/* Returns the acceleration of the body of curve j for linear l'. If its own friction nearly balances l'', this
 * difference comes first: it is then the same rounded amount in all modes of the phase, and the resulting
 * displacements, one way and the other, cancel as they should. If the two frictions nearly balance, their difference,
 * known exactly, comes first. */
static inline real body_slope(const struct walk *w, int j)
{
  real own = w->region == 0 || (j == 1 && w->region == 1) ? 1 : -1, pulled = w->pull[j] - own * w->push[j];
  if (w->region != 1 || magnitude(pulled) < magnitude(w->slope[1]))
    return pulled - (w->region == 1 ? -own : own) * w->push[1 - j];
  return w->slope[1] + w->pull[j];
}

/* c is near the curve that it has left: the velocity of that curve's body, c minus the curve, would lose digits. */
static inline bool is_near_left(real v, real c) { return 16 * magnitude(v) < magnitude(c); }

/* The velocity of the body that was released last, at u: from what it was, as long as that is better than from c. */
static real v_of_released(struct walk *w, real u, real c, const struct rates *there)
{
  real q = w->curve[w->left], duration = w->sense * (u - w->u);
  real rise = w->piece->linear ? there->rate * duration : walk_rise(w->piece, w->u, u);
  real v = w->v[w->left] + (w->slope[w->region] * duration - q * rise);
  if (is_near_left(v, c))
    return v;
  w->left = -1;
  return c - q * there->speed;
}

/* Moves along a straight line to u and that rest; the body of curve met, if any, comes to rest there. */
static inline void go_straight(struct walk *w, real u, real rest, const struct rates *there, int met)
{
  real c = w->in->base + rest;
  bool linear = w->piece->linear && !w->many; /* else each piece would add to the error of v */
  real duration = w->sense * (u - w->u), x = (w->c + c) / 2 * duration;
  real size = (magnitude(w->c) + magnitude(c)) / 2 * duration, covered = linear ? 0 : covers(w, u, there);
  last(w, u, c);
  come(w, 0, x, size);
  for (int j = 0; j < 2; j++) {
    real q = w->curve[j], v = c - q * there->speed, way = x - q * covered, parts = size + magnitude(q) * covered;
    if (met >= 0) /* then the other body moves with |l'| */
      v = j == met ? 0 : met == 0 ? there->speed : -there->speed;
    else if (linear) /* by its own acceleration: no cancellation */
      v = w->v[j] + body_slope(w, j) * duration;
    else if (j == w->left)
      v = v_of_released(w, u, c, there);
    if (linear) {
      way = (w->v[j] + v) / 2 * duration;
      parts = magnitude(way);
    }
    body_comes(w, j, way, parts);
    w->v[j] = v;
  }
  advance(w, u, rest, there);
}

/* Moves along the curve of the stuck body; the other body moves with |l'|. */
static inline void go_along(struct walk *w, real u, const struct rates *there)
{
  int j = w->stuck;
  real forward = j == 0 ? 1 : -1, c = w->curve[j] * there->speed, covered = covers(w, u, there);
  last(w, u, c);
  come(w, 0, w->curve[j] * covered, magnitude(w->curve[j]) * covered);
  body_comes(w, 1 - j, forward * covered, covered);
  w->v[j] = 0;
  w->v[1 - j] = forward * there->speed;
  advance(w, u, c - w->in->base, there);
}
