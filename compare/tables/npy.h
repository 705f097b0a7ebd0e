/* Files of NumPy: structured arrays with a record for each row; numpy.load can map them to memory.
 *
 * A column of numbers has doubles. A column with a text has texts, padded with zeros to a power of two, at least 8
 * bytes; numbers in it become texts (then at least 32 bytes). A longer text widens the file in place; the result
 * depends only on the rows, not on their order or the number of threads. The head has a fixed length and is written
 * last; it contains the '#' lines behind its dictionary. */
#ifndef SCALLOP_COMPARE_TABLES_NPY_H
#define SCALLOP_COMPARE_TABLES_NPY_H

#include <stdbool.h>
#include <stdio.h>

#include "compare/tables/aligned.h"

/* A cell of a row: a number, the text of a number, a text, or a cell copied from another table */
enum cell_kind { CELL_NUMBER, CELL_DIGITS, CELL_TEXT, CELL_CARRIED };
struct table_cell {
  enum cell_kind kind;
  double value; /* of a number; nan: only the text has it */
  char *text;   /* of all kinds except CELL_NUMBER */
  size_t room;  /* allocated size of text */
};

struct npy { /* rows in memory, or in a file */
  int columns;
  int width[TABLE_COLUMNS]; /* bytes of a text; 0: a double; -1: before the first row */
  size_t size;              /* of a record */
  long rows;
  char *records; /* in memory */
  long room;     /* allocated rows */
};

void npy_begin(struct npy *n, int columns);
void npy_free(struct npy *n);
/* Adds a row. digits: of doubles; 0: all. Returns 0 or an error as in errno, like the functions below. */
int npy_row(struct npy *n, const struct table_cell *cells, long digits);
/* Adds rows of doubles. Returns the memory to write them to; NULL: out of memory, or a column has texts. */
double *npy_doubles(struct npy *n, long rows);
/* Moves rows from memory to the end of a file with a head of `head` bytes. */
int npy_move(struct npy *file, FILE *to, long head, struct npy *from);
/* Returns a size of the head that suffices for all widths of columns; writes the head. notes: '#' lines, or NULL */
long npy_head_size(const char *const *names, int columns, const char *notes);
int npy_write_head(const struct npy *file, FILE *to, long head, const char *const *names, const char *notes);

/* An array that is read record by record (npy_read.c) */
struct npy_file {
  FILE *file;
  char *head;  /* its text, with NULs between parts */
  char *notes; /* the '#' lines, within head */
  long rows, head_size;
  int columns;
  size_t size; /* of a record */
  struct npy_column {
    char *name, kind; /* f i u S U; V: padding between columns */
    int size;
    bool is_big; /* big-endian */
  } column[TABLE_COLUMNS];
  char *record;
};

/* Reads the head; is_begun: the first byte is already read. Returns NULL or the error of the file, valid until the next
 * call. The array must be closed in either case. */
const char *npy_open(struct npy_file *npy, FILE *file, bool is_begun);
/* Reads the next record: writes its numbers and texts, as in a table and each ended by a NUL, to space of `size` bytes,
 * and their addresses to cells. Returns the number of cells; -1: end of file, or the space is too small. */
int npy_next(struct npy_file *npy, char *space, size_t size, char **cells);
void npy_close(struct npy_file *npy);

#endif
