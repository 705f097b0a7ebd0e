/* A sheet: the columns of a table by the texts that ask for them, and its rows at points.
 *
 * A text is QUANTITY, NAME = FORMULA or FORMULA, of names of quantities (quantities.h) and of the sheet's own names,
 * which come first: "regime = phase_regime" makes regime mean that of the phase. */
#ifndef SCALLOP_COMPARE_ANSWERS_SHEET_H
#define SCALLOP_COMPARE_ANSWERS_SHEET_H

#include "compare/answers/at.h"
#include "compare/columns/columns.h"

struct sheet {
  struct asked *asked;        /* grows with each column */
  struct column_list columns; /* their places: of quantities */
  const char *const *own;     /* texts that give the sheet's own names, NULL-terminated, or NULL */
  bool of_samples;            /* the rows are those of a trajectory */
  bool as_written;            /* --certified: parameters with all their digits, regime and modes as they are proven */
  long digits;                /* of certified values */
  bool early_status;          /* a status stands before other columns: these are asked for first */
};

/* Adds a column. NULL, or what is wrong with the text: that lives until the next call. */
const char *sheet_add(struct sheet *sheet, const char *text);
/* Does any column take a quantity of which that holds? */
bool sheet_takes(const struct sheet *sheet, bool (*holds)(const struct quantity *));
void sheet_free(struct sheet *sheet);

/* The names of the columns go into the head of the table, and the values at the point into a row of it. */
void sheet_head(const struct sheet *sheet, struct table *table);
void sheet_row(const struct sheet *sheet, struct table *table, struct at *at);

/* NULL, or what is wrong with a formula of quantities */
const char *sheet_formula(struct asked *asked, struct formula *formula, const char *text);
/* What is said where there is no such quantity */
const char *sheet_no_quantity(const struct asked *asked, const char *name);

#endif
