/* What a formula of asymptotics.h leaves out of the derived expansion, as a formula. */
#ifndef SCALLOP_LEFT_OUT_H
#define SCALLOP_LEFT_OUT_H

#include "asymptotics/asymptotics.h"
#include "asymptotics/formula.h"
#include "asymptotics/symbolic/symbolic.h"

/* The term in T^power of derived - formula, in the language of formula.h, to be freed with free: that of the steady state, of an extension from rest,
 * or of the phase of the formula from v0, whose sign counts. It holds for every crawler with the modes of this one, where the
 * coefficients of lower powers are 0 for all of these, or, with the derivatives of l of this very gait, for all of this gait. coefficient: what it is for this
 * crawler, where its gait is rational; else unchanged.
 *
 * NULL: it is not known as a formula, and `message` says why: the expansion has none (symbolic_expand_phase, symbolic_solve_steady), or the
 * formula (formula_symbolic); it gives the friction work; power is not below SYMBOLIC_ORDERS; or a lower coefficient is 0 by coincidence. */
char *symbolic_left_out(fmpq_t coefficient, const struct scallop_formula *formula,
                        const struct scallop_rational_crawler *crawler, const fmpq_t v0, slong power,
                        char message[FORMULA_MESSAGE]);

#endif
