/* One gait's part of the ledger while it is filled: the motions that its rows are about, and what the rows said. */
#ifndef SCALLOP_CLAIMS_BOOK_H
#define SCALLOP_CLAIMS_BOOK_H

#include "compare/claims/claims.h"
#include "compare/claims/samples.h"

enum { MOST_CONDITIONS = 5, SETTINGS = 5, MOST_ROWS = 1024 };

struct entry {
  char claim[64];
  const char *conditions;
  char corrected[64];
  bool stands; /* holds or is sharper                                                             */
};

struct book {
  const struct scallop_rational_crawler *crawler; /* with the gait                                */
  const char *only; /* the rows that are wanted, NULL for all                                     */
  claim_sink *sink;
  void *context;
  struct ledger_case cases[SETTINGS][2][MOST_CONDITIONS][2]; /* setting, kind, condition, mirrored */
  bool opened[SETTINGS][2][MOST_CONDITIONS][2];
  struct entry *entries;
  int count;
  const char *contradiction;
};

/* The verdict on a claim from what its formula leaves out: derived_order, coefficient, verdict and reason of the row. */
void claim_judge(struct claim_row *row, const struct ledger_proof *proof);

/* Fits the order to the points, holds it against the derived one, and hands the row to the sink. What contradicts itself is noted
 * in the book. points[row->count] are from the largest h. */
void book_enter(struct book *book, struct claim_row *row, struct order_point *points);

/* Every formula named as right where another is wrong has its row for the same conditions, and holds; if not, it is noted. */
void book_check_corrections(struct book *book);

/* The rows about l' and l near the end of a phase, (A.11) and (A.12) (ends.c). */
void book_add_ends(struct book *book);
/* Is any of a list of names one of these rows? */
bool claims_of_ends_listed(const char *list);

#endif
