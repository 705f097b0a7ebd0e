/* A ledger that was written before, for its verdicts. */
#ifndef SCALLOP_CLAIMS_READ_H
#define SCALLOP_CLAIMS_READ_H

#include <stdbool.h>

#include "compare/command/compare.h"

enum { COMMITTED_KEYS = 5 };

struct committed {
  char *line;                      /* holds the cells                                               */
  const char *key[COMMITTED_KEYS]; /* claim, equation, quantity, gait, conditions                   */
  const char *verdict, *order;
  bool met; /* for who compares: some row of today's ledger was this one           */
};

struct committed_ledger {
  struct committed *rows;
  int count, room;
};

/* Reads the file into a ledger, to be freed whatever the exit code is; it is EXIT_DONE, or the message is on stderr. NULL: the
 * ledger that comes with the tool. */
enum exit_code committed_read(struct committed_ledger *ledger, const char *file);
/* For messages. */
const char *ledger_name(const char *name);
void committed_free(struct committed_ledger *ledger);

#endif
