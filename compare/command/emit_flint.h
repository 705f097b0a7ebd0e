/* Series as programs and documents: a function of T in C or Python, or a formula in LaTeX or MathML, for each
 * quantity. */
#ifndef SCALLOP_COMPARE_COMMAND_EMIT_FLINT_H
#define SCALLOP_COMPARE_COMMAND_EMIT_FLINT_H

#include "asymptotics/symbolic/language.h"
#include "compare/answers/points.h"

struct emission {
  const struct style *style;
  const struct language *language;
  struct file out;
};
/* Opens the output of the style, and writes the head. language: "c", "python", "latex" or "mathml". command: what to
 * run for the same output; note: a sentence, or NULL. False: the message is on stderr, exit with EXIT_FILE. */
bool emission_open(struct emission *e, const struct style *style, const char *language, const char *command,
                   const char *note);

struct emitted { /* a quantity of a motion as a sum of terms                                             */
  const char *phase, *start, *quantity, *modes;
  const struct symbols *symbols; /* its arguments but T are those of used[]; NULL: there are none     */
  bool used[MOST_SYMBOLS];
  slong count, below; /* terms; the power of T, or of small, from which on they are left out, 0: none is */
  const char *small;  /* NULL: a function of T                                                  */
  struct written *terms;
};
/* Writes it, and frees the terms' texts. */
void emission_add(struct emission *e, struct emitted *emitted);
/* False: as above */
bool emission_close(struct emission *e);

#endif
