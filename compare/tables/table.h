/* Tables: TSV with '#' lines on top, JSON with one object a line, CSV, Markdown, or aligned for people, to standard
 * output, to a file that appears when it is complete (compare/text/file.h), or to a pipe or a device. */
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

/* FORMAT_TABLE: aligned, for people (aligned.h), with 6 significant digits: what a terminal gets where no format is
 * given */
enum format { FORMAT_TSV, FORMAT_JSON, FORMAT_CSV, FORMAT_MARKDOWN, FORMAT_TABLE, FORMAT_NPY, FORMATS };
enum { PEOPLE_DIGITS = 6 };
extern const char *const format_names[FORMATS + 1]; /* NULL-terminated */
extern const char no_npy_to_pipe[];                 /* what is said of a FORMAT_NPY there */

/* A choice of columns (compare/columns): what it shows of each row takes the place of the row. */
struct table_choice {
  /* The names of the columns that the table has, which outlive it. NULL, or what is wrong with the choice. */
  const char *(*begin)(struct table_choice *choice, const char *const *columns, int count);
  /* The cells that are shown of a row, count of them */
  void (*show)(struct table_choice *choice, const struct table_cell *row, struct table_cell *shown);
  const char *const *names; /* of the columns that are shown, after begin */
  int count;
  bool refused; /* it names what the table has not: the command ends with EXIT_USAGE */
};

/* How a command writes its table. */
struct style {
  const char *command; /* its name, for messages */
  const char *output;  /* NULL: standard output */
  enum format format;
  long digits; /* significant ones; 0: as many as read back exactly */
  bool quiet;
  bool has_output, has_format; /* are given */
  bool chosen;                 /* the columns are: people get these */
  bool upright;                /* an aligned table has its rows one by one, each upright */
  column_meaning *meaning;     /* of columns, for people, or NULL */
  struct table_choice *choice; /* NULL: all columns */
  struct plot plot;            /* a picture of what is written; of file NULL: none */
};

struct table {
  const struct style *style;
  const char *of; /* what kind of table its picture is of: the command, where that does not say another */
  struct sink {   /* the output, and a copy in TSV of which a picture is drawn */
    struct file out;
    enum format format;
    long digits;
    struct aligned aligned;  /* rows of a FORMAT_TABLE */
    struct npy kept, stored; /* rows of a FORMAT_NPY: in memory, and in the file */
    char *notes;             /* likewise: '#' lines of its head */
    long head;               /* likewise: the size of that      */
    int error;               /* of the first write that failed */
    struct {                 /* the last number of each column, as it is written: many columns change seldom */
      bool is_there;
      double value;
      char text[NUMBER_TEXT];
    } last[TABLE_COLUMNS];
    char *text; /* of a part: what is written      */
    size_t size;
  } sink[2];
  int sinks;
  bool is_part; /* of another table, in memory */
  char *notes;  /* '#' lines that wait until the choice of columns is found good */
  const char *columns[TABLE_COLUMNS];
  int count, at;                        /* columns; the next one in this row */
  int only_drawn;                       /* of the columns the last ones, which are for the picture alone */
  struct table_cell row[TABLE_COLUMNS]; /* so far                            */
  const char *const *names;             /* of the columns that are written, once rows have begun */
};

/* Opens the output of the style, which must outlive the table; if it has a plot, the rows are kept in TSV too, beside
 * the picture, until table_close. False: the message is on stderr, exit with EXIT_FILE. */
bool table_open(struct table *table, const struct style *style);
/* What all tables begin with: "# scallop VERSION" and "# command: ...", as printf writes it; table_head opens it too.
 */
#define table_command(table, ...) \
  (table_note((table), "scallop " SCALLOP_VERSION), table_note((table), "command: " __VA_ARGS__))
#define table_head(table, style, ...) (table_open((table), (style)) && (table_command((table), __VA_ARGS__), true))
/* Will the table be an aligned one? */
bool table_is_for_people(const struct style *style);
/* A '#' line before the columns or after the rows of a TSV or an aligned table; nothing in the other formats. */
void table_note(struct table *table, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* The header row: NULL-terminated names, which must outlive the table. May be called in parts. */
void table_columns(struct table *table, const char *const *names);
/* A choice of columns that are not there is refused on stderr, with nothing else written: the table has then failed. */
void table_begin_rows(struct table *table);

/* The cells of a row in the order of the columns. A row ends by itself with its last cell. */
void table_number(struct table *table, double value);
void table_count(struct table *table, long count);
void table_rounded(struct table *table, double value, const char *format); /* fewer digits, always */
void table_digits(struct table *table, const char *number);                /* a number as it stands, of any length */
void table_text(struct table *table, const char *text);
void table_carried(struct table *table, const char *text); /* of another table: in JSON a number where it is one */
/* So many rows of doubles, columns[i] being the column i. False: nothing is written, as a column is NULL, or the output
 * takes cells one by one. */
bool table_doubles(struct table *table, const double *const *columns, long rows);

/* A part of a table whose rows have begun, in memory: rows that are written into it, by whichever thread, become rows
 * of the table when they are joined, and the part is empty again. table_abandon ends it. False: out of memory. */
bool table_part(struct table *part, const struct table *table);
void table_join(struct table *table, struct table *part);

/* A table as a list of columns, each with its name and what it writes of a row; the last has name NULL. put writes one
 * cell. The functions below take the member of the row that lies `at`: { TABLE_COLUMN("order", column_number,
 * offsetof(struct row, order)) }; another may take `at` for what it likes. */
struct table_column {
  const char *name;
  void (*put)(struct table *table, const struct table_column *column, const void *row);
  size_t at;
  const char *format; /* of column_rounded */
  const char *blank;  /* in a row that has no values, "nan" for a number; NULL: put writes it there too */
};
#define TABLE_COLUMN(named, puts, where) .name = (named), .put = (puts), .at = (where)
void column_number(struct table *table, const struct table_column *column, const void *row);  /* a double       */
void column_rounded(struct table *table, const struct table_column *column, const void *row); /* likewise       */
void column_count(struct table *table, const struct table_column *column, const void *row);   /* an int         */
void column_long(struct table *table, const struct table_column *column, const void *row);    /* a long         */
void column_text(struct table *table, const struct table_column *column, const void *row);    /* a const char * */
/* The names of these columns, behind those that the table has. */
void table_add(struct table *table, const struct table_column *columns);
/* The cells of these columns. solved: the row has values. */
void table_row(struct table *table, const struct table_column *columns, const void *row, bool solved);

/* The columns begin anew, for a row of another kind behind all others. False: no row of this format can have columns of
 * its own, or columns are chosen. */
bool table_begin_anew(struct table *table);
/* Where the table is aligned, for people: a row that is written as a page, to this stream, instead of its cells; what
 * was kept of the row is forgotten. NULL: the table has another format, or columns are chosen. */
FILE *table_page(struct table *table);
/* Has writing failed already? Then nothing more is worth its time: table_close says why. */
bool table_failed(const struct table *table);
/* Writes out what has been kept back, to the disk. False: writing has failed. */
bool table_flush(struct table *table);
/* Closes, puts the file in its place, and draws the plot of the style. False: the message is on stderr, exit with
 * EXIT_FILE; an earlier file stays, but where only the picture has failed the table is written. */
bool table_close(struct table *table);
/* Gives the output up: nothing is left behind. */
void table_abandon(struct table *table);

#endif
