/* Table of the paper's claims, with verdicts (data/claims.tsv); docs/background/errata.md lists further errors.
 *
 * A row is one claim for one gait under one set of conditions. Claims about an order, "... + O(T^n)", are the rows of
 * asymptotics' lists of formulas, or of a formula file: order.c and user.c test these under their conditions, trial.c
 * expands and samples the motion, proof.c finds the terms that the formula leaves out. A claim in words is one row and
 * one function in random.c (every crawler), examples.c, families.c (crawlers that differ in one number) or figures.c.
 *
 * A verdict on an order is proven: every coefficient is exact, or in a ball that excludes 0. A claim that is neither
 * shown nor refuted is undecided. A row that contradicts itself (the measured error differs from the terms left out, a
 * correction does not hold) is an error of the table of claims, not a verdict. */
#ifndef SCALLOP_COMPARE_CLAIMS_CLAIMS_H
#define SCALLOP_COMPARE_CLAIMS_CLAIMS_H

#include "asymptotics/observed/order.h"
#include "compare/answers/request.h"
#include "compare/formulas/formula_file.h"

struct scallop_rational_crawler; /* model/exact/ball.h */

enum claim_verdict { CLAIM_HOLDS, CLAIM_SHARPER, CLAIM_UNDECIDED, CLAIM_REFUTED };
const char *claim_verdict_text(enum claim_verdict verdict);

/* Evidence of a verdict: a proof for all parameters with the modes of the row's motion (a claim in words: in
 * docs/background/theory.md); a proof for the crawler of the row; `sampled` crawlers, or other cases; doubles */
enum claim_evidence { NO_EVIDENCE, PROVEN_FOR_ALL, CERTIFIED_CRAWLER, SAMPLED, MEASURED };

/* Source of a claim: the paper, our formulas in place of the paper's wrong ones, or a formula file */
enum claim_source { OF_PAPER, OF_CORRECTED, OF_USER };

enum { CLAIM_NAME = 64, CLAIM_POINTS = 35 };
/* v0 of the rows from v0, in units of sqrt(L (F1 + F2)/M), rounded to two digits; an arbitrary number */
#define CLAIM_SPEED 0.37
/* Half the largest width of the interval of a measured order */
#define CLAIM_TOLERANCE 0.02

struct claim_row {
  char claim[CLAIM_NAME];
  const char *equation, *quantity, *gait;
  char conditions[240];
  bool inside; /* the paper assumes these conditions */
  enum claim_source source;
  bool any_crawler;     /* the crawler is an example: a claim that holds for it by coincidence is refuted */
  double claimed_order; /* nan: not a claim about an order */
  bool proven;          /* derived_order and coefficient, the first term left out, are known */
  bool exact;           /* every coefficient that was computed vanishes */
  long derived_order;
  char coefficient[80]; /* exact, or a ball that excludes 0; "": unknown, or 0 */
  char *leading_error;  /* this term as a formula, if proven for all parameters, else NULL; the table frees it */
  char *formula;        /* text of a formula from a file, else NULL; the table frees it */
  double error_at_T;    /* of a formula file: the formula over the certified value, less 1, at the given T */
  struct scallop_order_result fit;
  struct scallop_order_point points[CLAIM_POINTS]; /* from the largest T */
  int count;
  enum claim_verdict verdict;
  enum claim_evidence evidence;
  int sampled;
  bool in_words;
  char corrected[CLAIM_NAME]; /* refuted formula: name of the correct one, or "" */
  char summary[200];          /* claim in words: the number that decides */
  char reason[320];           /* of the verdict; refuted claim in words: a command that shows it */
};

struct claim_table { /* initially { 0 } */
  struct claim_row *rows;
  int count;
  char contradiction[600]; /* "", or the last row that contradicts itself */
  bool is_forecast;        /* rows are only counted, in `expected`, for progress; formulas for another limit included */
  int expected;
};
void claim_table_add(struct claim_table *claims, const struct claim_row *row);
bool claim_table_expects(struct claim_table *claims); /* Counts a row of a forecast; false if it is not a forecast. */
void claim_table_free(struct claim_table *claims);

/* Adds claims about orders for the gait of the crawler, inside and outside of the paper's conditions, and the formulas
 * in place of the refuted ones. T is not used; F1 > F2 and alpha > 1/2 (exchanged for conditions that require it).
 * only: names of the requested rows (formula_is_listed), or NULL for all. */
void claim_table_add_orders(struct claim_table *claims, const struct scallop_rational_crawler *crawler,
                            const char *only);
/* Add the claim of one formula, and of each formula of the files in use. Unless is_given, the crawler is changed to
 * meet the formula's conditions. */
void claim_table_add_formula(struct claim_table *claims, const struct scallop_rational_crawler *crawler, bool is_given,
                             const struct scallop_formula *formula);
void claim_table_add_user(struct claim_table *claims, const struct scallop_rational_crawler *crawler, bool is_given,
                          const char *only);
/* Adds claims in words, for the paper's crawler and for this one; F1, alpha and T vary. */
void claim_table_add_words(struct claim_table *claims, const struct scallop_crawler *crawler);

struct claims_options { /* of `scallop claims` */
  struct request request;
  const char *errors;           /* names of the claims of which a table of errors is requested, or NULL */
  struct optional_word verdict; /* of the requested rows; not given: all */
  bool summary;
  const char *formula, *claimed; /* one formula in place of the paper's or of request.formulas, or NULL */
  struct optional_word of, start, phase;
};
enum exit_code claims_table(const struct claims_options *options);

#endif
