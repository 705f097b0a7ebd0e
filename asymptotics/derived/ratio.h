/* Rational functions of named numbers, of which nothing is known but that they are independent: with them as
 * coefficients a series is as exact as with fractions, and holds for all their values. pi alone is such a name too: it
 * is transcendental, so that a rational function of pi is 0 only if it is 0 as a function. Needs FLINT. Not public. */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_RATIO_H
#define SCALLOP_ASYMPTOTICS_DERIVED_RATIO_H

#include <stdbool.h>

#include <flint/fmpz_mpoly.h>

#include "model/exact/scoped.h"

struct names {
  fmpz_mpoly_ctx_t ring; /* of polynomials with whole coefficients in all the names                   */
  slong pi;              /* its place among them, -1: it is none of them                              */
  bool only_pi;          /* the one name has a value                                                  */
  slong terms;           /* of the polynomials of all sums and products so far                        */
  slong most_terms;      /* with more of them the work is given up: what is still made is 1; 0: with any number */
};
void names_init(struct names *names, slong count);
void names_clear(struct names *names);
bool names_given_up(const struct names *names);
/* pi alone: one for all, which stays */
struct names *names_of_pi(void);

/* A polynomial that ends with its block: SCOPED_POLYNOMIAL(p, names) */
struct polynomial {
  fmpz_mpoly_t terms;
  const fmpz_mpoly_ctx_struct *ring;
};
fmpz_mpoly_struct *polynomial_begin(struct polynomial *p, const struct names *names);
void polynomial_end(struct polynomial *p);
#define SCOPED_POLYNOMIAL(name, names) \
  ENDED_BY(polynomial_end) struct polynomial name##_scoped; \
  fmpz_mpoly_struct *const name = polynomial_begin(&name##_scoped, names)

/* over/under, without a common divisor, the leading coefficient of under > 0 */
struct ratio {
  struct names *names;
  fmpz_mpoly_t over, under;
};
void ratio_init(struct ratio *r, struct names *names); /* 0 */
void ratio_clear(struct ratio *r);
void ratio_set(struct ratio *to, const struct ratio *a);
void ratio_set_fmpq(struct ratio *to, const fmpq_t value);
void ratio_zero(struct ratio *to);
bool ratio_is_zero(const struct ratio *r);
/* False: it depends on a name. */
bool ratio_get_fmpq(fmpq_t value, const struct ratio *r);
/* Of names that are pi alone, with `precision` bits; 0 where it is 0 */
void ratio_get_ball(arb_t value, const struct ratio *r, slong precision);

/* Aliases are allowed. */
void ratio_neg(struct ratio *to, const struct ratio *a);
void ratio_add(struct ratio *to, const struct ratio *a, const struct ratio *b);
void ratio_sub(struct ratio *to, const struct ratio *a, const struct ratio *b);
void ratio_mul(struct ratio *to, const struct ratio *a, const struct ratio *b);
void ratio_div(struct ratio *to, const struct ratio *a, const struct ratio *b); /* b is not 0 */
void ratio_mul_fmpq(struct ratio *to, const struct ratio *a, const fmpq_t factor);

#endif
