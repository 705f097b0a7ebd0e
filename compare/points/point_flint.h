/* A point in fractions, as it was written: what certified answers and derived series are about. And numbers with more
 * digits than a double has, as text. Needs FLINT. */
#ifndef SCALLOP_COMPARE_POINTS_POINT_FLINT_H
#define SCALLOP_COMPARE_POINTS_POINT_FLINT_H

#include "compare/points/point.h"
#include "model/exact/ball.h"
#include "model/exact/flint.h"

/* The gait with the decimals of its text as fractions: 0.2 is 1/5. It lives as long as the gait. The gait itself where
 * it has no numbers (quadratic, sinusoidal), and where its doubles stand for it: measured gaits, and polynomials whose
 * l' is not exactly 0 at the ends, or changes its sign within a phase. */
const struct scallop_gait *written_gait(const struct scallop_gait *gait);

/* One of the crawler's numbers by its place (points/point.h) */
fmpq *rational_field(struct scallop_rational_crawler *crawler, int place);
/* Every parameter becomes the shortest decimal number that reads back as the double: what a person means by 0.7. The
 * gait is the written one. */
void rational_crawler(struct scallop_rational_crawler *exact, const struct scallop_crawler *crawler);
/* The crawler of the point as it was written: every digit that was given counts. v0 likewise (may be NULL). */
void rational_point(struct scallop_rational_crawler *exact, fmpq_t v0, const struct point *point);

/* The middle of a ball with so many digits, or as many as it has, wrong by less than one unit of the last one; "0" for
 * an exact zero, "0e-50" for what is 0 to that many places. To be freed with flint_free. */
char *decimal_text(const arb_t x, long digits);
/* "-3/8", or "[0.1013 +/- 3.1e-5]" with so many digits. To be freed with flint_free. */
char *decimal_fraction(const fmpq_t x);
char *decimal_ball(const arb_t x, long digits);

#endif
