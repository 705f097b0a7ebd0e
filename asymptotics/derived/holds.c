/* c on each segment of a motion, and the proof that it stays between the curves that bound its region. */
#include "asymptotics/derived/holds.h"

#include <math.h>
#include <stddef.h>

#include "asymptotics/derived/scoped.h"
#include "model/law.h"

struct segment { /* c = a + b s in one region of one phase                                    */
  const struct phase_constants *p;
  int region;
  arb_t a, b;
  slong precision;
};

/* How far c is inside the region from curve j at offset u, and the derivative of that by u */
static void room(arb_t gap, arb_t slope, const struct segment *g, const struct scallop_piece *piece, int j,
                 const arb_t u)
{
  gap_at(gap, slope, piece, g->p->curve[j], g->a, g->b, u, g->precision);
  if (g->region <= j) { /* above it */
    arb_neg(gap, gap);
    arb_neg(slope, slope);
  }
}

/* Is it positive at all offsets of a ball? By its value in the middle and its derivative: near a curve that c almost
 * touches, where the derivative is small, its own ball is much too wide. */
static bool has_room(const struct segment *g, const struct scallop_piece *piece, int j, const arb_t u,
                     const arb_t slope)
{
  SCOPED(arb, middle, gap, there, off);
  arb_get_mid_arb(middle, u);
  room(gap, there, g, piece, j, middle);
  arb_sub(off, u, middle, g->precision);
  arb_addmul(gap, off, slope, g->precision);
  return arb_is_positive(gap);
}

/* c keeps off curve j between offsets lo and hi; it touches it, transversally, within the end whose flag is set. */
static bool keeps_off(const struct segment *g, const struct scallop_piece *piece, int j, const arf_t lo, const arf_t hi,
                      bool touches_lo, bool touches_hi, int depth)
{
  SCOPED(arb, u, gap, slope);
  SCOPED(arf, middle);
  arb_set_interval_arf(u, lo, hi, g->precision);
  room(gap, slope, g, piece, j, u);
  if (arb_is_positive(gap) || (touches_lo && !touches_hi && arb_is_positive(slope))
      || (touches_hi && !touches_lo && arb_is_negative(slope)) || has_room(g, piece, j, u, slope))
    return true;
  arf_add(middle, lo, hi, ARF_PREC_EXACT, ARF_RND_DOWN);
  arf_mul_2exp_si(middle, middle, -1);
  return depth > 0 && keeps_off(g, piece, j, lo, middle, touches_lo, false, depth - 1)
         && keeps_off(g, piece, j, middle, hi, false, touches_hi, depth - 1);
}

/* One end of a segment: a crossing, or an end of the phase (curve -1) */
struct edge {
  int curve;
  int piece;    /* its index                                                                    */
  arb_t offset; /* in that piece                                                                */
};

static void edge_at_end(struct edge *e, int piece, double offset)
{
  e->curve = -1;
  e->piece = piece;
  arb_set_d(e->offset, offset);
}

/* Where a crossing is by now: a crossing may have moved on into the next piece, or back, if l' has no corner there. */
static void edge_at_crossing(struct edge *e, const struct crossing *at, const struct phase_constants *p,
                             slong precision)
{
  const struct scallop_shape *shape = p->shape;
  e->curve = at->curve;
  e->piece = (int)(at->piece - shape->pieces);
  series_coefficient(e->offset, &at->offset, 0, precision);
  for (int moved = 1; moved != 0;) {
    const struct scallop_piece *piece = &shape->pieces[e->piece];
    double u = arf_get_d(arb_midref(e->offset), ARF_RND_NEAR), sense = law_sense(piece);
    bool goes_on = false, turns = false;
    moved = sense * (u - piece->end) > 0 ? 1 : sense * (piece->begin - u) > 0 ? -1 : 0;
    if (moved > 0 && e->piece + 1 < shape->count)
      goes_on = scallop_piece_goes_on(piece, piece + 1, &turns);
    else if (moved < 0 && e->piece > 0)
      goes_on = scallop_piece_goes_on(piece - 1, piece, &turns);
    if (!goes_on)
      return;
    e->piece += moved;
    if (turns) { /* measured from the other end */
      arb_sub_si(e->offset, e->offset, 1, precision);
      arb_neg(e->offset, e->offset);
    }
  }
}

/* Whether the ball of a crossing reaches over the end of its piece in time, or over the beginning */
static bool spills(const struct edge *e, const struct phase_constants *p, bool over_end, slong precision)
{
  const struct scallop_piece *piece = &p->shape->pieces[e->piece];
  bool forward = piece->anchor == SCALLOP_FROM_START;
  SCOPED(arb, border);
  (over_end ? scallop_ball_end : scallop_ball_begin)(border, piece, precision);
  bool inside = forward == over_end ? arb_lt(e->offset, border) : arb_gt(e->offset, border);
  return e->curve >= 0 && !inside;
}

/* The segment between two edges keeps off the curves of its region. */
static bool segment_is_clear(const struct segment *g, const struct edge *from, const struct edge *to)
{
  enum { DEPTH = 30 };
  bool clear = from->piece <= to->piece;
  /* a crossing on the border of two pieces may be in either */
  int touches_until = from->piece + (spills(from, g->p, true, g->precision) ? 1 : 0),
      touches_from = to->piece - (spills(to, g->p, false, g->precision) ? 1 : 0);
  SCOPED(arf, early, late);
  SCOPED(arb, border);
  for (int i = from->piece; clear && i <= to->piece; i++) {
    const struct scallop_piece *piece = &g->p->shape->pieces[i];
    bool forward = piece->anchor == SCALLOP_FROM_START;
    scallop_ball_begin(border, piece, g->precision); /* outward, where it is no number that a ball holds exactly */
    (forward ? arb_get_lbound_arf : arb_get_ubound_arf)(early, border, g->precision);
    scallop_ball_end(border, piece, g->precision);
    (forward ? arb_get_ubound_arf : arb_get_lbound_arf)(late, border, g->precision);
    if (i == from->piece)
      (forward ? arb_get_lbound_arf : arb_get_ubound_arf)(early, from->offset, g->precision);
    if (i == to->piece)
      (forward ? arb_get_ubound_arf : arb_get_lbound_arf)(late, to->offset, g->precision);
    clear = forward ? arf_cmp(early, late) <= 0 : arf_cmp(early, late) >= 0;
    for (int j = g->region == 2 ? 1 : 0; clear && j <= (g->region == 0 ? 0 : 1); j++) {
      bool at_early = i <= touches_until && from->curve == j, at_late = i >= touches_from && to->curve == j;
      clear = keeps_off(g, piece, j, forward ? early : late, forward ? late : early, forward ? at_early : at_late,
                        forward ? at_late : at_early, DEPTH);
    }
  }
  return clear;
}

static const char *const sticks[2][2] = {
  { "body 1 comes to rest in the extension", "body 2 comes to rest in the extension" },
  { "body 2 comes to rest in the contraction", "body 1 comes to rest in the contraction" }
};
static const char *const grazes[2] = { "a body begins or ceases to turn in the extension",
                                       "a body begins or ceases to turn in the contraction" };
static const char *const starts[2] = { "the velocity at the start of the extension reaches 0",
                                       "the velocity at the start of the contraction reaches 0" };
static const char *const leaves[2] = { "a switching time of the extension reaches a corner of l'",
                                       "a switching time of the contraction reaches a corner of l'" };

/* The curve is crossed, not followed: its slope lies beyond those of c on both of its sides. And it happens in its
 * piece. */
static const char *crossing_holds(const struct edge *at, const struct phase_constants *p, int from, int into,
                                  const arb_t eps, slong precision)
{
  const struct scallop_piece *piece = &p->shape->pieces[at->piece];
  const char *why = NULL;
  SCOPED(arb, along, limit);
  scallop_ball_rate(along, piece, at->offset, precision);
  ball_times(along, along, p->curve[at->curve], precision);
  arb_set_fmpq(limit, p->beta[into], precision);
  arb_mul(limit, limit, eps, precision);
  arb_sub(along, along, limit, precision);
  if (!(from < into ? arb_is_positive(along) : arb_is_negative(along)))
    why = sticks[p->kind][at->curve];
  bool forward = piece->anchor == SCALLOP_FROM_START, goes_on = false, turned;
  if (at->piece + 1 < p->shape->count)
    goes_on = scallop_piece_goes_on(piece, piece + 1, &turned);
  scallop_ball_end(limit, piece, precision);
  arb_sub(limit, limit, at->offset, precision);
  if (!goes_on && !(forward ? arb_is_nonnegative(limit) : arb_is_nonpositive(limit)))
    why = at->piece + 1 < p->shape->count ? leaves[p->kind] : starts[1 - p->kind]; /* where the other phase starts */
  goes_on = at->piece > 0 && scallop_piece_goes_on(piece - 1, piece, &turned);
  scallop_ball_begin(limit, piece, precision);
  arb_sub(limit, at->offset, limit, precision);
  if (!goes_on && !(forward ? arb_is_nonnegative(limit) : arb_is_nonpositive(limit)))
    why = at->piece > 0 ? leaves[p->kind] : starts[p->kind];
  return why;
}

/* What is nearest to happening at a crossing, and how near, from 0 to 1: only for the name of what cannot be shown. */
static double nearest_event(const struct edge *e, const struct phase_constants *p, int from, int into, const arb_t eps,
                            const char **what)
{
  const struct scallop_shape *shape = p->shape;
  const struct scallop_piece *piece = &shape->pieces[e->piece];
  double u = arf_get_d(arb_midref(e->offset), ARF_RND_NEAR), near = 1;
  bool first = e->piece == 0, last = e->piece + 1 == shape->count, turned;
  if (fabs(u - piece->begin) < near && (first || !scallop_piece_goes_on(piece - 1, piece, &turned))) {
    near = fabs(u - piece->begin);
    *what = first ? starts[p->kind] : leaves[p->kind];
  }
  if (fabs(u - piece->end) < near && (last || !scallop_piece_goes_on(piece, piece + 1, &turned))) {
    near = fabs(u - piece->end);
    *what = last ? starts[1 - p->kind] : leaves[p->kind];
  }
  SCOPED(arb, rate);
  scallop_ball_rate(rate, piece, e->offset, 64);
  double along = arf_get_d(arb_midref(rate), ARF_RND_NEAR) * fmpq_get_d(p->curve[e->curve]);
  double drive = arf_get_d(arb_midref(eps), ARF_RND_NEAR);
  double margin = fmin(fabs(along - drive * fmpq_get_d(p->beta[into])),
                       fabs(along - drive * fmpq_get_d(p->beta[from])));
  if (margin / (fabs(along) + drive) < near) {
    near = margin / (fabs(along) + drive);
    *what = sticks[p->kind][e->curve];
  }
  return near;
}

/* The line after a crossing goes through it: a = q |l'| - b s there. */
static void bend(struct segment *g, const struct crossing *at, const arb_t eps)
{
  slong precision = g->precision;
  const fmpq *q = g->p->curve[at->curve];
  SCOPED(arb, s);
  series_coefficient(s, &at->offset, 0, precision);
  scallop_ball_speed(g->a, at->piece, s, precision);
  ball_times(g->a, g->a, q, precision);
  time_of_offset(s, at->piece, s, precision);
  arb_set_fmpq(g->b, g->p->beta[at->to], precision);
  arb_mul(g->b, g->b, eps, precision);
  arb_submul(g->a, g->b, s, precision);
  g->region = at->to;
}

/* Why c is not shown to keep off the curves: a crossing is about to end, or a body begins or ceases to turn */
static const char *likely_event(const struct branch *b, const struct phase_constants *p, const arb_t eps,
                                slong precision)
{
  static const double NEAR = 0.04;
  const char *what = grazes[p->kind], *candidate = what;
  double nearest = NEAR;
  struct edge at;
  arb_init(at.offset);
  for (int i = 0; i < b->count; i++) {
    edge_at_crossing(&at, &b->crossing[i], p, precision);
    double near = nearest_event(&at, p, branch_region(b, i), b->crossing[i].to, eps, &candidate);
    if (near < nearest) {
      nearest = near;
      what = candidate;
    }
  }
  arb_clear(at.offset);
  return what;
}

/* NULL, or why the modes of the phase are not shown to be those of the branch. c: at its start. */
static const char *phase_holds(const struct branch *b, const struct phase_constants *p, const arb_t eps, const arb_t c,
                               slong precision)
{
  const struct scallop_shape *shape = p->shape;
  struct segment g = { .p = p, .region = b->first_region, .precision = precision };
  struct edge from, to;
  const char *why = NULL;
  arb_init(g.a);
  arb_init(g.b);
  arb_init(from.offset);
  arb_init(to.offset);
  arb_set(g.a, c);
  arb_set_fmpq(g.b, p->beta[g.region], precision);
  arb_mul(g.b, g.b, eps, precision);
  if (g.region != 1 && !(g.region == 0 ? arb_is_positive(c) : arb_is_negative(c)))
    why = starts[p->kind];
  edge_at_end(&from, 0, shape->pieces[0].begin);
  for (int i = 0; !why && i < b->count; i++) {
    const struct crossing *at = &b->crossing[i];
    edge_at_crossing(&to, at, p, precision);
    why = crossing_holds(&to, p, g.region, at->to, eps, precision);
    if (!why && !segment_is_clear(&g, &from, &to))
      why = likely_event(b, p, eps, precision);
    bend(&g, at, eps);
    from.curve = to.curve;
    from.piece = to.piece;
    arb_set(from.offset, to.offset);
  }
  edge_at_end(&to, shape->count - 1, shape->pieces[shape->count - 1].end);
  if (!why && !segment_is_clear(&g, &from, &to))
    why = likely_event(b, p, eps, precision);
  arb_clear(g.a);
  arb_clear(g.b);
  arb_clear(from.offset);
  arb_clear(to.offset);
  return why;
}

const char *limit_holds(const struct limit *l, const arb_t w, const arb_t w_mid, const arb_t eps, slong precision)
{
  const char *why = NULL;
  SCOPED(arb, c, here, fraction);
  for (int k = 0; !why && k < 2; k++) { /* in the units of the phase */
    arb_set_fmpq(fraction, l->phase[k].fraction, precision);
    arb_mul(here, eps, fraction, precision);
    arb_mul(here, here, fraction, precision);
    arb_mul(c, k == SCALLOP_EXTENSION ? w : w_mid, fraction, precision);
    why = phase_holds(&l->branch[k], &l->phase[k], here, c, precision);
  }
  return why;
}
