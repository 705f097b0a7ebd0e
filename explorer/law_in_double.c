/* Bernstein laws, evaluated in double: long double is binary128 in software here, a hundred times slower. model/law.c
 * says what is rounded off where long double is wider; how much that is, tests/explorer/core.js measures. What makes
 * gaits stays in long double. */
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

#define law_bernstein law_bernstein_in_double
#define long /* double */
#include "model/law.c"
