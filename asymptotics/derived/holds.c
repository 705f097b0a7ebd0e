/* c on each segment of a motion, and the proof that it stays between the curves that bound its region */
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

struct region_line { /* c = a + b s in one region of one phase                                    */
  const struct phase_constants *p;
  int region;
  arb_t a, b, eps;
  struct edge from, to;
  slong precision;
};
#define LINE_PARTS(of) of(arb, s->a) of(arb, s->b) of(arb, s->eps) of(edge, &s->from) of(edge, &s->to)
SCOPED_PARTS(region_line, struct region_line, LINE_PARTS)

/* Computes the distance of c from curve j, positive in the region, at offset u, and its derivative by u. */
static void distance_inside(arb_t gap, arb_t slope, const struct region_line *g, const struct scallop_piece *piece,
                            int j, const arb_t u)
{
  gap_at(gap, slope, piece, g->p->curve[j], g->a, g->b, u, g->precision);
  if (g->region <= j) { /* above it */
    arb_neg(gap, gap);
    arb_neg(slope, slope);
  }
}

/* Returns true if the distance is positive at all offsets of a ball, by its value in the middle and its derivative:
 * near a curve that c almost touches, the derivative is small, and the ball of the distance is much too wide. */
static bool stays_inside(const struct region_line *g, const struct scallop_piece *piece, int j, const arb_t u,
                         const arb_t slope)
{
  SCOPED(arb, middle, gap, there, off);
  arb_get_mid_arb(middle, u);
  distance_inside(gap, there, g, piece, j, middle);
  arb_sub(off, u, middle, g->precision);
  arb_addmul(gap, off, slope, g->precision);
  return arb_is_positive(gap);
}

/* Returns true if c stays off curve j between offsets lo and hi; it meets it transversally within an end with a set
 * flag. */
static bool keeps_off(const struct region_line *g, const struct scallop_piece *piece, int j, const arf_t lo,
                      const arf_t hi, bool touches_lo, bool touches_hi, int depth)
{
  SCOPED(arb, u, gap, slope);
  SCOPED(arf, middle);
  arb_set_interval_arf(u, lo, hi, g->precision);
  distance_inside(gap, slope, g, piece, j, u);
  if (arb_is_positive(gap) || (touches_lo && !touches_hi && arb_is_positive(slope))
      || (touches_hi && !touches_lo && arb_is_negative(slope)) || stays_inside(g, piece, j, u, slope))
    return true;
  arf_add(middle, lo, hi, ARF_PREC_EXACT, ARF_RND_DOWN);
  arf_mul_2exp_si(middle, middle, -1);
  return depth > 0 && keeps_off(g, piece, j, lo, middle, touches_lo, false, depth - 1)
         && keeps_off(g, piece, j, middle, hi, false, touches_hi, depth - 1);
}

/* Returns true if the piece after the one of this index, or for -1 before it, continues the same function. */
static bool continues(const struct scallop_shape *shape, int piece, int to, bool *turned)
{
  const int first = to > 0 ? piece : piece - 1;
  return first >= 0 && first + 1 < shape->count
         && scallop_piece_continues(&shape->pieces[first], &shape->pieces[first + 1], turned);
}

/* Sets the current piece and offset of a crossing: it may have moved to an adjacent piece if l' has no corner there. */
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
    if (moved == 0 || !continues(shape, e->piece, moved, &turned))
      return;
    e->piece += moved;
    if (turned) { /* measured from the other end */
      arb_sub_si(e->offset, e->offset, 1, precision);
      arb_neg(e->offset, e->offset);
    }
  }
}

/* Computes the time from an edge to the end of its piece, or since its start. */
static void way_to_border(arb_t way, const struct edge *e, const struct scallop_shape *shape, bool to_end,
                          slong precision)
{
  const struct scallop_piece *piece = &shape->pieces[e->piece];
  (to_end ? scallop_ball_end : scallop_ball_begin)(way, piece, precision);
  arb_sub(way, way, e->offset, precision);
  if ((piece->anchor == SCALLOP_FROM_START) != to_end)
    arb_neg(way, way);
}

/* Returns true if the ball of a crossing extends over this border: it may then be in either piece. */
static bool overlaps_border(const struct edge *e, const struct region_line *g, bool over_end)
{
  SCOPED(arb, way);
  way_to_border(way, e, g->p->shape, over_end, g->precision);
  return e->curve >= 0 && !arb_is_positive(way);
}

/* Computes the part of piece i that the segment covers, rounded outward. Returns false if it is empty. */
static bool part_of_piece(arf_t early, arf_t late, const struct region_line *g, int i)
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

/* Returns true if the segment stays off the curves of its region. */
static bool is_clear(const struct region_line *g)
{
  enum { DEPTH = 30 };
  const struct edge *from = &g->from, *to = &g->to;
  const int touches_until = from->piece + overlaps_border(from, g, true),
            touches_from = to->piece - overlaps_border(to, g, false);
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

/* Failures of a crossing from a region into another: its slope equals the slope of c after it, or before it, and c
 * follows the curve; or it leaves its piece. After the last piece the other phase starts. */
enum risk { STICKS_BEHIND, REACHES_END, REACHES_BEGIN, STICKS_BEFORE, RISKS };

/* Computes the distance from this failure, 0 to 1. Returns the event, or NULL if l' continues there. */
static const char *margin_of(arb_t margin, enum risk risk, const struct edge *e, const struct region_line *g, int from,
                             int into)
{
  const struct phase_constants *p = g->p;
  const bool at_end = risk == REACHES_END, outermost = e->piece == (at_end ? p->shape->count - 1 : 0);
  bool turned;
  if (risk == REACHES_END || risk == REACHES_BEGIN) {
    way_to_border(margin, e, p->shape, at_end, g->precision);
    return outermost                                                 ? starts[at_end ? 1 - p->kind : p->kind]
           : continues(p->shape, e->piece, at_end ? 1 : -1, &turned) ? NULL
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

/* Returns NULL, or the event that prevents the proof of the crossing at the end of the segment, in its piece. */
static const char *crossing_holds(const struct region_line *g, int into)
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

/* Returns the likely event if c may touch a curve: a crossing is about to end, or a body starts or stops turning. */
static const char *likely_change(const struct branch *b, const struct region_line *g)
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

static void set_region(struct region_line *g, int region)
{
  g->region = region;
  arb_set_fmpq(g->b, g->p->beta[region], g->precision);
  arb_mul(g->b, g->b, g->eps, g->precision);
}

/* Continues after a crossing with the line through it: a = q |l'| - b s there. */
static void continue_after_crossing(struct region_line *g, const struct crossing *at)
{
  SCOPED(arb, s);
  set_region(g, at->to);
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

/* Returns NULL, or the reason why the modes of the phase may not be the branch's. c: at its start. */
static const char *phase_holds(const struct branch *b, const struct phase_constants *p, const arb_t eps, const arb_t c,
                               slong precision)
{
  const int last = p->shape->count - 1;
  SCOPED(region_line, g);
  g.p = p;
  g.precision = precision;
  arb_set(g.a, c);
  arb_set(g.eps, eps);
  set_region(&g, b->first_region);
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
      return likely_change(b, &g);
    continue_after_crossing(&g, at);
  }
  edge_at_end(&g.to, last, p->shape->pieces[last].end);
  return is_clear(&g) ? NULL : likely_change(b, &g);
}

const char *limit_holds(const struct limit *l, const arb_t w, const arb_t w_mid, const arb_t eps, slong precision)
{
  const char *why = NULL;
  SCOPED(arb, c, here, fraction);
  for (int k = 0; !why && k < 2; k++) { /* in units of the phase */
    arb_set_fmpq(fraction, l->phase[k].fraction, precision);
    arb_mul(here, eps, fraction, precision);
    arb_mul(here, here, fraction, precision);
    arb_mul(c, k == SCALLOP_EXTENSION ? w : w_mid, fraction, precision);
    why = phase_holds(&l->branch[k], &l->phase[k], here, c, precision);
  }
  return why;
}
