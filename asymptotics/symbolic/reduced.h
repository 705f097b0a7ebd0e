/* Values of symbolic.h of which it is known how their symbols depend on one another. Not public. */
#ifndef SCALLOP_ASYMPTOTICS_SYMBOLIC_REDUCED_H
#define SCALLOP_ASYMPTOTICS_SYMBOLIC_REDUCED_H

#include "asymptotics/symbolic/symbolic.h"

/* In the place of a symbol another one, times a number and a power of pi; by < 0: the symbol stays. */
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

/* The same function with these replacements. NULL: it then divides by 0. independent: also with M = m1 + m2 and beta =
 * 1 - alpha: it is 0 if the function is, M is a factor or not in it, and where beta is in the list over and under are
 * homogeneous in alpha and beta; else M and beta stay as they stand. */
symbolic symbolic_replaced(struct symbols *s, symbolic a, const struct replacements *replacements, bool independent);

#endif
