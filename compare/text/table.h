/* Tables: TSV with '#' lines on top, or JSON with one object a line, to standard output, to a file that appears when it is complete
 * (compare/text/file.h), or to a pipe or a device. */
#ifndef SCALLOP_TABLE_H
#define SCALLOP_TABLE_H

#include <stdbool.h>
#include <stdio.h>

#include "compare/text/digits.h"
#include "compare/text/file.h"
#include "compare/command/options.h"

enum { TABLE_COLUMNS = 96, NUMBER_TEXT = DIGITS_TEXT, TABLE_TEXT = 1 << 15 };

/* x with so many significant digits, or, for digits = 0, with as few of 15 to 17 as read back exactly. Returns the length. */
size_t number_text(char text[NUMBER_TEXT], double x, long digits);

struct table {
  FILE *file;
  const struct options *options;
  const char *output; /* its name, NULL: standard output                          */
  struct file out;
  const char *columns[TABLE_COLUMNS];
  int count, at; /* columns; the next one in this row                     */
  bool in_rows;  /* they have begun                                       */
  bool watched;  /* on a terminal: a line appears when it is complete     */
  int error;     /* of the first write that failed                        */
  int leads;     /* cells at the head of each row                         */
  const char *const *lead_names, *const *lead_texts;
  const double *lead_numbers;
  struct table *into; /* the table that this one continues, or NULL            */
  bool is_later;      /* not the first to continue it                          */
  bool refused;       /* its columns are not those of the first                */
  bool is_continued;  /* of a table that is continued, and its columns         */
  char *names;
  size_t used;
  char text[TABLE_TEXT]; /* what the file has not got yet                         */
};

/* Opens output, or standard output where it is NULL. False: the message is on stderr, exit with EXIT_FILE. */
bool table_open_at(struct table *table, const struct options *options, const char *output);
/* Opens the output named by options; or, where options->into is an open table of the same format, continues that one: rows
 * follow the rows there, each with its lead cells. Notes and columns before the rows are of the first that continues it. A
 * later one must have the same columns: else table_begin_rows complains, and nothing that follows is written. One goes on at
 * a time, up to its close. */
bool table_open(struct table *table, const struct options *options);
/* Each row begins with so many lead cells, also the rows of what continues the table, which know nothing of them. The names
 * must outlive the table. Before the columns. */
void table_lead(struct table *table, const char *const *names, int count);
/* What is in them from here on: texts[i], or numbers[i] where that or texts is NULL. Both must outlive the rows. */
void table_lead_values(struct table *table, const double *numbers, const char *const *texts);
/* A '#' line before the columns or after the rows; nothing in JSON, nor before the rows of a later continuation. */
void table_note(struct table *table, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* Does a parameter vary: stands it, or what sets it, in front of each row? */
bool table_varies(const struct table *table, const char *parameter);
/* "# parameters: m1=1 ...": the parameters that hold in every row. Left out are those that stand in front of the rows, or that a
 * parameter there sets, and not_held (NULL-terminated, or NULL: none), which the table sets by itself or does not use. as_written: numbers
 * with all the digits that the options gave; else doubles. No line where nothing holds. */
void table_parameters(struct table *table, const struct options *options, const char *const *not_held, bool as_written);
/* The header row: NULL-terminated names, which must outlive the table, of a continuation only until it is closed. May be
 * called in parts. */
void table_columns(struct table *table, const char *const *names);
void table_begin_rows(struct table *table);
/* The cells of a row in the order of the columns. A row ends by itself with its last cell. */
void table_number(struct table *table, double value);
void table_rounded(struct table *table, double value, const char *format); /* fewer digits, always */
void table_digits(struct table *table, const char *number);                /* a number as it stands, of any length */
void table_text(struct table *table, const char *text);
/* Has writing failed already? Then nothing more is worth its time: table_close says why. */
bool table_failed(const struct table *table);
/* Writes out what has been kept back, to the disk. False: writing has failed, and table_close says why. */
bool table_flush(struct table *table);
/* Closes, and puts the file in its place. False: the message is on stderr, exit with EXIT_FILE; an earlier file stays. What
 * continues a table leaves that open; false: its columns were refused, or writing has failed, which closing that table
 * says. */
bool table_close(struct table *table);
/* Gives the output up: nothing is left behind. The rows of what continues a table stay there. */
void table_abandon(struct table *table);

#endif
