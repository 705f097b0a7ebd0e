/* Tables: TSV with '#' lines on top, JSON with one object a line, CSV, Markdown, or aligned for people, to standard
 * output, to a file that appears when it is complete (compare/text/file.h), or to a pipe or a device. */
#ifndef SCALLOP_COMPARE_TEXT_TABLE_H
#define SCALLOP_COMPARE_TEXT_TABLE_H

#include <stdbool.h>
#include <stdio.h>

#include "compare/text/aligned.h"
#include "compare/text/digits.h"
#include "compare/text/file.h"
#include "compare/text/plot.h"

enum { TABLE_COLUMNS = 384, TABLE_PART = 4096 };

/* FORMAT_TABLE: aligned, for people (aligned.h), with 6 significant digits: what a terminal gets where no format is
 * given */
enum format { FORMAT_TSV, FORMAT_JSON, FORMAT_CSV, FORMAT_MARKDOWN, FORMAT_TABLE, FORMATS };
extern const char *const format_names[FORMATS + 1]; /* NULL-terminated */

/* A cell of a row, and how it is written: see table_number and those behind it */
enum cell_kind { CELL_NUMBER, CELL_ROUNDED, CELL_DIGITS, CELL_TEXT, CELL_CARRIED };
struct table_cell {
  enum cell_kind kind;
  double value;
  const char *text; /* of CELL_ROUNDED the format */
};

/* A choice of columns (compare/columns): what it shows of each row takes the place of the row. */
struct table;
struct table_choice {
  /* The names of the columns that the table has, which outlive it. NULL, or what is wrong with the choice. */
  const char *(*begin)(struct table_choice *choice, const char *const *columns, int count);
  /* Keeps a cell of the row by its column. False: out of memory */
  bool (*keep)(struct table_choice *choice, int column, const struct table_cell *cell);
  /* Writes the cells that are shown of the row. */
  void (*write)(struct table_choice *choice, struct table *table);
  const char *const *names; /* of the columns that are shown, after begin */
  const bool *used;         /* of each column that the table has: does one that is shown take it? After begin */
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
  bool pager;                  /* shows standard output, to people */
  bool has_output, has_format; /* are given */
  column_meaning *meaning;     /* of columns, for people, or NULL */
  struct table_choice *choice; /* NULL: all columns */
  struct plot plot;            /* a picture of what is written; of file NULL: none */
};

struct table {
  FILE *file;
  const struct style *style;
  enum format format;
  const char *of;         /* what kind of table its picture is of: the command, where that does not say another */
  struct aligned aligned; /* what is kept of a FORMAT_TABLE */
  const char *output;     /* its name, NULL: standard output */
  struct file out;
  const char *columns[TABLE_COLUMNS];
  const char *const *names;    /* of those that are written: columns, or those of a choice */
  int count, at;               /* columns; the next one in this row */
  struct table_choice *choice; /* which takes the cells, or NULL */
  FILE *head;                  /* '#' lines, until the choice is found good */
  char *head_text;
  size_t head_size;
  struct pictured *pictured; /* a copy in TSV, of which a picture is drawn; NULL: none is wanted */
  int error;                 /* of the first write that failed */
  size_t used;               /* of part: what is not yet handed to file, part of a row */
  char part[TABLE_PART];
};

/* Opens output, or standard output where it is NULL. The style must outlive the table; if it has a plot, the rows are
 * kept in TSV too, beside the picture, until table_close. False: the message is on stderr, exit with EXIT_FILE. */
bool table_open_at(struct table *table, const struct style *style, const char *output);
/* Will the table be an aligned one? */
bool table_is_for_people(const struct style *style);
/* Opens the output of the style. */
bool table_open(struct table *table, const struct style *style);
/* A '#' line before the columns or after the rows of a TSV or an aligned table; nothing in the other formats. */
void table_note(struct table *table, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* The header row: NULL-terminated names, which must outlive the table. May be called in parts. */
void table_columns(struct table *table, const char *const *names);
/* A choice of columns that are not there is refused on stderr, with nothing else written: the table has then failed. */
void table_begin_rows(struct table *table);
/* Once the rows have begun: does anything that is written take the column of this name? A cell that is not used may
 * hold anything. */
bool table_uses(const struct table *table, const char *column);
/* The cells of a row in the order of the columns. A row ends by itself with its last cell. */
void table_number(struct table *table, double value);
void table_rounded(struct table *table, double value, const char *format); /* fewer digits, always */
void table_digits(struct table *table, const char *number);                /* a number as it stands, of any length */
void table_text(struct table *table, const char *text);
/* A cell of another table: its bytes, and in JSON a number where it is one. */
void table_carried(struct table *table, const char *text);
/* Any of these */
void table_cell(struct table *table, const struct table_cell *cell);
/* Where the table is aligned, for people: a row that is written as a page, to this stream, instead of its cells; what
 * was kept of the row is forgotten. NULL: the table has another format, or columns are chosen. */
FILE *table_page(struct table *table);
/* Has writing failed already? Then nothing more is worth its time: table_close says why. */
bool table_failed(const struct table *table);
/* Writes out what has been kept back, to the disk. False: writing has failed, and table_close says why. */
bool table_flush(struct table *table);
/* Closes, puts the file in its place, and draws the plot of the style. False: the message is on stderr, exit with
 * EXIT_FILE; an earlier file stays, but where only the picture has failed the table is written. */
bool table_close(struct table *table);
/* Gives the output up: nothing is left behind. */
void table_abandon(struct table *table);

#endif
