/* Polynomials whose coefficients are rational functions of pi: as exact as fractions, because pi is transcendental, so
 * that a coefficient is 0 only if it is 0 as a function. Needs FLINT. Not public. */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_PI_POLY_H
#define SCALLOP_ASYMPTOTICS_DERIVED_PI_POLY_H

#include "model/exact/flint.h"

#include <flint/fmpz_poly_q.h>
#include <stdbool.h>

struct pi_poly {
  slong length, room;         /* the coefficient of x^(length - 1) is not 0                               */
  fmpz_poly_q_struct *coeffs; /* `room` of them begun, 0 from `length` on                           */
};

void pi_poly_init(struct pi_poly *p);
void pi_poly_clear(struct pi_poly *p);
void pi_poly_set(struct pi_poly *to, const struct pi_poly *a);
/* The coefficient of x^k is that of the polynomial times pi^(power + k step). */
void pi_poly_set_fmpq_poly(struct pi_poly *to, const fmpq_poly_t poly, slong power, slong step);
/* The value of a coefficient, with `precision` bits; of all. 0 where it is 0 */
void pi_poly_get_ball(arb_t value, const struct pi_poly *a, slong k, slong precision);
void pi_poly_get_arb_poly(arb_poly_t to, const struct pi_poly *a, slong precision);
/* False: the coefficient of x^k depends on pi. */
bool pi_poly_get_fraction(fmpq_t value, const struct pi_poly *a, slong k);
/* Bits of all coefficients together */
slong pi_poly_bits(const struct pi_poly *a);

/* Aliases are allowed. times x^by, and by < 0: without the first -by coefficients */
void pi_poly_shift(struct pi_poly *to, const struct pi_poly *a, slong by);
void pi_poly_truncate(struct pi_poly *p, slong length);
void pi_poly_zero_coeff(struct pi_poly *p, slong k);
void pi_poly_neg(struct pi_poly *to, const struct pi_poly *a);
void pi_poly_add(struct pi_poly *to, const struct pi_poly *a, const struct pi_poly *b);
void pi_poly_sub(struct pi_poly *to, const struct pi_poly *a, const struct pi_poly *b);
/* The first `length` coefficients; of a divisor the first is not 0, of what is composed into another the first is 0. */
void pi_poly_mullow(struct pi_poly *to, const struct pi_poly *a, const struct pi_poly *b, slong length);
void pi_poly_div_series(struct pi_poly *to, const struct pi_poly *a, const struct pi_poly *b, slong length);
void pi_poly_compose_series(struct pi_poly *to, const struct pi_poly *outer, const struct pi_poly *inner, slong length);
void pi_poly_inflate(struct pi_poly *to, const struct pi_poly *a, slong power);
void pi_poly_integral(struct pi_poly *to, const struct pi_poly *a);
void pi_poly_derivative(struct pi_poly *to, const struct pi_poly *a);

#endif
