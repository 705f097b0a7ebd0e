/* Functions of truncated Laurent series, for x -> 0 from above. */
#include <stdlib.h>

#include "asymptotics/derived/scoped.h"
#include "asymptotics/derived/series.h"

static const char MAY_VANISH[] = "of what may be 0", IS_NEGATIVE[] = "of what is negative", IS_LARGE[] = "is too large",
                  IS_FAR[] = "gives a power of T beyond 4096";

/* Returns true if a tidy series is constant; only tidy series here and below. */
static bool is_constant(const struct series *a)
{
  return a->known >= SERIES_ALL && (series_terms(a) == 0 || (series_terms(a) == 1 && a->first == 0));
}

/* Returns the reason why a series is not proven to be positive for small x, or NULL. */
static const char *not_positive(const struct series *a, slong precision)
{
  const char *wrong = MAY_VANISH;
  SCOPED(arb, leading);
  if (series_terms(a) > 0) {
    series_coefficient(leading, a, a->first, precision);
    wrong = arb_is_positive(leading) ? NULL : arb_is_negative(leading) ? IS_NEGATIVE : MAY_VANISH;
  }
  return wrong;
}

static const char *not_entire(const struct series *a, slong precision)
{
  (void)precision;
  if (series_terms(a) > 0 && a->first < 0)
    return "of a negative power of T is not a series";
  return a->known > 0 ? NULL : "of what is not known at T = 0";
}

static const char *not_for_log(const struct series *a, slong precision)
{
  return series_terms(a) > 0 && a->first != 0 ? "of a power of T: a series has no logarithm of T"
                                              : not_positive(a, precision);
}

struct function {
  const char *(*refused)(const struct series *a, slong precision); /* of a tidy series */
  void (*exact)(fmpq_poly_t, const fmpq_poly_t, slong terms);
  slong exact_at; /* constant term with which fractions remain fractions */
  void (*balls)(arb_poly_t, const arb_poly_t, slong terms, slong precision);
  bool is_odd; /* f(a) = a + O(a^3) for small a                           */
};

static const struct function EXP = { not_entire, fmpq_poly_exp_series, 0, arb_poly_exp_series, false };
static const struct function LOG = { not_for_log, fmpq_poly_log_series, 1, arb_poly_log_series, false };
static const struct function SIN = { not_entire, fmpq_poly_sin_series, 0, arb_poly_sin_series, true };
static const struct function COS = { not_entire, fmpq_poly_cos_series, 0, arb_poly_cos_series, false };

/* Sets `to` to the polynomial, known below x^known, unless it is not finite. */
static const char *set_finite(struct series *to, const arb_poly_t poly, slong known)
{
  for (slong k = 0; k < arb_poly_length(poly); k++)
    if (!arb_is_finite(arb_poly_get_coeff_ptr(poly, k)))
      return IS_LARGE;
  series_set_ball_poly(to, poly, known);
  return NULL;
}

/* Computes the terms from x^0 on and below x^terms; a has no negative powers. */
static const char *set_terms(struct series *to, const struct series *a, const struct function *f, slong terms,
                             const struct ring *ring)
{
  const slong known = is_constant(a) ? SERIES_ALL : FLINT_MIN(a->known, terms);
  SCOPED(fmpq, constant);
  SCOPED(fmpq_poly, exact);
  SCOPED(arb_poly, balls);
  if (a->kind == SERIES_FRACTIONS && series_rational_coefficient(constant, a, 0)
      && fmpq_equal_si(constant, f->exact_at)) {
    fmpq_poly_shift_left(exact, a->rational, a->first);
    f->exact(exact, exact, terms);
    series_set_rational_poly(to, exact, known);
    return NULL;
  }
  series_get_ball_poly(balls, a, terms, ring->precision);
  f->balls(balls, balls, terms, ring->precision);
  return set_finite(to, balls, known);
}

static const char *apply_to_tidy(struct series *to, struct series *a, const struct function *f, const struct ring *ring)
{
  const char *wrong = f->refused(a, ring->precision);
  const bool nothing = series_terms(a) == 0;
  if (wrong)
    return wrong;
  if (nothing)
    a->first = 0;
  if (f->is_odd && (nothing || 2 * a->first >= ring->length)) {
    series_set(to, a);
    series_truncate(to, nothing ? SERIES_ALL : a->first + ring->length);
  } else
    wrong = set_terms(to, a, f, ring->length + (f->is_odd ? a->first : 0), ring);
  if (!wrong)
    series_tidy(to, ring);
  return wrong;
}

static const char *apply(struct series *to, const struct series *of, const struct function *f, const struct ring *ring)
{
  SCOPED(series, a);
  series_set(&a, of);
  series_tidy(&a, ring);
  return apply_to_tidy(to, &a, f, ring);
}

const char *series_exp(struct series *to, const struct series *a, const struct ring *ring)
{
  return apply(to, a, &EXP, ring);
}
const char *series_log(struct series *to, const struct series *a, const struct ring *ring)
{
  return apply(to, a, &LOG, ring);
}
const char *series_sin(struct series *to, const struct series *a, const struct ring *ring)
{
  return apply(to, a, &SIN, ring);
}
const char *series_cos(struct series *to, const struct series *a, const struct ring *ring)
{
  return apply(to, a, &COS, ring);
}
/* Returns true if |n| <= size. Below, a power of x is divided out of a series; the constant term is then positive. */

static bool is_within(const fmpz_t n, slong size) { return fmpz_cmp_si(n, size) <= 0 && fmpz_cmp_si(n, -size) >= 0; }

static bool is_small(const fmpq_t power)
{
  return is_within(fmpq_numref(power), SERIES_EXACT_POWER) && is_within(fmpq_denref(power), SERIES_EXACT_POWER);
}

/* Solves root^q = value, 0 < q <= SERIES_EXACT_POWER, value > 0. Returns false if the root is irrational. */
static bool get_root(fmpq_t root, const fmpq_t value, const fmpz_t q)
{
  return fmpz_root(fmpq_numref(root), fmpq_numref(value), fmpz_get_si(q))
         && fmpz_root(fmpq_denref(root), fmpq_denref(value), fmpz_get_si(q));
}

/* Computes a^(p/q) = (a0^(1/q))^p exp((p/q) log(a/a0)). Returns false if any of these is not in fractions. */
static bool set_exact_power(struct series *to, const struct series *a, const fmpq_t power, slong known, slong terms)
{
  SCOPED(fmpq, constant, root);
  SCOPED(fmpq_poly, poly);
  if (a->kind != SERIES_FRACTIONS || !is_small(power))
    return false;
  series_rational_coefficient(constant, a, 0);
  if (!get_root(root, constant, fmpq_denref(power)))
    return false;
  fmpq_poly_scalar_div_fmpq(poly, a->rational, constant);
  fmpq_poly_log_series(poly, poly, terms);
  fmpq_poly_scalar_mul_fmpq(poly, poly, power);
  fmpq_poly_exp_series(poly, poly, terms);
  fmpq_pow_si(root, root, fmpz_get_si(fmpq_numref(power)));
  fmpq_poly_scalar_mul_fmpq(poly, poly, root);
  series_set_rational_poly(to, poly, known);
  return true;
}

/* Computes a^power for a > 0 at x = 0. */
static const char *set_real_power(struct series *to, const struct series *a, const fmpq_t power,
                                  const struct ring *ring)
{
  const slong known = is_constant(a) ? SERIES_ALL : FLINT_MIN(a->known, ring->length);
  SCOPED(arb, ball);
  SCOPED(arb_poly, poly);
  if (set_exact_power(to, a, power, known, ring->length))
    return NULL;
  arb_set_fmpq(ball, power, ring->precision);
  series_get_ball_poly(poly, a, ring->length, ring->precision);
  arb_poly_pow_arb_series(poly, poly, ball, ring->length, ring->precision);
  return set_finite(to, poly, known);
}

/* Computes the power of x in (x^first)^power. */
static const char *get_first(slong *to, slong first, const fmpq_t power)
{
  SCOPED(fmpq, product);
  fmpq_mul_si(product, power, first);
  const bool whole = fmpz_is_one(fmpq_denref(product)), near = is_within(fmpq_numref(product), SERIES_FARTHEST);
  *to = whole && near ? fmpz_get_si(fmpq_numref(product)) : 0;
  return !whole ? "gives a power of T that is not whole" : near ? NULL : IS_FAR;
}

/* Computes base^power of a tidy base: (c x^k (1 + u))^y = (c (1 + u))^y x^(k y). */
static const char *set_any_power(struct series *to, struct series *base, const fmpq_t power, const struct ring *ring)
{
  const char *wrong = not_positive(base, ring->precision);
  const bool negate = wrong == IS_NEGATIVE && fmpz_is_one(fmpq_denref(power));
  slong first = 0;
  if (is_constant(base) && series_terms(base) == 0 && fmpq_sgn(power) > 0) {
    series_set_si(to, 0);
    return NULL;
  }
  if (negate)
    series_neg(base, base);
  if (!wrong || negate)
    wrong = get_first(&first, base->first, power);
  series_shift(base, base, -base->first);
  if (!wrong)
    wrong = set_real_power(to, base, power, ring);
  if (wrong)
    return wrong;
  series_shift(to, to, first);
  if (negate && fmpz_is_odd(fmpq_numref(power)))
    series_neg(to, to);
  series_tidy(to, ring);
  return NULL;
}

/* Computes a power by products: a base of any sign, or 0; finite sums stay finite. */
static const char *set_small_power(struct series *to, const struct series *base, slong power, const struct ring *ring)
{
  if (!is_constant(base) && labs(base->first * power) > SERIES_FARTHEST)
    return IS_FAR;
  SCOPED(series, one, product);
  series_set_si(&one, 1);
  series_set_si(&product, 1);
  for (slong i = 0; i < labs(power); i++)
    series_mul(&product, &product, base, ring);
  if (power < 0 && !series_div(&product, &one, &product, ring))
    return "divides by what may be 0";
  series_set(to, &product);
  return NULL;
}

const char *series_power(struct series *to, const struct series *base, const struct series *exponent,
                         const struct ring *ring)
{
  SCOPED(series, a, y);
  SCOPED(fmpq, value);
  series_set(&a, base);
  series_set(&y, exponent);
  series_tidy(&a, ring);
  series_tidy(&y, ring);
  if (!is_constant(&y) || !series_rational_coefficient(value, &y, 0))
    return "has a series for powers that are fractions only";
  const bool small = is_small(value);
  const slong power = small ? fmpz_get_si(fmpq_numref(value)) : 0, root = small ? fmpz_get_si(fmpq_denref(value)) : 1;
  if (series_bits(&a) * labs(power) / root > SERIES_BITS)
    return IS_LARGE;
  return small && root == 1 ? set_small_power(to, &a, power, ring) : set_any_power(to, &a, value, ring);
}

const char *series_sqrt(struct series *to, const struct series *a, const struct ring *ring)
{
  SCOPED(fmpq, value);
  SCOPED(series, half);
  fmpq_set_si(value, 1, 2);
  series_set_rational(&half, value);
  return series_power(to, a, &half, ring);
}
