/* Columns from texts: "NAME", "NAME = FORMULA", or "FORMULA" (asymptotics/formula.h), also the name of its column.
 * Names mean columns of a table, or quantities (answers/rows.h).
 *
 * For a table "a, b, c = F1/F2" chooses columns in this order and adds formulas of existing columns. Commas within
 * parentheses separate arguments of functions. A formula takes the double of a cell, independent of the printed digits;
 * for decimals (--certified) the nearest double, for a fraction such as -3/40 its value to an ulp or two, and nan for a
 * cell that is not a number. */
#ifndef SCALLOP_COMPARE_COLUMNS_COLUMNS_H
#define SCALLOP_COMPARE_COLUMNS_COLUMNS_H

#include "asymptotics/formula.h"
#include "compare/tables/table.h"

struct column {
  char *name;
  int place;               /* of the column or quantity that it copies; -1: a formula */
  struct formula *formula; /* or NULL */
};
struct column_list {
  int count;
  struct column *item;
};
struct column_names { /* the meaning of names */
  struct formula_names names;
  const char *(*missing)(void *context, const char *name); /* returns the error for an unknown name */
};
/* Adds a column. Returns NULL or the error of the text, valid until the next call. */
const char *column_add(struct column_list *list, const char *text, const struct column_names *names);
/* Writes the places that a column takes. Returns their number. */
int column_places(const struct column *column, int places[FORMULA_STEPS]);
bool column_list_has(const struct column_list *list, const char *name);
void column_list_free(struct column_list *list);

/* Returns the formula of "NAME = FORMULA" and the length of NAME without trailing blanks; for "FORMULA" the text and
 * its length. */
const char *column_formula(const char *text, int *name_length);
/* Returns the number of a text: decimal, or a fraction such as -3/40; else nan. */
double text_number(const char *text);

/* Reads a list of texts between commas into a new *choice, for one table at a time; columns_free frees it.
 * Returns NULL or the error, valid until the next call. The columns of the table are known when it begins:
 * table_begin_rows refuses other names. */
const char *columns_read(struct table_choice **choice, const char *text);
/* choice may be NULL. */
void columns_free(struct table_choice *choice);

#endif
