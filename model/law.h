/* Laws (struct scallop_law), and the curve that is made of a Bernstein law, in long double. Not public. */
#ifndef SCALLOP_LAW_H
#define SCALLOP_LAW_H

#include "model/model.h"

extern const struct scallop_curve law_curve_bernstein;

/* Whether |l'| is the same function of the offset. */
bool law_same(const struct scallop_law *a, const struct scallop_law *b);

/* sum of b[j] binomial(n, j) x^j y^(n - j), x + y = 1: to a few ulp of the sum of magnitudes, also next to x = 0 and y = 0. */
long double law_bernstein(const long double *b, int n, long double x, long double y);

/* |l'| at offset to minus |l'| at from, for a Bernstein law: to a few ulp of (to - from) max |l''|, however near they are to each other. */
double law_rise(const struct scallop_law *law, double from, double to);

#endif
