/* Lines of a text file, one at a time. */
#ifndef SCALLOP_LINES_H
#define SCALLOP_LINES_H

#include <stdbool.h>
#include <stdio.h>
#include <sys/types.h>

struct lines {
  FILE *file;
  char *line; /* the current one, without its end; free it when done */
  size_t size;
  ssize_t length;
  long number; /* from 1                                              */
  int error;   /* why the file cannot be read, where it cannot        */
};

/* Goes on to the next line, without its end (LF or CRLF) and without a byte order mark at the head of the file.
 * False at the end, or where the file cannot be read (ferror). */
bool next_line(struct lines *lines);

/* Does the current line hold a NUL byte? */
bool is_binary(const struct lines *lines);

/* The cells of a line between tabs, which become NULs: at most `most` of them. Returns how many. */
int lines_cells(char *line, char **cells, int most);

#endif
