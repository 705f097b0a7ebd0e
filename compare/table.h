/* Tables: TSV with '#' lines on top, or JSON with one object a line, to standard output, to a file that appears when it is complete
 * (compare/aside.h), or to a pipe or a device. */
#ifndef SCALLOP_TABLE_H
#define SCALLOP_TABLE_H

#include <stdbool.h>
#include <stdio.h>

#include "compare/aside.h"
#include "compare/digits.h"
#include "compare/options.h"

enum { TABLE_COLUMNS = 64, NUMBER_TEXT = DIGITS_TEXT, TABLE_TEXT = 1 << 15 };

/* x with so many significant digits, or, for digits = 0, with as few of 15 to 17 as read back exactly. Returns the length. */
size_t number_text(char text[NUMBER_TEXT], double x, long digits);

struct table {
  FILE *file;
  const struct options *options;
  struct aside aside;
  bool is_aside; /* or the file is standard output, a pipe or a device     */
  const char *columns[TABLE_COLUMNS];
  int count, at; /* columns; the next one in this row                     */
  bool watched;  /* on a terminal: a line appears when it is complete     */
  int error;     /* of the first write that failed                        */
  size_t used;
  char text[TABLE_TEXT]; /* what the file has not got yet                         */
};

/* Opens the output named by options. False: the message is on stderr, exit with EXIT_FILE. */
bool table_open(struct table *table, const struct options *options);
/* A '#' line before the columns or after the rows; nothing in JSON. */
void table_note(struct table *table, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* "# parameters: m1=1 ..." */
void table_parameters(struct table *table, const struct options *options);
/* The header row: NULL-terminated names, which must outlive the table. May be called in parts. */
void table_columns(struct table *table, const char *const *names);
void table_begin_rows(struct table *table);
/* The cells of a row in the order of the columns. A row ends by itself with its last cell. */
void table_number(struct table *table, double value);
void table_rounded(struct table *table, double value, const char *format); /* fewer digits, always */
void table_digits(struct table *table, const char *number);                /* a number as it stands, of any length */
void table_text(struct table *table, const char *text);
/* Has writing failed already? Then nothing more is worth its time: table_close says why. */
bool table_failed(const struct table *table);
/* Closes, and puts the file in its place. False: the message is on stderr, exit with EXIT_FILE; an earlier file stays. */
bool table_close(struct table *table);
/* Gives the output up: nothing is left behind. */
void table_abandon(struct table *table);

#endif
