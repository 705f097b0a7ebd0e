/* The verdicts on series, in the formats that people and CI servers read. */
#ifndef SCALLOP_COMPARE_ORDER_REPORT_H
#define SCALLOP_COMPARE_ORDER_REPORT_H

#include "compare/order/series.h"
#include "compare/text/table.h"

/* Those of tables (enum format), and one more. */
enum report_format { REPORT_JUNIT = FORMATS };
/* Their names, NULL-terminated, in this order. */
extern const char *const report_formats[];

/* What was asked of all of them. */
struct report {
  const struct series_list *list;
  const struct scallop_order_wanted *wanted;
  int format; /* enum format or enum report_format */
  const struct style *style;
};

/* EXIT_CHECK_FAILED if a table is not of the order that is expected, EXIT_UNSOLVED if none is expected and none can be
 * measured. Where the report went to a file, each such table is a line on stderr. */
enum exit_code report_exit(const struct report *report);
/* Writes a verdict for each series and a summary to the output of the style. */
enum exit_code report_write(const struct report *report);
/* Writes each row with its pairwise order and its use, in a format of tables. */
enum exit_code report_write_rows(const struct report *report);
/* Draws these rows, by the plot of the style. */
enum exit_code report_draw(const struct report *report);

#endif
