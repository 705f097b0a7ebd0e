/* Tables in aligned columns, for terminals. A single row is printed upright, with long texts on several lines. In a
 * long table the first ALIGNED_ROWS rows decide the widths of columns and which columns are numbers; further rows are
 * printed in blocks of ALIGNED_ROWS, and a block may widen a column. */
#ifndef SCALLOP_COMPARE_TABLES_ALIGNED_H
#define SCALLOP_COMPARE_TABLES_ALIGNED_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* The unit ("": dimensionless) and the description of a column; the legend prints the description of columns of
 * symbols. A column_meaning returns NULL for an unknown column. */
struct column_meaning {
  const char *unit, *sentence;
  bool has_symbols;
  const char *between; /* the meaning of " | " between parts of a text; else NULL */
};
typedef const struct column_meaning *column_meaning(const char *name);

enum { TABLE_COLUMNS = 384, ALIGNED_ROWS = 1000 };
struct aligned {
  FILE *kept; /* cells of rows that are not yet printed, each ended by a NUL; NULL: no such rows */
  char *text; /* the memory of kept */
  size_t size;
  long rows;      /* kept rows, including the names */
  bool has_begun; /* some rows are printed */
  bool gathers;   /* a table of one block has its constant columns in its head */
  bool upright;   /* print each row upright, without cells that are "-" */
  int columns;
  struct aligned_column {
    struct column_meaning meaning;
    int width;
    bool is_number, has_parts; /* numbers are right-aligned; a text has parts */
  } column[TABLE_COLUMNS];
};

/* Begins a row. Returns the stream for its cells, each followed by a NUL; the first row has the names. NULL: out of
 * memory. */
FILE *aligned_begin_row(struct aligned *a, int columns);
/* Returns true if a whole block of rows is kept. */
static inline bool aligned_is_full(const struct aligned *a) { return a->rows > ALIGNED_ROWS - a->has_begun; }
/* Prints the kept rows of the columns called names. last: prints the legend and resets the table; else more rows
 * follow. meaning may be NULL. Returns false if memory is short. */
bool aligned_print(struct aligned *a, const char *const *names, FILE *file, column_meaning *meaning, bool last);
void aligned_free(struct aligned *a);

#endif
