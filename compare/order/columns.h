/* Which columns of a table of h and err are which. */
#ifndef SCALLOP_ORDER_COLUMNS_H
#define SCALLOP_ORDER_COLUMNS_H

#include "compare/order/series.h"
#include "compare/text/tsv.h"

enum { MOST_Y = 64, COLUMN_NAME = 100 };

struct layout {
  int columns;   /* of a row                                          */
  int x, noise;  /* their places; -1: there is none                   */
  int y[MOST_Y]; /* likewise                                          */
  bool values[MOST_Y];
  int ys; /* how many                                          */
};

/* A number as in C; unlike an option's it may be nan or inf. */
bool read_cell(const char *text, double *value);

/* The columns, from the header of the table or, where it has none, from the number of columns; the current row is the first one with
 * data. Returns NULL, or what is wrong; the message lives until the next call. */
const char *columns_find(struct layout *layout, const struct tsv *t, const struct columns_wanted *wanted);

/* The name of a column: its number where there is no header. */
void column_name(char name[COLUMN_NAME], const struct tsv *t, int column);

#endif
