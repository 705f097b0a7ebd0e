/* Which columns a table has, as text: "a, b, c = F1/F2" chooses columns of a table by their names, in that order, and
 * adds new ones by formulas (asymptotics/formula.h) of the columns that the table has. A name that is no NAME = FORMULA
 * may be a formula too, which is then the name of its column. Commas within parentheses are those of functions.
 *
 * A formula takes the double behind a cell, however many digits are printed; of decimals (--certified) the nearest
 * double, of a fraction such as -3/40 its value to an ulp or two; a cell that is no number is nan. */
#ifndef SCALLOP_COMPARE_COLUMNS_COLUMNS_H
#define SCALLOP_COMPARE_COLUMNS_COLUMNS_H

#include "compare/text/table.h"

/* Reads text, which is kept as a copy: *choice is then new, for the style of one table at a time; columns_free ends it.
 * Returns NULL, or what is wrong; that lives until the next call. Which columns there are is known when the table
 * begins: table_begin_rows refuses a name that is none of theirs. */
const char *columns_read(struct table_choice **choice, const char *text);
/* choice may be NULL. */
void columns_free(struct table_choice *choice);

/* "NAME = FORMULA": the formula, and how long the name is, without blanks behind it. "FORMULA": the text, which is the
 * name too. */
const char *column_formula(const char *text, int *name_length);
/* The number that a text is: decimal, or a fraction such as -3/40; else nan */
double text_number(const char *text);
/* Can a new column be called that? Printable ASCII without quotes and backslashes, and not empty. */
bool column_may_be_called(const char *name);

#endif
