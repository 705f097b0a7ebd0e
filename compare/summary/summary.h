/* One crawler on one page: what it does, what the paper's formulas are worth for it, and where the expansion ends. The
 * page has the quantities (answers/quantities.h) of the point, as a row of the table has them, in sentences: the motion
 * is that of `steady`, verdicts are those of `claims`, events, reaches and orders those of `breakdown`. Needs FLINT. */
#ifndef SCALLOP_COMPARE_SUMMARY_SUMMARY_H
#define SCALLOP_COMPARE_SUMMARY_SUMMARY_H

#include "compare/answers/rows.h"
#include "compare/book/book.h"
#include "compare/breakdown/motion.h"
#include "compare/claims/claims.h"

/* `scallop summary`: a page, or a row, for each point; `scallop breakdown` without more: the part of the page about
 * events and reach */
const char *summary_plan(struct rows *rows);
const char *breakdown_page(struct rows *rows);

/* page.c. It is about formulas, and derived terms, for these quantities of the steady state. */
enum { SUMMARY_FORMULAS = BOOK_MOST + 8, PAGE_QUANTITIES = 2 };
struct page_quantity {
  enum quantity_id id;
  const char *derived; /* the name of these terms */
};
extern const struct page_quantity page_quantities[PAGE_QUANTITIES];
/* The errors at which a series' reach is told, as prefixes of quantities */
enum { PAGE_REACHES = 2 };
extern const char *const page_reaches[PAGE_REACHES];
/* The formulas that are listed for them. Returns how many. */
int page_formulas(const struct scallop_formula *formulas[SUMMARY_FORMULAS]);
/* What the rows do at a point */
void page_of_crawler(struct rows *rows, struct at *at);
void page_of_breakdown(struct rows *rows, struct at *at);

/* studied.c. At a point: its study along T; the row of the ledger for a formula, this gait and these
 * parameters, until the next row is asked for. NULL: there is none, and at->why says why. */
struct study *study_of(struct at *at);
const struct claim_row *claim_of(struct at *at, const struct scallop_formula *formula);

#endif
