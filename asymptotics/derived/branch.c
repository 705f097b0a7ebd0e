/* The laws of a branch in balls, and its crossings for T -> 0: at the ends of a phase, or at a given |l'| */
#include "asymptotics/derived/branch.h"

#include "asymptotics/derived/scoped.h"
#if __FLINT_RELEASE >= 30000
#include <flint/arb_calc.h>
#else
#include <arb_calc.h>
#endif

void set_kappa(fmpq_t kappa, const struct scallop_rational_crawler *c)
{
  SCOPED(fmpq, M);
  fmpq_add(M, c->m1, c->m2);
  fmpq_add(kappa, c->F1, c->F2);
  fmpq_div(kappa, kappa, M);
  fmpq_div(kappa, kappa, c->L);
}

void ball_times(arb_t product, const arb_t x, const fmpq_t q, slong precision)
{
  arb_mul_fmpz(product, x, fmpq_numref(q), precision);
  arb_div_fmpz(product, product, fmpq_denref(q), precision);
}

void time_of_offset(arb_t time, const struct scallop_piece *piece, const arb_t u, slong precision)
{
  arb_set(time, u);
  if (piece->anchor == SCALLOP_FROM_END) {
    arb_sub_si(time, time, 1, precision);
    arb_neg(time, time);
  }
}

/* Computes |l'| - level, and its derivative with respect to u. */
static void excess_at(arb_t excess, arb_t slope, const struct scallop_piece *piece, const arb_t level, const arb_t u,
                      slong precision)
{
  scallop_ball_speed(excess, piece, u, precision);
  arb_sub(excess, excess, level, precision);
  scallop_ball_rate(slope, piece, u, precision);
  if (piece->anchor == SCALLOP_FROM_END)
    arb_neg(slope, slope);
}

void gap_at(arb_t gap, arb_t slope, const struct scallop_piece *piece, const fmpq_t q, const arb_t a, const arb_t b,
            const arb_t u, slong precision)
{
  SCOPED(arb, s);
  time_of_offset(s, piece, u, precision);
  scallop_ball_speed(gap, piece, u, precision);
  ball_times(gap, gap, q, precision);
  arb_submul(gap, b, s, precision);
  arb_sub(gap, gap, a, precision);
  scallop_ball_rate(slope, piece, u, precision);
  ball_times(slope, slope, q, precision);
  arb_sub(slope, slope, b, precision);
  if (piece->anchor == SCALLOP_FROM_END)
    arb_neg(slope, slope);
}

/* Finds the middle by Newton's method, until it is stationary or alternates; value and slope are computed there. */
static bool find_middle(arb_t x, arb_t value, arb_t slope, root_function *f, void *of, slong precision)
{
  enum { STEPS = 40 };
  SCOPED(arb, step);
  for (int i = 0;; i++) {
    mag_zero(arb_radref(x));
    if (!f(value, slope, x, of, precision))
      return false;
    arb_div(step, value, slope, precision);
    if (!arb_is_finite(step))
      return false;
    if (i == STEPS || arf_cmpabs_mag(arb_midref(step), arb_radref(step)) <= 0)
      return true;
    arf_sub(arb_midref(x), arb_midref(x), arb_midref(step), precision, ARF_RND_NEAR);
  }
}

bool enclose_root(arb_t x, root_function *f, void *of, arb_srcptr holding, slong precision)
{
  enum { TRIES = 40 };
  SCOPED(arb, value, slope, unused, wide, next);
  if (!find_middle(x, value, slope, f, of, precision))
    return false;
  arb_div(next, value, slope, precision);
  arb_set(wide, x);
  arb_get_mag(arb_radref(wide), next);
  for (int i = 0; i < TRIES; i++) {
    mag_mul_2exp_si(arb_radref(wide), arb_radref(wide), 1);
    if (mag_is_zero(arb_radref(wide)))
      mag_set_ui_2exp_si(arb_radref(wide), 1, -precision);
    if (!f(unused, slope, wide, of, precision))
      return false;
    arb_div(next, value, slope, precision);
    arb_sub(next, x, next, precision);
    if (!arb_is_finite(next))
      return false;
    if (arb_contains(wide, next) && (!holding || arb_contains(wide, holding))) {
      arb_set(x, next);
      return true;
    }
  }
  return false; /* GCOVR_EXCL_LINE: balls too wide */
}

void phase_constants_set(struct phase_constants *p, const struct scallop_rational_crawler *c,
                         enum scallop_phase_kind kind)
{
  bool extension = kind == SCALLOP_EXTENSION;
  SCOPED(fmpq, total);
  p->kind = kind;
  p->shape = &c->gait->phase[kind];
  scallop_rational_fraction(p->fraction, c, kind);
  fmpq_add(total, c->m1, c->m2);
  fmpq_div(p->curve[0], extension ? c->m2 : c->m1, total);
  fmpq_sub_si(p->curve[1], p->curve[0], 1);
  fmpq_add(total, c->F1, c->F2);
  fmpq_sub(p->beta[1], extension ? c->F1 : c->F2, extension ? c->F2 : c->F1);
  fmpq_div(p->beta[1], p->beta[1], total);
  fmpq_set_si(p->beta[0], -1, 1);
  fmpq_set_si(p->beta[2], 1, 1);
}

void branch_init(struct branch *b)
{
  *b = (struct branch){ .first_region = 1 };
  for (int i = 0; i < MOST_CROSSINGS; i++)
    series_init(&b->crossing[i].offset);
}

void branch_clear(struct branch *b)
{
  for (int i = 0; i < MOST_CROSSINGS; i++)
    series_clear(&b->crossing[i].offset);
}

void branch_set(struct branch *to, const struct branch *from)
{
  to->first_region = from->first_region;
  to->count = from->count;
  for (int i = 0; i < from->count; i++) {
    const struct crossing *at = &from->crossing[i];
    to->crossing[i].tangent = at->tangent;
    to->crossing[i].piece = at->piece;
    to->crossing[i].curve = at->curve;
    to->crossing[i].to = at->to;
    series_set(&to->crossing[i].offset, &at->offset);
  }
}

int branch_region(const struct branch *b, int segment)
{
  return segment == 0 ? b->first_region : b->crossing[segment - 1].to;
}

typedef void piece_function(arb_t value, const struct scallop_piece *piece, const arb_t u, slong precision);

typedef void piece_place(arb_t u, const struct scallop_piece *piece, slong precision);

static bool is_zero_at(piece_function *f, const struct scallop_piece *piece, piece_place *place)
{
  SCOPED(arb, u, value);
  place(u, piece, 64);
  f(value, piece, u, 64);
  return arb_contains_zero(value);
}

const char *const branch_impossible =
    "l' is 0 or changes its sign within a phase: bodies turn there, too, and no series is derived for that";

bool branch_is_possible(const struct scallop_gait *gait)
{
  for (int kind = 0; kind < 2; kind++) {
    const struct scallop_shape *shape = &gait->phase[kind];
    for (int i = 0; i < shape->count; i++) {
      const struct scallop_piece *piece = &shape->pieces[i];
      if (piece->direction != (kind == SCALLOP_EXTENSION ? 1 : -1)
          || (i > 0 && is_zero_at(scallop_ball_speed, piece, scallop_ball_begin))
          || (i + 1 < shape->count && is_zero_at(scallop_ball_speed, piece, scallop_ball_end)))
        return false;
    }
  }
  return true;
}

const char *not_expandable(const struct scallop_rational_crawler *crawler, slong order, slong precision)
{
  enum { LEAST_PRECISION = 16 };
  return !scallop_rational_is_valid(crawler)       ? "a parameter is outside its domain"
         : order < 1 || order > SCALLOP_MOST_TERMS ? "the order is outside of 1 to 1000"
         : precision < LEAST_PRECISION             ? "fewer than 16 bits"
         : !scallop_gait_is_exact(crawler->gait)   ? "the gait has no exact law"
         : !branch_is_possible(crawler->gait)      ? branch_impossible
                                                   : NULL;
}

enum scallop_status refused_for(enum scallop_status status, const char *reason, const char **why)
{
  if (why)
    *why = reason;
  return status;
}

const char *const branch_without_ends =
    "l'' = 0 at an end of a phase: the switching times are fractional powers of T; or "
    "the piece there is anchored elsewhere";

static void add_crossing(struct branch *b, const struct scallop_piece *piece, int curve, int to, bool tangent)
{
  struct crossing *at = &b->crossing[b->count++];
  at->tangent = tangent;
  at->piece = piece;
  at->curve = curve;
  at->to = to;
  series_set_si(&at->offset, 0);
}

/* Adds a crossing at one end of the phase, at this offset of the piece: its anchor. If l' jumps there, it has no
 * crossing: c is small. */
static bool add_end(struct branch *b, const struct scallop_piece *piece, bool at_end, int curve, int to)
{
  piece_place *place = at_end ? scallop_ball_end : scallop_ball_begin;
  if (!is_zero_at(scallop_ball_speed, piece, place))
    return true;
  if ((at_end ? piece->end : piece->begin) != 0 || is_zero_at(scallop_ball_rate, piece, place))
    return false;
  add_crossing(b, piece, curve, to, false);
  return true;
}

/* Adds the release of a body: if l'' = 0 at the start of a phase from rest, friction holds the body with more friction.
 * Returns false as add_end. */
static bool add_release(struct branch *b, const struct scallop_piece *piece, int sign)
{
  if (sign == 0 || !is_zero_at(scallop_ball_speed, piece, scallop_ball_begin)
      || !is_zero_at(scallop_ball_rate, piece, scallop_ball_begin))
    return true;
  SCOPED(fmpq_poly, speed);
  SCOPED(fmpq, start);
  bool parabolic = piece->begin == 0 && scallop_rational_speed_series(speed, piece, start, 3, NULL)
                   && fmpq_poly_length(speed) == 3 && fmpz_is_zero(fmpq_poly_numref(speed) + 1);
  if (parabolic)
    add_crossing(b, piece, sign > 0 ? 0 : 1, 1, true);
  return parabolic;
}

const char *branch_from_ends(struct branch *b, const struct phase_constants *p, int at_start, int at_end)
{
  const struct scallop_piece *first = &p->shape->pieces[0], *last = &p->shape->pieces[p->shape->count - 1];
  b->count = 0;
  bool begun = at_start != 0 ? add_end(b, first, false, at_start > 0 ? 0 : 1, 1)
                             : add_release(b, first, fmpq_sgn(p->beta[1]));
  b->first_region = at_start == 0 || b->count == 0 ? 1 : at_start > 0 ? 0 : 2;
  bool ended = at_end == 0 || add_end(b, last, true, at_end > 0 ? 0 : 1, at_end > 0 ? 0 : 2);
  return begun && ended ? NULL : branch_without_ends;
}

const char *branch_of_phase(struct branch *b, struct phase_constants *p, const struct scallop_rational_crawler *crawler,
                            enum scallop_phase_kind kind, const fmpq_t v0, slong order, slong precision)
{
  const char *none = not_expandable(crawler, order, precision);
  if (none)
    return none;
  phase_constants_set(p, crawler, kind);
  const int sign = fmpq_sgn(v0);
  return branch_from_ends(b, p, sign, sign != 0 ? sign : fmpq_sgn(p->beta[1]));
}

struct crossing_search { /* for the crossings of one piece                                                     */
  const struct scallop_piece *piece;
  arb_srcptr level; /* level of |l'|, positive */
};

/* Computes |l'| - level and, with order 2, its derivative, in the form of arb_calc.h. */
static int excess(arb_ptr value, const arb_t u, void *search, slong order, slong precision)
{
  const struct crossing_search *s = search;
  SCOPED(arb, slope);
  excess_at(value, slope, s->piece, s->level, u, precision);
  if (order > 1)
    arb_set(value + 1, slope);
  return 0;
}

/* Finds a place near the single root in the block, by bisection, narrow enough for Newton's method. */
static void approach(arb_t u, struct crossing_search *s, const arf_interval_t block, slong precision)
{
  enum { HALVINGS = 24 };
  arf_interval_t narrow;
  SCOPED(arb, gap, slope);
  arf_interval_init(narrow);
  arb_calc_refine_root_bisect(narrow, excess, s, block, HALVINGS, precision);
  arf_interval_get_arb(u, narrow, precision);
  mag_zero(arb_radref(u));
  for (slong bits = HALVINGS; bits < 2 * precision; bits *= 2) {
    excess_at(gap, slope, s->piece, s->level, u, precision);
    arb_div(gap, gap, slope, precision);
    arb_sub(u, u, gap, precision);
    mag_zero(arb_radref(u));
  }
  arf_interval_clear(narrow);
}

/* Adds the roots in the order of time. Returns false if one is not isolated, or if they are too many. outer: the region
 * above curve 0 or below curve 1. */
static bool add_roots(struct branch *b, struct crossing_search *s, int outer, slong precision)
{
  enum { DEPTH = 40, MOST_EVALUATIONS = 100000 };
  const bool forward = s->piece->anchor == SCALLOP_FROM_START;
  arf_interval_ptr blocks;
  arf_interval_t all;
  int *flags; /* 1: one root in this block */
  SCOPED(arb, u);
  arf_interval_init(all);
  (forward ? scallop_ball_begin : scallop_ball_end)(u, s->piece, precision);
  arf_set(&all->a, arb_midref(u));
  (forward ? scallop_ball_end : scallop_ball_begin)(u, s->piece, precision);
  arf_set(&all->b, arb_midref(u));
  slong count = arb_calc_isolate_roots(&blocks, &flags, excess, s, all, DEPTH, MOST_EVALUATIONS, WORD_MAX, precision);
  bool found = true;
  for (slong i = 0; found && i < count; i++) {
    const slong next = forward ? i : count - 1 - i;
    found = flags[next] == 1 && b->count < MOST_CROSSINGS;
    if (!found)
      break;
    approach(u, s, blocks + next, precision);
    add_crossing(b, s->piece, outer == 0 ? 0 : 1, branch_region(b, b->count) == 1 ? outer : 1, false);
    series_set_ball(&b->crossing[b->count - 1].offset, u);
  }
  _arf_interval_vec_clear(blocks, count);
  flint_free(flags);
  arf_interval_clear(all);
  return found;
}

bool branch_of_level(struct branch *b, const struct phase_constants *p, const arb_t c, slong precision)
{
  const int outer = arb_is_positive(c) ? 0 : 2;
  const fmpq *q = p->curve[outer == 0 ? 0 : 1];
  SCOPED(arb, level, u, above, slope);
  struct crossing_search s = { .level = level };
  arb_div_fmpz(level, c, fmpq_numref(q), precision);
  arb_mul_fmpz(level, level, fmpq_denref(q), precision);
  scallop_ball_begin(u, &p->shape->pieces[0], precision);
  excess_at(above, slope, &p->shape->pieces[0], level, u, precision);
  b->count = 0;
  b->first_region = arb_is_negative(above) ? outer : 1; /* below the level both bodies move in the same direction */
  bool found = !arb_contains_zero(c) && !arb_contains_zero(above);
  for (int i = 0; found && i < p->shape->count; i++) {
    s.piece = &p->shape->pieces[i];
    found = add_roots(b, &s, outer, precision);
  }
  return found;
}
