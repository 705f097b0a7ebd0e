/* Text for people. A table: cells are kept, and printed in columns of equal width; a single row is printed upright, its
 * long texts in several lines. Of a long table the first ALIGNED_ROWS rows decide how wide columns are and which hold
 * numbers; further rows come in blocks of as many, and a column is wider from the block on that needs it. And prose, in
 * the columns of the terminal. */
#ifndef SCALLOP_COMPARE_TEXT_ALIGNED_H
#define SCALLOP_COMPARE_TEXT_ALIGNED_H

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>

/* What a column is, for people: its unit, "" where there is none, and a sentence, which is the legend below columns of
 * symbols. NULL: nothing is known of it. */
struct column_meaning {
  const char *unit, *sentence;
  bool has_symbols;
  const char *between; /* of a text of parts with " | " between: what that stands for; else NULL */
};
typedef const struct column_meaning *column_meaning(const char *name);

enum { ALIGNED_ROWS = 1000 };
struct aligned {
  char **cells;                  /* the names of the columns, and rows that are not yet printed */
  struct aligned_column *column; /* NULL: nothing is printed yet                                */
  int columns;
  long count;   /* cells */
  bool is_open; /* a cell that has not ended */
  bool lost;    /* memory ran out */
};

/* Keeps a copy of a cell, part after part, until it ends. */
void aligned_put(struct aligned *a, const char *text, size_t size);
void aligned_end_cell(struct aligned *a);
/* Is a whole block of rows kept, to be printed? */
bool aligned_is_full(const struct aligned *a);
/* Prints what was kept: the names of the columns are its first row. last: the legend behind it, and forgets all; else
 * more rows are to come. meaning may be NULL. False: memory ran out. */
bool aligned_print(struct aligned *a, FILE *file, column_meaning *meaning, bool last);
void aligned_free(struct aligned *a);

/* The columns of a terminal; 0: the file is none, or does not tell. */
int wrap_width(FILE *file);

/* Writes lines in so many columns (0: as they are), broken at blanks; a word that is longer stays whole. A line goes on
 * below its last part that stands behind two blanks or more, or below its first word where little room is left there.
 * full: of lines that were broken at this width already a line is joined with the one before, if that had no room for
 * its first word; 0: none is. False: writing failed. */
bool wrap_lines(FILE *to, const char *text, int width, int full);

/* A stream that keeps what is written, until wrap_end writes it to a file in the columns of the terminal that the file
 * is. NULL: out of memory. */
struct wrapped {
  FILE *file;
  char *text;
  size_t size;
};
FILE *wrap_begin(struct wrapped *wrapped);
bool wrap_end(struct wrapped *wrapped, FILE *to, int full);
/* "# NOTE" likewise */
bool wrap_note(FILE *to, const char *format, va_list arguments);

#endif
