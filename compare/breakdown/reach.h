/* How far a series reaches: the largest T up to which its relative error stays below a tolerance. */
#ifndef SCALLOP_COMPARE_BREAKDOWN_REACH_H
#define SCALLOP_COMPARE_BREAKDOWN_REACH_H

#include "compare/breakdown/series.h"

/* series/exact - 1 as a function of T, with what has been computed of it. */
struct comparison {
  const struct expansions *expansions;
  struct series_item item;
  struct exact_cache *cache; /* shared by the comparisons of a motion; for reach and limit */
  double tolerance;
};
/* To be freed; NULL: out of memory. */
struct exact_cache *exact_cache_new(const struct motion *motion);

/* The error at T for this exact value; nan where it has none, 0 where both are 0. */
double comparison_error_beside(const struct comparison *c, double T, const arb_t exact, slong precision);
/* The error at T, by binary128. */
double comparison_error(const struct comparison *c, double T);
/* By certified values with so many digits: -1 if |error| < tolerance at T is proven, +1 if the contrary is, 0 if
 * neither. */
int comparison_certified_side(const struct comparison *c, double T, long digits);

/* The largest T up to which |error| stays below the tolerance: 0 if it does not as T -> 0, INFINITY if for every T up
 * to permanent rest, nan where there is no such value. */
double comparison_reach(const struct comparison *c);
/* The error for T -> 0, if it settles at a value other than 0; else nan. */
double comparison_limit(const struct comparison *c);

#endif
