/* The ledger: every asymptotic and qualitative claim of the paper, decided. */
#ifndef SCALLOP_CLAIMS_H
#define SCALLOP_CLAIMS_H

#include <stdbool.h>

#include "compare/order/order.h"
#include "compare/text/message.h"
#include "model/ball.h"
#include "model/model.h"

struct options;

enum claim_verdict { CLAIM_HOLDS, CLAIM_SHARPER, CLAIM_REFUTED, CLAIM_UNDECIDED };
const char *claim_verdict_text(enum claim_verdict verdict);

struct claim_row {
  char claim[64];
  const char *equation, *quantity, *gait;
  const char *conditions; /* under which it was tested                                        */
  bool inside;            /* these are the conditions that the paper assumes                  */
  bool ours;              /* not a claim of the paper's, but one of the formulas that hold where it does not */
  double claimed_order;   /* nan: not a claim about an order                                  */
  bool proven;            /* derived_order and coefficient are there                          */
  bool exact;             /* every coefficient that was looked at vanishes                    */
  long derived_order;     /* of the first coefficient of what is left out                     */
  char coefficient[80];   /* exact, or a ball that does not hold 0; "" if none                */
  double slope;           /* measured between the two smallest T; nan if there is no error    */
  struct order_fit fit;
  const struct order_point *points; /* what was measured; valid in the sink                   */
  int count;
  enum claim_verdict verdict;
  char corrected[64]; /* of a refuted formula: the row of the one that holds, or ""               */
  char measured[200]; /* of a qualitative claim: the figure that decides                  */
  char reason[320];   /* of a verdict: why; of a refutation in words: an example to paste     */
};

typedef void claim_sink(void *context, const struct claim_row *row);

/* The claims "... + O(T^n)", each for every gait, inside and outside of its conditions, and the formulas that hold where one
 * of the paper's does not. crawler: T is not used; F1 > F2 and alpha > 1/2 are wanted (exchanged where a row says so). gait:
 * only that one, or NULL for all. only: the names of the rows that are wanted (see claim_is_listed), or NULL. Returns NULL, or what contradicts itself: a slope that is not the derived order, a
 * refuted formula whose correction has no row that holds. Static text until the next call. */
const char *claims_of_order(const struct scallop_rational_crawler *crawler, const struct scallop_gait *gait,
                            const char *only, claim_sink *sink, void *context);

/* Is the name one of a list, separated by commas, or the list "all"? */
bool claim_is_listed(const char *list, const char *name);
/* Is any of the list a claim about an order? */
bool claims_have_order(const char *list);

/* The claims in words. crawler: F1 and alpha are varied; they take half of the time at which the Froude number is 1. */
void claims_in_words(const struct scallop_crawler *crawler, const struct scallop_gait *gait, claim_sink *sink,
                     void *context);

/* `scallop claims` */
enum exit_code claims_table(const struct options *options);
/* claims --check: a table of the verdicts that differ from those of the ledger, the text of a table. EXIT_CHECK_FAILED: some do. */
struct options;
enum exit_code claims_check(const struct options *options, const char *ledger);

#endif
