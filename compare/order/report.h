/* The verdicts on series, in the formats that people and CI servers read. */
#ifndef SCALLOP_ORDER_REPORT_H
#define SCALLOP_ORDER_REPORT_H

#include "compare/order/series.h"
#include "compare/text/table.h"

enum report_format { REPORT_TSV, REPORT_JSON, REPORT_TAP, REPORT_JUNIT, REPORT_MARKDOWN };
/* Their names, NULL-terminated, in this order. */
extern const char *const report_formats[];

/* What was asked of all of them. */
struct report {
  const struct series_list *list;
  const struct scallop_order_wanted *wanted;
  enum report_format format;
  const struct style *style;
};

/* How many series have failed: those without a pass or, where no order was expected, those that are invalid. */
int report_failed(const struct report *report);
/* Writes a verdict for each series and a summary to the output of the style. */
enum exit_code report_write(const struct report *report);
/* Writes each row with its pairwise order and its use; TSV or JSON. */
enum exit_code report_write_rows(const struct report *report);

#endif
