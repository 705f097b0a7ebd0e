/* Lines of a text file, one at a time. */
#ifndef SCALLOP_LINES_H
#define SCALLOP_LINES_H

#include <stdbool.h>
#include <stdio.h>
#include <sys/types.h>

enum { LONGEST_LINE = 1 << 20 }; /* bytes; what is no text may hold no line end at all */

struct lines {
  FILE *file;           /* of which nothing was read yet, and which nothing else reads meanwhile; NULL: a text */
  char *line;           /* the current one, without its end; may be written to                */
  ssize_t length;       /* of it                                                              */
  long number;          /* from 1                                                             */
  int error;            /* why the file cannot be read, where it cannot; else 0               */
  bool too_long;        /* the current line, and it is the last                                 */
  bool ended_by_return; /* the current line, by a CR                                          */
  char *buffer;         /* what has been read, and from begin to end is still to come         */
  size_t begin, end, size;
};

/* Goes on to the next line, without its end (LF, CRLF or CR) and without a byte order mark at the head of the file. A line that is
 * too long is cut to LONGEST_LINE bytes, and is the last. False at the end, or where the file
 * cannot be read (error). */
bool next_line(struct lines *lines);
/* The lines of a text, of which a copy is kept. False: out of memory. */
bool lines_of_text(struct lines *lines, const char *text);
void lines_free(struct lines *lines);

/* What to say of error. */
const char *lines_error_text(const struct lines *lines);

/* Why the current line is no line of a text file (it holds a NUL byte, or is too long), or NULL. */
const char *line_fault(const struct lines *lines);

/* The cells of a line between tabs, which become NULs: at most `most` of them. Returns how many. */
int lines_cells(char *line, char **cells, int most);

#endif
