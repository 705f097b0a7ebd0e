/* Truncated Laurent series in one variable x, with coefficients that are fractions, or rational functions of pi, as
 * long as everything that went in was exact, and balls otherwise. Rational functions of pi become balls where they need
 * more than SERIES_PI_BITS.
 *
 * A series knows the terms from x^first up to, not including, x^known; beyond that it says nothing. An exact
 * constant is known to all orders. Needs FLINT.
 */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_SERIES_H
#define SCALLOP_ASYMPTOTICS_DERIVED_SERIES_H

#include "asymptotics/derived/named_poly.h"

struct ring {      /* what a computation keeps                                              */
  slong length;    /* terms of each series                                                  */
  slong precision; /* bits of each ball                                                     */
};

/* What the coefficients are; with one of a later kind, a sum or product is of that kind. */
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
      << 20, /* what an exact power has at most, but for rounding up: powers of powers would take all time and memory */
  SERIES_PI_BITS = 1 << 22,
  SERIES_PI_TERMS = 42,  /* longer expansions of sinusoidal gaits have balls                         */
  SERIES_FARTHEST = 4096 /* the largest power of x that series_power makes: products do not run out of memory */
};

/* known of a series with finitely many terms, all of which are there */
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
/* A number that does not exist: no coefficient of the series is known. */
void series_set_unknown(struct series *s);
bool series_is_unknown(const struct series *s);
/* The coefficient of x^k is that of the polynomial times pi^(power + k step). */
void series_set_pi_poly(struct series *s, const fmpq_poly_t poly, slong power, slong step, slong known);

/* Aliases are allowed everywhere. */
void series_add(struct series *sum, const struct series *a, const struct series *b, const struct ring *ring);
void series_sub(struct series *difference, const struct series *a, const struct series *b, const struct ring *ring);
void series_mul(struct series *product, const struct series *a, const struct series *b, const struct ring *ring);
void series_neg(struct series *to, const struct series *a);
void series_scale(struct series *to, const struct series *a, const fmpq_t factor, const struct ring *ring);
void series_scale_si(struct series *to, const struct series *a, slong factor, const struct ring *ring);
/* False: the first coefficient of b that is not exactly 0 may be 0, or there is none; quotient is then unchanged. */
bool series_div(struct series *quotient, const struct series *a, const struct series *b, const struct ring *ring);
void series_shift(struct series *to, const struct series *a, slong power);   /* times x^power   */
void series_inflate(struct series *to, const struct series *a, slong power); /* x becomes x^power */
/* outer(inner(x)): outer has no negative powers, inner begins with x or later. */
void series_compose(struct series *to, const struct series *outer, const struct series *inner, const struct ring *ring);
void series_integral(struct series *to, const struct series *a,
                     const struct ring *ring); /* from 0; no negative powers */
void series_derivative(struct series *to, const struct series *a, const struct ring *ring); /* no negative powers */
/* Forgets everything from x^known on. */
void series_truncate(struct series *s, slong known);
/* Takes exact zeros off the front, and what is beyond the ring's length or not known off the end. */
void series_tidy(struct series *s, const struct ring *ring);
/* A constant, the coefficient of x^power, which must be below known */
void series_set_coefficient(struct series *to, const struct series *s, slong power);
slong series_terms(const struct series *s); /* coefficients that it keeps, from x^first on */

/* Functions (series_functions.c), for x -> 0 from above. Each returns NULL, or what a series cannot do, as words that
 * follow the function's name; `to` is then unchanged. A sign, or an order of two, is that of the first coefficient that
 * is not exactly 0, and must be proven. Coefficients stay exact where those of the result are fractions because the
 * constant term (of a log: 1; of a power: p/q: a q-th power of a fraction; of exp, sin, cos: 0) is one for which
 * they are. */
const char *series_exp(struct series *to, const struct series *a,
                       const struct ring *ring); /* no negative powers       */
const char *series_log(struct series *to, const struct series *a,
                       const struct ring *ring); /* begins with c x^0, c > 0 */
const char *series_sin(struct series *to, const struct series *a, const struct ring *ring);
const char *series_cos(struct series *to, const struct series *a, const struct ring *ring);
/* base^exponent = c^y x^(k y) (1 + u)^y of base = c x^k (1 + u), y a fraction, with a whole power k y, at most
 * SERIES_FARTHEST in size. A whole y of at most SERIES_EXACT_POWER in size is a product: any base, finite sums stay
 * finite. Other whole y: c must not be 0; other y: c > 0, or the base is 0 and y > 0. */
const char *series_power(struct series *to, const struct series *base, const struct series *exponent,
                         const struct ring *ring);
const char *series_sqrt(struct series *to, const struct series *a, const struct ring *ring); /* the power 1/2 */

/* The coefficient of x^power, which must be below known. */
void series_coefficient(arb_t value, const struct series *s, slong power, slong precision);
/* false: it is a ball, or depends on pi */
bool series_rational_coefficient(fmpq_t value, const struct series *s, slong power);
bool series_coefficient_is_zero(const struct series *s, slong power); /* exactly            */
/* As a rational function of value's names, which are those of s; no balls */
void series_get_ratio(struct ratio *value, const struct series *s, slong power);
/* Bits of the largest exact numerator and the denominator, in pi of all of them; 0 of balls, which have as many as
 * their ring. */
slong series_bits(const struct series *s);
/* States that this coefficient is exactly 0, which the caller has proven. */
void series_set_zero(struct series *s, slong power);

/* The coefficients from x^0 on, below x^length; there must be none before. */
void series_get_ball_poly(arb_poly_t poly, const struct series *s, slong length, slong precision);

/* The value at x > 0 of the terms below x^before. */
void series_value(arb_t value, const struct series *s, const arb_t x, slong before, slong precision);

#endif
