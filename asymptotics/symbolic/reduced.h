/* Values of symbolic.h with known relations between their symbols. Not public. */
#ifndef SCALLOP_ASYMPTOTICS_SYMBOLIC_REDUCED_H
#define SCALLOP_ASYMPTOTICS_SYMBOLIC_REDUCED_H

#include "asymptotics/symbolic/symbolic.h"

/* Replaces a symbol by another one, times a number and a power of pi; by < 0: no replacement. */
struct replacement {
  int by, pi_power;
  fmpq_t times;
};
struct replacements {
  struct replacement of[MOST_SYMBOLS];
};
void replacements_init(struct replacements *r);
void replacements_clear(struct replacements *r);
SCOPED_KIND(replacements, struct replacements)

/* Returns the function after these replacements. NULL: it then divides by 0. independent: also with M = m1 + m2 and
 * beta = 1 - alpha. The result is 0 if the function is; M is a factor or absent; if beta is in the list, numerator and
 * denominator are homogeneous in alpha and beta. Otherwise M and beta are unchanged. */
symbolic symbolic_replaced(struct symbols *s, symbolic a, const struct replacements *replacements, bool independent);

#endif
