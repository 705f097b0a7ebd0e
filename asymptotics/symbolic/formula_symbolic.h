/* Formulas (formula.h) as series in T whose coefficients are rational functions of named symbols. Not public. */
#ifndef SCALLOP_ASYMPTOTICS_SYMBOLIC_FORMULA_SYMBOLIC_H
#define SCALLOP_ASYMPTOTICS_SYMBOLIC_FORMULA_SYMBOLIC_H

#include "asymptotics/formula.h"
#include "asymptotics/symbolic/symbolic.h"

/* The `count` coefficients from T^first on, 0 <= count <= SYMBOLIC_TERMS, the first of which is not 0; of what follows
 * nothing is known. What is 0 as far as it is known has none. */
struct symbolic_laurent {
  slong first, count;
  symbolic term[SYMBOLIC_TERMS];
};

/* value T^power, and the first terms of a series */
struct symbolic_laurent symbolic_laurent_set(struct symbols *s, symbolic value, slong power);
struct symbolic_laurent symbolic_laurent_of(struct symbols *s, const struct symbolic_series *series, slong first);
struct symbolic_laurent symbolic_laurent_sub(struct symbols *s, const struct symbolic_laurent *a,
                                             const struct symbolic_laurent *b);
/* The coefficient of T^power, or NULL: it is not known. */
symbolic symbolic_laurent_term(struct symbols *s, const struct symbolic_laurent *a, slong power);

/* The value, where values + place is that of the quantity at a place, NULL of a quantity that is no series here. Exact:
 * + - * /, and whole powers from -64 to 64. Returns NULL, or `message`: what cannot be done, and at which character.
 * Refused are functions, pi where it is no symbol, other powers, a division by what is 0, and values with coefficients
 * of more than 200 terms, degree 2000 or 20000 bits. */
const char *formula_symbolic(struct symbolic_laurent *value, const struct formula *formula,
                             const struct symbolic_laurent *const *values, struct symbols *s,
                             char message[FORMULA_MESSAGE]);

#endif
