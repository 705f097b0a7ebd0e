/* The wider solver in each of its types (wide_solve.h), without any look at the arguments. Not public. */
#ifndef SCALLOP_WIDE_PARTS_H
#define SCALLOP_WIDE_PARTS_H

#include "numerics/wide.h"

#ifdef __SIZEOF_FLOAT128__
#define WIDE_HAS_FLOAT128 1
#else
#define WIDE_HAS_FLOAT128 0
#endif

void wide_long_phase(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0,
                     struct scallop_wide_phase *out);
void wide_long_period(const struct scallop_crawler *crawler, double v0, struct scallop_wide_period *out);
void wide_quad_phase(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0,
                     struct scallop_wide_phase *out);
void wide_quad_period(const struct scallop_crawler *crawler, double v0, struct scallop_wide_period *out);

/* guess: a start velocity to begin with. False: no end of the iteration. */
bool wide_long_steady(const struct scallop_crawler *crawler, double guess, struct scallop_wide_steady *out);
bool wide_quad_steady(const struct scallop_crawler *crawler, double guess, struct scallop_wide_steady *out);

/* The same in the cheapest type that tells a sum of which only a fraction `left` is left, the rest having cancelled; left > 0, or 0 where
 * nothing is. False: there is none, or the gait has no exact law, or as above. */
bool wide_enough_phase(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0, double left,
                       struct scallop_wide_phase *out);
bool wide_enough_period(const struct scallop_crawler *crawler, double v0, double left, struct scallop_wide_period *out);
bool wide_enough_steady(const struct scallop_crawler *crawler, double guess, double left, struct scallop_wide_steady *out);

#endif
