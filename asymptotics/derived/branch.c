#include "asymptotics/derived/branch.h"

#include <math.h>

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

void gap_at(arb_t gap, arb_t slope, const struct scallop_piece *piece, const fmpq_t q, const arb_t a, const arb_t b,
            const arb_t u, slong precision)
{
  arb_t s;
  arb_init(s);
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
  arb_clear(s);
}

/* ---- the constants of a phase ---- */

void phase_constants_init(struct phase_constants *p, const struct scallop_rational_crawler *c, enum scallop_phase_kind kind)
{
  bool extension = kind == SCALLOP_EXTENSION;
  fmpq_t total;
  fmpq_init(total);
  fmpq_init(p->fraction);
  p->kind = kind;
  p->shape = &c->gait->phase[kind];
  scallop_rational_fraction(p->fraction, c, kind);
  for (int i = 0; i < 2; i++)
    fmpq_init(p->curve[i]);
  for (int i = 0; i < 3; i++)
    fmpq_init(p->beta[i]);
  fmpq_add(total, c->m1, c->m2);
  fmpq_div(p->curve[0], extension ? c->m2 : c->m1, total);
  fmpq_sub_si(p->curve[1], p->curve[0], 1);
  fmpq_add(total, c->F1, c->F2);
  fmpq_sub(p->beta[1], extension ? c->F1 : c->F2, extension ? c->F2 : c->F1);
  fmpq_div(p->beta[1], p->beta[1], total);
  fmpq_set_si(p->beta[0], -1, 1);
  fmpq_set_si(p->beta[2], 1, 1);
  fmpq_clear(total);
}

void phase_constants_clear(struct phase_constants *p)
{
  fmpq_clear(p->fraction);
  for (int i = 0; i < 2; i++)
    fmpq_clear(p->curve[i]);
  for (int i = 0; i < 3; i++)
    fmpq_clear(p->beta[i]);
}

/* ---- branches ---- */

void branch_init(struct branch *b)
{
  b->first_region = 1;
  b->count = 0;
  for (int i = 0; i < MOST_CROSSINGS; i++)
    series_init(&b->crossing[i].offset);
}

void branch_clear(struct branch *b)
{
  for (int i = 0; i < MOST_CROSSINGS; i++)
    series_clear(&b->crossing[i].offset);
}

int branch_region(const struct branch *b, int segment)
{
  return segment == 0 ? b->first_region : b->crossing[segment - 1].to;
}

typedef void piece_function(arb_t value, const struct scallop_piece *piece, const arb_t u, slong precision);

typedef void piece_place(arb_t u, const struct scallop_piece *piece, slong precision);

static bool is_zero_at(piece_function *f, const struct scallop_piece *piece, piece_place *place)
{
  arb_t u, value;
  arb_init(u);
  arb_init(value);
  place(u, piece, 64);
  f(value, piece, u, 64);
  bool zero = arb_contains_zero(value);
  arb_clear(u);
  arb_clear(value);
  return zero;
}

const char *const branch_impossible =
    "l' is 0 or changes its sign within a phase: bodies turn there, too, and there is no series for that";

bool branch_is_possible(const struct scallop_gait *gait)
{
  for (int kind = 0; kind < 2; kind++) {
    const struct scallop_shape *shape = &gait->phase[kind];
    for (int i = 0; i < shape->count; i++) {
      const struct scallop_piece *piece = &shape->pieces[i];
      if (piece->direction != (kind == SCALLOP_EXTENSION ? 1 : -1))
        return false;
      if ((i > 0 && is_zero_at(scallop_ball_speed, piece, scallop_ball_begin))
          || (i + 1 < shape->count && is_zero_at(scallop_ball_speed, piece, scallop_ball_end)))
        return false;
    }
  }
  return true;
}

const char *const branch_without_ends = "l'' = 0 at an end of a phase: the switching times go as fractional powers of T; or "
                                        "the piece there is anchored elsewhere";

/* A crossing at one end of the phase, which is at that offset of the piece: its anchor. Where l' jumps there is none: c is small. */
static bool add_end(struct branch *b, const struct scallop_piece *piece, bool at_end, int curve, int to)
{
  piece_place *place = at_end ? scallop_ball_end : scallop_ball_begin;
  if (!is_zero_at(scallop_ball_speed, piece, place))
    return true;
  if ((at_end ? piece->end : piece->begin) != 0 || is_zero_at(scallop_ball_rate, piece, place))
    return false;
  struct crossing *at = &b->crossing[b->count++];
  at->piece = piece;
  at->curve = curve;
  at->to = to;
  series_set_si(&at->offset, 0);
  return true;
}

bool branch_from_ends(struct branch *b, const struct phase_constants *p, int sign_at_start, int sign_at_end)
{
  const struct scallop_piece *first = &p->shape->pieces[0], *last = &p->shape->pieces[p->shape->count - 1];
  b->count = 0;
  b->first_region = 1;
  if (sign_at_start != 0) {
    if (!add_end(b, first, false, sign_at_start > 0 ? 0 : 1, 1))
      return false;
    if (b->count > 0)
      b->first_region = sign_at_start > 0 ? 0 : 2;
  }
  return sign_at_end == 0 || add_end(b, last, true, sign_at_end > 0 ? 0 : 1, sign_at_end > 0 ? 0 : 2);
}

/* ---- where |l'| takes a value ---- */

static int definite_sign(const arb_t x) { return arb_is_positive(x) ? 1 : arb_is_negative(x) ? -1 : 0; }

/* |l'|(u) - level */
static void excess(arb_t f, const struct scallop_piece *p, const arb_t u, const arb_t level, slong precision)
{
  scallop_ball_speed(f, p, u, precision);
  arb_sub(f, f, level, precision);
}

/* Halves [lo, hi] until it is narrow enough for Newton's method: the sign of the excess differs at its ends. */
static void approach(arb_t u, const struct scallop_piece *p, const arb_t level, const arf_t lo, const arf_t hi, int sign_lo,
                     slong precision)
{
  enum { HALVINGS = 24 };
  arf_t a, b;
  arb_t f;
  arf_init(a);
  arf_init(b);
  arb_init(f);
  arf_set(a, lo);
  arf_set(b, hi);
  for (int i = 0; i < HALVINGS; i++) {
    arf_add(arb_midref(u), a, b, ARF_PREC_EXACT, ARF_RND_DOWN);
    arf_mul_2exp_si(arb_midref(u), arb_midref(u), -1);
    mag_zero(arb_radref(u));
    excess(f, p, u, level, precision);
    arf_set(arf_sgn(arb_midref(f)) == sign_lo ? a : b, arb_midref(u));
  }
  for (slong bits = HALVINGS; bits < 2 * precision; bits *= 2) {
    arb_t rate;
    arb_init(rate);
    excess(f, p, u, level, precision);
    scallop_ball_rate(rate, p, u, precision);
    if (p->anchor == SCALLOP_FROM_END)
      arb_neg(rate, rate);
    arb_div(f, f, rate, precision);
    arb_sub(u, u, f, precision);
    mag_zero(arb_radref(u));
    arb_clear(rate);
  }
  arf_clear(a);
  arf_clear(b);
  arb_clear(f);
}

struct search {
  struct branch *branch;
  const struct scallop_piece *piece;
  const struct phase_constants *constants;
  arb_t level; /* of |l'|, positive                                                               */
  int outer;   /* the region above curve 0 or below curve 1: 0 or 2                               */
  slong precision;
};

static bool add_root(struct search *s, const arf_t lo, const arf_t hi, int sign_lo)
{
  if (s->branch->count == MOST_CROSSINGS)
    return false;
  struct crossing *at = &s->branch->crossing[s->branch->count];
  at->to = branch_region(s->branch, s->branch->count) == 1 ? s->outer : 1;
  at->curve = s->outer == 0 ? 0 : 1;
  at->piece = s->piece;
  arb_t u;
  arb_init(u);
  approach(u, s->piece, s->level, lo, hi, sign_lo, s->precision);
  series_set_ball(&at->offset, u);
  arb_clear(u);
  s->branch->count++;
  return true;
}

/* The roots between offsets lo and hi, in the order of time: none where the excess keeps its sign, one where it is monotone
 * and changes it. */
static bool search_between(struct search *s, const arf_t lo, const arf_t hi, int depth)
{
  arb_t u, f, rate;
  arf_t middle;
  arb_init(u);
  arb_init(f);
  arb_init(rate);
  arf_init(middle);
  bool found = false;
  arb_set_interval_arf(u, lo, hi, s->precision);
  excess(f, s->piece, u, s->level, s->precision);
  scallop_ball_rate(rate, s->piece, u, s->precision);
  if (definite_sign(f) != 0)
    found = true;
  else if (definite_sign(rate) != 0) {
    arb_set_arf(u, lo);
    excess(f, s->piece, u, s->level, s->precision);
    int at_lo = definite_sign(f);
    arb_set_arf(u, hi);
    excess(f, s->piece, u, s->level, s->precision);
    int at_hi = definite_sign(f);
    if (at_lo != 0 && at_hi != 0)
      found = at_lo == at_hi || add_root(s, lo, hi, at_lo);
  } else if (depth > 0) {
    bool forward = s->piece->anchor == SCALLOP_FROM_START;
    arf_add(middle, lo, hi, ARF_PREC_EXACT, ARF_RND_DOWN);
    arf_mul_2exp_si(middle, middle, -1);
    found = search_between(s, forward ? lo : middle, forward ? middle : hi, depth - 1)
            && search_between(s, forward ? middle : lo, forward ? hi : middle, depth - 1);
  }
  arb_clear(u);
  arb_clear(f);
  arb_clear(rate);
  arf_clear(middle);
  return found;
}

/* The side of the level on which a phase begins: -1 below it, where the bodies move alike. */
static int side_at_start(const struct search *s)
{
  arb_t u, f;
  arb_init(u);
  arb_init(f);
  scallop_ball_begin(u, &s->constants->shape->pieces[0], s->precision);
  excess(f, &s->constants->shape->pieces[0], u, s->level, s->precision);
  int side = definite_sign(f);
  arb_clear(u);
  arb_clear(f);
  return side;
}

bool branch_of_level(struct branch *b, const struct phase_constants *p, const arb_t c, slong precision)
{
  enum { DEPTH = 40 };
  int sign = definite_sign(c);
  struct search s = { .branch = b, .constants = p, .outer = sign > 0 ? 0 : 2, .precision = precision };
  arf_t lo, hi;
  if (sign == 0)
    return false;
  arb_t border;
  arb_init(border);
  arb_init(s.level);
  arf_init(lo);
  arf_init(hi);
  arb_div_fmpz(s.level, c, fmpq_numref(p->curve[sign > 0 ? 0 : 1]), precision);
  arb_mul_fmpz(s.level, s.level, fmpq_denref(p->curve[sign > 0 ? 0 : 1]), precision);
  int side = side_at_start(&s);
  b->count = 0;
  b->first_region = side < 0 ? s.outer : 1;
  bool found = side != 0;
  for (int i = 0; found && i < p->shape->count; i++) {
    s.piece = &p->shape->pieces[i];
    bool forward = s.piece->anchor == SCALLOP_FROM_START;
    (forward ? scallop_ball_begin : scallop_ball_end)(border, s.piece, precision);
    arf_set(lo, arb_midref(border));
    (forward ? scallop_ball_end : scallop_ball_begin)(border, s.piece, precision);
    arf_set(hi, arb_midref(border));
    found = search_between(&s, lo, hi, DEPTH);
  }
  arb_clear(border);
  arb_clear(s.level);
  arf_clear(lo);
  arf_clear(hi);
  return found;
}

/* ---- the base point in balls ---- */

void base_init(struct base *b)
{
  arb_init(b->c_end);
  arb_init(b->balance);
  arb_init(b->c_end_slope);
  arb_init(b->balance_slope);
}

void base_clear(struct base *b)
{
  arb_clear(b->c_end);
  arb_clear(b->balance);
  arb_clear(b->c_end_slope);
  arb_clear(b->balance_slope);
}

struct straight { /* c = a + b s                                                               */
  arb_t a, b, a_slope;
};

/* u becomes a ball that holds the crossing for every line within the balls of line: Newton's interval operator maps it into
 * itself. u comes in as a place near it. */
static bool enclose(arb_t u, const struct crossing *at, const fmpq_t q, const struct straight *line, bool same,
                    slong precision)
{
  enum { TRIES = 60, STEPS = 40 };
  arb_t gap, slope, wide, next, given;
  bool inside = false;
  arb_init(given);
  arb_set(given, u);
  arb_init(gap);
  arb_init(slope);
  arb_init(wide);
  arb_init(next);
  for (int i = 0; i < STEPS; i++) { /* the middle of u, for the middle of the line */
    mag_zero(arb_radref(u));
    gap_at(gap, slope, at->piece, q, line->a, line->b, u, precision);
    arb_div(gap, gap, slope, precision);
    if (!arb_is_finite(gap))
      break;
    arf_sub(arb_midref(u), arb_midref(u), arb_midref(gap), precision, ARF_RND_NEAR);
    if (arf_cmpabs_mag(arb_midref(gap), arb_radref(gap)) <= 0)
      break;
  }
  mag_zero(arb_radref(u));
  gap_at(gap, slope, at->piece, q, line->a, line->b, u, precision);
  arb_div(next, gap, slope, precision);
  arb_set(wide, u);
  arb_get_mag(arb_radref(wide), next);
  for (int i = 0; i < TRIES && !inside && arb_is_finite(next); i++) {
    mag_mul_2exp_si(arb_radref(wide), arb_radref(wide), 1);
    if (mag_is_zero(arb_radref(wide)))
      mag_set_ui_2exp_si(arb_radref(wide), 1, -precision);
    gap_at(next, slope, at->piece, q, line->a, line->b, wide, precision);
    arb_div(next, gap, slope, precision);
    arb_sub(next, u, next, precision);
    inside = arb_is_finite(next) && arb_contains(wide, next) && (!same || arb_contains(wide, given));
    if (arf_cmpabs_2exp_si(arb_midref(u), 1) > 0 || mag_cmp_2exp_si(arb_radref(wide), 1) > 0)
      break;
  }
  if (inside)
    arb_set(u, next);
  arb_clear(gap);
  arb_clear(slope);
  arb_clear(wide);
  arb_clear(next);
  arb_clear(given);
  return inside;
}

/* After the crossing at time s with ds/d(unknown) = s_slope, from region r to region `to`. */
static void bend(struct base *base, struct straight *line, const struct phase_constants *p, int r, int to, const arb_t eps,
                 const arb_t s, const arb_t s_slope, slong precision)
{
  arb_t term;
  fmpq_t drop;
  arb_init(term);
  fmpq_init(drop);
  fmpq_sub(drop, p->beta[r], p->beta[to]);
  ball_times(term, s, drop, precision);
  arb_add(base->balance, base->balance, term, precision);
  arb_addmul(line->a, term, eps, precision);
  ball_times(term, s_slope, drop, precision);
  arb_add(base->balance_slope, base->balance_slope, term, precision);
  arb_addmul(line->a_slope, term, eps, precision);
  ball_times(line->b, eps, p->beta[to], precision);
  arb_clear(term);
  fmpq_clear(drop);
}

bool base_follow(struct base *base, struct branch *b, const struct phase_constants *p, const arb_t eps, const arb_t c,
                 const arb_t c_slope, bool same, slong precision)
{
  struct straight line;
  arb_t u[MOST_CROSSINGS], gap, slope;
  bool found = true;
  arb_init(line.a);
  arb_init(line.b);
  arb_init(line.a_slope);
  arb_init(gap);
  arb_init(slope);
  for (int i = 0; i < b->count; i++)
    arb_init(u[i]);
  arb_set(line.a, c);
  arb_set(line.a_slope, c_slope);
  ball_times(line.b, eps, p->beta[b->first_region], precision);
  arb_zero(base->balance);
  arb_zero(base->balance_slope);
  for (int i = 0; found && i < b->count; i++) {
    const struct crossing *at = &b->crossing[i];
    series_coefficient(u[i], &at->offset, 0, precision);
    found = enclose(u[i], at, p->curve[at->curve], &line, same, precision);
    gap_at(gap, slope, at->piece, p->curve[at->curve], line.a, line.b, u[i], precision);
    if (at->piece->anchor == SCALLOP_FROM_END)
      arb_neg(slope, slope);
    arb_div(slope, line.a_slope, slope, precision);
    time_of_offset(gap, at->piece, u[i], precision);
    bend(base, &line, p, branch_region(b, i), at->to, eps, gap, slope, precision);
    found = found && arb_is_finite(slope);
  }
  if (found) {
    arb_add(base->c_end, line.a, line.b, precision);
    arb_set(base->c_end_slope, line.a_slope);
    arb_set_fmpq(gap, p->beta[branch_region(b, b->count)], precision);
    arb_add(base->balance, base->balance, gap, precision);
  }
  for (int i = 0; i < b->count; i++) {
    if (found)
      series_set_ball(&b->crossing[i].offset, u[i]);
    arb_clear(u[i]);
  }
  arb_clear(line.a);
  arb_clear(line.b);
  arb_clear(line.a_slope);
  arb_clear(gap);
  arb_clear(slope);
  return found;
}
