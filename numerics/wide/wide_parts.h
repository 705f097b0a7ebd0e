/* The wider solver in each of its types (wide_solve.h), without checks of the arguments. Not public. */
#ifndef SCALLOP_NUMERICS_WIDE_WIDE_PARTS_H
#define SCALLOP_NUMERICS_WIDE_WIDE_PARTS_H

#include <float.h>

#include "numerics/wide/wide.h"

#ifdef __SIZEOF_FLOAT128__
#define WIDE_HAS_FLOAT128 1
#else
#define WIDE_HAS_FLOAT128 0
#endif

struct wide_solver {
  void (*phase)(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0,
                struct scallop_wide_phase *out);
  /* walks: event by event, and not by the short cuts that the solver in double takes */
  void (*period)(const struct scallop_crawler *crawler, double v0, bool walks, struct scallop_wide_period *out);
  /* guess: v_start and v_mid to begin with. Without walks the friction work is not computed. */
  void (*steady)(const struct scallop_crawler *crawler, const double guess[2], bool walks,
                 struct scallop_wide_steady *out);
};
#if LDBL_MANT_DIG == 113 /* then both are one */
#define wide_long wide_quad
#endif
extern const struct wide_solver wide_long, wide_quad;

/* Solves in the cheapest type that resolves a sum of which cancellation leaves the fraction `left` >= 0. Returns false
 * if no such type exists, the gait has no exact law, or a result is no normal number. */
bool wide_enough_phase(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0, double left,
                       struct scallop_wide_phase *out);
bool wide_enough_period(const struct scallop_crawler *crawler, double v0, double left, struct scallop_wide_period *out);
bool wide_enough_steady(const struct scallop_crawler *crawler, const double guess[2], double left,
                        struct scallop_wide_steady *out);

#endif
