/* How a row about an order comes into the ledger. Needs FLINT. Not public. */
#ifndef SCALLOP_COMPARE_CLAIMS_LEDGER_H
#define SCALLOP_COMPARE_CLAIMS_LEDGER_H

#include "compare/claims/trial.h"

/* The verdict on a claim from what its formula leaves out: derived_order, coefficient, verdict, evidence and reason of
 * the row. */
void ledger_judge(struct ledger *ledger, struct claim_row *row, const struct proof *proof);

/* Notes what a row has that cannot be. */
void ledger_contradict(struct ledger *ledger, const struct claim_row *row, const char *what);

/* Fits the order to the points of the row, holds it against the derived one, and adds the row. What contradicts itself
 * is noted. */
void ledger_enter(struct ledger *ledger, struct claim_row *row);

/* Every formula that a row from `first` on names as right where another is wrong has its row for the same conditions,
 * and holds; if not, it is noted. */
void ledger_check_corrections(struct ledger *ledger, int first);

#endif
