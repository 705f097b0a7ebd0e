/* The walk from event to event through one phase, once for every floating type: motion.c makes the solver in double of it, wide_solve.h
 * the ones in wider types. No header in the usual sense, and not public. Before including it define
 *
 *     real                                              the type
 *     walk_velocity(piece), walk_acceleration(piece)    of a piece that is linear: l' at its anchor, and l''
 *     walk_curve(piece, u, &velocity, &acceleration)    l' and l'' at offset u of a piece that is not linear
 *     walk_when(piece, a)                               u in a curved piece with l''(u) = a, nan if there is none
 *     walk_way(piece, from, to)                         what |l'| covers between two offsets of such a piece, whichever is first
 *     walk_rise(piece, from, to)                        |l'| at to minus |l'| at from, which may be far larger than their difference
 *     struct root_end, root_function, root_between      as in root.h
 *
 *     walk_show(walk, u, c)                             what is told of each interval of constant mode; of a function the declaration
 */
#include <math.h>
#include <stddef.h>

#include "numerics/leg.h"
#include "numerics/numerics.h"

struct walk_input { /* in units where the phase lasts 1, L is 1 and forces are in F1 + F2                  */
  const struct scallop_shape *shape;
  real mu1, mu2, f1, f2, delta, eps; /* as in struct scallop_scaled; eps of this phase                           */
  real base; /* what velocities c at the start and at the end are counted from: 0, or see walk_level               */
};

struct walk_result { /* as in struct motion                                                                */
  real c_end, extra_impulse, slope, stretch, first_switch, last_switch;
  real way[3], size[3];
  real path[2]; /* of body 1 and body 2: how far each slides, one way and the other */
  bool forgets, delicate, sticks, never_moved[2];
  struct scallop_work work;
  struct scallop_modes *modes;
};

struct rates {
  real speed, rate; /* |l'| and d|l'|/dt */
};

struct walk_sum {
  real total, lost; /* what rounding dropped */
};
struct walk_sums {
  struct walk_sum way[3], path[2], extra_impulse;
};

static inline bool is_plateau(const struct scallop_piece *p) { return p->linear && p->acceleration == 0; }

/* The level of a curve over a plateau of l', if c is no further from the level than `near`; else 0. Friction changes c in a phase by
 * eps at most, which may be less than rounding of c. If c is counted from the level that change keeps its digits, because the level
 * minus the curve is exactly 0 on the plateau. */
static real walk_level(const struct walk_input *in, real c, real near)
{
  for (int i = 0; i < in->shape->count; i++) {
    const struct scallop_piece *p = &in->shape->pieces[i];
    if (!is_plateau(p) || p->direction == 0)
      continue;
    real q = (p->direction > 0) == (c > 0) ? in->mu2 : in->mu1, level = (c > 0 ? q : -q) * (p->direction * walk_velocity(p));
    if (c - level <= near && level - c <= near)
      return level;
  }
  return 0;
}

/* The sum of few parts is as good as they are; of more it keeps what rounding drops. */
enum { WALK_FEW_PIECES = 16 };

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
 * Where l' is 0 the curves meet at c = 0, and region 1 ends there: a node. So who comes to a node within a phase through region 1, or along a
 * curve, has c = 0 there, exactly. While l' stays 0, a dwell, both curves are c = 0, and c on them is both bodies at rest. */
struct walk {
  const struct walk_input *in;
  struct leg leg;
  const struct scallop_piece *piece;
  void *audience;           /* of walk_show, or NULL                                                   */
  real sense;               /* +1: u runs with time, -1: against it                                    */
  real curve[2];            /* c on a curve divided by |l'|                                            */
  real slope[3];            /* of c in each region                                                     */
  real push[2];             /* of friction on c: f eps of the rear and of the front body               */
  real pull[2];             /* of a linear l' on the body of curve j, beyond c: -curve[j] d|l'|/dt     */
  real extra[3];            /* what a region adds to extra_impulse per unit of time                    */
  real u, c;                /* where we are                                                            */
  real rest;                /* c minus in->base, which is known better than c unless base is 0          */
  real line_u, line_rest;   /* where rest and its line were, when a piece began of those that it has followed since   */
  long line_events;         /* the events by then                                       */
  struct walk_sums carried; /* over from out, if there are many pieces                   */
  bool many;                /* pieces                                                                  */
  bool node;                /* the piece ends at a node within the phase                               */
  real v[2];                /* velocity of the rear and of the front body there: c - curve[j] |l'|     */
  struct rates here, end;   /* there, and at the end of the piece                                      */
  int region;               /* 0, 1, 2; meaningless while stuck                                        */
  int stuck;                /* the curve that c is glued to, or -1                                     */
  int passed;               /* a curve that c has left for the rest of the piece, or -1                */
  int left;                 /* the curve whose body was released, if c has met none since and is near it; or -1 */
  bool turned;              /* the mode may have changed since it was last noted                       */
  struct walk_result *out;
};

static inline real given_offset(const struct walk *w, real u) { return w->leg.origin + w->leg.turn * u; }

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

/* ---- the record of what happened ---- */

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

/* Notes the mode that begins at u, unless it goes on. */
static void note_mode(const struct walk *w, struct scallop_mode mode)
{
  struct walk_result *out = w->out;
  struct scallop_modes *modes = out->modes;
  real at = given_offset(w, w->u);
  real passed = w->leg.given->anchor == SCALLOP_FROM_START ? at : 1 - at;
  real left = w->leg.given->anchor == SCALLOP_FROM_START ? 1 - at : at;
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

/* Goes on to u, with that rest and l' as in there. The sums are the caller's. */
static inline void advance(struct walk *w, real u, real rest, const struct rates *there)
{
  w->u = u;
  w->rest = rest;
  w->c = w->in->base + rest;
  w->here = *there;
}

/* The mode of now lasts until u, where c is the velocity. */
static inline void last(struct walk *w, real u, real c)
{
  if (u == w->u)
    return;
  if (w->turned)
    note_mode(w, mode_now(w));
  w->turned = false;
  if (w->audience)
    walk_show(w, u, c);
}

/* ---- how far the centre of mass and the bodies come ---- */

static inline real magnitude(real x) { return x < 0 ? -x : x; }

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

/* Adds x and keeps what rounding drops, as Neumaier's variant of Kahan's sum does. */
static void add(struct walk_sum *sum, real *x)
{
  real total = sum->total + *x;
  sum->lost += magnitude(sum->total) >= magnitude(*x) ? (sum->total - total) + *x : (*x - total) + sum->total;
  sum->total = total;
  *x = 0;
}

/* Of many pieces the sums in out are those of one piece, and are carried over to these. */
static void carry_over(struct walk *w)
{
  for (int i = 0; i < 3; i++)
    add(&w->carried.way[i], &w->out->way[i]);
  for (int i = 0; i < 2; i++)
    add(&w->carried.path[i], &w->out->path[i]);
  add(&w->carried.extra_impulse, &w->out->extra_impulse);
}

/* Where a piece begins, of many. If c has followed one line since an earlier one did, measured from the same anchor, it is counted from there, so
 * that no error adds up from piece to piece. */
static void keep_to_line(struct walk *w, bool goes_on)
{
  if (goes_on && w->stuck < 0 && w->out->work.events == w->line_events)
    advance(w, w->u, w->line_rest + w->slope[w->region] * (w->sense * w->leg.turn * (w->leg.given->begin - w->line_u)),
            &w->here);
  else {
    w->line_u = w->leg.given->begin;
    w->line_rest = w->rest;
    w->line_events = w->out->work.events;
  }
}

/* What |l'| covers from here to u. */
static inline real covers(const struct walk *w, real u, const struct rates *there)
{
  return w->piece->linear ? (w->here.speed + there->speed) / 2 * (w->sense * (u - w->u)) : walk_way(w->piece, w->u, u);
}

/* The acceleration of the body of curve j where l' is linear. Where its own friction nearly balances l'' that difference comes first: it is
 * then the same rounded amount in all modes of the phase, and the displacements that come of it, one way and the other, cancel as they
 * should. Where the two frictions nearly balance each other theirs does, which is known exactly. */
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

/* On along a straight line to u and that rest, where the body of curve met, if any, comes to rest. */
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
    if (met >= 0) /* where the other body moves with |l'| */
      v = j == met ? 0 : met == 0 ? there->speed : -there->speed;
    else if (linear) /* as it is itself, and nothing large need be subtracted */
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

/* On along the curve of the body that is stuck; the other one moves with |l'|. */
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

/* ---- meeting a curve ---- */

/* The region or curve where c goes on from a point of curve j: region j, region j + 1, or glued to
 * it (-1) while friction can hold the body, which is when the curve's slope lies between the slopes
 * on its two sides. */
static inline int beyond(const struct walk *w, int j)
{
  real along = w->curve[j] * w->here.rate;
  return along > w->slope[j + 1] ? j + 1 : along < w->slope[j] ? j : -1;
}

/* Of |l'|, about: at the start, or, where it begins level, on the way to its peak. */
static inline real steepest(const struct scallop_shape *shape)
{
  real start = magnitude(shape->l0), rise = 3 * (real)shape->peak;
  return start > rise ? start : rise;
}

/* A curve whose slope here is `along`, and `steep` where it is steepest, crossed by a line with these slopes on its sides. */
static inline bool is_delicate(real along, real before, real after, real steep)
{
  const int small = 32;
  real level = magnitude(along);
  return small * level < magnitude(steep) || small * magnitude(along - before) < level + magnitude(before)
         || small * magnitude(along - after) < level + magnitude(after);
}

/* c has met curve j, coming from w->region. moved: some time has passed since the last event. */
static inline void meet(struct walk *w, int j, bool moved)
{
  int to = beyond(w, j), from = w->region;
  w->out->work.events++;
  w->left = -1;
  if (to == from && moved) /* touched it, within rounding, and moves away */
    return;
  if (to == from) /* and is back at once: it grazes the curve where the curve begins to hold it */
    to = -1;
  w->turned = true;
  if (to < 0) {
    w->stuck = j;
    w->out->forgets = true;
    return;
  }
  real along = w->curve[j] * w->here.rate;
  /* the flow is sheared: d c_after / d c_before = (slope[to] - along)/(slope[from] - along) = 1 + eps x,
   * and (slope[to] - slope[from])/eps is the difference of what the regions add to the impulse */
  real x = (w->extra[to] - w->extra[from]) / (w->slope[from] - along);
  w->out->slope += x + w->in->eps * x * w->out->slope;
  w->out->stretch *= (w->slope[to] - along) / (w->slope[from] - along);
  if (!w->piece->linear)
    w->out->delicate |= is_delicate(along, w->slope[from], w->slope[to], w->curve[j] * steepest(w->in->shape));
  w->region = to;
}

/* ---- the next curve met in a region ----
 *
 * A curve that is touched and not crossed splits the derivative of the map. The one from the right is
 * kept: a touch counts from below, where a slightly larger c would cross, and not from above. */

struct gap { /* the distance of c to curve j, positive inside the region                */
  const struct walk *walk;
  real side, curve, anchor, c_slope; /* anchor: of the line of rest                              */
  real now;                          /* c above the curve here */
  bool closed;                       /* here: c is on the curve */
  bool since;                        /* now is formed from where c left the curve */
};

static inline real gap_at(const struct gap *g, real u, real speed)
{
  return g->side * above(g->walk, g->anchor + g->c_slope * (g->walk->sense * u), g->curve * speed);
}

/* at u, and its derivative with respect to u */
static real gap_value(const void *context, real u, real *slope)
{
  const struct gap *g = context;
  struct rates r = rates_at(g->walk, u);
  g->walk->out->work.root_iterations++;
  *slope = g->side * g->walk->sense * (g->c_slope - g->curve * r.rate);
  return gap_at(g, u, r.speed);
}

/* May the gap be closed at its narrowest, where it is left? */
static inline bool closes(const struct gap *g, real left) { return left < 0 || (left == 0 && g->side < 0); }

/* Does the gap close, in a piece where l' is linear? Both sides are straight lines: one division. */
static inline bool straight_contact(const struct gap *g, real *u)
{
  const struct walk *w = g->walk;
  const struct scallop_piece *p = w->piece;
  real along = g->curve * w->here.rate;
  if (g->side * (g->c_slope - along) >= 0)
    return false;
  *u = w->sense * above(w, g->anchor, g->curve * p->direction * walk_velocity(p)) / (along - g->c_slope);
  if (g->since)
    *u = w->u + w->sense * g->now / (along - g->c_slope);
  if (g->closed || w->sense * (*u - w->u) < 0)
    *u = w->u;
  if (w->in->base != 0 && !g->closed) { /* friction may do less in a phase than rounding of u hides */
    if (w->sense * (*u - p->end) > 0)
      *u = p->end;
    return closes(g, g->side * above(w, w->rest + g->c_slope * (w->sense * (p->end - w->u)), g->curve * w->end.speed));
  }
  if (!w->node || g->closed)
    return closes(g, w->sense * (*u - p->end));
  /* both curves are at 0 at the end: they must agree which of them c has met by then */
  real left = g->side * (w->c + g->c_slope * (w->sense * (p->end - w->u)));
  if (left == 0 || w->sense * (*u - p->end) > 0)
    *u = p->end;
  return closes(g, left);
}

/* The gap to a curve that c has just crossed, or has left since it was on it, formed from what changes from here on: it may be far smaller
 * than rounding is in c. */
static real gap_since(const void *context, real u, real *slope)
{
  const struct gap *g = context;
  const struct walk *w = g->walk;
  w->out->work.root_iterations++;
  *slope = g->side * w->sense * (g->c_slope - g->curve * rates_at(w, u).rate);
  return g->side * (g->now + (g->c_slope * (w->sense * (u - w->u)) - g->curve * walk_rise(w->piece, w->u, u)));
}

/* c has just crossed the curve and turns towards it again soon, at u = turn: then it is back after about twice that time, and four times
 * are enough. False: not soon enough for that, or not back. */
static bool comes_back(const struct gap *g, real turn, real *u)
{
  const struct walk *w = g->walk;
  real away = turn - w->u, far = w->u + 4 * away;
  if (magnitude(away) > w->u / 256 || w->sense * (w->piece->end - far) < 0)
    return false;
  struct root_end now = { .u = turn }, end = { .u = far };
  now.f = gap_since(g, now.u, &now.slope);
  end.f = gap_since(g, end.u, &end.slope);
  if (now.f <= 0) { /* it was not left for as long as can be told */
    *u = turn;
    return true;
  }
  if (end.f >= 0)
    return false;
  *u = root_between(gap_since, g, now, end);
  return true;
}

/* The same where l' is curved. The rate of the gap is monotone because l'' is; so the gap has at most
 * one turning point, and where it falls it holds at most one root. */
static bool curved_contact(const struct gap *g, real *u)
{
  const struct walk *w = g->walk;
  root_function *gap = g->since ? gap_since : gap_value;
  struct root_end now = { .u = w->u, .f = g->side * g->now };
  struct root_end end = { .u = w->piece->end };
  now.slope = g->side * w->sense * (g->c_slope - g->curve * w->here.rate);
  end.slope = g->side * w->sense * (g->c_slope - g->curve * w->end.rate);
  if (g->since)
    end.f = gap_since(g, end.u, &end.slope);
  else
    end.f = gap_at(g, end.u, w->end.speed);
  bool falls_now = w->sense * now.slope < 0, falls_at_end = w->sense * end.slope < 0;
  if (!falls_now && (!falls_at_end || !closes(g, end.f)))
    return false;
  if (falls_now && now.f <= 0) {
    *u = now.u;
    return true;
  }
  if (falls_now != falls_at_end && now.slope != 0 && end.slope != 0) { /* else an end is the turning point */
    struct root_end turn = { .u = walk_when(w->piece, g->c_slope / g->curve * w->piece->direction) };
    if (w->sense * (turn.u - now.u) >= 0 && w->sense * (end.u - turn.u) >= 0) {
      if (!falls_now && g->closed && comes_back(g, turn.u, u))
        return true;
      turn.f = gap(g, turn.u, &turn.slope);
      *(falls_now ? &end : &now) = turn;
    } /* else it is within rounding of the end where it falls */
  }
  if (!closes(g, end.f))
    return false;
  *u = now.f <= 0 ? now.u : root_between(gap, g, now, end);
  return true;
}

static inline bool contact(const struct walk *w, int j, real *u)
{
  real c_slope = w->slope[w->region];
  bool closed = w->v[j] == 0, since = j == w->left && is_near_left(w->v[j], w->c);
  real now = closed ? 0 : since ? w->v[j] : above(w, w->rest, w->curve[j] * w->here.speed);
  struct gap g = { w,    w->region <= j ? 1 : -1, w->curve[j], w->rest - c_slope * (w->sense * w->u), c_slope, now, closed,
                   since };
  return w->piece->linear ? straight_contact(&g, u) : curved_contact(&g, u);
}

/* ---- from event to event ---- */

/* At a node within the phase, where c = 0. A slightly larger c, which the derivative is for, has crossed the curves that c comes to from
 * below. */
static void come_to_node(struct walk *w)
{
  if (w->region == 2)
    meet(w, 1, true);
  if (w->region == 1 && w->stuck < 0)
    meet(w, 0, true);
}

/* The piece does not touch the end of the phase that it is anchored at, or |l'| goes to 0 at its other end: an ulp of u is more than an
 * ulp of |l'| there. Where |l'| only rises from the anchor, concave, it never is. */
static inline bool is_vague(const struct walk *w, real u, const struct rates *there)
{
  const int much = 4;
  const struct scallop_piece *p = w->leg.given;
  return (p->begin > 0 && p->end > 0) || magnitude(there->rate) * given_offset(w, u) > much * there->speed;
}

/* c meets curve j a little late: is it better off where its line is then, or on the curve, to go on along the next line? */
static bool line_tells_better(const struct walk *w, int j, const struct rates *there)
{
  real next = w->slope[w->region <= j ? j + 1 : j];
  return magnitude(w->slope[w->region] - next) < magnitude(w->curve[j] * there->rate - next);
}

static void slide(struct walk *w)
{
  real u = w->piece->end, candidate;
  int met = -1;
  for (int j = w->region == 2 ? 1 : 0; j <= (w->region == 0 ? 0 : 1); j++)
    if (j != w->passed && contact(w, j, &candidate) && (met < 0 || w->sense * (candidate - u) < 0)) {
      u = candidate;
      met = j;
    }
  bool at_node = false;
  if (w->node && u == w->piece->end && (met >= 0 || w->region == 1)) {
    at_node = true;
    met = 0;
  }
  real duration = w->sense * (u - w->u), rest = w->rest + w->slope[w->region] * duration;
  struct rates there = met >= 0 && u != w->piece->end ? rates_at(w, u) : w->end;
  bool on_line = met >= 0
                 && (w->in->base != 0 ? there.rate != 0 : is_vague(w, u, &there) && line_tells_better(w, met, &there));
  if (met >= 0 && !on_line)
    rest = w->curve[met] * there.speed - w->in->base; /* on the curve to the last digit: the body's velocity is 0 */
  w->out->extra_impulse += w->extra[w->region] * duration;
  go_straight(w, u, rest, &there, on_line ? -1 : met);
  if (met < 0)
    return;
  if (at_node)
    come_to_node(w);
  else
    meet(w, met, duration != 0);
  if (on_line && (w->region <= met ? w->v[met] < 0 : w->v[met] > 0))
    w->v[met] = 0; /* not on the side where it goes on, by rounding */
}

/* Where the body that is held by curve j is released, into region `to`: between here and the end, or at once if it is at its limit. */
static real released(const struct walk *w, int j, int to)
{
  const struct scallop_piece *p = w->piece;
  real now = magnitude(w->curve[j] * w->here.rate - w->slope[to]);
  real when = now == 0 || p->linear ? w->u : walk_when(p, w->slope[to] / w->curve[j] * p->direction);
  if (w->sense * (when - w->u) >= 0)
    return w->sense * (p->end - when) > 0 ? when : p->end;
  /* it is within rounding of one of them, and may then be nowhere */
  return when != when && magnitude(w->curve[j] * w->end.rate - w->slope[to]) < now ? p->end : w->u;
}

static void stick(struct walk *w)
{
  int j = w->stuck, to = -1;
  real u = w->piece->end, along_end = w->curve[j] * w->end.rate;
  if (along_end > w->slope[j + 1] || along_end < w->slope[j]) { /* the body is released */
    to = along_end > w->slope[j + 1] ? j + 1 : j;
    u = released(w, j, to);
  }
  struct rates there = to >= 0 ? rates_at(w, u) : w->end;
  go_along(w, u, &there);
  if (to >= 0) {
    w->out->work.events++;
    w->stuck = -1;
    w->region = to;
    w->passed = w->left = j;
    w->turned = true;
  }
}

/* Where c stands when the curves are not known to continue: at the start of a phase, at a node, and where l'
 * jumps. On the curves' common point c = 0, l' = 0 it stands for c = 0+. */
static void place(struct walk *w)
{
  real upper = w->curve[0] * w->here.speed, lower = w->curve[1] * w->here.speed;
  for (int j = 0; j < 2; j++)
    w->v[j] = w->c - w->curve[j] * w->here.speed;
  w->stuck = w->left = -1;
  w->turned = true;
  w->region = w->c >= upper ? 0 : w->c < lower ? 2 : 1;
  if (w->c == upper)
    meet(w, 0, true);
}

static void set_regions(struct walk *w)
{
  const struct walk_input *s = w->in;
  real eps = s->eps;
  bool rear_is_1 = w->piece->direction > 0;
  w->slope[0] = -eps;
  w->slope[2] = eps;
  w->push[0] = eps * (rear_is_1 ? s->f1 : s->f2);
  w->push[1] = eps * (rear_is_1 ? s->f2 : s->f1);
  w->extra[1] = 0;
  if (w->piece->direction == 0) { /* region 1 is empty: c at rest, which is held */
    w->curve[0] = w->curve[1] = w->slope[1] = 0;
    w->extra[0] = -1;
    w->extra[2] = 1;
    return;
  }
  w->curve[0] = rear_is_1 ? s->mu2 : s->mu1;
  w->curve[1] = rear_is_1 ? -s->mu1 : -s->mu2;
  w->slope[1] = eps * (rear_is_1 ? s->delta : -s->delta);
  w->extra[0] = -2 * (rear_is_1 ? s->f1 : s->f2);
  w->extra[2] = 2 * (rear_is_1 ? s->f2 : s->f1);
}

/* A body is held where a new piece begins: l'' may jump there, and let go of it. */
static void look_again(struct walk *w)
{
  int to = beyond(w, w->stuck);
  if (to < 0)
    return;
  w->out->work.events++;
  w->region = to;
  w->left = w->stuck;
  w->stuck = -1;
  w->turned = true;
}

/* Looks at the leg that begins. It ends at a node if the piece does and there is no other leg. */
static void look_along(struct walk *w, const struct scallop_piece *next)
{
  w->piece = w->leg.piece;
  w->sense = w->piece->anchor == SCALLOP_FROM_START ? 1 : -1;
  w->u = w->piece->begin;
  w->here = rates_at(w, w->piece->begin);
  w->end = rates_at(w, w->piece->end);
  w->node = next && !w->leg.goes_on && !next->jump && (next->direction != w->piece->direction || w->end.speed == 0);
  if (w->node)
    w->end.speed = 0;
}

/* At the begin of a piece, if c is counted from a level: where a ramp meets a plateau |l'| is that of the plateau to the last digit, and
 * the velocities of the bodies are formed anew from the level. */
static void look_from_level(struct walk *w, const struct scallop_piece *before, real speed_before,
                            const struct scallop_piece *next)
{
  if (before && is_plateau(before) && !w->leg.given->jump)
    w->here.speed = speed_before;
  if (next && is_plateau(next) && !next->jump && !w->leg.goes_on)
    w->end.speed = next->direction * walk_velocity(next);
  for (int j = 0; before && j < 2; j++)
    w->v[j] = above(w, w->rest, w->curve[j] * w->here.speed);
}

/* next: the piece after it, NULL after the last */
static void enter(struct walk *w, const struct scallop_piece *piece, const struct scallop_piece *next)
{
  const struct scallop_piece *before = w->leg.given;
  real speed_before = w->end.speed;
  bool from_node = w->node;
  leg_first(&w->leg, piece);
  w->passed = -1;
  look_along(w, next);
  if (w->in->base != 0)
    look_from_level(w, before, speed_before, next);
  bool anew = !before || from_node || piece->jump || piece->direction != before->direction || w->here.speed == 0;
  if (w->many) {
    carry_over(w);
    keep_to_line(w, before && piece->anchor == before->anchor && !piece->jump);
  }
  if (anew) {
    if (before && !piece->jump)
      w->here.speed = 0;
    set_regions(w);
    place(w);
  } else if (w->stuck >= 0)
    look_again(w);
  /* once a piece: a compiler that contracts might round it for one body and not for the other */
  for (int j = 0; j < 2; j++)
    w->pull[j] = -w->curve[j] * w->here.rate;
}

static inline void go_to_end(struct walk *w)
{
  while (w->u != w->piece->end) {
    if (w->stuck >= 0)
      stick(w);
    else
      slide(w);
  }
}

/* c0: velocity of the centre of mass at the start, from base. modes: where they go. */
static void walk_phase(const struct walk_input *input, real c0, void *audience, struct scallop_modes *modes,
                       struct walk_result *result)
{
  struct walk w;
  *result = (struct walk_result){
    .stretch = 1, .first_switch = NAN, .last_switch = NAN, .never_moved = { true, true }, .modes = modes
  };
  modes->count = 0;
  w.in = input;
  w.leg.given = NULL;
  w.audience = audience;
  w.rest = c0;
  w.c = input->base + c0;
  w.end.speed = 0;
  w.stuck = w.left = -1;
  w.out = result;
  w.node = false;
  w.many = input->shape->count > WALK_FEW_PIECES;
  if (w.many)
    w.carried = (struct walk_sums){ .extra_impulse = { 0, 0 } };
  const struct scallop_piece *pieces = input->shape->pieces, *last_piece = pieces + input->shape->count - 1;
  for (const struct scallop_piece *p = pieces; p <= last_piece; p++) {
    const struct scallop_piece *next = p == last_piece ? NULL : p + 1;
    enter(&w, p, next);
    go_to_end(&w);
    if (w.leg.goes_on) {
      leg_second(&w.leg);
      look_along(&w, next);
      go_to_end(&w);
    }
  }
  if (w.many) {
    carry_over(&w);
    for (int i = 0; i < 3; i++)
      result->way[i] = w.carried.way[i].total + w.carried.way[i].lost;
    for (int i = 0; i < 2; i++)
      result->path[i] = w.carried.path[i].total + w.carried.path[i].lost;
    result->extra_impulse = w.carried.extra_impulse.total + w.carried.extra_impulse.lost;
  }
  result->c_end = w.rest;
}
