/* The proof that a steady motion has the modes of a branch: between its crossings c keeps off the curves, and at each
 * it goes through. Not public. */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_HOLDS_H
#define SCALLOP_ASYMPTOTICS_DERIVED_HOLDS_H

#include "asymptotics/derived/limit.h"

/* For every eps and the start velocities w and w_mid of the two phases within the balls, the branches' offsets
 * enclosing the crossings for them. NULL, or what keeps it from being shown (static text): just before the end of a
 * branch, what happens there. */
const char *limit_holds(const struct limit *l, const arb_t w, const arb_t w_mid, const arb_t eps, slong precision);

#endif
