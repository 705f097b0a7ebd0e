/* What the files of the claims in words share. Not public. */
#ifndef SCALLOP_CLAIMS_WORDS_H
#define SCALLOP_CLAIMS_WORDS_H

#include <gsl/gsl_qrng.h>

#include "compare/claims.h"
#include "numerics/numerics.h"

struct words {
  struct scallop_crawler crawler; /* with the gait in question                                        */
  bool of_the_paper;              /* it is the one of the paper's figures                             */
  claim_sink *sink;
  void *context;
};

const char *words_whose(const struct words *w);

/* A row; reason: of a verdict other than holds, may be NULL. The texts need to last for the call only. */
struct words_claim {
  const char *claim, *section, *quantity, *conditions;
  bool inside;
};
/* holds, or refuted where that is proven, or else undecided */
enum claim_verdict words_verdict(bool holds, bool proven);
void words_enter(const struct words *w, const struct words_claim *claim, enum claim_verdict verdict, const char *measured,
                 const char *reason);

/* nan where there is none */
struct scallop_steady_result words_steady(const struct scallop_crawler *c);
/* The duration at which the Froude number is 1 */
double words_natural_time(const struct scallop_crawler *c);
/* Masses and forces within a factor of 10 of 1, L = 1, 0.05 < alpha < 0.95, eps from 0.01 to 10; the same bits on every machine.
 * q has 6 dimensions. */
struct scallop_crawler words_random(gsl_qrng *q, const struct scallop_gait *gait);

/* Where mean velocity is highest, over F1/F2, the strength of friction, T, alpha, masses and at random (claims_peak.c). */
void words_of_peaks(const struct words *w);
void words_of_random_peaks(const struct words *w);
/* The steady state: is there one, when is it reached, for which alpha is (27) right; a phase from a start velocity (claims_steady.c). */
void words_of_steady_states(const struct words *w);
void words_of_jumps(const struct words *w);

#endif
