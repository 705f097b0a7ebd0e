/* Formulas (formula.h) in balls and as series in T. Needs FLINT. */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_FORMULA_FLINT_H
#define SCALLOP_ASYMPTOTICS_DERIVED_FORMULA_FLINT_H

#include "asymptotics/formula.h"
#include "asymptotics/derived/series.h"

/* A number of a formula, exactly as it is written */
void formula_number(fmpq_t number, const struct formula_step *step);

/* The value, where values + place is that of the quantity at a place; value is none of them. */
void formula_ball(arb_t value, const struct formula *formula, arb_srcptr values, slong precision);

/* Likewise as a series. Returns NULL, or `message`: what a series cannot do and at which character; value is then
 * unchanged. names: NULL, or those in which values are rational functions. Then the formula is one, too: refused are
 * functions, powers but whole ones from -64 to 64, pi where it is no name, and values with coefficients of more than
 * 200 terms, degree 2000 or 20000 bits. */
const char *formula_series(struct series *value, const struct formula *formula, const struct series *values,
                           struct names *names, const struct ring *ring, char message[FORMULA_MESSAGE]);

#endif
