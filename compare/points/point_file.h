/* A file of points: TSV whose header names parameters. Other columns are carried along, cell by cell. */
#ifndef SCALLOP_COMPARE_POINTS_POINT_FILE_H
#define SCALLOP_COMPARE_POINTS_POINT_FILE_H

#include "compare/points/sweep.h"
#include "compare/text/message.h"
#include "compare/tables/tsv.h"

struct point_file {
  struct tsv tsv;
  const struct parameter *parameter[TSV_CELLS]; /* of each column; NULL: it is none                              */
  const char *carried[TSV_CELLS + 1];           /* names of columns that are no parameters and are carried along */
  int column[TSV_CELLS];                        /* where these are                                               */
  int carries;                                  /* how many                                                      */
  const char *cell[TSV_CELLS];                  /* of the current row: what is carried along                     */
  bool v0_may_be_nan;                           /* where none is given                                         */
  double bytes, read;                           /* of a regular file, else 0; those of the rows so far         */
};

/* Opens the file, "-": standard input, and reads its header. extra: parameters beyond the crawler's that it may name;
 * columns: "NAME" or "NAME = FORMULA", names that are taken by the table; both NULL-terminated. EXIT_DONE, or the exit
 * code, the message being on stderr; to be closed in either case. */
enum exit_code point_file_open(struct point_file *file, const char *name, const char *command, bool quiet,
                               const char *const *extra, const char *const *columns);
void point_file_close(struct point_file *file);

/* Goes to the point of the next row, which is the base but for what the row says. False: there is none, or the file
 * cannot be read (tsv_error of file->tsv). */
bool point_file_next(struct point_file *file, struct sweep_place *place, const struct point *base);
/* How many rows a file of that name has. */
long point_file_count(const char *name);
/* About how many rows there are, of which so many have been read; 0: that is not known. */
long point_file_rows(const struct point_file *file, long read);

#endif
