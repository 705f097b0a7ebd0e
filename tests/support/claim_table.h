/* The whole table of claims of one crawler, for tests of its rows. */
#ifndef SCALLOP_TESTS_SUPPORT_CLAIM_TABLE_H
#define SCALLOP_TESTS_SUPPORT_CLAIM_TABLE_H

#include <stdio.h>
#include <string.h>

#include "compare/claims/claims.h"
#include "compare/points/point_flint.h"
#include "tests/support/random_crawler.h"
#include "tests/support/scoped.h"
#include "tests/support/solved.h"

static inline void fill_claim_table(struct claim_table *claims, const struct scallop_crawler *crawler, bool orders)
{
  SCOPED(scallop_rational, exact);
  struct scallop_crawler c = *crawler;
  for (int g = 0; g < 2; g++) {
    c.gait = every_gait[g];
    rational_crawler(&exact, &c);
    if (orders)
      claim_table_add_orders(claims, &exact, NULL);
    claim_table_add_words(claims, &c);
  }
}

/* The one that the tests of a program look at, and its end */
static struct claim_table claims;
static inline int empty(void **state) { return (void)state, claim_table_free(&claims), 0; }

/* Filled for the tests' crawler, with or without the claims about orders */
static inline int fill(bool orders)
{
  fill_claim_table(&claims, &(struct scallop_crawler){ 1.7, 0.8, 4.1, 1.3, 11.3, 1, 0.66, &scallop_gait_quadratic },
                   orders);
  return 0;
}

/* Its first row about every_gait[g] whose conditions hold the text, among those of the paper, the others, or all */
enum which_rows { OUTSIDE, INSIDE, ALL_ROWS };
static inline const struct claim_row *find(const char *claim, int g, const char *conditions, int which)
{
  for (const struct claim_row *row = claims.rows; row < claims.rows + claims.count; row++)
    if (strcmp(row->claim, claim) == 0 && strcmp(row->gait, every_gait[g]->name) == 0
        && strstr(row->conditions, conditions) && (which == ALL_ROWS || row->inside == (which == INSIDE)))
      return row;
  fail_msg("no row %s, %s, %s", claim, every_gait[g]->name, conditions);
  return claims.rows;
}

static inline const struct claim_row *row_of(const char *claim, int g, const char *conditions)
{
  return find(claim, g, conditions, ALL_ROWS);
}

/* The numbers behind a text in what was measured: as many as sscanf is to read */
#define READ_NUMBERS(row, text, count, ...) assert_int_equal(sscanf(behind(row, text), __VA_ARGS__), count)
static inline const char *behind(const struct claim_row *row, const char *text)
{
  const char *at = strstr(row->summary, text);
  if (!at)
    fail_msg("%s: no '%s' in '%s'", row->claim, text, row->summary);
  return at ? at + strlen(text) : "";
}

static inline double number_after(const struct claim_row *row, const char *text)
{
  double x = NAN;
  READ_NUMBERS(row, text, 1, "%lf", &x);
  return x;
}

/* The paper's crawler */
static inline struct scallop_crawler paper(int g) { return with_gait(every_gait[g]); }

#endif
