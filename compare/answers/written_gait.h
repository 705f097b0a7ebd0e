/* Gaits with their own numbers as they were written, all digits of them. Needs FLINT. */
#ifndef SCALLOP_WRITTEN_GAIT_H
#define SCALLOP_WRITTEN_GAIT_H

#include "model/ball.h"

/* The gait with the decimals of its text, or of its table, as fractions: 0.2 is 1/5. It lives as long as the gait. The gait itself where it has no
 * numbers (quadratic, sinusoidal), and where its doubles stand for it: polynomials whose l' is not exactly 0 at the ends, or changes its sign
 * within a phase, and tables with two lengths that differ and are the same double. */
const struct scallop_gait *written_gait(const struct scallop_gait *gait);

/* What a measured gait has of its own, as fractions. False: this is none. */
bool written_gait_has_own(const struct scallop_gait *gait, fmpq_t L, fmpq_t T, fmpq_t alpha);

#endif
