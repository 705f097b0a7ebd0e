#include "compare/claims/orders.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text/progress.h"
#include "compare/text/memory.h"
#include "model/exact/scoped.h"

/* The order is fitted over the smallest T. */
enum { FITTED = 12 };
/* What is left of the next terms there, many times over. */
static const double AGREEMENT = 1e-6;

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
  struct claim_row *rows = with_room(ledger->rows, ledger->count, sizeof *rows);
  if (!rows) {
    snprintf(ledger->contradiction, sizeof ledger->contradiction, "out of memory");
    free(row->leading_error);
    return;
  }
  ledger->rows = rows;
  rows[ledger->count++] = *row;
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
  free(ledger->rows);
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

void add_reason(struct claim_row *row, const char *format, ...)
{
  char reason[sizeof row->reason];
  va_list values;
  va_start(values, format);
  vsnprintf(reason, sizeof reason, format, values);
  va_end(values);
  append(row->reason, sizeof row->reason, "%s%s", *row->reason ? "; " : "", reason);
}

struct claim_row row_of_formula(const struct scallop_formula *f, const struct scallop_gait *gait)
{
  struct claim_row row = { .equation = f->equation,
                           .gait = gait->name,
                           .claimed_order = f->remainder == SCALLOP_EQUALITY ? INFINITY : f->remainder,
                           .mismatch = NAN };
  append(row.claim, sizeof row.claim, "%s", f->name);
  append(row.corrected, sizeof row.corrected, "%s", f->corrected ? f->corrected : "");
  return row;
}

/* Is the error enclosed by 0 at every T, or, last, at the smallest? */
static bool is_enclosed(const struct claim_row *row, bool last)
{
  bool enclosed = row->count > 0;
  for (int i = last ? row->count - 1 : 0; i >= 0 && i < row->count; i++)
    enclosed = enclosed && fabs(row->points[i].err) <= row->points[i].noise;
  return enclosed;
}

static void fit(struct claim_row *row)
{
  struct scallop_order_point *points = row->points;
  int tail = row->count < FITTED ? row->count : FITTED;
  for (int i = 0; i < row->count; i++) {
    points[i].pairwise = i + 1 < row->count
                             ? log(fabs(points[i].err / points[i + 1].err)) / log(points[i].h / points[i + 1].h)
                             : NAN;
    points[i].use = row->exact ? SCALLOP_ORDER_ZERO : SCALLOP_ORDER_COARSE;
  }
  struct scallop_order_wanted wanted = { .order = NAN, .tolerance = CLAIM_TOLERANCE };
  scallop_order(points + row->count - tail, &tail, &wanted, &row->fit);
}

void ledger_enter(struct ledger *ledger, struct claim_row *row)
{
  fit(row);
  if (row->exact && isinf(row->claimed_order) && row->count > 0 && !is_enclosed(row, false)) {
    row->verdict = CLAIM_REFUTED;
    row->evidence = CERTIFIED_CRAWLER;
    add_reason(row, "but the certified error is not 0 at every T");
  }
  const bool beyond = row->fit.order > (double)row->derived_order - CLAIM_TOLERANCE; /* of what was looked at */
  /* the measured error is what is left out; of what vanishes below a power it is 0 at the smallest T, or of that */
  if (row->proven && row->count == 0)
    ledger_contradict(ledger, row, "no exact motion has the modes of the expansion");
  else if (row->proven && row->exact && !is_enclosed(row, true) && !beyond)
    ledger_contradict(ledger, row, "nothing is left out, and the certified error is not 0");
  else if (row->proven && !row->exact && row->mismatch > AGREEMENT)
    ledger_contradict(ledger, row, "the sum of what is left out differs from the certified error by %.1e of it",
                      row->mismatch);
  if (row->proven && !row->exact && fabs(row->fit.order - (double)row->derived_order) > CLAIM_TOLERANCE)
    add_reason(row, "at the T that were measured it goes as T^%.3g", row->fit.order);
  if (row->verdict != CLAIM_REFUTED)
    *row->corrected = '\0';
  /* the corrections are for the gaits of the paper: with others there may be none */
  else if (!*row->corrected && row->source != OF_BOOK && scallop_gait_named(row->gait))
    ledger_contradict(ledger, row, "refuted, and nothing is named that holds");
  ledger_add(ledger, row);
}

void ledger_check_corrections(struct ledger *ledger, int first)
{
  for (int i = first; i < ledger->count; i++) {
    const struct claim_row *wrong = &ledger->rows[i];
    bool stands = !*wrong->corrected;
    for (int j = first; j < ledger->count && !stands; j++) {
      const struct claim_row *row = &ledger->rows[j];
      stands = (row->verdict == CLAIM_HOLDS || row->verdict == CLAIM_SHARPER)
               && strcmp(row->claim, wrong->corrected) == 0 && strcmp(row->conditions, wrong->conditions) == 0;
    }
    if (!stands)
      ledger_contradict(ledger, wrong, "%s, which is to take its place, has no row that holds", wrong->corrected);
  }
}
