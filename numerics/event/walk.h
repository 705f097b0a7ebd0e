/* The walk from event to event through one phase, one text for every floating type: a part of solve.h. Not public.
 * Before including it define what period.h needs, and
 *
 *     walk_velocity(piece), walk_acceleration(piece)    of a piece that is linear: l' at its anchor, and l''
 *     walk_curve(piece, u, &velocity, &acceleration)    l' and l'' at offset u of a piece that is not linear
 *     walk_when(piece, a)                               u in a curved piece with l''(u) = a, nan if no such u exists
 *     walk_way(piece, from, to)                         the integral of |l'| between two offsets of such a piece
 *     walk_rise(piece, from, to)                        |l'| at to minus |l'| at from, without cancellation
 */
#include "numerics/event/walk_meet.h"

/* Handles a node within the phase. c is below it if c has crossed the curves that come to the node downwards, nearer to
 * it than u resolves. At c = 0 a slightly larger c, the side of the derivative, has crossed them upwards. */
static void come_to_node(struct walk *w)
{
  int first = w->c < 0 ? 0 : 1;
  if (w->region == 2 * first)
    meet(w, first, true);
  if (w->region == 1 && w->stuck < 0)
    meet(w, 1 - first, true);
}

/* The piece does not touch the end of the phase that it is anchored at, or |l'| goes to 0 at its other end: an ulp of u
 * is more than an ulp of |l'| there. Where |l'| only rises from the anchor, concave, it never is. */
static inline bool is_vague(const struct walk *w, real u, const struct rates *there)
{
  const int much = 4;
  const struct scallop_piece *p = w->segment.given;
  return (p->begin > 0 && p->end > 0) || magnitude(there->rate) * given_offset(w, u) > much * there->speed;
}

/* Rounding placed the crossing of curve j slightly late. Returns whether c continues more accurately from its line than
 * from the curve. */
static bool line_tells_better(const struct walk *w, int j, const struct rates *there)
{
  real next = w->slope[w->region <= j ? j + 1 : j];
  return magnitude(w->slope[w->region] - next) < magnitude(w->curve[j] * there->rate - next);
}

static inline void begin_line(struct walk *w, real lost)
{
  w->line_rest = w->rest;
  w->lost = lost;
  w->line_time = 0;
}

/* Returns rest after `duration` in a phase of many pieces: counted from the beginning of the line, to add up no errors
 * of pieces. lost: what rounding drops */
static real rest_on_line(struct walk *w, real duration, real *lost)
{
  real gained = w->lost + w->slope[w->region] * (w->line_time + duration), rest = w->line_rest + gained;
  *lost = sum_dropped(rest, w->line_rest, gained);
  w->out->furthest = magnitude(w->c) > w->out->furthest ? magnitude(w->c) : w->out->furthest;
  return rest;
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
  real duration = w->sense * (u - w->u), lost = 0;
  real rest = w->many ? rest_on_line(w, duration, &lost) : w->rest + w->slope[w->region] * duration;
  struct rates there = met >= 0 && u != w->piece->end ? rates_at(w, u) : w->end;
  bool on_line = met >= 0
                 && (w->in->base != 0 ? there.rate != 0 : is_vague(w, u, &there) && line_tells_better(w, met, &there));
  if (met >= 0 && !on_line) {
    rest = w->curve[met] * there.speed - w->in->base; /* on the curve to the last digit: the body's velocity is 0 */
    lost = 0;
  }
  w->out->extra_impulse += w->extra[w->region] * duration;
  go_straight(w, u, rest, &there, on_line ? -1 : met);
  if (met < 0) {
    w->line_time += duration;
    return;
  }
  begin_line(w, lost);
  if (at_node)
    come_to_node(w);
  else
    meet(w, met, duration != 0);
  if (on_line && (w->region <= met ? w->v[met] < 0 : w->v[met] > 0))
    w->v[met] = 0; /* rounding put it on the wrong side */
}

/* Returns the offset at which the body stuck on curve j is released, into region `to`: between here and the end, or
 * here if it is at its limit. */
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
  w->out->furthest = 0;
  begin_line(w, 0);
  if (to >= 0) {
    w->out->work.events++;
    w->stuck = -1;
    w->region = to;
    w->passed = w->left = j;
    w->turned = true;
  }
}

/* Sets the region of c if the curves are not known to continue: at the start of a phase, at a node, and where l' jumps.
 * The curves' common point c = 0, l' = 0 counts as c = 0+. */
static void place(struct walk *w)
{
  for (int j = 0; j < 2; j++)
    w->v[j] = above(w, w->rest, w->curve[j] * w->here.speed);
  w->stuck = w->left = -1;
  w->turned = true;
  w->region = w->v[0] >= 0 ? 0 : w->v[1] < 0 ? 2 : 1;
  if (w->v[0] == 0)
    meet(w, 0, true);
}

static void set_regions(struct walk *w)
{
  const struct phase_input *s = w->in;
  real eps = s->eps;
  bool rear_is_1 = w->piece->direction > 0;
  w->slope[0] = -eps;
  w->slope[2] = eps;
  w->push[0] = eps * (rear_is_1 ? s->f1 : s->f2);
  w->push[1] = eps * (rear_is_1 ? s->f2 : s->f1);
  w->extra[1] = 0;
  if (w->piece->direction == 0) { /* region 1 is empty: a body at rest sticks */
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

/* Re-tests a stuck body where a new piece begins, as l'' may jump there. */
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

/* Enters a segment. It ends at a node if the piece does and has no other segment. */
static void look_along(struct walk *w, const struct scallop_piece *next)
{
  w->piece = w->segment.piece;
  w->sense = law_sense(w->piece);
  w->u = w->piece->begin;
  w->here = rates_at(w, w->piece->begin);
  w->end = rates_at(w, w->piece->end);
  w->node = next && !w->segment.continues && !next->jump
            && (next->direction != w->piece->direction || w->end.speed == 0);
  if (w->node)
    w->end.speed = 0;
}

/* Enters a piece if c is counted from a level: if a slope meets a plateau, |l'| there equals the plateau's to the last
 * digit, and the velocities of the bodies are formed again from the level. */
static void look_from_level(struct walk *w, const struct scallop_piece *before, real speed_before,
                            const struct scallop_piece *next)
{
  if (before && is_plateau(before) && !w->segment.given->jump)
    w->here.speed = speed_before;
  if (next && is_plateau(next) && !next->jump && !w->segment.continues)
    w->end.speed = next->direction * walk_velocity(next);
  for (int j = 0; before && j < 2; j++)
    w->v[j] = above(w, w->rest, w->curve[j] * w->here.speed);
}

/* next: the piece after it, NULL after the last */
static void enter(struct walk *w, const struct scallop_piece *piece, const struct scallop_piece *next)
{
  const struct scallop_piece *before = w->segment.given;
  real speed_before = w->end.speed;
  bool from_node = w->node;
  segment_first(&w->segment, piece);
  w->passed = -1;
  look_along(w, next);
  if (w->in->base != 0)
    look_from_level(w, before, speed_before, next);
  bool anew = !before || from_node || piece->jump || piece->direction != before->direction || w->here.speed == 0;
  if (w->many)
    carry_over(w);
  if (anew) {
    if (before && !piece->jump)
      w->here.speed = 0;
    set_regions(w);
    place(w);
    if (w->region == 1 || piece->jump) /* then the slope of c may change */
      begin_line(w, 0);
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

SOLVE void motion_walk(const struct phase_input *input, real c_0, scallop_visitor *visit, void *context,
                       struct period_motion *motion)
{
  struct walk w;
  *motion =
      (struct period_motion){ .stretch = 1, .first_switch = NAN, .last_switch = NAN, .never_moved = { true, true } };
  w.in = input;
  w.segment.given = NULL;
  w.visit = visit;
  w.context = context;
  w.rest = c_0;
  begin_line(&w, 0);
  w.c = input->base + c_0;
  w.end.speed = 0;
  w.stuck = w.left = -1;
  w.out = motion;
  w.node = false;
  w.many = input->shape->count > WALK_FEW_PIECES;
  if (w.many)
    memset(&w.carried, 0, sizeof w.carried);
  const struct scallop_piece *pieces = input->shape->pieces, *last_piece = pieces + input->shape->count - 1;
  for (const struct scallop_piece *p = pieces; p <= last_piece; p++) {
    const struct scallop_piece *next = p == last_piece ? NULL : p + 1;
    enter(&w, p, next);
    go_to_end(&w);
    if (w.segment.continues) {
      segment_second(&w.segment);
      look_along(&w, next);
      go_to_end(&w);
    }
  }
  if (w.many) {
    carry_over(&w);
    for (int i = 0; i < 3; i++)
      motion->way[i] = sum_value(&w.carried.way[i]);
    for (int i = 0; i < 2; i++)
      motion->path[i] = sum_value(&w.carried.path[i]);
    motion->extra_impulse = sum_value(&w.carried.extra_impulse);
  }
  motion->c_end = w.rest + 0; /* no -0 */
}
