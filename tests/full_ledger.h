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

/* That of the tests' crawler: a group's setup, with or without the claims about orders, and its end */
static struct ledger ledger;

static inline int fill(bool orders)
{
  fill_ledger(&ledger, &(struct scallop_crawler){ 1.7, 0.8, 4.1, 1.3, 11.3, 1, 0.66, &scallop_gait_quadratic }, orders);
  return 0;
}

static inline int empty(void **state)
{
  (void)state;
  ledger_free(&ledger);
  return 0;
}

/* Its row. conditions: all of them, or NULL for any */
static inline const struct claim_row *find(const char *claim, const char *gait, const char *conditions, bool inside)
{
  for (const struct claim_row *row = ledger.rows; row < ledger.rows + ledger.count; row++)
    if (strcmp(row->claim, claim) == 0 && strcmp(row->gait, gait) == 0 && row->inside == inside
        && (!conditions || strcmp(row->conditions, conditions) == 0))
      return row;
  fail_msg("no row %s, %s", claim, gait);
  return ledger.rows;
}

#endif
