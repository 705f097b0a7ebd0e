/* Output of tables: TSV with '#' lines on top, JSON lines, CSV, Markdown, NumPy, or aligned for terminals; to standard
 * output, to a file that is replaced atomically (compare/text/file.h), or to a pipe or a device. */
#ifndef SCALLOP_COMPARE_TABLES_TABLE_H
#define SCALLOP_COMPARE_TABLES_TABLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "compare/tables/aligned.h"
#include "compare/text/digits.h"
#include "compare/text/file.h"
#include "compare/tables/npy.h"
#include "compare/tables/plot.h"
#include "model/version.h"

/* FORMAT_TABLE: aligned (aligned.h), with 6 significant digits; the default on a terminal */
enum format { FORMAT_TSV, FORMAT_JSON, FORMAT_CSV, FORMAT_MARKDOWN, FORMAT_TABLE, FORMAT_NPY, FORMATS };
enum { ALIGNED_DIGITS = 6 };
extern const char *const format_names[FORMATS + 1]; /* NULL-terminated */
extern const char no_npy_to_pipe[];                 /* the error of FORMAT_NPY to a pipe */

/* A choice of columns (compare/columns); it replaces the cells of each row */
struct table_choice {
  /* Receives the names of the table's columns; they outlive the choice. Returns NULL or the error of the choice. */
  const char *(*begin)(struct table_choice *choice, const char *const *columns, int count);
  /* Computes the `count` cells shown for a row. */
  void (*show)(struct table_choice *choice, const struct table_cell *row, struct table_cell *shown);
  const char *const *names; /* of the shown columns, after begin */
  int count;
  bool refused; /* begin failed: the exit code is EXIT_USAGE */
};

/* The output options of a command */
struct style {
  const char *command; /* its name, for messages */
  const char *output;  /* NULL: standard output */
  enum format format;
  long digits; /* significant digits; 0: the fewest that read back exactly */
  bool quiet;
  bool has_output, has_format; /* output, format are given */
  bool chosen;                 /* columns are chosen: an aligned table keeps constant columns */
  bool upright;                /* an aligned table prints each row upright */
  column_meaning *meaning;     /* for aligned tables and plots, or NULL */
  struct table_choice *choice; /* NULL: all columns */
  struct plot plot;            /* of the table; plot.file NULL: no plot */
};

struct table {
  const struct style *style;
  const char *of; /* kind of the table for its plot; default: the command */
  struct sink {   /* the output, and a copy in TSV for the plot */
    struct file out;
    enum format format;
    long digits;
    struct aligned aligned;  /* rows of a FORMAT_TABLE */
    struct npy kept, stored; /* rows of a FORMAT_NPY: in memory, and in the file */
    char *notes;             /* FORMAT_NPY: '#' lines of its head */
    long head;               /* FORMAT_NPY: size of the head */
    int error;               /* of the first write that failed */
    struct {                 /* the last number of each column and its text, because many columns change rarely */
      bool is_there;
      double value;
      char text[NUMBER_TEXT];
    } last[TABLE_COLUMNS];
    char *text; /* the output of a part */
    size_t size;
  } sink[2];
  int sinks;
  bool is_part; /* a part of another table, in memory */
  char *notes;  /* '#' lines that are not yet written, because the choice of columns may be refused */
  const char *columns[TABLE_COLUMNS];
  int count, at;                        /* number of columns; index of the next cell */
  int only_drawn;                       /* number of last columns that only the plot has */
  struct table_cell row[TABLE_COLUMNS]; /* the current row */
  const char *const *names;             /* of the written columns, after table_begin_rows */
};

/* Opens the output of the style, for a plot also a copy in TSV beside the picture, until table_close. The style must
 * outlive the table. Returns false after a message on stderr; the exit code is EXIT_FILE. */
bool table_open(struct table *table, const struct style *style);
/* Writes the first lines of all tables: "# scallop VERSION" and "# command: ..." like printf; table_head also opens the
 * table. */
#define table_command(table, ...) \
  (table_note((table), "scallop " SCALLOP_VERSION), table_note((table), "command: " __VA_ARGS__))
#define table_head(table, style, ...) (table_open((table), (style)) && (table_command((table), __VA_ARGS__), true))
/* Returns true if the table will be aligned. */
bool table_is_aligned(const struct style *style);
/* Writes a '#' line before the columns or after the rows of a TSV or an aligned table; other formats have no such
 * lines, except the head of FORMAT_NPY. */
void table_note(struct table *table, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* Adds columns: NULL-terminated names; they must outlive the table. */
void table_columns(struct table *table, const char *const *names);
/* Writes the head. A choice of missing columns is refused on stderr, without other output, and the table fails. */
void table_begin_rows(struct table *table);

/* Write the cells of a row in the order of the columns. The last cell ends the row. */
void table_number(struct table *table, double value);
void table_count(struct table *table, long count);
void table_rounded(struct table *table, double value, const char *format); /* by format in all outputs */
void table_digits(struct table *table, const char *number);                /* the text of a number, of any length */
void table_text(struct table *table, const char *text);
void table_carried(struct table *table, const char *text); /* a cell of another table: in JSON a number if it is one */
/* Writes rows of doubles, of column i from columns[i]. Returns false, with nothing written, if a column is NULL or the
 * output needs single cells. */
bool table_doubles(struct table *table, const double *const *columns, long rows);

/* Begins a part of a table, in memory, after table_begin_rows; any thread may write to it, and table_abandon frees it.
 * Returns false if memory is short. table_join appends the rows of a part to the table and empties the part. */
bool table_part(struct table *part, const struct table *table);
void table_join(struct table *table, struct table *part);

/* A column of a table: its name, and the function that writes its cell of a row. The last column has name NULL. The
 * functions below write the member of the row at offset `at`: { TABLE_COLUMN("order", column_number,
 * offsetof(struct row, order)) }; others may use `at` differently. */
struct table_column {
  const char *name;
  void (*put)(struct table *table, const struct table_column *column, const void *row);
  size_t at;
  const char *format; /* of column_rounded */
  const char *blank;  /* the cell of a row without values, "nan" for a number; NULL: put writes it */
};
#define TABLE_COLUMN(named, puts, where) .name = (named), .put = (puts), .at = (where)
void column_number(struct table *table, const struct table_column *column, const void *row);  /* a double */
void column_rounded(struct table *table, const struct table_column *column, const void *row); /* a double */
void column_count(struct table *table, const struct table_column *column, const void *row);   /* an int */
void column_long(struct table *table, const struct table_column *column, const void *row);    /* a long */
void column_text(struct table *table, const struct table_column *column, const void *row);    /* a const char * */
/* Adds the columns to the table. */
void table_add(struct table *table, const struct table_column *columns);
/* Writes the cells of these columns. solved: the row has values. */
void table_row(struct table *table, const struct table_column *columns, const void *row, bool solved);

/* Removes all columns, for a last row with other columns. Returns false if the format does not allow such a row, or
 * columns are chosen. */
bool table_restart_columns(struct table *table);
/* Returns the stream of an aligned table, for a page in place of rows; discards the kept rows. NULL: the table has
 * another format, or columns are chosen. */
FILE *table_page(struct table *table);
/* Returns true if writing has failed; table_close prints why. */
bool table_failed(const struct table *table);
/* Flushes the output to the disk. Returns false if writing has failed. */
bool table_flush(struct table *table);
/* Closes the table, replaces the file, and draws the plot. Returns false after a message on stderr, with the exit code
 * EXIT_FILE: the earlier file remains; if only the plot failed the table is written. */
bool table_close(struct table *table);
/* Discards the output. */
void table_abandon(struct table *table);

#endif
