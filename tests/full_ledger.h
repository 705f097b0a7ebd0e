/* The whole ledger of one crawler, for tests of its rows. */
#ifndef SCALLOP_TESTS_FULL_LEDGER_H
#define SCALLOP_TESTS_FULL_LEDGER_H

#include "tests/check.h"

#include <stdio.h>
#include <string.h>

#include "compare/claims/claims.h"
#include "compare/answers/point_flint.h"
#include "numerics/numerics.h"

static inline void fill_ledger(struct ledger *ledger, const struct scallop_crawler *crawler, bool orders)
{
  struct scallop_rational_crawler exact;
  scallop_rational_init(&exact);
  rational_crawler(&exact, crawler);
  if (orders)
    ledger_add_orders(ledger, &exact, NULL, NULL);
  ledger_add_words(ledger, crawler, NULL);
  scallop_rational_clear(&exact);
}

/* conditions: all of them, or NULL for any */
static inline const struct claim_row *find_row(const struct ledger *ledger, const char *claim, const char *gait,
                                               const char *conditions, bool inside)
{
  for (const struct claim_row *row = ledger->rows; row < ledger->rows + ledger->count; row++)
    if (strcmp(row->claim, claim) == 0 && strcmp(row->gait, gait) == 0 && row->inside == inside
        && (!conditions || strcmp(row->conditions, conditions) == 0))
      return row;
  fail_msg("no row %s, %s", claim, gait);
  return ledger->rows;
}

#endif
