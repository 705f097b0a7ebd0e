/* Arithmetic of truncated Laurent series; each result knows the power from which on it is unknown. */
#include <stdlib.h>

#include "asymptotics/derived/series.h"

static slong least(slong a, slong b) { return a < b ? a : b; }

/* known, when the series is multiplied by x^power: what is known to all orders stays so. */
static slong moved(slong known, slong power) { return known >= SERIES_ALL ? SERIES_ALL : known + power; }

void series_init(struct series *s)
{
  s->exact = true;
  s->first = 0;
  s->known = SERIES_ALL;
  fmpq_poly_init(s->rational);
  arb_poly_init(s->ball);
}

void series_clear(struct series *s)
{
  fmpq_poly_clear(s->rational);
  arb_poly_clear(s->ball);
}

void series_set(struct series *to, const struct series *from)
{
  if (to == from)
    return;
  to->exact = from->exact;
  to->first = from->first;
  to->known = from->known;
  if (from->exact)
    fmpq_poly_set(to->rational, from->rational);
  else
    arb_poly_set(to->ball, from->ball);
}

static void begin(struct series *s, bool exact, slong first, slong known)
{
  s->exact = exact;
  s->first = first;
  s->known = known;
}

void series_set_rational(struct series *s, const fmpq_t value)
{
  begin(s, true, 0, SERIES_ALL);
  fmpq_poly_set_fmpq(s->rational, value);
}

void series_set_si(struct series *s, slong value)
{
  begin(s, true, 0, SERIES_ALL);
  fmpq_poly_set_si(s->rational, value);
}

void series_set_ball(struct series *s, const arb_t value)
{
  begin(s, false, 0, SERIES_ALL);
  arb_poly_set_arb(s->ball, value);
}

void series_set_rational_poly(struct series *s, const fmpq_poly_t poly, slong known)
{
  begin(s, true, 0, known);
  fmpq_poly_set(s->rational, poly);
}

void series_set_ball_poly(struct series *s, const arb_poly_t poly, slong known)
{
  begin(s, false, 0, known);
  arb_poly_set(s->ball, poly);
}

void series_set_x(struct series *s)
{
  series_set_si(s, 1);
  s->first = 1;
}

slong series_terms(const struct series *s) { return s->exact ? fmpq_poly_length(s->rational) : arb_poly_length(s->ball); }

static bool leading_is_zero(const struct series *s)
{
  return s->exact ? fmpz_is_zero(fmpq_poly_numref(s->rational)) : arb_is_zero(arb_poly_get_coeff_ptr(s->ball, 0));
}

void series_tidy(struct series *s, const struct ring *ring)
{
  slong zeros = 0;
  if (series_terms(s) > 0 && leading_is_zero(s)) {
    while (zeros < series_terms(s) && series_coefficient_is_zero(s, s->first + zeros))
      zeros++;
    if (s->exact)
      fmpq_poly_shift_right(s->rational, s->rational, zeros);
    else
      arb_poly_shift_right(s->ball, s->ball, zeros);
    s->first += zeros;
  }
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
  if (s->exact)
    fmpq_poly_truncate(s->rational, keep);
  else
    arb_poly_truncate(s->ball, keep);
}

/* The coefficients of s as balls: its own, or converted into spare, which the caller has initialised. */
static const arb_poly_struct *as_balls(arb_poly_t spare, const struct series *s, slong precision)
{
  if (!s->exact)
    return s->ball;
  arb_poly_set_fmpq_poly(spare, s->rational, precision);
  return spare;
}

static void add_or_sub(struct series *to, const struct series *a, const struct series *b, bool sub, const struct ring *ring)
{
  slong first = least(a->first, b->first);
  bool exact = a->exact && b->exact;
  slong known = least(a->known, b->known);
  if (exact) {
    fmpq_poly_t p, q;
    fmpq_poly_init(p);
    fmpq_poly_init(q);
    fmpq_poly_shift_left(p, a->rational, a->first - first);
    fmpq_poly_shift_left(q, b->rational, b->first - first);
    (sub ? fmpq_poly_sub : fmpq_poly_add)(to->rational, p, q);
    fmpq_poly_clear(p);
    fmpq_poly_clear(q);
  } else {
    arb_poly_t p, q;
    arb_poly_init(p);
    arb_poly_init(q);
    arb_poly_shift_left(p, as_balls(p, a, ring->precision), a->first - first);
    arb_poly_shift_left(q, as_balls(q, b, ring->precision), b->first - first);
    (sub ? arb_poly_sub : arb_poly_add)(to->ball, p, q, ring->precision);
    arb_poly_clear(p);
    arb_poly_clear(q);
  }
  begin(to, exact, first, known);
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
  bool exact = a->exact && b->exact;
  slong first = a->first + b->first, known = least(moved(a->known, b->first), moved(b->known, a->first));
  bool cut = series_terms(a) > 0 && series_terms(b) > 0 && series_terms(a) + series_terms(b) - 1 > ring->length;
  if (exact)
    fmpq_poly_mullow(product->rational, a->rational, b->rational, ring->length);
  else {
    arb_poly_t p, q;
    arb_poly_init(p);
    arb_poly_init(q);
    arb_poly_mullow(product->ball, as_balls(p, a, ring->precision), as_balls(q, b, ring->precision), ring->length,
                    ring->precision);
    arb_poly_clear(p);
    arb_poly_clear(q);
  }
  begin(product, exact, first, cut ? least(known, first + ring->length) : known);
  series_tidy(product, ring);
}

void series_neg(struct series *to, const struct series *a)
{
  series_set(to, a);
  if (to->exact)
    fmpq_poly_neg(to->rational, to->rational);
  else
    arb_poly_neg(to->ball, to->ball);
}

void series_scale(struct series *to, const struct series *a, const fmpq_t factor, const struct ring *ring)
{
  struct series constant;
  series_init(&constant);
  series_set_rational(&constant, factor);
  series_mul(to, a, &constant, ring);
  series_clear(&constant);
}

void series_scale_si(struct series *to, const struct series *a, slong factor, const struct ring *ring)
{
  struct series constant;
  series_init(&constant);
  series_set_si(&constant, factor);
  series_mul(to, a, &constant, ring);
  series_clear(&constant);
}

bool series_div(struct series *quotient, const struct series *a, const struct series *b, const struct ring *ring)
{
  struct series divisor;
  series_init(&divisor);
  series_set(&divisor, b);
  series_tidy(&divisor, ring);
  bool possible = series_terms(&divisor) > 0
                  && (divisor.exact || !arb_contains_zero(arb_poly_get_coeff_ptr(divisor.ball, 0)));
  if (possible) {
    bool exact = a->exact && divisor.exact;
    slong first = a->first - divisor.first;
    slong known = least(moved(a->known, -divisor.first), moved(divisor.known, a->first - 2 * divisor.first));
    if (series_terms(&divisor) > 1 || series_terms(a) > ring->length) /* before a may be overwritten */
      known = least(known, first + ring->length);
    if (exact)
      fmpq_poly_div_series(quotient->rational, a->rational, divisor.rational, ring->length);
    else {
      arb_poly_t p, q;
      arb_poly_init(p);
      arb_poly_init(q);
      arb_poly_div_series(quotient->ball, as_balls(p, a, ring->precision), as_balls(q, &divisor, ring->precision),
                          ring->length, ring->precision);
      arb_poly_clear(p);
      arb_poly_clear(q);
    }
    begin(quotient, exact, first, known);
    series_tidy(quotient, ring);
  }
  series_clear(&divisor);
  return possible;
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
  if (to->exact) {
    fmpq_poly_t spread;
    fmpq_t c;
    fmpq_init(c);
    fmpq_poly_init(spread);
    for (slong k = 0; k < fmpq_poly_length(to->rational); k++) {
      fmpq_poly_get_coeff_fmpq(c, to->rational, k);
      fmpq_poly_set_coeff_fmpq(spread, k * power, c);
    }
    fmpq_poly_swap(to->rational, spread);
    fmpq_poly_clear(spread);
    fmpq_clear(c);
  } else {
    arb_poly_t spread;
    arb_poly_init(spread);
    for (slong k = 0; k < arb_poly_length(to->ball); k++)
      arb_poly_set_coeff_arb(spread, k * power, arb_poly_get_coeff_ptr(to->ball, k));
    arb_poly_swap(to->ball, spread);
    arb_poly_clear(spread);
  }
}

/* The coefficients of s from x^0 on, which needs first >= 0. */
static void from_zero(struct series *to, const struct series *s)
{
  series_set(to, s);
  if (to->exact)
    fmpq_poly_shift_left(to->rational, to->rational, to->first);
  else
    arb_poly_shift_left(to->ball, to->ball, to->first);
  to->first = 0;
}

void series_compose(struct series *to, const struct series *outer, const struct series *inner, const struct ring *ring)
{
  struct series f, g;
  series_init(&f);
  series_init(&g);
  from_zero(&f, outer);
  from_zero(&g, inner);
  bool exact = f.exact && g.exact;
  slong known = least(least(f.known, g.known), ring->length);
  if (exact)
    fmpq_poly_compose_series(to->rational, f.rational, g.rational, known);
  else {
    arb_poly_t p, q;
    arb_poly_init(p);
    arb_poly_init(q);
    arb_poly_compose_series(to->ball, as_balls(p, &f, ring->precision), as_balls(q, &g, ring->precision), known,
                            ring->precision);
    arb_poly_clear(p);
    arb_poly_clear(q);
  }
  begin(to, exact, 0, known);
  series_tidy(to, ring);
  series_clear(&f);
  series_clear(&g);
}

void series_integral(struct series *to, const struct series *a, const struct ring *ring)
{
  from_zero(to, a);
  if (to->exact)
    fmpq_poly_integral(to->rational, to->rational);
  else
    arb_poly_integral(to->ball, to->ball, ring->precision);
  to->known = moved(to->known, 1);
  series_tidy(to, ring);
}

void series_derivative(struct series *to, const struct series *a, const struct ring *ring)
{
  from_zero(to, a);
  if (to->exact)
    fmpq_poly_derivative(to->rational, to->rational);
  else
    arb_poly_derivative(to->ball, to->ball, ring->precision);
  to->known = moved(to->known, -1);
  series_tidy(to, ring);
}

void series_coefficient(arb_t value, const struct series *s, slong power, slong precision)
{
  if (power < s->first)
    arb_zero(value);
  else if (!s->exact)
    arb_poly_get_coeff_arb(value, s->ball, power - s->first);
  else {
    fmpq_t c;
    fmpq_init(c);
    fmpq_poly_get_coeff_fmpq(c, s->rational, power - s->first);
    arb_set_fmpq(value, c, precision);
    fmpq_clear(c);
  }
}

bool series_rational_coefficient(fmpq_t value, const struct series *s, slong power)
{
  bool zero = series_coefficient_is_zero(s, power);
  if (zero)
    fmpq_zero(value);
  else if (s->exact)
    fmpq_poly_get_coeff_fmpq(value, s->rational, power - s->first);
  return zero || s->exact;
}

bool series_coefficient_is_zero(const struct series *s, slong power)
{
  slong k = power - s->first;
  if (k < 0 || k >= series_terms(s))
    return true;
  return s->exact ? fmpz_is_zero(fmpq_poly_numref(s->rational) + k) : arb_is_zero(arb_poly_get_coeff_ptr(s->ball, k));
}

void series_set_zero(struct series *s, slong power)
{
  slong k = power - s->first;
  if (k < 0 || k >= series_terms(s))
    return;
  if (s->exact)
    fmpq_poly_set_coeff_si(s->rational, k, 0);
  else
    arb_poly_set_coeff_si(s->ball, k, 0);
}

void series_get_ball_poly(arb_poly_t poly, const struct series *s, slong length, slong precision)
{
  if (s->exact)
    arb_poly_set_fmpq_poly(poly, s->rational, precision);
  else
    arb_poly_set_round(poly, s->ball, precision);
  arb_poly_shift_left(poly, poly, s->first);
  arb_poly_truncate(poly, length);
}

void series_value(arb_t value, const struct series *s, const arb_t x, slong before, slong precision)
{
  struct series cut;
  arb_poly_t balls;
  arb_t power;
  series_init(&cut);
  arb_poly_init(balls);
  arb_init(power);
  series_set(&cut, s);
  series_truncate(&cut, before);
  arb_poly_evaluate(value, as_balls(balls, &cut, precision), x, precision);
  arb_set(power, x);
  if (cut.first < 0)
    arb_inv(power, power, precision);
  arb_pow_ui(power, power, (ulong)(cut.first < 0 ? -cut.first : cut.first), precision);
  arb_mul(value, value, power, precision);
  arb_poly_clear(balls);
  arb_clear(power);
  series_clear(&cut);
}

slong series_bits(const struct series *s)
{
  const fmpq_poly_struct *p = s->rational;
  return s->exact ? labs(_fmpz_vec_max_bits(p->coeffs, p->length)) + (slong)fmpz_bits(fmpq_poly_denref(p)) : 0;
}
