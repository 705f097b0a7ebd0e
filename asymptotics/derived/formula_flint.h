/* Formulas (formula.h) in balls and as series in T. Needs FLINT. */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_FORMULA_FLINT_H
#define SCALLOP_ASYMPTOTICS_DERIVED_FORMULA_FLINT_H

#include "asymptotics/formula.h"
#include "asymptotics/derived/series.h"

/* Sets number to the exact value of a number in a formula. */
void formula_number(fmpq_t number, const struct formula_step *step);

/* Computes the value; values + place is the quantity with this index; value must not be one of them. */
void formula_ball(arb_t value, const struct formula *formula, arb_srcptr values, slong precision);

/* Computes the formula as a series. Returns NULL, or `message`: the operation that a series does not allow and its
 * character; value is then unchanged. names: NULL, or the names of which the values are rational functions. Then the
 * result must be one, too: functions, powers except whole ones from -64 to 64, pi unless it is a name, and values with
 * coefficients of more than 200 terms, degree 2000 or 20000 bits are refused. */
const char *formula_series(struct series *value, const struct formula *formula, const struct series *values,
                           struct names *names, const struct ring *ring, char message[FORMULA_MESSAGE]);

#endif
