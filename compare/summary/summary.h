/* One crawler on one page: what it does, what the paper's formulas are worth for it, and where the expansion ends. The
 * page has the quantities (answers/quantities.h) of the point, as a row of the table has them, in sentences: the motion
 * is that of `steady`, verdicts are those of `claims`, events, reaches and orders those of `breakdown`. Needs FLINT. */
#ifndef SCALLOP_COMPARE_SUMMARY_SUMMARY_H
#define SCALLOP_COMPARE_SUMMARY_SUMMARY_H

#include "compare/answers/rows.h"
#include "compare/book/book.h"
#include "compare/breakdown/study.h"
#include "compare/claims/claims.h"

enum { SUMMARY_FORMULAS = BOOK_MOST + 8, SUMMARY_LEVELS = 2, SUMMARY_ORDER = 8 };
extern const double summary_levels[SUMMARY_LEVELS]; /* relative errors whose T are looked for: 0.01 and 0.05 */

/* `scallop summary`: a page, or a row, for each point */
const char *summary_plan(struct rows *rows);
/* `scallop breakdown` without more: the part of the page about events and reach. */
enum exit_code summary_of_breakdown(const struct request *request);

/* page.c. A formula, or the derived terms below T^SUMMARY_ORDER, for a quantity of the steady state */
struct page_series {
  char name[QUANTITY_NAME];              /* as of a quantity                 */
  const struct scallop_formula *formula; /* NULL: it is derived */
  enum quantity_id of;
};
struct page {
  FILE *file;
  int digits;
  struct at *at;            /* the point */
  struct quantities *asked; /* of it: all that the page tells */
  struct study *study;
  struct page_series series[SUMMARY_FORMULAS + 2]; /* formulas first */
  int count;
};
/* With its series, of which there may be some that the crawler has not. */
void page_init(struct page *page);
/* NULL, or why the crawler has no page. */
const char *page_begin(struct page *page);
void page_of_crawler(const struct page *page);
void page_of_breakdown(const struct page *page);

/* studied.c. At a point: its study along T; the row of the ledger for a formula, this gait and these
 * parameters. NULL: there is none, and at->why says why. */
struct study *study_of(struct at *at);
const struct claim_row *claim_of(struct at *at, const struct scallop_formula *formula);

#endif
