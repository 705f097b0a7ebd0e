/* What the claims in words are decided with: solutions in double, random crawlers, roots and maxima. Needs FLINT. Not
 * public. */
#ifndef SCALLOP_COMPARE_CLAIMS_EVIDENCE_H
#define SCALLOP_COMPARE_CLAIMS_EVIDENCE_H

#include "compare/claims/claims.h"
#include "numerics/certified/certified.h"

/* The duration at which the Froude number is 1 */
double natural_time(const struct scallop_crawler *c);

/* In doubles; nan where there is no solution */
struct scallop_steady_result steady_state(const struct scallop_crawler *c);
struct scallop_phase_result extension(const struct scallop_crawler *c, double v0);
double middle(const arb_t x);
double nearest_double(const fmpq_t x); /* fmpq_get_d does not round to nearest */

/* Masses and forces within a factor of 10 of 1, L = 1, 0.05 < alpha < 0.95, eps from 0.01 to 10: a Sobol sequence, the
 * same bits on every machine. Returns count, or 0: out of memory. */
enum { RANDOM_CRAWLERS = 400 };
int random_crawlers(struct scallop_crawler *c, int count, const struct scallop_gait *gait);

typedef double function_of(const void *context, double x);
/* The last double before f, positive at low and not at high, is not positive any more */
double last_positive(function_of *f, const void *context, double low, double high);
/* Where f, with one maximum between a and b, is highest, to 1e-7 of it */
double highest_between(function_of *f, const void *context, double a, double b);

/* The number with so many digits: what a command says */
double short_number(double x, int digits);

#endif
