/* A formula as text, evaluated in series arithmetic: how the published formulas are put beside the derived ones
 * coefficient by coefficient. Whole numbers up to 10^9, names, + - * / ( ) and whole powers from 0 to 64 after ^. Needs FLINT. */
#ifndef SCALLOP_EXPRESSION_H
#define SCALLOP_EXPRESSION_H

#include "asymptotics/series.h"

/* Sets value to what the name (not terminated, `length` characters) stands for; false if it stands for nothing. */
typedef bool expression_lookup(void *context, const char *name, size_t length, struct series *value);

/* False: the text is not a formula, a name is unknown, or a divisor may be 0; value is then unchanged. */
bool expression_evaluate(struct series *value, const char *text, expression_lookup *lookup, void *context,
                         const struct ring *ring);

#endif
