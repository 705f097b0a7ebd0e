/* The one loop: points times quantities are tables. The tables of a scene share their points, so that what several
 * ask for is computed once. */
#ifndef SCALLOP_COMPARE_ANSWERS_VISIT_H
#define SCALLOP_COMPARE_ANSWERS_VISIT_H

#include "compare/answers/rows.h"

/* Tables of the same points, all with the same sheet.asked */
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

/* The table of a command by itself. */
enum exit_code rows_table(struct rows *rows);

#endif
