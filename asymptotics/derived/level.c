/* Where |l'| takes a value: the crossings of a branch at given c, every root isolated. */
#include "asymptotics/derived/branch.h"
#include "asymptotics/derived/scoped.h"

#include <math.h>

static int definite_sign(const arb_t x) { return arb_is_positive(x) ? 1 : arb_is_negative(x) ? -1 : 0; }

/* |l'|(u) - level */
static void excess(arb_t f, const struct scallop_piece *p, const arb_t u, const arb_t level, slong precision)
{
  scallop_ball_speed(f, p, u, precision);
  arb_sub(f, f, level, precision);
}

/* Halves [lo, hi] until it is narrow enough for Newton's method: the sign of the excess differs at its ends. */
static void approach(arb_t u, const struct scallop_piece *p, const arb_t level, const arf_t lo, const arf_t hi,
                     int sign_lo, slong precision)
{
  enum { HALVINGS = 24 };
  SCOPED(arf, a, b);
  SCOPED(arb, f);
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
    SCOPED(arb, rate);
    excess(f, p, u, level, precision);
    scallop_ball_rate(rate, p, u, precision);
    if (p->anchor == SCALLOP_FROM_END)
      arb_neg(rate, rate);
    arb_div(f, f, rate, precision);
    arb_sub(u, u, f, precision);
    mag_zero(arb_radref(u));
  }
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
  SCOPED(arb, u);
  approach(u, s->piece, s->level, lo, hi, sign_lo, s->precision);
  series_set_ball(&at->offset, u);
  s->branch->count++;
  return true;
}

/* The roots between offsets lo and hi, in the order of time: none where the excess keeps its sign, one where it is
 * monotone and changes it. */
static bool search_between(struct search *s, const arf_t lo, const arf_t hi, int depth)
{
  SCOPED(arb, u, f, rate);
  SCOPED(arf, middle);
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
  return found;
}

/* The side of the level on which a phase begins: -1 below it, where the bodies move alike. */
static int side_at_start(const struct search *s)
{
  SCOPED(arb, u, f);
  scallop_ball_begin(u, &s->constants->shape->pieces[0], s->precision);
  excess(f, &s->constants->shape->pieces[0], u, s->level, s->precision);
  return definite_sign(f);
}

bool branch_of_level(struct branch *b, const struct phase_constants *p, const arb_t c, slong precision)
{
  enum { DEPTH = 40 };
  int sign = definite_sign(c);
  struct search s = { .branch = b, .constants = p, .outer = sign > 0 ? 0 : 2, .precision = precision };
  if (sign == 0)
    return false;
  SCOPED(arb, border);
  arb_init(s.level);
  SCOPED(arf, lo, hi);
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
  arb_clear(s.level);
  return found;
}
