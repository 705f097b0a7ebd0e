/* Columns by the texts that ask for them: "NAME", or "NAME = FORMULA", or "FORMULA", then also the name of its column
 * (asymptotics/formula.h), of names that mean columns of a table, or quantities (answers/rows.h).
 *
 * Of a table: "a, b, c = F1/F2" chooses columns by their names, in that order, and adds new ones by formulas of the
 * columns that it has. Commas within parentheses are those of functions. A formula takes the double behind a cell,
 * however many digits are printed; of decimals (--certified) the nearest double, of a fraction such as -3/40 its value
 * to an ulp or two; a cell that is no number is nan. */
#ifndef SCALLOP_COMPARE_COLUMNS_COLUMNS_H
#define SCALLOP_COMPARE_COLUMNS_COLUMNS_H

#include "asymptotics/formula.h"
#include "compare/tables/table.h"

struct column {
  char *name;
  int place;               /* of what it shows as it is; -1: the formula */
  struct formula *formula; /* or NULL */
};
struct column_list {
  int count;
  struct column *item;
};
struct column_names { /* what names mean */
  struct formula_names names;
  const char *(*missing)(void *context, const char *name); /* the message where a name means nothing */
};
/* Adds a column. NULL, or what is wrong with the text: that lives until the next call. */
const char *column_add(struct column_list *list, const char *text, const struct column_names *names);
/* The places that a column takes, with room for FORMULA_STEPS. Returns how many. */
int column_places(const struct column *column, int places[FORMULA_STEPS]);
bool column_list_has(const struct column_list *list, const char *name);
void column_list_free(struct column_list *list);

/* "NAME = FORMULA": the formula, and how long the name is, without blanks behind it. "FORMULA": the text, which is the
 * name too. */
const char *column_formula(const char *text, int *name_length);
/* The number that a text is: decimal, or a fraction such as -3/40; else nan */
double text_number(const char *text);

/* Reads a list of texts with commas between, which is kept as a copy: *choice is then new, for the style of one
 * table at a time; columns_free ends it. Returns NULL, or what is wrong; that lives until the next call. Which
 * columns there are is known when the table begins: table_begin_rows refuses a name that is none of theirs. */
const char *columns_read(struct table_choice **choice, const char *text);
/* choice may be NULL. */
void columns_free(struct table_choice *choice);

#endif
