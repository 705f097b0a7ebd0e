/* Numbers with more digits than a double has, to and from text. Needs FLINT. */
#ifndef SCALLOP_DECIMAL_H
#define SCALLOP_DECIMAL_H

#include "compare/command/options.h"
#include "model/ball.h"

/* Every parameter becomes the shortest decimal number that reads back as the double: what a person means by 0.7. The gait is the one of its own
 * numbers as they were written (written_gait.h). */
void decimal_crawler(struct scallop_rational_crawler *exact, const struct scallop_crawler *crawler);
/* The crawler of the options, as it was written: every digit that was given counts. v0 likewise (may be NULL). */
void decimal_options(struct scallop_rational_crawler *exact, fmpq_t v0, const struct options *options);

/* The middle of a ball with so many digits, or as many as it has, wrong by less than one unit of the last one; "0" for an exact
 * zero, "0e-50" for what is 0 to that many places. To be freed with flint_free. */
char *decimal_text(const arb_t x, long digits);
/* "-3/8", or "[0.1013 +/- 3.1e-5]" with so many digits. To be freed with flint_free. */
char *decimal_fraction(const fmpq_t x);
char *decimal_ball(const arb_t x, long digits);

#endif
