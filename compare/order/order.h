/* Tables and reports of `scallop order`: series of h and err in files (series.c), and verdicts on them in the formats
 * of people and CI servers (report.c). asymptotics/observed/order.h decides the verdicts. */
#ifndef SCALLOP_COMPARE_ORDER_ORDER_H
#define SCALLOP_COMPARE_ORDER_ORDER_H

#include "asymptotics/observed/order.h"
#include "compare/text/message.h"
#include "compare/tables/table.h"

/* Expected orders: of columns by name, or one for each column of errors in their order, or one for all */
enum { MAX_ORDERS = 32 };
struct expected_orders {
  int count;
  struct {
    const char *name; /* not terminated; NULL: without a name */
    int length;
    double order;
  } of[MAX_ORDERS];
  bool at_least, required; /* higher orders pass too; without an expected order, one must be measured */
  double tolerance;
};

/* Columns to read: names in the header, or numbers from 1 */
enum { MAX_LISTS = 16 };
struct order_columns {
  /* NULL: the column h, else the first one with a name; "1/N": h = 1/N of the column N */
  const char *x;
  /* lists of names, separated by commas; if empty, the columns named in orders, else err, error or value, else each
   * column of numbers right of x, except noise and orders */
  const char *y[MAX_LISTS];
  int lists;    /* in y */
  bool values;  /* y are values, not errors; otherwise, a column named value alone is */
  double power; /* h = x^power; 0: h = x */
  bool quiet;   /* no note about the columns */
  const struct expected_orders *orders;
};

/* Outcome of a series; without an expected order it is measured or not measured */
enum outcome { PASSED, FAILED, MEASURED, NOT_MEASURED, UNREAD, OUTCOMES };
/* Points of one column y against x, in the rows with the same texts left of x */
enum { SERIES_NAME = 1024, COLUMN_NAME = 100 };
struct error_series {
  const char *file;       /* its name in messages */
  char name[SERIES_NAME]; /* the texts left of x, joined; may be empty */
  char y[COLUMN_NAME];    /* the column                                           */
  int place;              /* of y among the columns of errors, from 0 */
  int missing;            /* rows without a value                        */
  enum outcome outcome;
  struct scallop_order_wanted expected;
  struct scallop_order_point *points;
  int count;
  struct scallop_order_result result;                        /* unread file: reason has the error */
  const char *names[2], *interval, *test, *verdict, *reason; /* in words, after series_judge */
};
enum { MAX_SERIES = 4096, MAX_ROWS = 1000000 };
struct series_list {
  struct error_series *series;
  int count, outcomes[OUTCOMES];
  long rows;           /* of all series */
  bool values;         /* a series has values, not errors */
  char x[COLUMN_NAME]; /* the column of h of the last file; "": not a number of cells */
};
/* Adds the series of a file ('-': standard input). For a file that cannot be read, or is no table, adds one unread
 * series without rows, and prints a message to stderr. */
enum exit_code series_read(struct series_list *list, const char *file, const struct order_columns *columns);
void series_judge(struct series_list *list, const struct expected_orders *orders);
void series_free(struct series_list *list);

/* Formats of reports: the formats of tables (enum format), then junit; NULL-terminated. */
enum { REPORT_JUNIT = FORMATS };
extern const char *const report_formats[];
/* Writes a verdict for each series and a summary to the output of the style. */
enum exit_code report_write(const struct series_list *list, const struct expected_orders *orders,
                            const struct style *style, int format);
/* Writes each row with its pairwise order and its use, in a format of tables, and draws the plot of the style. For the
 * plot alone, the output is "/dev/null". */
enum exit_code report_rows(const struct series_list *list, const struct style *style);
/* Returns EXIT_CHECK_FAILED if a table has another order than expected or, if one is required, no order was measured.
 * to_file: the report is in a file; each verdict is then a line on stderr. */
enum exit_code report_exit(const struct series_list *list, const struct expected_orders *orders, bool to_file);

#endif
