/* Summary of one crawler on one page: its motion, the accuracy of the paper's formulas, and the end of the expansion.
 * The page states in sentences the quantities (answers/quantities.h) of a row of the table: the motion from `steady`,
 * verdicts from `claims`, transitions, reaches and orders from `breakdown`. Needs FLINT. */
#ifndef SCALLOP_COMPARE_SUMMARY_SUMMARY_H
#define SCALLOP_COMPARE_SUMMARY_SUMMARY_H

#include "compare/answers/rows.h"
#include "compare/breakdown/motion.h"
#include "compare/claims/claims.h"

/* Plan a page, or a row, for each point of `scallop summary`; and, for `scallop breakdown` without options of its
 * table, the part of the page about transitions and reach. */
const char *summary_plan(struct rows *rows);
const char *breakdown_page(struct rows *rows);

/* Derived terms on pages, and the errors, in percent, with a reach on pages */
#define PAGE_TERMS "derived_8."
#define PAGE_PERCENTS 1, 5

/* studied.c. Return, for a point, its study along T; and the claim of a formula for its gait and parameters, valid
 * until the next call. NULL: at->why has the reason. */
struct study *study_of(struct at *at);
const struct claim_row *claim_of(struct at *at, const struct scallop_formula *formula);

#endif
