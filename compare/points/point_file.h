/* Files of points: TSV with parameters as column names. The cells of other columns are copied to the output. */
#ifndef SCALLOP_COMPARE_POINTS_POINT_FILE_H
#define SCALLOP_COMPARE_POINTS_POINT_FILE_H

#include "compare/points/sweep.h"
#include "compare/text/message.h"
#include "compare/tables/tsv.h"

struct point_file {
  struct tsv tsv;
  const struct parameter *parameter[TSV_CELLS]; /* of each column; NULL: not a parameter                 */
  const char *carried[TSV_CELLS + 1];           /* names of the other columns */
  int column[TSV_CELLS];                        /* places of these                                       */
  int carries;                                  /* number of these                                       */
  const char *cell[TSV_CELLS];                  /* cells of these in the current row                     */
  bool v0_may_be_nan;                           /* nan: v0 is not given                                  */
  double bytes, read;                           /* size of a regular file, else 0; bytes of the rows read */
};

/* Opens the file, "-" for standard input, and reads its header. extra: further parameters that the header may name;
 * columns: "NAME" or "NAME = FORMULA", the columns of the table; both NULL-terminated. Returns EXIT_DONE, or the exit
 * code after a message on stderr. The file must be closed in either case. */
enum exit_code point_file_open(struct point_file *file, const char *name, const char *command, bool quiet,
                               const char *const *extra, const char *const *columns);
void point_file_close(struct point_file *file);

/* Reads the next row: the point is base, changed by the row. Returns false at the end of the file, or if it cannot be
 * read (tsv_error of file->tsv). */
bool point_file_next(struct point_file *file, struct sweep_place *place, const struct point *base);
/* Returns the number of rows of the file. */
long point_file_count(const char *name);
/* Returns the approximate number of rows, from the size of those already read; 0: unknown. */
long point_file_rows(const struct point_file *file, long read);

#endif
