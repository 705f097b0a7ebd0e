/* Numbers with more digits than a double has, as text. Needs FLINT. */
#ifndef SCALLOP_DECIMAL_H
#define SCALLOP_DECIMAL_H

#include "model/flint.h"

/* The middle of a ball with so many digits, or as many as it has, wrong by less than one unit of the last one; "0" for an exact
 * zero, "0e-50" for what is 0 to that many places. To be freed with flint_free. */
char *decimal_text(const arb_t x, long digits);
/* "-3/8", or "[0.1013 +/- 3.1e-5]" with so many digits. To be freed with flint_free. */
char *decimal_fraction(const fmpq_t x);
char *decimal_ball(const arb_t x, long digits);

#endif
