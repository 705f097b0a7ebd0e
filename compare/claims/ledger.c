#include "compare/claims/ledger.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/points/point_flint.h"
#include "compare/text/progress.h"
#include "compare/text/memory.h"
#include "model/exact/scoped.h"

/* The order is fitted over the smallest T. */
enum { FITTED = 12, DIGITS = 12 };
/* What is left of the next terms there, many times over. */
static const double AGREEMENT = 1e-6;

const char *claim_evidence_text(const struct claim_row *row)
{
  static char sampled[40];
  switch (row->evidence) {
  case PROVEN_FOR_ALL: return "proven for all parameters";
  case CERTIFIED_CRAWLER: return "certified for the crawler named";
  case SAMPLED: snprintf(sampled, sizeof sampled, "sampled: %d cases", row->sampled); return sampled;
  case MEASURED: return "measured in doubles";
  default: return "-";
  }
}

const char *claim_verdict_text(enum claim_verdict verdict)
{
  static const char *const text[] = { "holds", "sharper", "refuted", "undecided" };
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
  progress_count(ledger->count, 0);
}

void ledger_free(struct ledger *ledger)
{
  for (int i = 0; i < ledger->count; i++)
    free(ledger->rows[i].leading_error);
  free(ledger->rows);
  *ledger = (struct ledger){ .rows = NULL };
}

void ledger_contradict(struct ledger *ledger, const struct claim_row *row, const char *what)
{
  snprintf(ledger->contradiction, sizeof ledger->contradiction, "%s, %s, %s: %s", row->claim, row->gait,
           row->conditions, what);
}

static void set_coefficient(struct claim_row *row, const struct series *left_out, slong power)
{
  SCOPED(fmpq, q);
  SCOPED(arb, x);
  bool is_rational = series_rational_coefficient(q, left_out, power);
  series_coefficient(x, left_out, power, 128);
  if (!is_rational && arb_is_exact(x)) { /* a ball of no radius: a number all the same */
    arf_get_fmpq(q, arb_midref(x));
    is_rational = true;
  }
  char *text = is_rational ? decimal_fraction(q) : NULL;
  if (!text || strlen(text) >= sizeof row->coefficient) {
    flint_free(text);
    text = decimal_ball(x, DIGITS);
  }
  snprintf(row->coefficient, sizeof row->coefficient, "%s", text);
  flint_free(text);
}

static void add_reason(struct claim_row *row, const char *format, double number)
{
  size_t used = strlen(row->reason);
  used += (size_t)snprintf(row->reason + used, sizeof row->reason - used, "%s", used > 0 ? "; " : "");
  if (used < sizeof row->reason)
    snprintf(row->reason + used, sizeof row->reason - used, format, number);
}

/* Finitely many coefficients prove an order up to them, and no equality but of finite sums, or of known degree. */
static void judge_exact(struct claim_row *row, const struct proof *proof)
{
  const bool all = proof->known >= SERIES_ALL;
  const bool equal = isinf(row->claimed_order) && (all || proof->for_all);
  row->verdict = (double)proof->known > row->claimed_order             ? CLAIM_SHARPER
                 : (double)proof->known == row->claimed_order || equal ? CLAIM_HOLDS
                                                                       : CLAIM_UNDECIDED;
  if (all)
    add_reason(row, "every coefficient vanishes", 0);
  else
    add_reason(row, "every coefficient below T^%.0f vanishes", (double)proof->known);
  if (proof->for_all_below > 0 && !all)
    add_reason(row, "for all parameters those below T^%.0f", (double)proof->for_all_below);
  if (row->verdict == CLAIM_UNDECIDED)
    row->evidence = NO_EVIDENCE;
}

static void judge_order(struct claim_row *row, const struct proof *proof)
{
  set_coefficient(row, &proof->left_out, proof->order);
  row->verdict = row->derived_order == row->claimed_order  ? CLAIM_HOLDS
                 : row->derived_order > row->claimed_order ? CLAIM_SHARPER
                                                           : CLAIM_REFUTED;
  if (row->verdict == CLAIM_REFUTED && row->derived_order == 0)
    add_reason(row, "the error does not fall", 0);
  else if (row->verdict != CLAIM_HOLDS)
    add_reason(row, "the error goes as T^%.0f", (double)row->derived_order);
}

void ledger_judge(struct ledger *ledger, struct claim_row *row, const struct proof *proof)
{
  row->proven = !proof->undecided;
  row->evidence = proof->undecided ? NO_EVIDENCE : proof->for_all ? PROVEN_FOR_ALL : CERTIFIED_CRAWLER;
  if (proof->contradicts)
    ledger_contradict(ledger, row, "the coefficients in names are other ones than in numbers");
  row->exact = !proof->undecided && !proof->found;
  row->derived_order = proof->order;
  row->verdict = CLAIM_UNDECIDED;
  if (proof->undecided) {
    snprintf(row->reason, sizeof row->reason, "the coefficient of T^%ld cannot be told from 0", (long)proof->order);
    return;
  }
  (row->exact ? judge_exact : judge_order)(row, proof);
  if (proof->general < proof->order)
    add_reason(row, "of other crawlers as T^%.0f", (double)proof->general);
}

/* Is the error enclosed by 0 at every T, or, last, at the smallest? */
static bool is_enclosed(const struct claim_row *row, bool last)
{
  bool enclosed = row->count > 0;
  for (int i = last ? row->count - 1 : 0; i >= 0 && i < row->count; i++)
    enclosed = enclosed && fabs(row->points[i].err) <= row->points[i].noise;
  return enclosed;
}

/* The measured error is what is left out; of what vanishes below a power it is 0 at the smallest T, or of that. */
static bool agrees(const struct claim_row *row)
{
  return !row->proven
         || (row->exact ? is_enclosed(row, true) || row->fit.order > (double)row->derived_order - CLAIM_TOLERANCE
                        : row->count > 0 && !(row->mismatch > AGREEMENT));
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
    add_reason(row, "but the certified error is not 0 at every T", 0);
  }
  if (!agrees(row)) {
    char what[120];
    if (row->count == 0)
      snprintf(what, sizeof what, "no exact motion has the modes of the expansion");
    else if (row->exact)
      snprintf(what, sizeof what, "nothing is left out, and the certified error is not 0");
    else
      snprintf(what, sizeof what, "the sum of what is left out differs from the certified error by %.1e of it",
               row->mismatch);
    ledger_contradict(ledger, row, what);
  }
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
      snprintf(ledger->contradiction, sizeof ledger->contradiction,
               "%s, %s: %s, which is to take its place, has no row that holds", wrong->claim, wrong->conditions,
               wrong->corrected);
  }
}
