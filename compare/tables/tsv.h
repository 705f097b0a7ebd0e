/* Tables as text, one row at a time, as programs and people write them: the cells of a row between tabs, commas,
 * semicolons, blanks or |, or the members of a JSON object (a row is a line), or the records of an array of NumPy.
 *
 * The first row settles what separates the cells. Empty lines, lines that begin with # or %, and Markdown's line of
 * dashes are passed over; lines end with LF, CRLF or CR; a byte order mark at the head is dropped. A line of more than
 * a million characters, or with a NUL byte, is a row with a fault; one that is too long is the last. */
#ifndef SCALLOP_COMPARE_TABLES_TSV_H
#define SCALLOP_COMPARE_TABLES_TSV_H

#include <stdbool.h>
#include <stdio.h>

enum { TSV_CELLS = 256, TSV_MESSAGE = 480, LONGEST_LINE = 1 << 20 };

enum tsv_style {
  TSV_POINTS, /* the first row names the columns; between tabs each byte belongs to a cell */
  TSV_ANY     /* there may be no names; blanks and quotes around a cell are not part of it */
};

struct tsv {
  FILE *file;
  const char *name; /* of the file, for messages */
  enum tsv_style style;
  char separator;    /* '\t', ',', ';', ' ', '|' or '{' for JSON; 0: there is no row yet */
  long number;       /* of the current line, from 1 */
  int error;         /* why the file cannot be read, where it cannot; else 0 */
  const char *fault; /* of the current row: why it cannot be read, or NULL */
  int count;         /* cells of the current row */
  char *cell[TSV_CELLS];
  int columns;                       /* that have names, 0: none has */
  const char *column[TSV_CELLS + 1]; /* NULL-terminated */
  bool had_comma[TSV_CELLS];         /* of the current row: tsv_number has taken its comma for a point */
  bool commas, points;               /* numbers have had decimal commas, decimal points         */
  bool waits;                        /* the current row is still to be given                    */
  bool after_first;                  /* a row below the names has been read                     */
  bool runs;                         /* several separators are one                              */
  char *header;                      /* what the names point into                               */
  char *comment;                     /* the last one before the first row, which may name them  */
  char *buffer;                      /* the current line        */
  size_t length;                     /* of what was read of it  */
  bool ended_by_return;              /* likewise                */
  struct npy_file *npy;              /* a file of NumPy, which is read by: else NULL */
  bool (*next_record)(struct tsv *);
  void (*close_npy)(struct npy_file *);
};

/* Opens a file, or for "-" standard input, and reads the names of its columns: the first row, if its first cell is no
 * number, else the comment above, if it has as many words. In a name a unit in brackets is left out, but where another
 * column has the same name. False: tsv_error says why. Whichever it is, tsv_close ends it. */
bool tsv_open(struct tsv *tsv, const char *file, enum tsv_style style);
/* The same for a text, of style TSV_ANY; name is for messages. */
bool tsv_open_text(struct tsv *tsv, const char *name, const char *text);
void tsv_close(struct tsv *tsv);

/* Goes on to the next row, and splits it unless it has a fault. False: there is none, or the file cannot be read
 * (tsv_error). */
bool tsv_next(struct tsv *tsv);
/* Passes over so many rows. */
void tsv_skip(struct tsv *tsv, long rows);
/* "cannot read FILE: why", or NULL. */
const char *tsv_error(struct tsv *tsv);

/* The text of a cell, a number's as C writes it: a decimal comma is a point where commas separate no cells, Fortran's D
 * an e. A table with decimal commas and decimal points gets a fault. */
const char *tsv_number(struct tsv *tsv, int column);
/* Does a cell say that there is no value? It is empty, -, NA, n/a or null. */
bool tsv_is_missing(const char *cell);
/* What the table was taken for, for a note: "columns between semicolons, decimal commas". */
const char *tsv_taken_for(const struct tsv *tsv, char text[80]);

/* "FILE:LINE: text", or "FILE: text" for line 0: a wrong_text. */
const char *tsv_at_line(struct tsv *tsv, long line, const char *format, ...)
    __attribute__((format(printf, 3, 4), returns_nonnull));
/* The same of the current row. */
#define tsv_at(tsv, ...) tsv_at_line((tsv), (tsv)->number, __VA_ARGS__)

#endif
