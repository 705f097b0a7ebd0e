/* The one loop: points times quantities are tables. A command plans a table, its columns and what it does at a point;
 * the tables of a scene share their points, so that what several ask for is computed once.
 *
 * The columns are a sheet, by the texts that ask for them. A text is QUANTITY, NAME = FORMULA or FORMULA, of names of
 * quantities (quantities.h) and of the sheet's own names, which come first: "regime = phase_regime" makes regime mean
 * that of the phase. */
#ifndef SCALLOP_COMPARE_ANSWERS_ROWS_H
#define SCALLOP_COMPARE_ANSWERS_ROWS_H

#include "compare/answers/at.h"
#include "compare/answers/request.h"
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

/* The names of the columns go into the head of the table, and the values at the point into a row of it. */
void sheet_head(const struct sheet *sheet, struct table *table);
void sheet_row(const struct sheet *sheet, struct table *table, struct at *at);

/* NULL, or what is wrong with a formula of quantities */
const char *sheet_formula(struct asked *asked, struct formula *formula, const char *text);
/* What is said where there is no such quantity */
const char *sheet_no_quantity(const struct asked *asked, const char *name);

enum { ROWS_EXTRA = 3 };

struct rows { /* a table with a row for each point, as it is planned; zero but for the request and sheet.asked */
  const struct request *request;
  struct sheet sheet;
  bool notes_parameters;             /* those that hold in all rows stand in the head; of a scene they always do */
  bool has_parameters;               /* the crawler's stand in front of its own columns, where none are chosen */
  const char *extra[ROWS_EXTRA];     /* parameters beyond the crawler's, which also stand there, NULL-terminated */
  char *own[TABLE_COLUMNS + 1];      /* the texts of its own columns, NULL-terminated */
  const char *const *behind;         /* names of columns behind those of the sheet, which visit writes; or NULL */
  bool has_errors;                   /* visit asks for errors of series, too */
  const struct table_choice *choice; /* of columns; NULL: that of the request */
  const char *command;               /* what the head says of it; NULL: its name */
  int only_drawn;                    /* columns at the end that its picture needs, and that are not written */
  const char *of;                    /* the kind of its picture; NULL: that of the command */
  void (*head)(struct rows *rows);   /* more '#' lines, or NULL */
  void (*visit)(struct rows *rows, struct at *at); /* NULL: sheet_row */
  void *context;                                   /* of these two: freed with the rows, or NULL */
  bool any_order;                                  /* visit takes points in any order, by several threads */
  bool opens_late;                                 /* visit calls rows_open, with the first row */
  /* while it is made */
  struct style style;
  struct table table;
  bool is_open, cannot_open;
  long failed_checks;
};

/* Adds an own column, unless it is there. NULL, or rows_no_memory. */
const char *rows_own(struct rows *rows, const char *format, ...) __attribute__((format(printf, 2, 3)));
extern const char rows_no_memory[];
/* The columns of the sheet: those that are chosen, or labels, parameters, what is carried along and the own ones. NULL,
 * or what is wrong, until the next call. */
const char *rows_columns(struct rows *rows);
void rows_free(struct rows *rows);
bool rows_open(struct rows *rows); /* False: the message is on stderr. */

/* visit.c: tables of the same points, all with the same sheet.asked */
struct rows_run {
  int count;
  struct rows *rows;
  long points, unsolved;
  char why[POINT_STATUS]; /* the first reason of those unsolved */
};
/* Opens the tables, whose columns are known, visits all points of the first request, and has the tables complete on
 * the disk; in *file: the points, if they come from one. The exit code, the message being on stderr. */
struct point_file;
enum exit_code rows_visit(struct rows_run *run, struct point_file *file);
/* Puts the tables in their places; keep: else the earlier files stay. False: one could not be. */
bool rows_close(struct rows_run *run, bool keep);

/* How many threads the request is to run on, from 1 to MOST_THREADS: as many as are given, or OMP_NUM_THREADS says, or
 * there are processors for this process. */
enum { MOST_THREADS = 1024 };
int threads_wanted(const struct request *request);

/* The table of a command by itself. */
enum exit_code rows_table(struct rows *rows);

#endif
