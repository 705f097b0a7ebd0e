/* A table for people: cells are kept, and printed in columns of equal width; a single row is printed upright, its long texts in
 * several lines. */
#ifndef SCALLOP_ALIGNED_H
#define SCALLOP_ALIGNED_H

#include <stdbool.h>
#include <stdio.h>

/* What a column is, for people: its unit, "" where there is none, and a sentence, which is the legend below columns of symbols. NULL: nothing
 * is known of it. */
struct column_meaning {
  const char *unit, *sentence;
  bool has_symbols;
};
typedef const struct column_meaning *column_meaning(const char *name);

struct aligned {
  char **cells;
  int columns;
  long count;   /* cells */
  bool is_open; /* a cell that has not ended */
  bool lost;    /* memory ran out */
};

/* Keeps a copy of a cell, part after part, until it ends. */
void aligned_put(struct aligned *a, const char *text, size_t size);
void aligned_end_cell(struct aligned *a);
/* Prints what was kept: the names of the columns are its first row. Forgets it. meaning may be NULL. False: memory ran out. */
bool aligned_print(struct aligned *a, FILE *file, column_meaning *meaning);
void aligned_free(struct aligned *a);

#endif
