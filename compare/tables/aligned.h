/* Text for people. Cells are kept, and printed in columns of equal width; a single row is printed upright, its long
 * texts in several lines. Of a long table the first ALIGNED_ROWS rows decide how wide columns are and which hold
 * numbers; further rows come in blocks of as many, and a column is wider from the block on that needs it. */
#ifndef SCALLOP_COMPARE_TABLES_ALIGNED_H
#define SCALLOP_COMPARE_TABLES_ALIGNED_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* What a column is, for people: its unit, "" where there is none, and a sentence, which is the legend below columns of
 * symbols. NULL: nothing is known of it. */
struct column_meaning {
  const char *unit, *sentence;
  bool has_symbols;
  const char *between; /* of a text of parts with " | " between: what that stands for; else NULL */
};
typedef const struct column_meaning *column_meaning(const char *name);

enum { TABLE_COLUMNS = 384, ALIGNED_ROWS = 1000 };
struct aligned {
  FILE *kept; /* cells of rows that are not yet printed, each ended by a NUL; NULL: there are none */
  char *text; /* what it writes to                                                               */
  size_t size;
  long rows;      /* that are kept, with that of the names */
  bool has_begun; /* some rows are printed  */
  bool gathers;   /* of a table in one block the columns that are the same in every row are put into its head */
  bool upright;   /* each row is printed upright, without cells that are "-" */
  int columns;
  struct aligned_column {
    struct column_meaning meaning;
    int width;
    bool is_number, has_parts; /* it is on the right; some text has several */
  } column[TABLE_COLUMNS];
};

/* Where the cells of another row are to be written, each with a NUL behind it; the first row is of names. NULL: out of
 * memory. */
FILE *aligned_begin_row(struct aligned *a, int columns);
/* Is a whole block of rows kept, to be printed? */
static inline bool aligned_is_full(const struct aligned *a) { return a->rows > ALIGNED_ROWS - a->has_begun; }
/* Prints the rows that are kept, of columns of these names. last: the legend behind them, and forgets all; else more
 * rows are to come. meaning may be NULL. False: memory ran out. */
bool aligned_print(struct aligned *a, const char *const *names, FILE *file, column_meaning *meaning, bool last);
void aligned_free(struct aligned *a);

#endif
