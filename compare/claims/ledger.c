#include "compare/claims/orders.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text/progress.h"

void append(char *text, size_t size, const char *format, ...)
{
  size_t used = strlen(text);
  va_list values;
  va_start(values, format);
  vsnprintf(text + used, size - used, format, values);
  va_end(values);
}

const char *claim_verdict_text(enum claim_verdict verdict)
{
  static const char *const text[] = { "holds", "sharper", "undecided", "refuted" };
  return text[verdict];
}

void ledger_add(struct ledger *ledger, const struct claim_row *row)
{
  ledger->rows = flint_realloc(ledger->rows, (size_t)(ledger->count + 1) * sizeof *row);
  ledger->rows[ledger->count++] = *row;
  if (ledger->expected > 0) /* a table of its own, and no row of another */
    progress_count(ledger->count, ledger->expected);
}

bool ledger_expects(struct ledger *ledger)
{
  ledger->expected += ledger->is_forecast;
  return ledger->is_forecast;
}

void ledger_free(struct ledger *ledger)
{
  for (int i = 0; i < ledger->count; i++)
    free(ledger->rows[i].leading_error);
  flint_free(ledger->rows);
  *ledger = (struct ledger){ .rows = NULL };
}

void ledger_contradict(struct ledger *ledger, const struct claim_row *row, const char *format, ...)
{
  va_list values;
  va_start(values, format);
  vsnprintf(ledger->contradiction, sizeof ledger->contradiction, format, values);
  va_end(values);
  append(ledger->contradiction, sizeof ledger->contradiction, " (%s, %s, %s)", row->claim, row->gait, row->conditions);
}

struct claim_row row_of_formula(const struct scallop_formula *f, const struct scallop_gait *gait,
                                const struct condition *condition)
{
  struct claim_row row = { .equation = f->equation,
                           .quantity = formula_quantity_text(f, condition->kind),
                           .gait = gait->name,
                           .inside = condition->inside,
                           .claimed_order = f->remainder == SCALLOP_EQUALITY ? INFINITY : f->remainder,
                           .mismatch = NAN };
  append(row.claim, sizeof row.claim, "%s", f->name);
  append(row.corrected, sizeof row.corrected, "%s", f->corrected ? f->corrected : "");
  append(row.conditions, sizeof row.conditions, "%s", condition->text);
  return row;
}
