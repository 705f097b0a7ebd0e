/* Values of symbolic.h in factored form, as text in the language of asymptotics/formula.h, in Python or in LaTeX. */
#ifndef SCALLOP_ASYMPTOTICS_SYMBOLIC_LANGUAGE_H
#define SCALLOP_ASYMPTOTICS_SYMBOLIC_LANGUAGE_H

#include "asymptotics/symbolic/symbolic.h"

/* The notation of a language */
struct language {
  const char *name, *times, *alpha;
  const char *power[2], *subscript[2]; /* around the exponent, or the index, after its base */
  const char *fraction[3];             /* before, between and after numerator and denominator */
  const char *difference;              /* Delta before a letter */
  const char *ten[2];                  /* around the exponent of 10 in a decimal number; NULL: unchanged */
  bool slash;                          /* a fraction does not group numerator and denominator */
};
extern const struct language language_text, language_python, language_latex;

struct written {
  bool negative;
  char *text; /* the absolute value; the caller frees it */
};
/* Writes a T^power. T need not be in the list. A factor that contains T is written by powers of T. */
struct written symbolic_written(struct symbols *s, symbolic a, slong power, const struct language *language);
/* Writes a decimal number, for instance -1.25e-7, times T^power. */
struct written decimal_written(const char *decimal, slong power, const struct language *language);
/* Writes one symbol; the caller frees the text. */
char *symbol_written(const struct symbol *symbol, const struct language *language);
/* Sets used[place] for each symbol of the list in a; other elements are unchanged. */
void symbolic_uses(symbolic a, const struct symbols *s, bool *used);

#endif
