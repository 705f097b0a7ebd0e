/* Which columns of a table of h and err are which. */
#ifndef SCALLOP_COMPARE_ORDER_COLUMNS_H
#define SCALLOP_COMPARE_ORDER_COLUMNS_H

#include <stdbool.h>

#include "compare/text/tsv.h"

enum { MOST_Y = 64, MOST_LISTS = 16, COLUMN_NAME = 100 };

/* Which columns are read: names in the header, or numbers from 1. */
struct columns_wanted {
  /* NULL: h, and where no column has this name the first one that has a name */
  const char *x;
  /* lists with commas between names; where there is none: err, error or value, and where none has such a name each
   * right of x that holds numbers, but for noise and for orders */
  const char *y[MOST_LISTS];
  int ys;      /* how many lists                                                                               */
  bool values; /* y are values; without it, only a column of this name                                         */
};

struct layout {
  int columns;   /* of a row                                          */
  int x, noise;  /* their places; -1: there is none                   */
  int y[MOST_Y]; /* likewise                                          */
  bool values[MOST_Y];
  int ys; /* how many                                          */
};

/* A number as in C; unlike an option's it may be nan or inf. */
bool read_cell(const char *text, double *value);

/* The columns, from the header of the table or, where it has none, from the number of columns; the current row is the
 * first one with data. Returns NULL, or what is wrong; the message lives until the next call. */
const char *columns_find(struct layout *layout, const struct tsv *t, const struct columns_wanted *wanted);

/* What is wrong with a row of other than so many columns; likewise. */
const char *columns_differ(const struct tsv *t, int columns);

/* The name of a column: its number where there is no header. */
void column_name(char name[COLUMN_NAME], const struct tsv *t, int column);

#endif
