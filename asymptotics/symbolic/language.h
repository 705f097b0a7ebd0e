/* Values of symbolic.h written down, in factored form: as text in the language of asymptotics/formula.h, in Python
 * or LaTeX. */
#ifndef SCALLOP_ASYMPTOTICS_SYMBOLIC_LANGUAGE_H
#define SCALLOP_ASYMPTOTICS_SYMBOLIC_LANGUAGE_H

#include "asymptotics/symbolic/symbolic.h"

/* How a language writes what formulas are made of. */
struct language {
  const char *name, *times, *alpha;
  const char *power[2], *subscript[2]; /* around it, behind what has it                                   */
  const char *fraction[3];             /* before, between and behind its two sides                        */
  const char *difference;              /* Delta in front of a letter                                      */
  const char *ten[2];                  /* around the exponent of 10 in a decimal number; NULL: as it is   */
  bool slash;                          /* a fraction does not hold its two sides together                 */
};
extern const struct language language_text, language_python, language_latex;

struct written {
  bool negative;
  char *text; /* of the absolute value; to be freed with free                                      */
};
/* a T^power. T need not be in the list. A factor that has T in it is written by powers of T. */
struct written symbolic_written(struct symbols *s, symbolic a, slong power, const struct language *language);
/* The same of a decimal number, as in -1.25e-7 */
struct written decimal_written(const char *decimal, slong power, const struct language *language);
/* One symbol; to be freed with free */
char *symbol_written(const struct symbol *symbol, const struct language *language);
/* Which symbols of the list a has in it: sets used[place], and leaves the others as they are. */
void symbolic_uses(symbolic a, const struct symbols *s, bool *used);

#endif
