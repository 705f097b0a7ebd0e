/* One crawler on one page: what it does, what the paper's formulas are worth for it, and where the expansion ends. The
 * page tells in sentences the quantities (answers/quantities.h) that a row of the table has: the motion is that of
 * `steady`, verdicts are those of `claims`, transitions, reaches and orders those of `breakdown`. Needs FLINT. */
#ifndef SCALLOP_COMPARE_SUMMARY_SUMMARY_H
#define SCALLOP_COMPARE_SUMMARY_SUMMARY_H

#include "compare/answers/rows.h"
#include "compare/breakdown/motion.h"
#include "compare/claims/claims.h"

/* `scallop summary`: a page, or a row, for each point; `scallop breakdown` without more: the part of the page about
 * transitions and reach */
const char *summary_plan(struct rows *rows);
const char *breakdown_page(struct rows *rows);

/* Derived terms that pages tell of, and the errors, in percent, whose reach they tell */
#define PAGE_TERMS "derived_8."
#define PAGE_PERCENTS 1, 5

/* studied.c. At a point: its study along T; the row of the table of claims for a formula, this gait and these
 * parameters, until the next row is asked for. NULL: there is none, and at->why says why. */
struct study *study_of(struct at *at);
const struct claim_row *claim_of(struct at *at, const struct scallop_formula *formula);

#endif
