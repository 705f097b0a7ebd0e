/* Values of symbolic.h of which it is known how their symbols depend on one another. Not public. */
#ifndef SCALLOP_ASYMPTOTICS_SYMBOLIC_REDUCED_H
#define SCALLOP_ASYMPTOTICS_SYMBOLIC_REDUCED_H

#include "asymptotics/symbolic/symbolic.h"

/* In the place of a symbol another one, times a number and a power of pi; by < 0: the symbol stays. */
struct replacement {
  int by, pi_power;
  fmpq_t times;
};
void replacements_init(struct replacement replaced[MOST_SYMBOLS]);
void replacements_clear(struct replacement replaced[MOST_SYMBOLS]);

/* The same function with these replacements, and M and beta as they stand. NULL: it then divides by 0. */
symbolic symbolic_replaced(struct symbols *s, symbolic a, const struct replacement replaced[MOST_SYMBOLS]);
/* Likewise with M = m1 + m2 and beta = 1 - alpha: it is 0 if the function is, M is a factor or not in it, and where
 * beta is in the list over and under are homogeneous in alpha and beta. */
symbolic symbolic_reduced(struct symbols *s, symbolic a, const struct replacement replaced[MOST_SYMBOLS]);

#endif
