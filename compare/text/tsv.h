/* Tables as text: TSV files, or columns between blanks, one row at a time; a file of NumPy is read as such a table,
 * whose lines are its records.
 *
 * Comments (lines that begin with #) and empty lines are passed over; lines end with LF, CRLF or CR; a byte order mark
 * at the head is dropped. A line of more than a million characters, or with a NUL byte, is a row with a fault; one that
 * is too long is the last. */
#ifndef SCALLOP_COMPARE_TEXT_TSV_H
#define SCALLOP_COMPARE_TEXT_TSV_H

#include <stdbool.h>
#include <stdio.h>

enum { TSV_CELLS = 256, TSV_MESSAGE = 480, LONGEST_LINE = 1 << 20 };

enum tsv_style {
  TSV_TABS, /* each tab ends a cell                                                                            */
  /* cells stand between any number of tabs, or of blanks where a line has no tab; blanks around them are none of
   * theirs */
  TSV_WORDS,
  /* the same, but in a line without a tab and with a comma each comma ends a cell, which may be empty */
  TSV_ANY
};

struct tsv {
  FILE *file;
  const char *name; /* of the file, for messages */
  enum tsv_style style;
  long number;       /* of the current line, from 1 */
  int error;         /* why the file cannot be read, where it cannot; else 0 */
  const char *fault; /* of the current row: why it cannot be read, or NULL */
  int count;         /* cells of the current row */
  char *cell[TSV_CELLS];
  int columns;                       /* of the header, 0: none was read */
  const char *column[TSV_CELLS + 1]; /* NULL-terminated */
  char *header;                      /* what they point into */
  char *buffer;                      /* the current line        */
  size_t length;                     /* of what was read of it  */
  bool ended_by_return;              /* likewise                */
  struct npy_file *npy;              /* a file of NumPy; else NULL */
  const char *wrong;                 /* with that, or NULL         */
};

/* Opens a file, or for "-" standard input. False: tsv_error says why. Whichever it is, tsv_close ends it. */
bool tsv_open(struct tsv *tsv, const char *file, enum tsv_style style);
/* The same for a text; name is for messages. */
bool tsv_open_text(struct tsv *tsv, const char *name, const char *text);
void tsv_close(struct tsv *tsv);

/* Goes on to the next row, and splits it unless it has a fault. False: there is none, or the file cannot be read
 * (tsv_error). */
bool tsv_next(struct tsv *tsv);
/* Passes over so many rows. */
void tsv_skip(struct tsv *tsv, long rows);
/* "cannot read FILE: why", or NULL. */
const char *tsv_error(struct tsv *tsv);

/* Takes the current row as the header: names of columns, without blanks and quotes around them. False: out of memory */
bool tsv_take_header(struct tsv *tsv);

/* "FILE:LINE: text", or "FILE: text" for line 0: a wrong_text. */
const char *tsv_at_line(struct tsv *tsv, long line, const char *format, ...)
    __attribute__((format(printf, 3, 4), returns_nonnull));
/* The same of the current row. */
#define tsv_at(tsv, ...) tsv_at_line((tsv), (tsv)->number, __VA_ARGS__)

#endif
