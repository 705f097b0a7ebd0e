/* One crawler on one page: what it does, what the paper's formulas are worth for it, and where the expansion ends.
 * Nothing is computed here: the motion is that of `steady`, verdicts are those of `claims`, events, reaches and orders
 * those of `breakdown`. Needs FLINT. */
#ifndef SCALLOP_COMPARE_SUMMARY_SUMMARY_H
#define SCALLOP_COMPARE_SUMMARY_SUMMARY_H

#include "compare/answers/stretches.h"
#include "compare/book/book.h"
#include "compare/answers/rows.h"
#include "compare/breakdown/motion.h"
#include "compare/claims/claims.h"

enum { SUMMARY_FORMULAS = BOOK_MOST + 8, SUMMARY_LEVELS = 2, SUMMARY_ORDER = 8 };
extern const double summary_levels[SUMMARY_LEVELS]; /* relative errors whose T are looked for: 0.01 and 0.05 */

/* A formula or a derived series for a quantity of the steady state */
struct summary_series {
  struct series_item item;
  double value, error;          /* at the point's T; error: value/exact - 1, nan where there is none */
  double reach[SUMMARY_LEVELS]; /* comparison_reach */
  double limit;                 /* comparison_limit: what |error| tends to as T -> 0; nan: to 0, or to nothing */
  struct claim_row claim;       /* of a formula                                   */
};

struct summary {
  struct motion motion;
  struct answer answer;
  struct study study;
  struct summary_series formula[SUMMARY_FORMULAS], derived[2]; /* derived: of v_start and of the displacement */
  int formulas, series;
  /* of the derived series at the point's T, below T^best_order: the least error; 0: there is none */
  slong best_order[2];
  double best_error[2];
};
/* The formulas of the books and of the paper that every steady state has */
int summary_formulas(const struct scallop_formula *formulas[SUMMARY_FORMULAS]);

/* Is one of them of the book that was given, if any was? False: the message is on stderr. */
bool summary_serves(const struct request *request);

/* verdicts: of the formulas, which takes the longest. NULL, or why there is no answer; the summary has to be cleared in
 * either case. */
const char *summary_make(struct summary *summary, const struct point *point, bool verdicts);
void summary_clear(struct summary *summary);

/* `scallop summary`: a page, or a row, for each point */
const char *summary_plan(struct rows *rows);
/* `scallop breakdown` without more: the part of the page about events and reach. */
enum exit_code summary_of_breakdown(const struct request *request);

/* page.c: the parts of the page */
void page_of_motion(FILE *page, const struct summary *summary, int digits);
void page_of_formulas(FILE *page, const struct summary *summary, int digits);
void page_of_events(FILE *page, const struct summary *summary, int digits);
void page_of_reversals(FILE *page, const struct summary *summary, int digits);
void page_of_place(FILE *page, const struct summary *summary, int digits); /* of T among the events */
void page_of_reaches(FILE *page, const struct summary *summary, int digits);

#endif
