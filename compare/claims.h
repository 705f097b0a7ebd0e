/* The ledger: every asymptotic and qualitative claim of the paper, measured. */
#ifndef SCALLOP_CLAIMS_H
#define SCALLOP_CLAIMS_H

#include <stdbool.h>

#include "compare/order.h"
#include "model/model.h"

enum claim_verdict { CLAIM_HOLDS, CLAIM_SHARPER, CLAIM_REFUTED, CLAIM_UNDECIDED };
const char *claim_verdict_text(enum claim_verdict verdict);

struct claim_row {
  const char *claim, *equation, *quantity, *gait;
  const char *conditions; /* under which it was tested                                        */
  bool inside;            /* these are the conditions that the paper assumes                  */
  double claimed_order;   /* nan: not a claim about an order                                  */
  struct order_fit fit;
  const struct order_point *points; /* what was fitted and what was left out; valid in the sink        */
  int count;
  enum claim_verdict verdict;
  char measured[120]; /* of a qualitative claim: the figure that decides                  */
  char reason[200];   /* of a verdict: why; of a refutation in words: an example to paste     */
};

typedef void claim_sink(void *context, const struct claim_row *row);

/* The claims "... + O(T^n)", each for every gait, inside and outside of its conditions. crawler: T is
 * not used (the claims in words take half of the time at which the Froude number is 1), F1 > F2 and alpha > 1/2 are wanted (exchanged where a row says so). gait: only that one, or
 * NULL for all. */
void claims_of_order(const struct scallop_crawler *crawler, const struct scallop_gait *gait, claim_sink *sink,
                     void *context);

/* The claims in words. crawler: F1 and alpha are varied. */
void claims_in_words(const struct scallop_crawler *crawler, const struct scallop_gait *gait, claim_sink *sink,
                     void *context);

#endif
