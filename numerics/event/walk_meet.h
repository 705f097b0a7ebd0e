/* Part of walk.h: the next curve that c meets in its piece, and the region after it. */
#include "numerics/event/walk_state.h"

/* Returns where c continues from a point of curve j: region j, region j + 1, or along the curve (-1): the body sticks
 * if the curve's slope lies between the slopes on its two sides. */
static inline int beyond(const struct walk *w, int j)
{
  real along = w->curve[j] * w->here.rate;
  return along > w->slope[j + 1] ? j + 1 : along < w->slope[j] ? j : -1;
}

/* Returns about the largest slope of |l'|: at the start or, if it begins level, on the way to its peak. */
static inline real steepest(const struct scallop_shape *shape)
{
  real start = magnitude(shape->l0), rise = 3 * (real)shape->peak;
  return start > rise ? start : rise;
}

/* c has met curve j, coming from w->region. moved: some time has passed since the last event. */
static inline void meet(struct walk *w, int j, bool moved)
{
  int to = beyond(w, j), from = w->region;
  w->out->work.events++;
  w->left = -1;
  if (to == from && moved) /* touched it, within rounding, and moves away */
    return;
  if (to == from) /* and is back at once: it grazes the curve as the curve begins to hold it */
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

/* The next curve met in a region. A curve that is touched and not crossed splits the derivative of the map. The
 * derivative from the right is kept: a touch counts from below, as a larger c would cross, not from above. */

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

/* Returns whether the gap is closed at its narrowest, with width `left`. */
static inline bool closes(const struct gap *g, real left) { return left < 0 || (left == 0 && g->side < 0); }

/* Returns whether the gap closes in a piece where l' is linear: both sides are straight lines, one division. */
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

/* The gap to a curve that c has just crossed, or has left since it was on it, formed from what changes from here on: it
 * may be far smaller than rounding is in c. */
static real gap_since(const void *context, real u, real *slope)
{
  const struct gap *g = context;
  const struct walk *w = g->walk;
  w->out->work.root_iterations++;
  *slope = g->side * w->sense * (g->c_slope - g->curve * rates_at(w, u).rate);
  return g->side * (g->now + (g->c_slope * (w->sense * (u - w->u)) - g->curve * walk_rise(w->piece, w->u, u)));
}

/* c has just crossed the curve and turns towards it again soon, at u = turn: then it is back after about twice that
 * time, and four times are enough. False: not soon enough for that, or not back. */
static bool comes_back(const struct gap *g, real turn, real *u)
{
  const struct walk *w = g->walk;
  real away = turn - w->u, far = w->u + 4 * away;
  if (magnitude(away) > w->u / 256 || w->sense * (w->piece->end - far) < 0)
    return false;
  struct root_end now = { .u = turn }, end = { .u = far };
  now.f = gap_since(g, now.u, &now.slope);
  end.f = gap_since(g, end.u, &end.slope);
  if (now.f <= 0) { /* it was left for less than rounding */
    *u = turn;
    return true;
  }
  if (end.f >= 0)
    return false; /* GCOVR_EXCL_LINE: such phases of the tests are solved without a walk */
  *u = root_between(gap_since, g, now, end);
  return true;
}

/* Returns whether the gap closes in a curved piece. Its rate is monotone because l'' is; therefore the gap has at most
 * one turning point, and at most one root while it falls. */
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
    } /* else it is within rounding of the falling end */
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
  struct gap g = {
    w, w->region <= j ? 1 : -1, w->curve[j], w->rest - c_slope * (w->sense * w->u), c_slope, now, closed, since
  };
  return w->piece->linear ? straight_contact(&g, u) : curved_contact(&g, u);
}
