/* The table of claims of the paper's claims, with verdicts (data/claims.tsv); docs/background/evidence.md lists the
 * others.
 *
 * A row is one claim for one gait under one set of conditions. Claims about an order, "... + O(T^n)", are the rows of
 * asymptotics' lists of formulas, or of a formula file: order.c and user.c go through these under their conditions,
 * trial.c expands and samples the motion, proof.c finds what the formula leaves out. Claims in words are one row and
 * one function in random.c (every crawler), examples.c, families.c (crawlers that differ in one number) or figures.c.
 *
 * A verdict on an order is proven: every coefficient is exact, or in a ball that does not hold 0. What is neither
 * shown nor refuted is undecided. A row that contradicts itself (a measured error that is not what is left out, a
 * correction that does not hold) is an error of the table of claims, not a verdict. */
#ifndef SCALLOP_COMPARE_CLAIMS_CLAIMS_H
#define SCALLOP_COMPARE_CLAIMS_CLAIMS_H

#include "asymptotics/observed/order.h"
#include "compare/answers/request.h"
#include "compare/formulas/formula_file.h"

struct scallop_rational_crawler; /* model/exact/ball.h */

enum claim_verdict { CLAIM_HOLDS, CLAIM_SHARPER, CLAIM_UNDECIDED, CLAIM_REFUTED };
const char *claim_verdict_text(enum claim_verdict verdict);

/* How it is known: for all parameters with which the motion has the modes of the row's (a claim in words: by
 * docs/background/theory.md); for the crawler that is named; from `sampled` crawlers, or other cases; from doubles */
enum claim_evidence { NO_EVIDENCE, PROVEN_FOR_ALL, CERTIFIED_CRAWLER, SAMPLED, MEASURED };

/* Whose claim a row is: the paper's, one of the formulas that hold where the paper's do not, or a formula file's */
enum claim_source { OF_PAPER, OF_CORRECTED, OF_USER };

enum { CLAIM_NAME = 64, CLAIM_POINTS = 35 };
/* v0 of the rows from v0, in units of sqrt(L (F1 + F2)/M), rounded to two digits: no coincidence */
#define CLAIM_SPEED 0.37
/* Half the width of the interval that a measured order is to have. */
#define CLAIM_TOLERANCE 0.02

struct claim_row {
  char claim[CLAIM_NAME];
  const char *equation, *quantity, *gait;
  char conditions[240];
  bool inside; /* these are the conditions that the paper assumes */
  enum claim_source source;
  bool any_crawler;     /* that it is tested for stands for all: what holds for it by coincidence is refuted */
  double claimed_order; /* nan: not a claim about an order */
  bool proven;          /* derived_order and coefficient, the first of what is left out, are there */
  bool exact;           /* every coefficient that was looked at vanishes */
  long derived_order;
  char coefficient[80]; /* exact, or a ball that does not hold 0; "" if none */
  char *leading_error;  /* of a formula proven for all: that term as a formula; of claims itself, or NULL */
  char *formula;        /* its text, of a formula file; likewise */
  double error_at_T;    /* of a formula file: the formula over the certified value, less 1, at the given T */
  struct scallop_order_result fit;
  struct scallop_order_point points[CLAIM_POINTS]; /* from the largest T */
  int count;
  enum claim_verdict verdict;
  enum claim_evidence evidence;
  int sampled;
  bool in_words;
  char corrected[CLAIM_NAME]; /* of a refuted formula: the claim that holds, or "" */
  char summary[200];          /* of a claim in words: the figure that decides */
  char reason[320];           /* of a verdict: why; of a refutation in words: an example to paste */
};

struct claim_table { /* begins as { 0 } */
  struct claim_row *rows;
  int count;
  char contradiction[600]; /* "", or what contradicts itself (the last one) */
  bool is_forecast; /* rows are only counted, as expected, nearly: with the formulas for another limit; for progress */
  int expected;
};
void claim_table_add(struct claim_table *claims, const struct claim_row *row);
bool claim_table_expects(struct claim_table *claims); /* Is it a forecast? Then that counts a row. */
void claim_table_free(struct claim_table *claims);

/* Claims about orders for the gait of the crawler, inside and outside of their conditions, and the formulas that hold
 * where one of the paper's does not. T is not used; F1 > F2 and alpha > 1/2 (exchanged where a row says so). only: the
 * names of the requested rows (formula_is_listed), or NULL for all. */
void claim_table_add_orders(struct claim_table *claims, const struct scallop_rational_crawler *crawler,
                            const char *only);
/* Of one formula; of the formula files that were read. A crawler that is not given is changed to meet the formula's
 * conditions. */
void claim_table_add_formula(struct claim_table *claims, const struct scallop_rational_crawler *crawler, bool is_given,
                             const struct scallop_formula *formula);
void claim_table_add_user(struct claim_table *claims, const struct scallop_rational_crawler *crawler, bool is_given,
                          const char *only);
/* Claims in words, of the paper's crawler and of this one, of which F1, alpha and T are varied */
void claim_table_add_words(struct claim_table *claims, const struct scallop_crawler *crawler);

struct claims_options { /* of `scallop claims` */
  struct request request;
  const char *errors;           /* the names whose errors are wanted, or NULL */
  struct optional_word verdict; /* of the rows that are wanted, or all */
  bool summary;
  const char *formula, *claimed; /* one formula instead of the paper's or of request.formulas; NULL: none */
  struct optional_word of, start, phase;
};
enum exit_code claims_table(const struct claims_options *options);

#endif
