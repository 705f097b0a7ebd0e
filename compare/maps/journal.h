/* Rows of numbers that take long to compute, kept in a file as they come: the same command resumes from there.
 *
 * The first line is a title, with all that the numbers depend on; the journal of another computation is neither used
 * nor touched. Each further line has the number of a row, its numbers as hexadecimal doubles, and a checksum, so that a
 * damaged or half-written line is noticed: the journal ends before it. */
#ifndef SCALLOP_COMPARE_MAPS_JOURNAL_H
#define SCALLOP_COMPARE_MAPS_JOURNAL_H

#include <stdbool.h>
#include <stdio.h>

enum { JOURNAL_WIDTH = 96 }; /* numbers of a row, at most */

struct journal {
  long rows, done_count;
  int width;
  double *values; /* row by row */
  bool *done;
  char *path;   /* NULL: no file */
  FILE *stream; /* likewise */
  int error;    /* errno of the first write that failed, or 0 */
};

/* For so many rows of so many numbers, without a file. False: out of memory. To be closed in either case. */
bool journal_init(struct journal *journal, long rows, int width);
/* Takes the rows of OUTPUT.rows, and keeps further ones there. False: the message is on stderr, and the file stays as
 * it was. */
bool journal_open(struct journal *journal, const char *output, const char *title);
/* Adds a row, in one write; not for two threads at once. False: this or an earlier write failed. */
bool journal_add(struct journal *journal, long row, const double *values);
/* Closes the journal; done: and removes its file. */
void journal_close(struct journal *journal, bool done);

#endif
