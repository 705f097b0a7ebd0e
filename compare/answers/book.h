/* Formulas by name: the paper's, those that hold where one of the paper's does not, and those of a book that was read. */
#ifndef SCALLOP_BOOK_H
#define SCALLOP_BOOK_H

#include "asymptotics/published/read.h"

/* The formula at place i of all, or NULL: there are no more. */
const struct scallop_formula *formula_at(int i);
/* That of this name, or NULL. */
const struct scallop_formula *formula_named(const char *name);

/* Its text, read when it is first asked for, and kept while the program runs. NULL: out of memory. Any thread may ask. */
const struct formula *formula_read_once(const struct scallop_formula *formula);
/* Does its text, or a part of it, use the symbol? */
bool formula_takes(const struct scallop_formula *formula, enum scallop_symbol symbol);

#endif
