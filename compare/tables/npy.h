/* Files of NumPy: a structured array, a record for each row, which numpy.load opens without reading it.
 *
 * Doubles are doubles. A column in which some row has a text is one of texts, each filled up with zeros to a power of
 * two of bytes, at least 8; numbers in it are written out (then at least 32). So what a file looks like depends on its
 * rows alone, and not on their order or on how they were shared out: it is widened in place where a longer text comes.
 * The head has a fixed length, and is written last. '#' lines stand in it as comments, behind its dictionary. */
#ifndef SCALLOP_COMPARE_TABLES_NPY_H
#define SCALLOP_COMPARE_TABLES_NPY_H

#include <stdbool.h>
#include <stdio.h>

#include "compare/tables/aligned.h"

/* A cell of a row: a number, a number as it stands, a text, or a cell of another table */
enum cell_kind { CELL_NUMBER, CELL_DIGITS, CELL_TEXT, CELL_CARRIED };
struct table_cell {
  enum cell_kind kind;
  double value; /* of a number; nan: only the text says it */
  char *text;   /* of all but CELL_NUMBER */
  size_t room;  /* of text                */
};

struct npy { /* rows in memory, or in a file */
  int columns;
  int width[TABLE_COLUMNS]; /* bytes of a text; 0: a double; -1: no row has come yet */
  size_t size;              /* of a record */
  long rows;
  char *records; /* in memory, of so many rows */
  long room;
};

void npy_begin(struct npy *n, int columns);
void npy_free(struct npy *n);
/* Adds a row. Returns 0 or an error as in errno, like all of the following. digits: of doubles; 0: all */
int npy_row(struct npy *n, const struct table_cell *cells, long digits);
/* Where the next rows are to be written, columns of doubles, which then count; NULL: no memory, or a column is none. */
double *npy_doubles(struct npy *n, long rows);
/* The same for a file whose head takes so many bytes: moves the rows behind its own. */
int npy_move(struct npy *file, FILE *to, long head, struct npy *from);
/* Bytes of the head, whatever its columns become, and the head, of that length. notes: '#' lines, or NULL */
long npy_head_size(const char *const *names, int columns, const char *notes);
int npy_write_head(const struct npy *file, FILE *to, long head, const char *const *names, const char *notes);

/* npy_read.c: an array that is read, record by record */
struct npy_file {
  FILE *file;
  char *head;  /* its text, cut apart; the '#' lines begin behind it */
  char *notes; /* likewise */
  long rows, head_size;
  int columns;
  size_t size; /* of a record */
  struct npy_column {
    char *name, kind; /* f i u S U, V: what lies between columns */
    int size;
    bool is_big; /* its first byte is the greatest */
  } column[TABLE_COLUMNS];
  char *record;
};

/* Reads the head, from where the file begins, or behind the first byte. NULL, or what is wrong with the file, until the
 * next call: it is to be closed in either case. */
const char *npy_open(struct npy_file *npy, FILE *file, bool is_begun);
/* Reads the next record: its numbers and texts as they are written in a table, each ended by a NUL, into the space,
 * which is large enough for columns of so many bytes; where they begin into cells. Returns how many there are, without
 * what lies between; -1: the file is at its end. */
int npy_next(struct npy_file *npy, char *space, size_t size, char **cells);
void npy_close(struct npy_file *npy);

#endif
