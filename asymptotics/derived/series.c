/* Arithmetic of truncated Laurent series; each result knows the power from which on it is unknown */
#include <stdlib.h>

#include "asymptotics/derived/scoped.h"

#include <flint/fmpz_vec.h>

/* Selects the call for this kind of coefficients. */
#define BY_KIND(kind, fractions, named, balls) \
  ((kind) == SERIES_FRACTIONS ? (fractions) : (kind) == SERIES_NAMED ? (named) : (balls))

/* Returns known after multiplication by x^power; a series known to all orders remains so. */
static slong moved(slong known, slong power) { return known >= SERIES_ALL ? SERIES_ALL : known + power; }

void series_init(struct series *s)
{
  s->kind = SERIES_FRACTIONS;
  s->first = 0;
  s->known = SERIES_ALL;
  fmpq_poly_init(s->rational);
  named_poly_init(&s->named);
  arb_poly_init(s->ball);
}

void series_clear(struct series *s)
{
  fmpq_poly_clear(s->rational);
  named_poly_clear(&s->named);
  arb_poly_clear(s->ball);
}

void series_set(struct series *to, const struct series *from)
{
  if (to == from)
    return;
  to->kind = from->kind;
  to->first = from->first;
  to->known = from->known;
  BY_KIND(to->kind, fmpq_poly_set(to->rational, from->rational), named_poly_set(&to->named, &from->named),
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

void series_set_ratio(struct series *s, const struct ratio *value)
{
  begin(s, SERIES_NAMED, 0, SERIES_ALL);
  named_poly_set_constant(&s->named, value);
}

static void begin_pi(struct ratio *pi, struct names *names)
{
  ratio_init(pi, names);
  fmpz_mpoly_gen(pi->over, names->pi, names->ring);
}

void series_set_pi_poly(struct series *s, const fmpq_poly_t poly, slong power, slong step, slong known)
{
  ENDED_BY(ratio_clear) struct ratio pi;
  begin_pi(&pi, names_of_pi());
  begin(s, SERIES_NAMED, 0, known);
  named_poly_set_fmpq_poly(&s->named, poly, pi.names);
  named_poly_mul_powers(&s->named, &pi, power, step);
}

void series_set_pi(struct series *s, struct names *names)
{
  ENDED_BY(ratio_clear) struct ratio pi;
  begin_pi(&pi, names ? names : names_of_pi());
  series_set_ratio(s, &pi);
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
         : s->kind == SERIES_NAMED   ? s->named.length
                                     : arb_poly_length(s->ball);
}

static void shift(struct series *s, slong by)
{
  if (by > 0)
    BY_KIND(s->kind, fmpq_poly_shift_left(s->rational, s->rational, by), named_poly_shift(&s->named, &s->named, by),
            arb_poly_shift_left(s->ball, s->ball, by));
  else if (by < 0)
    BY_KIND(s->kind, fmpq_poly_shift_right(s->rational, s->rational, -by), named_poly_shift(&s->named, &s->named, by),
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
    s->known = FLINT_MIN(s->known, s->first + ring->length);
  series_truncate(s, s->known);
}

void series_truncate(struct series *s, slong known)
{
  s->known = FLINT_MIN(s->known, known);
  s->first = FLINT_MIN(s->first, s->known);
  slong keep = s->known - s->first;
  if (series_terms(s) <= keep)
    return;
  BY_KIND(s->kind, fmpq_poly_truncate(s->rational, keep), named_poly_truncate(&s->named, keep),
          arb_poly_truncate(s->ball, keep));
}

static enum series_kind later(enum series_kind a, enum series_kind b) { return a > b ? a : b; }

/* The target of a conversion of coefficients */
struct form {
  enum series_kind kind;
  struct names *names; /* if they have names                                                  */
  slong precision;     /* if they are balls                                                   */
};

/* Returns the form in which two series are combined. */
static struct form common(const struct series *a, const struct series *b, const struct ring *ring)
{
  enum series_kind kind = later(a->kind, b->kind);
  struct names *names = a->kind == SERIES_NAMED ? a->named.names : b->named.names;
  bool large = kind == SERIES_NAMED && names->only_pi
               && (series_bits(a) > SERIES_PI_BITS || series_bits(b) > SERIES_PI_BITS);
  return (struct form){ large ? SERIES_BALLS : kind, names, ring->precision };
}

/* Returns s with coefficients of a more general form: itself, or converted into spare, initialised by the caller. */
static const struct series *in_form(struct series *spare, const struct series *s, struct form form)
{
  if (s->kind == form.kind)
    return s;
  begin(spare, form.kind, s->first, s->known);
  if (form.kind == SERIES_NAMED)
    named_poly_set_fmpq_poly(&spare->named, s->rational, form.names);
  else if (s->kind == SERIES_NAMED)
    named_poly_get_arb_poly(spare->ball, &s->named, form.precision);
  else
    arb_poly_set_fmpq_poly(spare->ball, s->rational, form.precision);
  return spare;
}

/* Sets a copy in this form with coefficients from x^first on; x^first is not after the first of s. */
static void set_from(struct series *to, const struct series *s, slong first, struct form form)
{
  series_set(to, in_form(to, s, form));
  shift(to, to->first - first);
  to->first = first;
}

/* Returns s, or `nothing` if s begins beyond the terms that a ring keeps of a sum with the other: balls without effect
 * would turn all coefficients into balls. */
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
  const slong first = FLINT_MIN(a->first, b->first), known = FLINT_MIN(a->known, b->known);
  const struct form form = common(a, b, ring);
  set_from(&p, a, first, form);
  set_from(&q, b, first, form);
  BY_KIND(form.kind, (sub ? fmpq_poly_sub : fmpq_poly_add)(to->rational, p.rational, q.rational),
          (sub ? named_poly_sub : named_poly_add)(&to->named, &p.named, &q.named),
          (sub ? arb_poly_sub : arb_poly_add)(to->ball, p.ball, q.ball, ring->precision));
  begin(to, form.kind, first, known);
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

/* Returns the count of terms of a product or quotient up to its last known power. */
static slong terms_that_count(slong first, slong known, const struct ring *ring)
{
  return known > first ? FLINT_MIN(ring->length, known - first) : 1;
}

void series_mul(struct series *product, const struct series *a, const struct series *b, const struct ring *ring)
{
  const struct form form = common(a, b, ring);
  const slong first = a->first + b->first, known = FLINT_MIN(moved(a->known, b->first), moved(b->known, a->first));
  const slong length = terms_that_count(first, known, ring);
  SCOPED(series, spare_a, spare_b);
  const struct series *p = in_form(&spare_a, a, form), *q = in_form(&spare_b, b, form);
  bool cut = series_terms(p) > 0 && series_terms(q) > 0 && series_terms(p) + series_terms(q) - 1 > length;
  BY_KIND(form.kind, fmpq_poly_mullow(product->rational, p->rational, q->rational, length),
          named_poly_mullow(&product->named, &p->named, &q->named, length),
          arb_poly_mullow(product->ball, p->ball, q->ball, length, ring->precision));
  begin(product, form.kind, first, cut ? FLINT_MIN(known, first + length) : known);
  series_tidy(product, ring);
}

void series_neg(struct series *to, const struct series *a)
{
  series_set(to, a);
  BY_KIND(to->kind, fmpq_poly_neg(to->rational, to->rational), named_poly_neg(&to->named, &to->named),
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
  const struct form form = common(a, &divisor, ring);
  const slong first = a->first - divisor.first;
  const struct series *p = in_form(&spare_a, a, form);
  const struct series *q = in_form(&spare_b, &divisor, form);
  slong known = FLINT_MIN(moved(a->known, -divisor.first), moved(divisor.known, a->first - 2 * divisor.first));
  const slong length = terms_that_count(first, known, ring);
  if (series_terms(&divisor) > 1 || series_terms(a) > length) /* before a is overwritten */
    known = FLINT_MIN(known, first + length);
  BY_KIND(form.kind, fmpq_poly_div_series(quotient->rational, p->rational, q->rational, length),
          named_poly_div_series(&quotient->named, &p->named, &q->named, length),
          arb_poly_div_series(quotient->ball, p->ball, q->ball, length, ring->precision));
  begin(quotient, form.kind, first, known);
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
  SCOPED(fmpq_poly, spread);
  SCOPED(arb_poly, spread_balls);
  fmpq_poly_set_coeff_si(spread, power, 1);
  arb_poly_set_coeff_si(spread_balls, power, 1);
  series_set(to, a);
  to->first *= power;
  if (to->known < SERIES_ALL)
    to->known *= power;
  BY_KIND(to->kind, fmpq_poly_compose(to->rational, to->rational, spread),
          named_poly_inflate(&to->named, &to->named, power),
          arb_poly_compose(to->ball, to->ball, spread_balls, ARF_PREC_EXACT));
}

void series_compose(struct series *to, const struct series *outer, const struct series *inner, const struct ring *ring)
{
  const struct form form = common(outer, inner, ring);
  SCOPED(series, f, g);
  set_from(&f, outer, 0, form);
  set_from(&g, inner, 0, form);
  slong bends = 1; /* outer is c + d x^bends + ...: unknown terms of inner enter times inner^(bends - 1) */
  while (bends < series_terms(&f) && series_coefficient_is_zero(&f, bends))
    bends++;
  slong known = FLINT_MIN(FLINT_MIN(f.known, moved(g.known, (bends - 1) * inner->first)), ring->length);
  BY_KIND(form.kind, fmpq_poly_compose_series(to->rational, f.rational, g.rational, known),
          named_poly_compose_series(&to->named, &f.named, &g.named, known),
          arb_poly_compose_series(to->ball, f.ball, g.ball, known, ring->precision));
  begin(to, form.kind, 0, known);
  series_tidy(to, ring);
}

void series_integral(struct series *to, const struct series *a, const struct ring *ring)
{
  set_from(to, a, 0, (struct form){ .kind = a->kind });
  BY_KIND(to->kind, fmpq_poly_integral(to->rational, to->rational), named_poly_integral(&to->named, &to->named),
          arb_poly_integral(to->ball, to->ball, ring->precision));
  to->known = moved(to->known, 1);
  series_tidy(to, ring);
}

void series_derivative(struct series *to, const struct series *a, const struct ring *ring)
{
  set_from(to, a, 0, (struct form){ .kind = a->kind });
  BY_KIND(to->kind, fmpq_poly_derivative(to->rational, to->rational), named_poly_derivative(&to->named, &to->named),
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
  else if (s->kind == SERIES_NAMED)
    ratio_get_ball(value, &s->named.coeffs[power - s->first], precision);
  else {
    SCOPED(fmpq, c);
    fmpq_poly_get_coeff_fmpq(c, s->rational, power - s->first);
    arb_set_fmpq(value, c, precision);
  }
}

void series_get_ratio(struct ratio *value, const struct series *s, slong power)
{
  SCOPED(fmpq, fraction);
  if (s->kind == SERIES_NAMED && !series_coefficient_is_zero(s, power))
    ratio_set(value, &s->named.coeffs[power - s->first]);
  else {
    series_rational_coefficient(fraction, s, power);
    ratio_set_fmpq(value, fraction);
  }
}

bool series_rational_coefficient(fmpq_t value, const struct series *s, slong power)
{
  bool zero = series_coefficient_is_zero(s, power);
  if (zero)
    fmpq_zero(value);
  else if (s->kind == SERIES_FRACTIONS)
    fmpq_poly_get_coeff_fmpq(value, s->rational, power - s->first);
  else if (s->kind == SERIES_NAMED)
    return ratio_get_fmpq(value, &s->named.coeffs[power - s->first]);
  return zero || s->kind == SERIES_FRACTIONS;
}

bool series_coefficient_is_zero(const struct series *s, slong power)
{
  slong k = power - s->first;
  if (k < 0 || k >= series_terms(s))
    return true;
  return s->kind == SERIES_FRACTIONS ? fmpz_is_zero(fmpq_poly_numref(s->rational) + k)
         : s->kind == SERIES_NAMED   ? ratio_is_zero(&s->named.coeffs[k])
                                     : arb_is_zero(arb_poly_get_coeff_ptr(s->ball, k));
}

void series_set_zero(struct series *s, slong power)
{
  slong k = power - s->first;
  if (k >= 0 && k < series_terms(s))
    BY_KIND(s->kind, fmpq_poly_set_coeff_si(s->rational, k, 0), named_poly_zero_coeff(&s->named, k),
            arb_poly_set_coeff_si(s->ball, k, 0));
}

void series_get_ball_poly(arb_poly_t poly, const struct series *s, slong length, slong precision)
{
  SCOPED(series, spare);
  arb_poly_set_round(poly, in_form(&spare, s, (struct form){ SERIES_BALLS, NULL, precision })->ball, precision);
  arb_poly_shift_left(poly, poly, s->first);
  arb_poly_truncate(poly, length);
}

void series_value(arb_t value, const struct series *s, const arb_t x, slong before, slong precision)
{
  SCOPED(series, cut, spare);
  SCOPED(arb, power);
  series_set(&cut, s);
  series_truncate(&cut, before);
  arb_poly_evaluate(value, in_form(&spare, &cut, (struct form){ SERIES_BALLS, NULL, precision })->ball, x, precision);
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
         : s->kind == SERIES_NAMED ? named_poly_bits(&s->named)
                                   : 0;
}
