/* Where |l'| takes a value: the crossings of a branch at given c, every root isolated. */
#include "asymptotics/derived/branch.h"

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

/* The roots between offsets lo and hi, in the order of time: none where the excess keeps its sign, one where it is
 * monotone and changes it. */
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
