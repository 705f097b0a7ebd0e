/* Truncated Laurent series in one variable x. Coefficients are fractions, or rational functions of pi, if all inputs
 * are exact, otherwise balls. Rational functions of pi become balls above SERIES_PI_BITS.
 *
 * A series knows the terms from x^first up to, not including, x^known. An exact constant is known to all orders. Needs
 * FLINT. */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_SERIES_H
#define SCALLOP_ASYMPTOTICS_DERIVED_SERIES_H

#include "asymptotics/derived/named_poly.h"

struct ring {      /* size of the numbers in a computation */
  slong length;    /* terms of each series                                                  */
  slong precision; /* bits of each ball                                                     */
};

/* Kinds of coefficients; a sum or product has the later kind of its operands. */
enum series_kind { SERIES_FRACTIONS, SERIES_NAMED, SERIES_BALLS };

struct series {
  enum series_kind kind;
  slong first, known;
  fmpq_poly_t rational;    /* the coefficients from x^first on, if fractions                    */
  struct named_poly named; /* if rational functions of names                                    */
  arb_poly_t ball;         /* otherwise                                                         */
};

enum {
  SERIES_EXACT_POWER = 64, /* the largest numerator, and denominator, of an exact power           */
  SERIES_BITS =
      1
      /* limit of the bits of an exact power, except for rounding up: powers of powers would take all time and memory */
      << 20,
  SERIES_PI_BITS = 1 << 22,
  SERIES_PI_TERMS = 42,  /* longer expansions of sinusoidal gaits are in balls */
  SERIES_FARTHEST = 4096 /* the largest power of x of series_power: limits the memory of products */
};

/* `known` of a series with finitely many terms, all known */
#define SERIES_ALL (WORD_MAX / 8)

void series_init(struct series *s);
void series_clear(struct series *s);
SCOPED_KIND(series, struct series)
void series_set(struct series *to, const struct series *from);
void series_set_rational(struct series *s, const fmpq_t value);
void series_set_si(struct series *s, slong value);
void series_set_ball(struct series *s, const arb_t value);
void series_set_rational_poly(struct series *s, const fmpq_poly_t poly, slong known);
void series_set_ball_poly(struct series *s, const arb_poly_t poly, slong known);
void series_set_x(struct series *s);                       /* the variable itself */
void series_set_pi(struct series *s, struct names *names); /* NULL: pi alone                     */
void series_set_ratio(struct series *s, const struct ratio *value);
/* Sets a nonexistent value: no coefficient of the series is known. */
void series_set_unknown(struct series *s);
bool series_is_unknown(const struct series *s);
/* Sets the coefficient of x^k to the polynomial's times pi^(power + k step). */
void series_set_pi_poly(struct series *s, const fmpq_poly_t poly, slong power, slong step, slong known);

/* Arithmetic; aliases are allowed everywhere. */
void series_add(struct series *sum, const struct series *a, const struct series *b, const struct ring *ring);
void series_sub(struct series *difference, const struct series *a, const struct series *b, const struct ring *ring);
void series_mul(struct series *product, const struct series *a, const struct series *b, const struct ring *ring);
void series_neg(struct series *to, const struct series *a);
void series_scale(struct series *to, const struct series *a, const fmpq_t factor, const struct ring *ring);
void series_scale_si(struct series *to, const struct series *a, slong factor, const struct ring *ring);
/* Returns false, with quotient unchanged, if all of b, or its first coefficient that is not exactly 0, may be 0. */
bool series_div(struct series *quotient, const struct series *a, const struct series *b, const struct ring *ring);
void series_shift(struct series *to, const struct series *a, slong power);   /* times x^power   */
void series_inflate(struct series *to, const struct series *a, slong power); /* replaces x by x^power */
/* Composes outer(inner(x)): outer has no negative powers, inner begins with x or later. */
void series_compose(struct series *to, const struct series *outer, const struct series *inner, const struct ring *ring);
void series_integral(struct series *to, const struct series *a,
                     const struct ring *ring); /* from 0; no negative powers */
void series_derivative(struct series *to, const struct series *a, const struct ring *ring); /* no negative powers */
/* Drops all knowledge from x^known on. */
void series_truncate(struct series *s, slong known);
/* Removes exact zeros at the front, and terms beyond the ring's length or unknown at the end. */
void series_tidy(struct series *s, const struct ring *ring);
/* Sets a constant, the coefficient of x^power; power must be below known. */
void series_set_coefficient(struct series *to, const struct series *s, slong power);
slong series_terms(const struct series *s); /* count of stored coefficients, from x^first on */

/* Functions (series_functions.c), for x -> 0 from above. Each returns NULL, or the reason of a refusal, as words that
 * follow the function's name; `to` is then unchanged. The sign, or the order of two, is decided by the first
 * coefficient that is not exactly 0, and must be proven. Coefficients stay exact if the constant term makes the
 * result's coefficients fractions (log: 1; power p/q: a q-th power of a fraction; exp, sin, cos: 0). */
const char *series_exp(struct series *to, const struct series *a,
                       const struct ring *ring); /* no negative powers       */
const char *series_log(struct series *to, const struct series *a,
                       const struct ring *ring); /* begins with c x^0, c > 0 */
const char *series_sin(struct series *to, const struct series *a, const struct ring *ring);
const char *series_cos(struct series *to, const struct series *a, const struct ring *ring);
/* Computes base^exponent = c^y x^(k y) (1 + u)^y for base = c x^k (1 + u), y a fraction, with a whole power k y, at
 * most SERIES_FARTHEST in size. A whole y of at most SERIES_EXACT_POWER in size is a product: any base, finite sums
 * stay finite. Other whole y: c must not be 0; other y: c > 0, or the base is 0 and y > 0. */
const char *series_power(struct series *to, const struct series *base, const struct series *exponent,
                         const struct ring *ring);
const char *series_sqrt(struct series *to, const struct series *a, const struct ring *ring); /* the power 1/2 */

/* Computes the coefficient of x^power; power must be below known. */
void series_coefficient(arb_t value, const struct series *s, slong power, slong precision);
/* Returns false if the coefficient is a ball, or depends on pi. */
bool series_rational_coefficient(fmpq_t value, const struct series *s, slong power);
bool series_coefficient_is_zero(const struct series *s, slong power); /* exactly            */
/* Computes the coefficient as a rational function of value's names, the names of s; not for balls. */
void series_get_ratio(struct ratio *value, const struct series *s, slong power);
/* Returns the bits of the largest exact numerator and the denominator, in pi of all; 0 for balls. */
slong series_bits(const struct series *s);
/* Sets this coefficient to exactly 0, as proven by the caller. */
void series_set_zero(struct series *s, slong power);

/* Computes the coefficients from x^0 on, below x^length; no negative powers. */
void series_get_ball_poly(arb_poly_t poly, const struct series *s, slong length, slong precision);

/* Computes the value at x > 0 of the terms below x^before. */
void series_value(arb_t value, const struct series *s, const arb_t x, slong before, slong precision);

#endif
