/* Polynomials by their coefficients: orders are low, and each coefficient is large. */
#include "asymptotics/derived/named_poly.h"

#include <stdlib.h>

void named_poly_init(struct named_poly *p) { *p = (struct named_poly){ .names = NULL }; }

void named_poly_clear(struct named_poly *p)
{
  for (slong k = 0; k < p->allocated; k++)
    ratio_clear(&p->coeffs[k]);
  flint_free(p->coeffs);
}

static void swap(struct named_poly *a, struct named_poly *b)
{
  struct named_poly kept = *a;
  *a = *b;
  *b = kept;
}

static void allocate(struct named_poly *p, slong length)
{
  if (length <= p->allocated)
    return;
  p->coeffs = flint_realloc(p->coeffs, (size_t)length * sizeof *p->coeffs);
  for (; p->allocated < length; p->allocated++)
    ratio_init(&p->coeffs[p->allocated], p->names);
}

/* Initializes a result; the caller clears it. */
static void begin(struct named_poly *p, struct names *names, slong length)
{
  *p = (struct named_poly){ .names = names };
  allocate(p, length);
}

/* Sets length by the last coefficient that is not 0. */
static void set_length(struct named_poly *p, slong length)
{
  for (slong k = length; k < p->length; k++)
    ratio_zero(&p->coeffs[k]);
  while (length > 0 && ratio_is_zero(&p->coeffs[length - 1]))
    length--;
  p->length = length;
}

void named_poly_truncate(struct named_poly *p, slong length)
{
  if (length < p->length)
    set_length(p, length);
}

void named_poly_zero_coeff(struct named_poly *p, slong k)
{
  ratio_zero(&p->coeffs[k]);
  set_length(p, p->length);
}

/* Copies the coefficients from x^from on, times x^by, to every `spread`-th place. */
static void place(struct named_poly *to, const struct named_poly *a, slong from, slong by, slong spread)
{
  slong length = a->length > from ? (a->length - from - 1) * spread + 1 + by : 0;
  ENDED_BY(named_poly_clear) struct named_poly made;
  begin(&made, a->names, length);
  for (slong k = from; k < a->length; k++)
    ratio_set(&made.coeffs[(k - from) * spread + by], &a->coeffs[k]);
  made.length = length;
  swap(to, &made);
}

void named_poly_set(struct named_poly *to, const struct named_poly *a)
{
  if (to != a)
    place(to, a, 0, 0, 1);
}

void named_poly_shift(struct named_poly *to, const struct named_poly *a, slong by)
{
  place(to, a, by < 0 ? -by : 0, by > 0 ? by : 0, 1);
}

void named_poly_inflate(struct named_poly *to, const struct named_poly *a, slong power) { place(to, a, 0, 0, power); }

void named_poly_set_fmpq_poly(struct named_poly *to, const fmpq_poly_t poly, struct names *names)
{
  ENDED_BY(named_poly_clear) struct named_poly made;
  SCOPED(fmpq, c);
  begin(&made, names, fmpq_poly_length(poly));
  for (slong k = 0; k < made.allocated; k++) {
    fmpq_poly_get_coeff_fmpq(c, poly, k);
    ratio_set_fmpq(&made.coeffs[k], c);
  }
  made.length = made.allocated;
  swap(to, &made);
}

void named_poly_set_constant(struct named_poly *to, const struct ratio *value)
{
  ENDED_BY(named_poly_clear) struct named_poly made;
  begin(&made, value->names, 1);
  ratio_set(&made.coeffs[0], value);
  set_length(&made, 1);
  swap(to, &made);
}

void named_poly_mul_powers(struct named_poly *p, const struct ratio *value, slong power, slong step)
{
  ENDED_BY(ratio_clear) struct ratio factor;
  ratio_init(&factor, p->names);
  fmpz_mpoly_one(factor.over, p->names->ring);
  for (slong k = 0, reached = 0; k < p->length; k++) {
    for (; reached < power + k * step; reached++)
      ratio_mul(&factor, &factor, value);
    ratio_mul(&p->coeffs[k], &p->coeffs[k], &factor);
  }
}

void named_poly_get_arb_poly(arb_poly_t to, const struct named_poly *a, slong precision)
{
  arb_poly_zero(to);
  arb_poly_fit_length(to, a->length);
  for (slong k = 0; k < a->length; k++)
    ratio_get_ball(to->coeffs + k, &a->coeffs[k], precision);
  _arb_poly_set_length(to, a->length);
}

slong named_poly_bits(const struct named_poly *a)
{
  slong bits = 0;
  for (slong k = 0; k < a->length; k++) {
    const fmpz_mpoly_struct *parts[] = { a->coeffs[k].over, a->coeffs[k].under };
    for (int i = 0; i < 2; i++)
      bits += fmpz_mpoly_length(parts[i], a->names->ring) * labs(fmpz_mpoly_max_bits(parts[i]));
  }
  return bits;
}

void named_poly_neg(struct named_poly *to, const struct named_poly *a)
{
  named_poly_set(to, a);
  for (slong k = 0; k < to->length; k++)
    ratio_neg(&to->coeffs[k], &to->coeffs[k]);
}

static void add_or_sub(struct named_poly *to, const struct named_poly *a, const struct named_poly *b,
                       void (*combine)(struct ratio *, const struct ratio *, const struct ratio *))
{
  slong length = a->length > b->length ? a->length : b->length;
  ENDED_BY(named_poly_clear) struct named_poly sum;
  begin(&sum, a->names ? a->names : b->names, length);
  for (slong k = 0; k < a->length; k++)
    ratio_set(&sum.coeffs[k], &a->coeffs[k]);
  for (slong k = 0; k < b->length; k++)
    combine(&sum.coeffs[k], &sum.coeffs[k], &b->coeffs[k]);
  set_length(&sum, length);
  swap(to, &sum);
}

void named_poly_add(struct named_poly *to, const struct named_poly *a, const struct named_poly *b)
{
  add_or_sub(to, a, b, ratio_add);
}

void named_poly_sub(struct named_poly *to, const struct named_poly *a, const struct named_poly *b)
{
  add_or_sub(to, a, b, ratio_sub);
}

/* Adds a[i] b[k - i], i from first on. */
static void convolve(struct ratio *sum, const struct named_poly *a, const struct named_poly *b, slong k, slong first)
{
  ENDED_BY(ratio_clear) struct ratio term;
  ratio_init(&term, sum->names);
  for (slong i = k < b->length ? first : k - b->length + 1; i < a->length && i <= k; i++)
    if (i >= first && !ratio_is_zero(&a->coeffs[i]) && !ratio_is_zero(&b->coeffs[k - i])) {
      ratio_mul(&term, &a->coeffs[i], &b->coeffs[k - i]);
      ratio_add(sum, sum, &term);
    }
}

void named_poly_mullow(struct named_poly *to, const struct named_poly *a, const struct named_poly *b, slong length)
{
  length = a->length && b->length ? FLINT_MIN(length, a->length + b->length - 1) : 0;
  ENDED_BY(named_poly_clear) struct named_poly product;
  begin(&product, a->names, length);
  for (slong k = 0; k < length; k++)
    convolve(&product.coeffs[k], a, b, k, 0);
  set_length(&product, length);
  swap(to, &product);
}

void named_poly_div_series(struct named_poly *to, const struct named_poly *a, const struct named_poly *b, slong length)
{
  ENDED_BY(named_poly_clear) struct named_poly quotient;
  if (b->length == 1 && a->length < length)
    length = a->length;
  begin(&quotient, b->names, length);
  quotient.length = length;
  for (slong k = 0; k < length; k++) {
    struct ratio *c = &quotient.coeffs[k];
    convolve(c, b, &quotient, k, 1);
    ratio_neg(c, c);
    if (k < a->length)
      ratio_add(c, c, &a->coeffs[k]);
    if (!ratio_is_zero(c))
      ratio_div(c, c, &b->coeffs[0]);
  }
  set_length(&quotient, length);
  swap(to, &quotient);
}

void named_poly_compose_series(struct named_poly *to, const struct named_poly *outer, const struct named_poly *inner,
                               slong length)
{
  ENDED_BY(named_poly_clear) struct named_poly value;
  begin(&value, outer->names, 1);
  for (slong k = FLINT_MIN(outer->length, length) - 1; k >= 0; k--) { /* Horner's rule */
    named_poly_mullow(&value, &value, inner, length - k);
    allocate(&value, 1);
    ratio_add(&value.coeffs[0], &value.coeffs[0], &outer->coeffs[k]);
    set_length(&value, value.length > 0 ? value.length : 1);
  }
  swap(to, &value);
}

static void mul_si(struct ratio *r, slong over, ulong under)
{
  SCOPED(fmpq, factor);
  fmpq_set_si(factor, over, under);
  ratio_mul_fmpq(r, r, factor);
}

void named_poly_integral(struct named_poly *to, const struct named_poly *a)
{
  named_poly_shift(to, a, 1);
  for (slong k = 2; k < to->length; k++)
    mul_si(&to->coeffs[k], 1, (ulong)k);
}

void named_poly_derivative(struct named_poly *to, const struct named_poly *a)
{
  named_poly_shift(to, a, -1);
  for (slong k = 1; k < to->length; k++)
    mul_si(&to->coeffs[k], k + 1, 1);
}
