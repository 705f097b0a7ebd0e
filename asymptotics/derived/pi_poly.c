#include "asymptotics/derived/pi_poly.h"

#include <stdlib.h>

#include "asymptotics/derived/scoped.h"

static slong least(slong a, slong b) { return a < b ? a : b; }

void pi_poly_init(struct pi_poly *p) { *p = (struct pi_poly){ .length = 0 }; }

void pi_poly_clear(struct pi_poly *p)
{
  for (slong k = 0; k < p->room; k++)
    fmpz_poly_q_clear(&p->coeffs[k]);
  flint_free(p->coeffs);
}

static void swap(struct pi_poly *a, struct pi_poly *b)
{
  struct pi_poly kept = *a;
  *a = *b;
  *b = kept;
}

static void make_room(struct pi_poly *p, slong length)
{
  if (length <= p->room)
    return;
  p->coeffs = flint_realloc(p->coeffs, (size_t)length * sizeof *p->coeffs);
  for (; p->room < length; p->room++)
    fmpz_poly_q_init(&p->coeffs[p->room]);
}

/* length becomes that up to the last coefficient that is not 0. */
static void set_length(struct pi_poly *p, slong length)
{
  for (slong k = length; k < p->length; k++)
    fmpz_poly_q_zero(&p->coeffs[k]);
  while (length > 0 && fmpz_poly_q_is_zero(&p->coeffs[length - 1]))
    length--;
  p->length = length;
}

void pi_poly_truncate(struct pi_poly *p, slong length)
{
  if (length < p->length)
    set_length(p, length);
}

void pi_poly_zero_coeff(struct pi_poly *p, slong k)
{
  fmpz_poly_q_zero(&p->coeffs[k]);
  set_length(p, p->length);
}

/* The coefficients from x^from on, times x^by, one in `spread` places */
static void place(struct pi_poly *to, const struct pi_poly *a, slong from, slong by, slong spread)
{
  slong length = a->length > from ? (a->length - from - 1) * spread + 1 + by : 0;
  ENDED_BY(pi_poly_clear) struct pi_poly made;
  pi_poly_init(&made);
  make_room(&made, length);
  for (slong k = from; k < a->length; k++)
    fmpz_poly_q_set(&made.coeffs[(k - from) * spread + by], &a->coeffs[k]);
  made.length = length;
  swap(to, &made);
}

void pi_poly_set(struct pi_poly *to, const struct pi_poly *a)
{
  if (to != a)
    place(to, a, 0, 0, 1);
}
void pi_poly_shift(struct pi_poly *to, const struct pi_poly *a, slong by)
{
  place(to, a, by < 0 ? -by : 0, by > 0 ? by : 0, 1);
}
void pi_poly_inflate(struct pi_poly *to, const struct pi_poly *a, slong power) { place(to, a, 0, 0, power); }

void pi_poly_set_fmpq_poly(struct pi_poly *to, const fmpq_poly_t poly, slong power, slong step)
{
  slong length = fmpq_poly_length(poly);
  make_room(to, length);
  for (slong k = 0; k < length; k++) {
    fmpz_poly_q_struct *c = &to->coeffs[k];
    fmpz_poly_q_zero(c);
    fmpz_poly_set_coeff_fmpz(fmpz_poly_q_numref(c), power + k * step, fmpq_poly_numref(poly) + k);
    fmpz_poly_set_fmpz(fmpz_poly_q_denref(c), fmpq_poly_denref(poly));
    fmpz_poly_q_canonicalise(c);
  }
  set_length(to, length);
}

/* Neither over nor under vanishes at pi, so that more bits tell them from 0. */
void pi_poly_get_ball(arb_t value, const struct pi_poly *a, slong k, slong precision)
{
  enum { SPARE = 16 };
  const fmpz_poly_q_struct *c = &a->coeffs[k];
  SCOPED(arb, pi, under);
  arb_zero(value);
  for (slong bits = precision + SPARE; !fmpz_poly_q_is_zero(c); bits *= 2) {
    arb_const_pi(pi, bits);
    arb_fmpz_poly_evaluate_arb(value, fmpz_poly_q_numref(c), pi, bits);
    arb_fmpz_poly_evaluate_arb(under, fmpz_poly_q_denref(c), pi, bits);
    arb_div(value, value, under, bits);
    if (arb_rel_accuracy_bits(value) > precision)
      break;
  }
  arb_set_round(value, value, precision);
}

void pi_poly_get_arb_poly(arb_poly_t to, const struct pi_poly *a, slong precision)
{
  arb_poly_zero(to);
  arb_poly_fit_length(to, a->length);
  for (slong k = 0; k < a->length; k++)
    pi_poly_get_ball(to->coeffs + k, a, k, precision);
  _arb_poly_set_length(to, a->length);
}

bool pi_poly_get_fraction(fmpq_t value, const struct pi_poly *a, slong k)
{
  const fmpz_poly_struct *over = fmpz_poly_q_numref(&a->coeffs[k]), *under = fmpz_poly_q_denref(&a->coeffs[k]);
  bool constant = fmpz_poly_degree(over) <= 0 && fmpz_poly_degree(under) == 0;
  if (constant) {
    fmpz_poly_get_coeff_fmpz(fmpq_numref(value), over, 0);
    fmpz_poly_get_coeff_fmpz(fmpq_denref(value), under, 0);
    fmpq_canonicalise(value);
  }
  return constant;
}

slong pi_poly_bits(const struct pi_poly *a)
{
  slong bits = 0;
  for (slong k = 0; k < a->length; k++) {
    const fmpz_poly_struct *parts[] = { fmpz_poly_q_numref(&a->coeffs[k]), fmpz_poly_q_denref(&a->coeffs[k]) };
    for (int i = 0; i < 2; i++)
      bits += fmpz_poly_length(parts[i]) * labs(fmpz_poly_max_bits(parts[i]));
  }
  return bits;
}

void pi_poly_neg(struct pi_poly *to, const struct pi_poly *a)
{
  pi_poly_set(to, a);
  for (slong k = 0; k < to->length; k++)
    fmpz_poly_q_neg(&to->coeffs[k], &to->coeffs[k]);
}

static void add_or_sub(struct pi_poly *to, const struct pi_poly *a, const struct pi_poly *b,
                       void (*combine)(fmpz_poly_q_t, const fmpz_poly_q_t))
{
  slong length = a->length > b->length ? a->length : b->length;
  ENDED_BY(pi_poly_clear) struct pi_poly sum;
  pi_poly_init(&sum);
  pi_poly_set(&sum, a);
  make_room(&sum, length);
  for (slong k = 0; k < b->length; k++)
    combine(&sum.coeffs[k], &b->coeffs[k]);
  set_length(&sum, length);
  swap(to, &sum);
}

void pi_poly_add(struct pi_poly *to, const struct pi_poly *a, const struct pi_poly *b)
{
  add_or_sub(to, a, b, fmpz_poly_q_add_in_place);
}
void pi_poly_sub(struct pi_poly *to, const struct pi_poly *a, const struct pi_poly *b)
{
  add_or_sub(to, a, b, fmpz_poly_q_sub_in_place);
}

/* sum of a[i] b[k - i], i from first on */
static void convolve(fmpz_poly_q_t sum, const struct pi_poly *a, const struct pi_poly *b, slong k, slong first)
{
  fmpz_poly_q_t term;
  fmpz_poly_q_init(term);
  fmpz_poly_q_zero(sum);
  for (slong i = k < b->length ? first : k - b->length + 1; i < a->length && i <= k; i++)
    if (i >= first && !fmpz_poly_q_is_zero(&a->coeffs[i]) && !fmpz_poly_q_is_zero(&b->coeffs[k - i])) {
      fmpz_poly_q_mul(term, &a->coeffs[i], &b->coeffs[k - i]);
      fmpz_poly_q_add_in_place(sum, term);
    }
  fmpz_poly_q_clear(term);
}

void pi_poly_mullow(struct pi_poly *to, const struct pi_poly *a, const struct pi_poly *b, slong length)
{
  length = a->length && b->length ? least(length, a->length + b->length - 1) : 0;
  ENDED_BY(pi_poly_clear) struct pi_poly product;
  pi_poly_init(&product);
  make_room(&product, length);
  for (slong k = 0; k < length; k++)
    convolve(&product.coeffs[k], a, b, k, 0);
  set_length(&product, length);
  swap(to, &product);
}

void pi_poly_div_series(struct pi_poly *to, const struct pi_poly *a, const struct pi_poly *b, slong length)
{
  ENDED_BY(pi_poly_clear) struct pi_poly quotient;
  pi_poly_init(&quotient);
  if (b->length == 1 && a->length < length)
    length = a->length;
  make_room(&quotient, length);
  quotient.length = length;
  for (slong k = 0; k < length; k++) {
    fmpz_poly_q_struct *c = &quotient.coeffs[k];
    convolve(c, b, &quotient, k, 1);
    fmpz_poly_q_neg(c, c);
    if (k < a->length)
      fmpz_poly_q_add_in_place(c, &a->coeffs[k]);
    fmpz_poly_q_div(c, c, &b->coeffs[0]);
  }
  set_length(&quotient, length);
  swap(to, &quotient);
}

void pi_poly_compose_series(struct pi_poly *to, const struct pi_poly *outer, const struct pi_poly *inner, slong length)
{
  ENDED_BY(pi_poly_clear) struct pi_poly sum;
  pi_poly_init(&sum);
  ENDED_BY(pi_poly_clear) struct pi_poly term;
  pi_poly_init(&term);
  for (slong k = least(outer->length, length) - 1; k >= 0; k--) { /* Horner */
    pi_poly_mullow(&sum, &sum, inner, length - k);
    make_room(&term, 1);
    fmpz_poly_q_set(&term.coeffs[0], &outer->coeffs[k]);
    set_length(&term, 1);
    pi_poly_add(&sum, &sum, &term);
  }
  swap(to, &sum);
}

void pi_poly_integral(struct pi_poly *to, const struct pi_poly *a)
{
  pi_poly_shift(to, a, 1);
  for (slong k = 2; k < to->length; k++)
    fmpz_poly_q_scalar_div_si(&to->coeffs[k], &to->coeffs[k], k);
}

void pi_poly_derivative(struct pi_poly *to, const struct pi_poly *a)
{
  pi_poly_shift(to, a, -1);
  for (slong k = 1; k < to->length; k++)
    fmpz_poly_q_scalar_mul_si(&to->coeffs[k], &to->coeffs[k], k + 1);
}
