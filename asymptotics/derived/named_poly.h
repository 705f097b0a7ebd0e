/* Polynomials in x with rational functions of names as coefficients (ratio.h). Needs FLINT. Not public. */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_NAMED_POLY_H
#define SCALLOP_ASYMPTOTICS_DERIVED_NAMED_POLY_H

#include "asymptotics/derived/ratio.h"

struct named_poly {
  struct names *names;
  slong length, allocated; /* the coefficient of x^(length - 1) is not 0                               */
  struct ratio *coeffs;    /* `allocated` of them are initialized, 0 from `length` on */
};

void named_poly_init(struct named_poly *p);
void named_poly_clear(struct named_poly *p);
void named_poly_set(struct named_poly *to, const struct named_poly *a);
void named_poly_set_fmpq_poly(struct named_poly *to, const fmpq_poly_t poly, struct names *names);
void named_poly_set_constant(struct named_poly *to, const struct ratio *value);
/* Multiplies the coefficient of x^k by value^(power + k step); power, step >= 0. */
void named_poly_mul_powers(struct named_poly *p, const struct ratio *value, slong power, slong step);
/* Converts to balls; the only name is pi: see ratio_get_ball. */
void named_poly_get_arb_poly(arb_poly_t to, const struct named_poly *a, slong precision);
/* Returns the bits of all coefficients together. */
slong named_poly_bits(const struct named_poly *a);

/* Arithmetic; aliases are allowed. shift: times x^by; by < 0 drops the first -by coefficients. */
void named_poly_shift(struct named_poly *to, const struct named_poly *a, slong by);
void named_poly_truncate(struct named_poly *p, slong length);
void named_poly_zero_coeff(struct named_poly *p, slong k);
void named_poly_neg(struct named_poly *to, const struct named_poly *a);
void named_poly_add(struct named_poly *to, const struct named_poly *a, const struct named_poly *b);
void named_poly_sub(struct named_poly *to, const struct named_poly *a, const struct named_poly *b);
/* Arithmetic on the first `length` coefficients. The first coefficient of a divisor is not 0, of an inner series 0. */
void named_poly_mullow(struct named_poly *to, const struct named_poly *a, const struct named_poly *b, slong length);
void named_poly_div_series(struct named_poly *to, const struct named_poly *a, const struct named_poly *b, slong length);
void named_poly_compose_series(struct named_poly *to, const struct named_poly *outer, const struct named_poly *inner,
                               slong length);
void named_poly_inflate(struct named_poly *to, const struct named_poly *a, slong power);
void named_poly_integral(struct named_poly *to, const struct named_poly *a);
void named_poly_derivative(struct named_poly *to, const struct named_poly *a);

#endif
