/* `scallop order`: tables of h and err as files hold them (series.c), and the verdicts on them in the formats that
 * people and CI servers read (report.c). The verdicts themselves are those of asymptotics/observed/order.h. */
#ifndef SCALLOP_COMPARE_ORDER_ORDER_H
#define SCALLOP_COMPARE_ORDER_ORDER_H

#include "asymptotics/observed/order.h"
#include "compare/text/message.h"
#include "compare/tables/table.h"

/* The orders that are expected: of columns by their names, or one for each column of errors in their order, or one for
 * all. */
enum { MOST_ORDERS = 32 };
struct orders_wanted {
  int count; /* 0: none */
  struct {
    const char *name; /* not terminated, NULL: none */
    int length;
    double order;
  } of[MOST_ORDERS];
  bool at_least, required; /* higher orders pass, too; where none is expected, one has to be measured */
  double tolerance;
};

/* Which columns are read: names in the header, or numbers from 1. */
enum { MOST_LISTS = 16 };
struct columns_wanted {
  /* NULL: h, and where no column has this name the first one that has a name; "1/N": h = 1/N of the column N */
  const char *x;
  /* lists with commas between names; where there is none: those that orders names; else err, error or value, and where
   * none has such a name each right of x that holds numbers, but for noise and for orders */
  const char *y[MOST_LISTS];
  int ys;       /* how many lists                                                */
  bool values;  /* y are values; without it, only a column of this name          */
  double power; /* h = x^power; 0: h = x */
  bool quiet;   /* no note of what was read */
  const struct orders_wanted *orders;
};

/* What a series is counted as. Without an expected order it is measured or not. */
enum outcome { PASSED, FAILED, MEASURED, NOT_MEASURED, UNREAD, OUTCOMES };
/* One column y against x, in the rows with the same texts left of x */
enum { SERIES_NAME = 1024, COLUMN_NAME = 100 };
struct series {
  const char *file;       /* as it is called in messages                          */
  char name[SERIES_NAME]; /* the texts left of x, joined; "" where there are none */
  char y[COLUMN_NAME];    /* the column                                           */
  int place;              /* of the column among those of errors, from 0 */
  int missing;            /* rows without a value                        */
  enum outcome outcome;
  struct scallop_order_wanted wanted;
  struct scallop_order_point *points;
  int count;
  struct scallop_order_result result; /* of an unread file reason says why it could not be read */
  const char *names[2], *interval, *test, *verdict, *reason; /* in words, after series_judge     */
};
enum { MOST_SERIES = 4096, MOST_ROWS = 1000000 };
struct series_list {
  struct series *series;
  int count, outcomes[OUTCOMES];
  long rows;           /* of all of them                */
  bool values;         /* some of them are of values    */
  char x[COLUMN_NAME]; /* the column of h of the last file; "": it is no number of cells */
};
/* Adds the series of a file ('-': standard input). Of a file that cannot be read, or is no table, it adds one series
 * without rows that is unread, and the message is on stderr. */
enum exit_code series_read(struct series_list *list, const char *file, const struct columns_wanted *columns);
void series_judge(struct series_list *list, const struct orders_wanted *orders);
void series_free(struct series_list *list);

/* The formats of reports: those of tables (enum format), and one more; NULL-terminated. */
enum { REPORT_JUNIT = FORMATS };
extern const char *const report_formats[];
/* Writes a verdict for each series and a summary to the output of the style. */
enum exit_code report_write(const struct series_list *list, const struct orders_wanted *orders,
                            const struct style *style, int format);
/* Writes each row with its pairwise order and its use, in a format of tables, and draws them, by the plot of the style.
 * Where nothing but the plot is wanted the output is "/dev/null". */
enum exit_code report_rows(const struct series_list *list, const struct style *style);
/* EXIT_CHECK_FAILED if a table is not of the order that is expected or, where one is required, none can be measured.
 * Where the report went to a file, the verdict on each table is a line on stderr. */
enum exit_code report_exit(const struct series_list *list, const struct orders_wanted *orders, bool to_file);

#endif
