/* Arithmetic of truncated Laurent series; each result knows the power from which on it is unknown. */
#include <stdlib.h>

#include "asymptotics/derived/scoped.h"

#include <flint/fmpz_vec.h>

/* The call for this kind of coefficients */
#define BY_KIND(kind, fractions, of_pi, balls) \
  ((kind) == SERIES_FRACTIONS ? (fractions) : (kind) == SERIES_IN_PI ? (of_pi) : (balls))

static slong least(slong a, slong b) { return a < b ? a : b; }

/* known, when the series is multiplied by x^power: what is known to all orders stays so. */
static slong moved(slong known, slong power) { return known >= SERIES_ALL ? SERIES_ALL : known + power; }

void series_init(struct series *s)
{
  s->kind = SERIES_FRACTIONS;
  s->first = 0;
  s->known = SERIES_ALL;
  fmpq_poly_init(s->rational);
  pi_poly_init(&s->in_pi);
  arb_poly_init(s->ball);
}

void series_clear(struct series *s)
{
  fmpq_poly_clear(s->rational);
  pi_poly_clear(&s->in_pi);
  arb_poly_clear(s->ball);
}

void series_set(struct series *to, const struct series *from)
{
  if (to == from)
    return;
  to->kind = from->kind;
  to->first = from->first;
  to->known = from->known;
  BY_KIND(to->kind, fmpq_poly_set(to->rational, from->rational), pi_poly_set(&to->in_pi, &from->in_pi),
          arb_poly_set(to->ball, from->ball));
}

static void begin(struct series *s, enum series_kind kind, slong first, slong known)
{
  s->kind = kind;
  s->first = first;
  s->known = known;
}

void series_set_rational(struct series *s, const fmpq_t value)
{
  begin(s, SERIES_FRACTIONS, 0, SERIES_ALL);
  fmpq_poly_set_fmpq(s->rational, value);
}

void series_set_si(struct series *s, slong value)
{
  begin(s, SERIES_FRACTIONS, 0, SERIES_ALL);
  fmpq_poly_set_si(s->rational, value);
}

void series_set_ball(struct series *s, const arb_t value)
{
  begin(s, SERIES_BALLS, 0, SERIES_ALL);
  arb_poly_set_arb(s->ball, value);
}

void series_set_rational_poly(struct series *s, const fmpq_poly_t poly, slong known)
{
  begin(s, SERIES_FRACTIONS, 0, known);
  fmpq_poly_set(s->rational, poly);
}

void series_set_ball_poly(struct series *s, const arb_poly_t poly, slong known)
{
  begin(s, SERIES_BALLS, 0, known);
  arb_poly_set(s->ball, poly);
}

void series_set_pi_poly(struct series *s, const fmpq_poly_t poly, slong power, slong step, slong known)
{
  begin(s, SERIES_IN_PI, 0, known);
  pi_poly_set_fmpq_poly(&s->in_pi, poly, power, step);
}

void series_set_pi(struct series *s)
{
  series_set_si(s, 1);
  series_set_pi_poly(s, s->rational, 1, 0, SERIES_ALL);
}

void series_set_unknown(struct series *s)
{
  series_set_si(s, 0);
  s->first = s->known = -SERIES_ALL;
}

bool series_is_unknown(const struct series *s) { return s->known == -SERIES_ALL; }

void series_set_x(struct series *s)
{
  series_set_si(s, 1);
  s->first = 1;
}

slong series_terms(const struct series *s)
{
  return s->kind == SERIES_FRACTIONS ? fmpq_poly_length(s->rational)
         : s->kind == SERIES_IN_PI   ? s->in_pi.length
                                     : arb_poly_length(s->ball);
}

static void shift(struct series *s, slong by)
{
  if (by > 0)
    BY_KIND(s->kind, fmpq_poly_shift_left(s->rational, s->rational, by), pi_poly_shift(&s->in_pi, &s->in_pi, by),
            arb_poly_shift_left(s->ball, s->ball, by));
  else if (by < 0)
    BY_KIND(s->kind, fmpq_poly_shift_right(s->rational, s->rational, -by), pi_poly_shift(&s->in_pi, &s->in_pi, by),
            arb_poly_shift_right(s->ball, s->ball, -by));
}

void series_set_coefficient(struct series *to, const struct series *s, slong power)
{
  series_set(to, s);
  series_truncate(to, power + 1);
  shift(to, to->first - power);
  to->first = 0;
  to->known = SERIES_ALL;
}

void series_tidy(struct series *s, const struct ring *ring)
{
  slong zeros = 0;
  while (zeros < series_terms(s) && series_coefficient_is_zero(s, s->first + zeros))
    zeros++;
  shift(s, -zeros);
  s->first += zeros;
  if (series_terms(s) > ring->length)
    s->known = least(s->known, s->first + ring->length);
  series_truncate(s, s->known);
}

void series_truncate(struct series *s, slong known)
{
  s->known = least(s->known, known);
  s->first = least(s->first, s->known);
  slong keep = s->known - s->first;
  if (series_terms(s) <= keep)
    return;
  BY_KIND(s->kind, fmpq_poly_truncate(s->rational, keep), pi_poly_truncate(&s->in_pi, keep),
          arb_poly_truncate(s->ball, keep));
}

static enum series_kind later(enum series_kind a, enum series_kind b) { return a > b ? a : b; }

/* The kind in which two series are combined */
static enum series_kind common(const struct series *a, const struct series *b)
{
  enum series_kind kind = later(a->kind, b->kind);
  bool large = kind == SERIES_IN_PI && (series_bits(a) > SERIES_PI_BITS || series_bits(b) > SERIES_PI_BITS);
  return large ? SERIES_BALLS : kind;
}

/* s with coefficients of a kind that its own can be: itself, or converted into spare, which the caller has
 * initialised. */
static const struct series *as_kind(struct series *spare, const struct series *s, enum series_kind kind,
                                    slong precision)
{
  if (s->kind == kind)
    return s;
  begin(spare, kind, s->first, s->known);
  if (kind == SERIES_IN_PI)
    pi_poly_set_fmpq_poly(&spare->in_pi, s->rational, 0, 0);
  else if (s->kind == SERIES_IN_PI)
    pi_poly_get_arb_poly(spare->ball, &s->in_pi, precision);
  else
    arb_poly_set_fmpq_poly(spare->ball, s->rational, precision);
  return spare;
}

/* The same, as a copy whose coefficients begin with that of x^first, which is not after its own */
static void set_from(struct series *to, const struct series *s, slong first, enum series_kind kind, slong precision)
{
  series_set(to, as_kind(to, s, kind, precision));
  shift(to, to->first - first);
  to->first = first;
}

/* s, or, where it begins beyond the terms that a ring keeps of a sum with the other one, nothing: balls that do not
 * count would make balls of all. */
static const struct series *within(struct series *nothing, const struct series *s, const struct series *other,
                                   const struct ring *ring)
{
  const slong end = other->first + ring->length;
  if (s->first < end || series_terms(other) == 0 || series_coefficient_is_zero(other, other->first))
    return s;
  series_truncate(nothing, end);
  return nothing;
}

static void add_or_sub(struct series *to, const struct series *all_of_a, const struct series *all_of_b, bool sub,
                       const struct ring *ring)
{
  SCOPED(series, p, q);
  const struct series *a = within(&p, all_of_a, all_of_b, ring), *b = within(&q, all_of_b, all_of_a, ring);
  const slong first = least(a->first, b->first), known = least(a->known, b->known);
  const enum series_kind kind = common(a, b);
  set_from(&p, a, first, kind, ring->precision);
  set_from(&q, b, first, kind, ring->precision);
  BY_KIND(kind, (sub ? fmpq_poly_sub : fmpq_poly_add)(to->rational, p.rational, q.rational),
          (sub ? pi_poly_sub : pi_poly_add)(&to->in_pi, &p.in_pi, &q.in_pi),
          (sub ? arb_poly_sub : arb_poly_add)(to->ball, p.ball, q.ball, ring->precision));
  begin(to, kind, first, known);
  series_tidy(to, ring);
}

void series_add(struct series *sum, const struct series *a, const struct series *b, const struct ring *ring)
{
  add_or_sub(sum, a, b, false, ring);
}

void series_sub(struct series *difference, const struct series *a, const struct series *b, const struct ring *ring)
{
  add_or_sub(difference, a, b, true, ring);
}

void series_mul(struct series *product, const struct series *a, const struct series *b, const struct ring *ring)
{
  const enum series_kind kind = common(a, b);
  const slong first = a->first + b->first, known = least(moved(a->known, b->first), moved(b->known, a->first));
  const slong length = ring->length;
  SCOPED(series, spare_a, spare_b);
  const struct series *p = as_kind(&spare_a, a, kind, ring->precision),
                      *q = as_kind(&spare_b, b, kind, ring->precision);
  bool cut = series_terms(p) > 0 && series_terms(q) > 0 && series_terms(p) + series_terms(q) - 1 > length;
  BY_KIND(kind, fmpq_poly_mullow(product->rational, p->rational, q->rational, length),
          pi_poly_mullow(&product->in_pi, &p->in_pi, &q->in_pi, length),
          arb_poly_mullow(product->ball, p->ball, q->ball, length, ring->precision));
  begin(product, kind, first, cut ? least(known, first + length) : known);
  series_tidy(product, ring);
}

void series_neg(struct series *to, const struct series *a)
{
  series_set(to, a);
  BY_KIND(to->kind, fmpq_poly_neg(to->rational, to->rational), pi_poly_neg(&to->in_pi, &to->in_pi),
          arb_poly_neg(to->ball, to->ball));
}

void series_scale(struct series *to, const struct series *a, const fmpq_t factor, const struct ring *ring)
{
  SCOPED(series, constant);
  series_set_rational(&constant, factor);
  series_mul(to, a, &constant, ring);
}

void series_scale_si(struct series *to, const struct series *a, slong factor, const struct ring *ring)
{
  SCOPED(series, constant);
  series_set_si(&constant, factor);
  series_mul(to, a, &constant, ring);
}

bool series_div(struct series *quotient, const struct series *a, const struct series *b, const struct ring *ring)
{
  SCOPED(series, divisor, spare_a, spare_b);
  series_set(&divisor, b);
  series_tidy(&divisor, ring);
  if (series_terms(&divisor) == 0
      || (divisor.kind == SERIES_BALLS && arb_contains_zero(arb_poly_get_coeff_ptr(divisor.ball, 0))))
    return false;
  const enum series_kind kind = common(a, &divisor);
  const slong first = a->first - divisor.first, length = ring->length;
  const struct series *p = as_kind(&spare_a, a, kind, ring->precision);
  const struct series *q = as_kind(&spare_b, &divisor, kind, ring->precision);
  slong known = least(moved(a->known, -divisor.first), moved(divisor.known, a->first - 2 * divisor.first));
  if (series_terms(&divisor) > 1 || series_terms(a) > length) /* before a may be overwritten */
    known = least(known, first + length);
  BY_KIND(kind, fmpq_poly_div_series(quotient->rational, p->rational, q->rational, length),
          pi_poly_div_series(&quotient->in_pi, &p->in_pi, &q->in_pi, length),
          arb_poly_div_series(quotient->ball, p->ball, q->ball, length, ring->precision));
  begin(quotient, kind, first, known);
  series_tidy(quotient, ring);
  return true;
}

void series_shift(struct series *to, const struct series *a, slong power)
{
  series_set(to, a);
  to->first += power;
  to->known = moved(to->known, power);
}

void series_inflate(struct series *to, const struct series *a, slong power)
{
  series_set(to, a);
  to->first *= power;
  if (to->known < SERIES_ALL)
    to->known *= power;
  if (to->kind == SERIES_IN_PI)
    pi_poly_inflate(&to->in_pi, &to->in_pi, power);
  else if (to->kind == SERIES_FRACTIONS) {
    fmpq_poly_t spread;
    SCOPED(fmpq, c);
    fmpq_poly_init(spread);
    for (slong k = 0; k < fmpq_poly_length(to->rational); k++) {
      fmpq_poly_get_coeff_fmpq(c, to->rational, k);
      fmpq_poly_set_coeff_fmpq(spread, k * power, c);
    }
    fmpq_poly_swap(to->rational, spread);
    fmpq_poly_clear(spread);
  } else {
    arb_poly_t spread;
    arb_poly_init(spread);
    for (slong k = 0; k < arb_poly_length(to->ball); k++)
      arb_poly_set_coeff_arb(spread, k * power, arb_poly_get_coeff_ptr(to->ball, k));
    arb_poly_swap(to->ball, spread);
    arb_poly_clear(spread);
  }
}

void series_compose(struct series *to, const struct series *outer, const struct series *inner, const struct ring *ring)
{
  const enum series_kind kind = common(outer, inner);
  SCOPED(series, f, g);
  set_from(&f, outer, 0, kind, ring->precision);
  set_from(&g, inner, 0, kind, ring->precision);
  slong known = least(least(f.known, g.known), ring->length);
  BY_KIND(kind, fmpq_poly_compose_series(to->rational, f.rational, g.rational, known),
          pi_poly_compose_series(&to->in_pi, &f.in_pi, &g.in_pi, known),
          arb_poly_compose_series(to->ball, f.ball, g.ball, known, ring->precision));
  begin(to, kind, 0, known);
  series_tidy(to, ring);
}

void series_integral(struct series *to, const struct series *a, const struct ring *ring)
{
  set_from(to, a, 0, a->kind, ring->precision);
  BY_KIND(to->kind, fmpq_poly_integral(to->rational, to->rational), pi_poly_integral(&to->in_pi, &to->in_pi),
          arb_poly_integral(to->ball, to->ball, ring->precision));
  to->known = moved(to->known, 1);
  series_tidy(to, ring);
}

void series_derivative(struct series *to, const struct series *a, const struct ring *ring)
{
  set_from(to, a, 0, a->kind, ring->precision);
  BY_KIND(to->kind, fmpq_poly_derivative(to->rational, to->rational), pi_poly_derivative(&to->in_pi, &to->in_pi),
          arb_poly_derivative(to->ball, to->ball, ring->precision));
  to->known = moved(to->known, -1);
  series_tidy(to, ring);
}

void series_coefficient(arb_t value, const struct series *s, slong power, slong precision)
{
  if (series_coefficient_is_zero(s, power))
    arb_zero(value);
  else if (s->kind == SERIES_BALLS)
    arb_poly_get_coeff_arb(value, s->ball, power - s->first);
  else if (s->kind == SERIES_IN_PI)
    pi_poly_get_ball(value, &s->in_pi, power - s->first, precision);
  else {
    SCOPED(fmpq, c);
    fmpq_poly_get_coeff_fmpq(c, s->rational, power - s->first);
    arb_set_fmpq(value, c, precision);
  }
}

bool series_rational_coefficient(fmpq_t value, const struct series *s, slong power)
{
  bool zero = series_coefficient_is_zero(s, power);
  if (zero)
    fmpq_zero(value);
  else if (s->kind == SERIES_FRACTIONS)
    fmpq_poly_get_coeff_fmpq(value, s->rational, power - s->first);
  else if (s->kind == SERIES_IN_PI)
    return pi_poly_get_fraction(value, &s->in_pi, power - s->first);
  return zero || s->kind == SERIES_FRACTIONS;
}

bool series_coefficient_is_zero(const struct series *s, slong power)
{
  slong k = power - s->first;
  if (k < 0 || k >= series_terms(s))
    return true;
  return s->kind == SERIES_FRACTIONS ? fmpz_is_zero(fmpq_poly_numref(s->rational) + k)
         : s->kind == SERIES_IN_PI   ? fmpz_poly_q_is_zero(&s->in_pi.coeffs[k])
                                     : arb_is_zero(arb_poly_get_coeff_ptr(s->ball, k));
}

void series_set_zero(struct series *s, slong power)
{
  slong k = power - s->first;
  if (k >= 0 && k < series_terms(s))
    BY_KIND(s->kind, fmpq_poly_set_coeff_si(s->rational, k, 0), pi_poly_zero_coeff(&s->in_pi, k),
            arb_poly_set_coeff_si(s->ball, k, 0));
}

void series_get_ball_poly(arb_poly_t poly, const struct series *s, slong length, slong precision)
{
  SCOPED(series, spare);
  arb_poly_set_round(poly, as_kind(&spare, s, SERIES_BALLS, precision)->ball, precision);
  arb_poly_shift_left(poly, poly, s->first);
  arb_poly_truncate(poly, length);
}

void series_value(arb_t value, const struct series *s, const arb_t x, slong before, slong precision)
{
  SCOPED(series, cut, spare);
  SCOPED(arb, power);
  series_set(&cut, s);
  series_truncate(&cut, before);
  arb_poly_evaluate(value, as_kind(&spare, &cut, SERIES_BALLS, precision)->ball, x, precision);
  arb_set(power, x);
  if (cut.first < 0)
    arb_inv(power, power, precision);
  arb_pow_ui(power, power, (ulong)(cut.first < 0 ? -cut.first : cut.first), precision);
  arb_mul(value, value, power, precision);
}

slong series_bits(const struct series *s)
{
  const fmpq_poly_struct *p = s->rational;
  return s->kind == SERIES_FRACTIONS
             ? labs(_fmpz_vec_max_bits(p->coeffs, p->length)) + (slong)fmpz_bits(fmpq_poly_denref(p))
         : s->kind == SERIES_IN_PI ? pi_poly_bits(&s->in_pi)
                                   : 0;
}
