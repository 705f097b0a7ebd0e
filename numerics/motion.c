#include "numerics/motion.h"

#include <math.h>
#include <stddef.h>

#include "numerics/ramps.h"
#include "numerics/root.h"

struct rates {
  double speed, rate; /* |l'| and d|l'|/dt */
};

/* Over one piece the plane of (time, c) has three regions, divided by two curves. With `front` the
 * body that l' drives forward and `rear` the other:
 *
 *     region 0   both forward                                        slope -eps
 *     curve 0    rear stuck,  c =  mu_front |l'|
 *     region 1   rear backward, front forward (opposite motion)      slope  eps (f_rear - f_front)
 *     curve 1    front stuck, c = -mu_rear |l'|
 *     region 2   both backward                                       slope  eps
 *
 * Region j lies above curve j and region j + 1 below it. */
struct walk {
  const struct motion_input *in;
  const struct scallop_piece *piece;
  scallop_visitor *visit;
  void *context;
  double sense;           /* +1: u runs with time, -1: against it                                    */
  double curve[2];        /* c on a curve divided by |l'|                                            */
  double slope[3];        /* of c in each region                                                     */
  double extra[3];        /* what a region adds to extra_impulse per unit of time                    */
  double u, c;            /* where we are                                                            */
  struct rates here, end; /* there, and at the end of the piece                                      */
  int region;             /* 0, 1, 2; meaningless while stuck                                        */
  int stuck;              /* the curve that c is glued to, or -1                                     */
  int passed;             /* a curve that c has left for the rest of the piece, or -1                */
  bool turned;            /* the mode may have changed since it was last noted                       */
  struct motion *out;
};

static inline struct rates rates_at(const struct walk *w, double u)
{
  const struct scallop_piece *p = w->piece;
  if (p->linear)
    return (struct rates){ p->direction * (p->velocity + p->acceleration * (w->sense * u)), p->direction * p->acceleration };
  double velocity, acceleration;
  w->out->work.gait_evaluations++;
  piece_rates(p, u, &velocity, &acceleration);
  return (struct rates){ p->direction * velocity, p->direction * acceleration };
}

/* ---- the record of what happened ---- */

static struct scallop_mode mode_now(const struct walk *w)
{
  signed char rear = (signed char)(w->region == 0 ? 1 : -1), front = (signed char)(w->region == 2 ? -1 : 1);
  if (w->stuck >= 0) {
    rear = (signed char)(w->stuck == 0 ? 0 : -1);
    front = (signed char)(w->stuck == 0 ? 1 : 0);
  }
  return w->piece->direction > 0 ? (struct scallop_mode){ rear, front } : (struct scallop_mode){ front, rear };
}

/* Notes the mode that begins at u, unless it goes on. */
static void note_mode(const struct walk *w, struct scallop_mode mode)
{
  struct motion *out = w->out;
  struct scallop_modes *modes = &out->modes;
  double passed = w->piece->anchor == SCALLOP_FROM_START ? w->u : 1 - w->u;
  double left = w->piece->anchor == SCALLOP_FROM_START ? 1 - w->u : w->u;
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

static void show(const struct walk *w, double u, double c)
{
  bool glued = w->stuck >= 0;
  struct scallop_interval interval = { .piece = w->piece,
                                       .u_begin = w->u,
                                       .u_end = u,
                                       .mode = mode_now(w),
                                       .c_begin = w->c,
                                       .c_end = c,
                                       .c_slope = glued ? 0 : w->slope[w->region],
                                       .glue = glued ? w->curve[w->stuck] * w->piece->direction : 0,
                                       .x_begin = w->out->travel };
  w->visit(w->context, &interval);
}

/* Go on to u with velocity c there; x is how far the centre of mass comes meanwhile. */
static inline void advance(struct walk *w, double u, double c, double x)
{
  if (u != w->u) {
    if (w->turned)
      note_mode(w, mode_now(w));
    w->turned = false;
    if (w->visit)
      show(w, u, c);
  }
  w->out->travel += x;
  w->u = u;
  w->c = c;
}

/* ---- meeting a curve ---- */

/* The region or curve where c goes on from a point of curve j: region j, region j + 1, or glued to
 * it (-1) while friction can hold the body, which is when the curve's slope lies between the slopes
 * on its two sides. */
static inline int beyond(const struct walk *w, int j)
{
  double along = w->curve[j] * w->here.rate;
  return along > w->slope[j + 1] ? j + 1 : along < w->slope[j] ? j : -1;
}

/* c has met curve j, coming from w->region. moved: some time has passed since the last event. */
static inline void meet(struct walk *w, int j, bool moved)
{
  int to = beyond(w, j), from = w->region;
  w->out->work.events++;
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
  /* the flow is sheared: d c_after / d c_before = (slope[to] - along)/(slope[from] - along) = 1 + eps x,
   * and (slope[to] - slope[from])/eps is the difference of what the regions add to the impulse */
  double x = (w->extra[to] - w->extra[from]) / (w->slope[from] - w->curve[j] * w->here.rate);
  w->out->slope += x + w->in->eps * x * w->out->slope;
  w->region = to;
}

/* ---- the next curve met in a region ----
 *
 * A curve that is touched and not crossed splits the derivative of the map. The one from the right is
 * kept: a touch counts from below, where a slightly larger c would cross, and not from above. */

struct gap { /* the distance of c to curve j, positive inside the region                */
  const struct walk *walk;
  double side, curve, c_anchor, c_slope;
};

/* at u, and its derivative with respect to u */
static double gap_value(const void *context, double u, double *slope)
{
  const struct gap *g = context;
  struct rates r = rates_at(g->walk, u);
  g->walk->out->work.root_iterations++;
  *slope = g->side * g->walk->sense * (g->c_slope - g->curve * r.rate);
  return g->side * (g->c_anchor + g->c_slope * (g->walk->sense * u) - g->curve * r.speed);
}

/* May the gap be closed at its narrowest, where it is left? */
static inline bool closes(const struct gap *g, double left) { return left < 0 || (left == 0 && g->side < 0); }

/* Does the gap close, in a piece where l' is linear? Both sides are straight lines: one division. */
static inline bool straight_contact(const struct gap *g, double *u)
{
  const struct walk *w = g->walk;
  const struct scallop_piece *p = w->piece;
  double along = g->curve * w->here.rate;
  if (g->side * (g->c_slope - along) >= 0)
    return false;
  *u = w->sense * (g->c_anchor - g->curve * p->direction * p->velocity) / (along - g->c_slope);
  if (w->sense * (*u - w->u) < 0)
    *u = w->u;
  return closes(g, w->sense * (*u - p->end));
}

/* The same where l' is curved. The rate of the gap is monotone because l'' is; so the gap has at most
 * one turning point, and where it falls it holds at most one root. */
static bool curved_contact(const struct gap *g, double *u)
{
  const struct walk *w = g->walk;
  struct root_end now = { .u = w->u, .f = g->side * (w->c - g->curve * w->here.speed) };
  struct root_end end = { .u = w->piece->end };
  now.slope = g->side * w->sense * (g->c_slope - g->curve * w->here.rate);
  end.slope = g->side * w->sense * (g->c_slope - g->curve * w->end.rate);
  end.f = g->side * (g->c_anchor + g->c_slope * (w->sense * end.u) - g->curve * w->end.speed);
  bool falls_now = w->sense * now.slope < 0, falls_at_end = w->sense * end.slope < 0;
  if (!falls_now && (!falls_at_end || !closes(g, end.f)))
    return false;
  if (falls_now && now.f <= 0) {
    *u = now.u;
    return true;
  }
  if (falls_now != falls_at_end) {
    struct root_end turn = { .u = w->piece->curve->when(w->piece, g->c_slope / g->curve * w->piece->direction) };
    if (w->sense * (turn.u - now.u) >= 0 && w->sense * (end.u - turn.u) >= 0) {
      turn.f = gap_value(g, turn.u, &turn.slope);
      *(falls_now ? &end : &now) = turn;
    } /* else it is within rounding of the end where it falls */
  }
  if (!closes(g, end.f))
    return false;
  *u = now.f <= 0 ? now.u : root_between(gap_value, g, now, end);
  return true;
}

static inline bool contact(const struct walk *w, int j, double *u)
{
  double c_slope = w->slope[w->region];
  struct gap g = { w, w->region <= j ? 1 : -1, w->curve[j], w->c - c_slope * (w->sense * w->u), c_slope };
  return w->piece->linear ? straight_contact(&g, u) : curved_contact(&g, u);
}

/* ---- from event to event ---- */

static void slide(struct walk *w)
{
  double u = w->piece->end, candidate;
  int met = -1;
  for (int j = w->region == 2 ? 1 : 0; j <= (w->region == 0 ? 0 : 1); j++)
    if (j != w->passed && contact(w, j, &candidate) && (met < 0 || w->sense * (candidate - u) < 0)) {
      u = candidate;
      met = j;
    }
  double duration = w->sense * (u - w->u), c = w->c + w->slope[w->region] * duration;
  w->here = met >= 0 ? rates_at(w, u) : w->end;
  if (met >= 0) /* on the curve to the last digit: the body's velocity is 0 */
    c = w->curve[met] * w->here.speed;
  w->out->extra_impulse += w->extra[w->region] * duration;
  advance(w, u, c, 0.5 * (w->c + c) * duration);
  if (met >= 0)
    meet(w, met, duration != 0);
}

static double piece_length(const struct walk *w, double u) { return w->piece->curve->length(w->piece, u); }

static void stick(struct walk *w)
{
  int j = w->stuck, to = -1;
  double u = w->piece->end, along_end = w->curve[j] * w->end.rate;
  if (along_end > w->slope[j + 1] || along_end < w->slope[j]) { /* the body is released */
    to = along_end > w->slope[j + 1] ? j + 1 : j;
    double when = w->piece->curve->when(w->piece, w->slope[to] / w->curve[j] * w->piece->direction);
    if (w->sense * (when - w->u) < 0)
      when = w->u;
    if (w->sense * (u - when) > 0)
      u = when;
  }
  w->here = to >= 0 ? rates_at(w, u) : w->end;
  advance(w, u, w->curve[j] * w->here.speed,
          w->curve[j] * w->piece->direction * (piece_length(w, u) - piece_length(w, w->u)));
  if (to >= 0) {
    w->out->work.events++;
    w->stuck = -1;
    w->region = to;
    w->passed = j;
    w->turned = true;
  }
}

/* Where c stands when the curves are not known to continue: at the start of a phase, and where l'
 * jumps or changes sign. On the curves' common point c = 0, l' = 0 it stands for c = 0+. */
static void place(struct walk *w)
{
  double upper = w->curve[0] * w->here.speed, lower = w->curve[1] * w->here.speed;
  w->stuck = -1;
  w->turned = true;
  w->region = w->c >= upper ? 0 : w->c < lower ? 2 : 1;
  if (w->c == upper)
    meet(w, 0, true);
}

static void set_regions(struct walk *w)
{
  const struct scallop_scaled *s = w->in->scaled;
  double eps = w->in->eps;
  bool rear_is_1 = w->piece->direction > 0;
  w->curve[0] = rear_is_1 ? s->mu2 : s->mu1;
  w->curve[1] = rear_is_1 ? -s->mu1 : -s->mu2;
  w->slope[0] = -eps;
  w->slope[1] = eps * (rear_is_1 ? s->delta : -s->delta);
  w->slope[2] = eps;
  w->extra[0] = -2 * (rear_is_1 ? s->f1 : s->f2);
  w->extra[1] = 0;
  w->extra[2] = 2 * (rear_is_1 ? s->f2 : s->f1);
}

static void enter(struct walk *w, const struct scallop_piece *piece)
{
  bool anew = !w->piece || piece->jump || piece->direction != w->piece->direction;
  w->piece = piece;
  w->sense = piece->anchor == SCALLOP_FROM_START ? 1 : -1;
  w->u = piece->begin;
  w->passed = -1;
  w->here = rates_at(w, piece->begin);
  w->end = rates_at(w, piece->end);
  if (anew) {
    set_regions(w);
    place(w);
  } else if (w->stuck >= 0) {
    int to = beyond(w, w->stuck);
    if (to >= 0) {
      w->out->work.events++;
      w->region = to;
      w->stuck = -1;
      w->turned = true;
    }
  }
}

void motion_modes(const struct motion *motion, enum scallop_phase_kind kind, struct scallop_modes *modes)
{
  if (motion->trail)
    trail_modes(motion->trail, kind, modes);
  else
    *modes = motion->modes;
}

void motion_solve(const struct motion_input *input, double c0, struct motion *motion, scallop_visitor *visit, void *context)
{
  motion->travel = motion->extra_impulse = motion->slope = 0;
  motion->sticks = motion->forgets = false;
  motion->never_moved[0] = motion->never_moved[1] = true;
  motion->first_switch = motion->last_switch = NAN;
  motion->modes.count = 0;
  motion->trail = 0;
  motion->work = (struct scallop_work){ 0 };
  struct walk w;
  w.in = input;
  w.piece = NULL;
  w.visit = visit;
  w.context = context;
  w.c = c0;
  w.stuck = -1;
  w.out = motion;
  for (int i = 0; i < input->shape->count; i++) {
    enter(&w, &input->shape->pieces[i]);
    while (w.u != w.piece->end) {
      if (w.stuck >= 0)
        stick(&w);
      else
        slide(&w);
    }
  }
  motion->c_end = w.c + 0.0; /* no -0 */
}
