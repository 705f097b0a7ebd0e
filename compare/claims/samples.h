/* Certified samples of a motion as T falls, and the errors of formulas there. Needs FLINT. Not public. */
#ifndef SCALLOP_COMPARE_CLAIMS_SAMPLES_H
#define SCALLOP_COMPARE_CLAIMS_SAMPLES_H

#include "compare/claims/trial.h"

/* CLAIM_POINTS of them, T = T0 4^-k: T0 is the duration at which the Froude number is 1, or less where masses or forces
 * are far apart; the last T is below 1e-20 T0. NULL: out of memory. */
struct sample *samples_take(const struct trial *m);
void samples_free(struct sample *samples);

/* The certified error of the formula at every T where the motion has the modes of the limit: points and count of the
 * row, and mismatch. left_out: the derived expansion minus the formula. */
void samples_measure(struct claim_row *row, const struct trial *m, const struct scallop_formula *formula,
                     const struct series *left_out);

#endif
