/* Points with rational parameters, for certified answers and derived series; balls and fractions as text. Needs
 * FLINT. */
#ifndef SCALLOP_COMPARE_POINTS_POINT_FLINT_H
#define SCALLOP_COMPARE_POINTS_POINT_FLINT_H

#include "compare/points/point.h"
#include "model/exact/ball.h"
#include "model/exact/flint.h"

/* Returns the gait with the decimals of its text as fractions (0.2 is 1/5), valid as long as the gait. Returns the gait
 * itself if it has no numbers (quadratic, sinusoidal) or its doubles are taken as exact: measured gaits, and
 * polynomials if l' is not exactly 0 at the ends, or changes its sign within a phase. */
const struct scallop_gait *written_gait(const struct scallop_gait *gait);

/* Returns a number of the crawler by its place (points/point.h). */
fmpq *rational_field(struct scallop_rational_crawler *crawler, int place);
/* Converts every parameter to the shortest decimal number that reads back as the double, and the gait to
 * written_gait. */
void rational_crawler(struct scallop_rational_crawler *exact, const struct scallop_crawler *crawler);
/* Converts the crawler of the point, and v0 unless it is NULL, with all given digits. */
void rational_point(struct scallop_rational_crawler *exact, fmpq_t v0, const struct point *point);

/* Returns the midpoint of a ball with at most `digits` digits, wrong by less than one unit of the last; "0" for an
 * exact zero, "0e-50" for a ball that is 0 to 50 places. The caller frees it by flint_free. */
char *decimal_text(const arb_t x, long digits);
/* Return "-3/8", or "[0.1013 +/- 3.1e-5]" with `digits` digits. The caller frees it by flint_free. */
char *decimal_fraction(const fmpq_t x);
char *decimal_ball(const arb_t x, long digits);

#endif
