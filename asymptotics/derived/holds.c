/* c on each segment of a motion, and the proof that it stays between the curves that bound its region. */
#include "asymptotics/derived/limit.h"

#include <math.h>

#include "asymptotics/derived/scoped.h"
#include "model/law.h"

/* One end of a segment: a crossing, or an end of the phase (curve -1) */
struct edge {
  int curve;
  int piece;    /* its index                                                                    */
  arb_t offset; /* in that piece                                                                */
};
#define EDGE(of) of(arb, s->offset)
SCOPED_PARTS(edge, struct edge, EDGE)

struct segment { /* c = a + b s in one region of one phase                                    */
  const struct phase_constants *p;
  int region;
  arb_t a, b, eps;
  struct edge from, to;
  slong precision;
};
#define SEGMENT(of) of(arb, s->a) of(arb, s->b) of(arb, s->eps) of(edge, &s->from) of(edge, &s->to)
SCOPED_PARTS(segment, struct segment, SEGMENT)

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

/* Whether the piece after that of this index, or with -1 before it, goes on with the same function */
static bool goes_on(const struct scallop_shape *shape, int piece, int to, bool *turned)
{
  const int first = to > 0 ? piece : piece - 1;
  return first >= 0 && first + 1 < shape->count
         && scallop_piece_goes_on(&shape->pieces[first], &shape->pieces[first + 1], turned);
}

/* Where a crossing is by now: it may have moved on into the next piece, or back, if l' has no corner there. */
static void edge_at_crossing(struct edge *e, const struct crossing *at, const struct scallop_shape *shape,
                             slong precision)
{
  bool turned = false;
  e->curve = at->curve;
  e->piece = (int)(at->piece - shape->pieces);
  series_coefficient(e->offset, &at->offset, 0, precision);
  for (;;) {
    const struct scallop_piece *piece = &shape->pieces[e->piece];
    const double u = arf_get_d(arb_midref(e->offset), ARF_RND_NEAR), sense = law_sense(piece);
    const int moved = sense * (u - piece->end) > 0 ? 1 : sense * (piece->begin - u) > 0 ? -1 : 0;
    if (moved == 0 || !goes_on(shape, e->piece, moved, &turned))
      return;
    e->piece += moved;
    if (turned) { /* measured from the other end */
      arb_sub_si(e->offset, e->offset, 1, precision);
      arb_neg(e->offset, e->offset);
    }
  }
}

/* How far, in time, an edge is before the end of its piece, or behind its beginning */
static void way_to_border(arb_t way, const struct edge *e, const struct scallop_shape *shape, bool to_end,
                          slong precision)
{
  const struct scallop_piece *piece = &shape->pieces[e->piece];
  (to_end ? scallop_ball_end : scallop_ball_begin)(way, piece, precision);
  arb_sub(way, way, e->offset, precision);
  if ((piece->anchor == SCALLOP_FROM_START) != to_end)
    arb_neg(way, way);
}

/* Whether the ball of a crossing reaches over that border: it may then be in either piece. */
static bool spills(const struct edge *e, const struct segment *g, bool over_end)
{
  SCOPED(arb, way);
  way_to_border(way, e, g->p->shape, over_end, g->precision);
  return e->curve >= 0 && !arb_is_positive(way);
}

/* The part of piece i that the segment covers, outward where balls end it. False: none of it */
static bool part_of_piece(arf_t early, arf_t late, const struct segment *g, int i)
{
  const struct scallop_piece *piece = &g->p->shape->pieces[i];
  const bool forward = piece->anchor == SCALLOP_FROM_START;
  SCOPED(arb, begin, end);
  scallop_ball_begin(begin, piece, g->precision);
  scallop_ball_end(end, piece, g->precision);
  (forward ? arb_get_lbound_arf : arb_get_ubound_arf)(early, i == g->from.piece ? g->from.offset : begin, g->precision);
  (forward ? arb_get_ubound_arf : arb_get_lbound_arf)(late, i == g->to.piece ? g->to.offset : end, g->precision);
  return forward ? arf_cmp(early, late) <= 0 : arf_cmp(early, late) >= 0;
}

/* The segment keeps off the curves of its region. */
static bool is_clear(const struct segment *g)
{
  enum { DEPTH = 30 };
  const struct edge *from = &g->from, *to = &g->to;
  const int touches_until = from->piece + spills(from, g, true), touches_from = to->piece - spills(to, g, false);
  SCOPED(arf, early, late);
  for (int i = from->piece; i <= to->piece; i++) {
    const struct scallop_piece *piece = &g->p->shape->pieces[i];
    const bool forward = piece->anchor == SCALLOP_FROM_START;
    if (!part_of_piece(early, late, g, i))
      return false; /* GCOVR_EXCL_LINE: balls too wide */
    for (int j = g->region == 2 ? 1 : 0; j <= (g->region == 0 ? 0 : 1); j++) {
      const bool at_early = i <= touches_until && from->curve == j, at_late = i >= touches_from && to->curve == j;
      if (!keeps_off(g, piece, j, forward ? early : late, forward ? late : early, forward ? at_early : at_late,
                     forward ? at_late : at_early, DEPTH))
        return false;
    }
  }
  return from->piece <= to->piece;
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

/* What a crossing of the curve from a region into another may run into: its slope is that of c behind it, or before, so
 * that the curve is followed; or it leaves its piece. Behind the last piece the other phase starts. */
enum risk { STICKS_BEHIND, REACHES_END, REACHES_BEGIN, STICKS_BEFORE, RISKS };

/* How far it is from that, 0 to 1, and what would happen; NULL: nothing, l' goes on there. */
static const char *margin_of(arb_t margin, enum risk risk, const struct edge *e, const struct segment *g, int from,
                             int into)
{
  const struct phase_constants *p = g->p;
  const bool at_end = risk == REACHES_END, outermost = e->piece == (at_end ? p->shape->count - 1 : 0);
  bool turned;
  if (risk == REACHES_END || risk == REACHES_BEGIN) {
    way_to_border(margin, e, p->shape, at_end, g->precision);
    return outermost                                               ? starts[at_end ? 1 - p->kind : p->kind]
           : goes_on(p->shape, e->piece, at_end ? 1 : -1, &turned) ? NULL
                                                                   : leaves[p->kind];
  }
  SCOPED(arb, along, size);
  scallop_ball_rate(along, &p->shape->pieces[e->piece], e->offset, g->precision);
  ball_times(along, along, p->curve[e->curve], g->precision);
  arb_abs(size, along);
  arb_add(size, size, g->eps, g->precision);
  ball_times(margin, g->eps, p->beta[risk == STICKS_BEHIND ? into : from], g->precision);
  arb_sub(margin, along, margin, g->precision);
  if (from > into)
    arb_neg(margin, margin);
  arb_div(margin, margin, size, g->precision);
  return sticks[p->kind][e->curve];
}

/* NULL, or what keeps the crossing at the end of the segment from being shown to be one, in its piece */
static const char *crossing_holds(const struct segment *g, int into)
{
  const char *why = NULL;
  SCOPED(arb, margin);
  for (enum risk risk = 0; risk <= REACHES_BEGIN; risk++) {
    const char *event = margin_of(margin, risk, &g->to, g, g->region, into);
    if (event && !(risk == STICKS_BEHIND ? arb_is_positive(margin) : arb_is_nonnegative(margin)))
      why = event;
  }
  return why;
}

/* Why c is not shown to keep off the curves: a crossing is about to end, or a body begins or ceases to turn */
static const char *likely_event(const struct branch *b, const struct segment *g)
{
  const char *what = grazes[g->p->kind];
  double near = 0.04;
  SCOPED(edge, at);
  SCOPED(arb, margin);
  for (int i = 0; i < b->count; i++) {
    edge_at_crossing(&at, &b->crossing[i], g->p->shape, g->precision);
    for (enum risk risk = 0; risk < RISKS; risk++) {
      const char *event = margin_of(margin, risk, &at, g, branch_region(b, i), b->crossing[i].to);
      const double here = fabs(arf_get_d(arb_midref(margin), ARF_RND_NEAR));
      if (event && here < near) {
        near = here;
        what = event;
      }
    }
  }
  return what;
}

static void enter(struct segment *g, int region)
{
  g->region = region;
  arb_set_fmpq(g->b, g->p->beta[region], g->precision);
  arb_mul(g->b, g->b, g->eps, g->precision);
}

/* The line after a crossing goes through it: a = q |l'| - b s there. */
static void bend(struct segment *g, const struct crossing *at)
{
  SCOPED(arb, s);
  enter(g, at->to);
  series_coefficient(s, &at->offset, 0, g->precision);
  scallop_ball_speed(g->a, at->piece, s, g->precision);
  ball_times(g->a, g->a, g->p->curve[at->curve], g->precision);
  time_of_offset(s, at->piece, s, g->precision);
  arb_submul(g->a, g->b, s, g->precision);
  g->from.curve = g->to.curve;
  g->from.piece = g->to.piece;
  arb_set(g->from.offset, g->to.offset);
}

static void edge_at_end(struct edge *e, int piece, double offset)
{
  e->curve = -1;
  e->piece = piece;
  arb_set_d(e->offset, offset);
}

/* NULL, or why the modes of the phase are not shown to be those of the branch. c: at its start. */
static const char *phase_holds(const struct branch *b, const struct phase_constants *p, const arb_t eps, const arb_t c,
                               slong precision)
{
  const int last = p->shape->count - 1;
  SCOPED(segment, g);
  g.p = p;
  g.precision = precision;
  arb_set(g.a, c);
  arb_set(g.eps, eps);
  enter(&g, b->first_region);
  if (g.region != 1 && !(g.region == 0 ? arb_is_positive(c) : arb_is_negative(c)))
    return starts[p->kind];
  edge_at_end(&g.from, 0, p->shape->pieces[0].begin);
  for (int i = 0; i < b->count; i++) {
    const struct crossing *at = &b->crossing[i];
    edge_at_crossing(&g.to, at, p->shape, precision);
    const char *why = crossing_holds(&g, at->to);
    if (why)
      return why;
    if (!is_clear(&g))
      return likely_event(b, &g);
    bend(&g, at);
  }
  edge_at_end(&g.to, last, p->shape->pieces[last].end);
  return is_clear(&g) ? NULL : likely_event(b, &g);
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
