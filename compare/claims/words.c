/* The rows of the claims in words */
#include <math.h>

#include "compare/claims/decide.h"

static void add_row(struct ledger *ledger, const struct statement *claim, const struct scallop_crawler *crawler,
                    bool of_the_paper)
{
  struct question q = { .claim = claim,
                        .crawler = *crawler,
                        .of_the_paper = of_the_paper,
                        .by = CERTIFIED_CRAWLER,
                        .solved = true,
                        .row = { .equation = claim->place,
                                 .quantity = claim->quantity,
                                 .gait = crawler->gait->name,
                                 .inside = of_the_paper && !claim->outside,
                                 .in_words = true,
                                 .claimed_order = NAN,
                                 .fit = { .order = NAN, .low = NAN, .high = NAN } } };
  append(q.row.claim, sizeof q.row.claim, "%s", claim->name);
  append(q.row.conditions, sizeof q.row.conditions, claim->conditions,
         of_the_paper ? "the paper's crawler" : "the ledger's crawler");
  set_conditions(&q.crawler, q.row.conditions);
  claim->test(&q, q.crawler);
  ledger_add(ledger, &q.row);
}

static void add_rows(struct ledger *ledger, const struct statement *claim, const struct scallop_crawler *crawler,
                     bool of_the_paper)
{
  for (; claim->name; claim++)
    if ((of_the_paper || !claim->of_its_crawler)
        && (scallop_gait_named(crawler->gait->name) || !claim->of_its_gaits_alone) && !ledger_expects(ledger))
      add_row(ledger, claim, crawler, of_the_paper);
}

void ledger_add_words(struct ledger *ledger, const struct scallop_crawler *crawler)
{
  struct scallop_crawler paper = scallop_crawler_default(), own = *crawler;
  paper.gait = crawler->gait;
  own.T = 0.5 * sqrt((own.m1 + own.m2) / (own.F1 + own.F2) * own.L); /* half of that at which the Froude number is 1 */
  add_rows(ledger, statements_at_random, &paper, true);
  add_rows(ledger, statements_by_example, &paper, true);
  add_rows(ledger, statements_of_families, &paper, true);
  add_rows(ledger, statements_of_figures, &paper, true);
  add_rows(ledger, statements_of_families, &own, false);
  add_rows(ledger, statements_of_figures, &own, false);
}
