/* A point in fractions: what certified answers and derived series are about. Needs FLINT. */
#ifndef SCALLOP_RATIONAL_H
#define SCALLOP_RATIONAL_H

#include "compare/answers/point.h"
#include "model/ball.h"

/* Every parameter becomes the shortest decimal number that reads back as the double: what a person means by 0.7. The gait is the one of its own
 * numbers as they were written (written_gait.h). */
void rational_crawler(struct scallop_rational_crawler *exact, const struct scallop_crawler *crawler);
/* The crawler of the point as it was written: every digit that was given counts. v0 likewise (may be NULL). */
void rational_point(struct scallop_rational_crawler *exact, fmpq_t v0, const struct point *point);

#endif
