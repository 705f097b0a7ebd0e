/* What the files of the claims in words share. Not public. */
#ifndef SCALLOP_CLAIMS_WORDS_H
#define SCALLOP_CLAIMS_WORDS_H

#include <gsl/gsl_qrng.h>

#include "compare/claims/claims.h"
#include "numerics/numerics.h"

struct words {
  struct scallop_crawler crawler; /* with the gait in question                                        */
  bool of_the_paper;              /* it is the one of the paper's figures                             */
  claim_sink *sink;
  void *context;
};

/* A displacement in L that is only rounding: a dozen terms of size up to 1, the start velocity known to an ulp. */
#define WORDS_ZERO 1e-14

const char *words_whose(const struct words *w);
/* The paper's crawler with the gait in question */
struct scallop_crawler words_paper_crawler(const struct words *w);

/* For what a claim is decided: once, for each gait, for each gait with the paper's crawler and with the ledger's, with the paper's. */
enum words_scope { WORDS_ONCE, WORDS_EACH_GAIT, WORDS_EACH_CRAWLER, WORDS_OF_THE_PAPER };

/* A claim, where the paper makes it, and the function that decides it: it enters one row. which: what the function varies from row to
 * row. A table ends with a row without a claim; claims_in_words.c has the list of tables. */
struct words_claim {
  const char *claim, *section, *quantity;
  enum words_scope scope;
  void (*decide)(const struct words *w, const struct words_claim *claim);
  int which;
};
extern const struct words_claim words_at_random[], words_of_peaks[], words_of_figures[], words_of_steady_states[],
    words_of_phases[], words_of_regimes[], words_of_appendices[];

/* holds, or refuted where that is proven, or else undecided */
enum claim_verdict words_verdict(bool holds, bool proven);
/* A row; reason: of a verdict other than holds, may be NULL. The texts need to last for the call only. */
void words_enter(const struct words *w, const struct words_claim *claim, const char *conditions, bool inside,
                 enum claim_verdict verdict, const char *measured, const char *reason);

/* nan where there is none */
struct scallop_steady_result words_steady(const struct scallop_crawler *c);
/* The duration at which the Froude number is 1 */
double words_natural_time(const struct scallop_crawler *c);
/* Masses and forces within a factor of 10 of 1, L = 1, 0.05 < alpha < 0.95, eps from 0.01 to 10; the same bits on every machine.
 * q has 6 dimensions. */
struct scallop_crawler words_random(gsl_qrng *q, const struct scallop_gait *gait);

#endif
