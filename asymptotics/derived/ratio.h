/* Rational functions of independent names. A series with such coefficients is as exact as with fractions, and holds for
 * all values of the names. pi alone is also such a name: it is transcendental, therefore a rational function of pi is 0
 * only if it is 0 as a function. Needs FLINT. Not public. */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_RATIO_H
#define SCALLOP_ASYMPTOTICS_DERIVED_RATIO_H

#include <stdbool.h>

#include <flint/fmpz_mpoly.h>

#include "model/exact/scoped.h"

struct names {
  fmpz_mpoly_ctx_t ring; /* polynomials with integer coefficients in all names */
  slong pi;              /* index of pi among the names, -1 if absent */
  bool only_pi;          /* pi is the only name */
  slong terms;           /* terms of the polynomials of all sums and products so far */
  slong most_terms;      /* limit of terms; above it work stops, and each further result is 1; 0: no limit */
};
void names_init(struct names *names, slong count);
void names_clear(struct names *names);
bool names_given_up(const struct names *names);
/* Returns the single instance of the names with pi alone; it is never cleared. */
struct names *names_of_pi(void);

/* A polynomial cleared at the end of its block: SCOPED_POLYNOMIAL(p, names) */
struct polynomial {
  fmpz_mpoly_t terms;
  const fmpz_mpoly_ctx_struct *ring;
};
fmpz_mpoly_struct *polynomial_begin(struct polynomial *p, const struct names *names);
void polynomial_end(struct polynomial *p);
#define SCOPED_POLYNOMIAL(name, names) \
  ENDED_BY(polynomial_end) struct polynomial name##_scoped; \
  fmpz_mpoly_struct *const name = polynomial_begin(&name##_scoped, names)

/* over/under in lowest terms, the leading coefficient of under > 0 */
struct ratio {
  struct names *names;
  fmpz_mpoly_t over, under;
};
void ratio_init(struct ratio *r, struct names *names); /* sets r = 0 */
void ratio_clear(struct ratio *r);
void ratio_set(struct ratio *to, const struct ratio *a);
void ratio_set_fmpq(struct ratio *to, const fmpq_t value);
void ratio_zero(struct ratio *to);
bool ratio_is_zero(const struct ratio *r);
/* Returns false if the value depends on a name. */
bool ratio_get_fmpq(fmpq_t value, const struct ratio *r);
/* Computes the value with `precision` bits; the only name is pi. It is 0 for the function 0. */
void ratio_get_ball(arb_t value, const struct ratio *r, slong precision);

/* Arithmetic; aliases are allowed. */
void ratio_neg(struct ratio *to, const struct ratio *a);
void ratio_add(struct ratio *to, const struct ratio *a, const struct ratio *b);
void ratio_sub(struct ratio *to, const struct ratio *a, const struct ratio *b);
void ratio_mul(struct ratio *to, const struct ratio *a, const struct ratio *b);
void ratio_div(struct ratio *to, const struct ratio *a, const struct ratio *b); /* b is not 0 */
void ratio_mul_fmpq(struct ratio *to, const struct ratio *a, const fmpq_t factor);

#endif
