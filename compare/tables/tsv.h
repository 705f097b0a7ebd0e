/* Input of tables, row by row: cells between tabs, commas, semicolons, blanks or |, or the members of a JSON object,
 * with a row on each line; or the records of an array of NumPy.
 *
 * The first row decides the separator. Empty lines, lines that begin with # or %, and Markdown's line of dashes are
 * skipped; lines end with LF, CRLF or CR; a byte order mark at the head is ignored. A line of more than a million
 * characters, or with a NUL byte, is a row with a fault; reading ends at a line that is too long. */
#ifndef SCALLOP_COMPARE_TABLES_TSV_H
#define SCALLOP_COMPARE_TABLES_TSV_H

#include <stdbool.h>
#include <stdio.h>

enum { TSV_CELLS = 256, TSV_MESSAGE = 480, LONGEST_LINE = 1 << 20 };

enum tsv_style {
  TSV_POINTS, /* the first row names the columns; between tabs each byte belongs to a cell */
  TSV_ANY     /* names are optional; blanks and quotes around a cell are not part of it */
};

struct tsv {
  FILE *file;
  const char *name; /* of the file, for messages */
  enum tsv_style style;
  char separator;    /* '\t', ',', ';', ' ', '|' or '{' for JSON; 0: before the first row */
  long number;       /* of the current line, from 1 */
  int error;         /* why the file cannot be read, as in errno; else 0 */
  const char *fault; /* why the current row cannot be read, or NULL */
  int count;         /* number of cells of the current row */
  char *cell[TSV_CELLS];
  int columns;                       /* number of columns with names, or 0 */
  const char *column[TSV_CELLS + 1]; /* NULL-terminated */
  bool had_comma[TSV_CELLS];         /* tsv_number has replaced a decimal comma in the cell of the current row */
  bool commas, points;               /* numbers so far have decimal commas, decimal points */
  bool waits;                        /* tsv_next will return the current row */
  bool after_first;                  /* a row below the names has been read */
  bool runs;                         /* several separators count as one */
  char *header;                      /* memory of the names */
  char *comment;                     /* the last comment before the first row; it may name the columns */
  char *buffer;                      /* the current line */
  size_t length;                     /* number of bytes read of it */
  bool ended_by_return;              /* it ended by CR */
  struct npy_file *npy;              /* an array of NumPy, or NULL; the functions read and close it */
  bool (*next_record)(struct tsv *);
  void (*close_npy)(struct npy_file *);
};

/* Opens a file, "-" for standard input, and reads the names of its columns: the first row, if its first cell is not a
 * number, else the comment above, if it has the same number of words. A unit in brackets is removed from a name, unless
 * another column has the same name. Returns false on failure (tsv_error). tsv_close is needed in either case. */
bool tsv_open(struct tsv *tsv, const char *file, enum tsv_style style);
/* Opens a text, in style TSV_ANY; name: for messages. */
bool tsv_open_text(struct tsv *tsv, const char *name, const char *text);
void tsv_close(struct tsv *tsv);

/* Reads the next row, and splits it unless it has a fault. Returns false at the end, or if the file cannot be read
 * (tsv_error). */
bool tsv_next(struct tsv *tsv);
/* Skips rows. */
void tsv_skip(struct tsv *tsv, long rows);
/* Returns "cannot read FILE: why", or NULL. */
const char *tsv_error(struct tsv *tsv);

/* Returns the text of a cell; a number in C's notation: a decimal comma becomes a point unless commas separate cells,
 * and Fortran's D an e. A table with decimal commas and decimal points gets a fault. */
const char *tsv_number(struct tsv *tsv, int column);
/* Returns true if the value of a cell is missing: it is empty, -, NA, n/a or null. */
bool tsv_is_missing(const char *cell);
/* Writes the detected format for a note: "columns between semicolons, decimal commas". Returns text. */
const char *tsv_format_text(const struct tsv *tsv, char text[80]);

/* Formats "FILE:LINE: text", or "FILE: text" for line 0 (a wrong_text). */
const char *tsv_at_line(struct tsv *tsv, long line, const char *format, ...)
    __attribute__((format(printf, 3, 4), returns_nonnull));
/* tsv_at_line for the current row */
#define tsv_at(tsv, ...) tsv_at_line((tsv), (tsv)->number, __VA_ARGS__)

#endif
