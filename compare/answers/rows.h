/* Tables with a row for each point, and the loop over points that writes them. A command plans a table: its columns,
 * and the function for each point. The tables of a scene share their points and the quantities of these.
 *
 * The columns of a table are a sheet. The text of a column is QUANTITY, NAME = FORMULA or FORMULA, of names of
 * quantities (quantities.h) and of the sheet's own names; own names have precedence: after "regime = phase_regime" the
 * name regime means phase_regime. */
#ifndef SCALLOP_COMPARE_ANSWERS_ROWS_H
#define SCALLOP_COMPARE_ANSWERS_ROWS_H

#include "compare/answers/at.h"
#include "compare/answers/request.h"
#include "compare/columns/columns.h"

struct sheet {
  struct requirements *required; /* grows with each column */
  struct column_list columns;    /* with places of quantities */
  const char *const *own;        /* texts that define the sheet's own names, NULL-terminated, or NULL */
  bool of_samples;               /* rows of a trajectory */
  bool as_written;               /* --certified: parameters with all given digits, regime and modes proven */
  long digits;                   /* of certified values */
  bool early_status;             /* status precedes other columns: these are computed first */
};

/* Write the names of the columns to the head of the table, and the values at the point to a row. */
void sheet_head(const struct sheet *sheet, struct table *table);
void sheet_row(const struct sheet *sheet, struct table *table, struct at *at);

/* Reads a formula of quantities. Returns NULL or the error. */
const char *sheet_formula(struct requirements *required, struct formula *formula, const char *text);
/* Returns the error for an unknown quantity. */
const char *unknown_quantity_error(const struct requirements *required, const char *name);

enum { ROWS_EXTRA = 3 };

struct rows { /* a table with a row for each point; begins as zero, except request and sheet.required */
  const struct request *request;
  struct sheet sheet;
  bool notes_parameters;             /* the head has the constant parameters; a scene's head always has them */
  bool has_parameters;               /* without a choice of columns the crawler's parameters come first */
  const char *extra[ROWS_EXTRA];     /* further parameters behind the crawler's, NULL-terminated */
  char *own[TABLE_COLUMNS + 1];      /* the texts of the table's own columns, NULL-terminated */
  const char *const *behind;         /* names of columns that visit writes behind the sheet; or NULL */
  bool has_errors;                   /* visit also requests errors of series */
  const struct table_choice *choice; /* of columns; NULL: the choice of the request */
  const char *command;               /* printed in the head; NULL: the name of the command */
  int only_drawn;                    /* columns at the end for the plot only, not written */
  const char *of;                    /* kind of the plot; NULL: by the command */
  void (*head)(struct rows *rows);   /* more '#' lines, or NULL */
  void (*visit)(struct rows *rows, struct at *at); /* NULL: sheet_row */
  void *context;                                   /* for head and visit; owned, or NULL */
  bool any_order;                                  /* visit may run in several threads, in any order */
  bool opens_late;                                 /* visit calls rows_open at the first row */
  /* set during the run: */
  struct style style;
  struct table table;
  bool is_open, cannot_open;
  long failed_checks;
};

/* Adds an own column, unless the table has it. Returns NULL or rows_no_memory. */
const char *rows_own(struct rows *rows, const char *format, ...) __attribute__((format(printf, 2, 3)));
extern const char rows_no_memory[];
/* Sets the columns of the sheet: the chosen ones, or labels, parameters, carried and own columns. Returns NULL or the
 * error, valid until the next call. */
const char *rows_columns(struct rows *rows);
void rows_free(struct rows *rows);
bool rows_open(struct rows *rows); /* returns false after a message on stderr */

/* visit.c: tables of the same points, all with the same sheet.required */
struct rows_set {
  int count;
  struct rows *rows;
  long points, unsolved;
  char why[POINT_STATUS]; /* the reason of the first unsolved point */
};
/* Opens the tables after their columns are set, visits all points of the first request, or of the file if it is not
 * NULL, and writes the tables to the disk. Returns the exit code, after a message on stderr. */
struct point_file;
enum exit_code rows_visit(struct rows_set *set, struct point_file *file);
/* Closes the tables. keep: they replace the earlier files, else these remain. Returns false if writing fails. */
bool rows_close(struct rows_set *set, bool keep);

/* Returns the number of threads, from 1 to MAX_THREADS: as given, else OMP_NUM_THREADS, else the number of processors
 * of the process. */
enum { MAX_THREADS = 1024 };
int request_threads(const struct request *request);

/* Writes the table of a command that has only one. */
enum exit_code rows_table(struct rows *rows);

#endif
