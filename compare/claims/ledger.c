#include "compare/claims/ledger.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/answers/point_flint.h"
#include "compare/text/memory.h"

/* The order is fitted over the smallest T. */
enum { FITTED = 12, DIGITS = 12 };
/* What is left of the next terms there, many times over. */
static const double AGREEMENT = 1e-6;

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
  snprintf(ledger->contradiction, sizeof ledger->contradiction, "%s, %s, %s: %s", row->claim, row->gait, row->conditions,
           what);
}

static void set_coefficient(struct claim_row *row, const struct series *left_out, slong power)
{
  fmpq_t q;
  arb_t x;
  fmpq_init(q);
  arb_init(x);
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
  fmpq_clear(q);
  arb_clear(x);
}

static void judge_exact(struct claim_row *row, const struct proof *proof)
{
  row->verdict = isinf(row->claimed_order) ? CLAIM_HOLDS : CLAIM_SHARPER;
  if (proof->known >= SERIES_ALL)
    snprintf(row->reason, sizeof row->reason, "every coefficient vanishes");
  else
    snprintf(row->reason, sizeof row->reason, "every coefficient below T^%ld vanishes", (long)proof->known);
}

void ledger_judge(struct claim_row *row, const struct proof *proof)
{
  row->proven = !proof->undecided;
  row->exact = !proof->undecided && !proof->found;
  row->derived_order = proof->order;
  row->verdict = CLAIM_UNDECIDED;
  if (proof->undecided) {
    snprintf(row->reason, sizeof row->reason, "the coefficient of T^%ld cannot be told from 0", (long)proof->order);
    return;
  }
  if (row->exact) {
    judge_exact(row, proof);
    return;
  }
  set_coefficient(row, &proof->left_out, proof->order);
  row->verdict = row->derived_order == row->claimed_order  ? CLAIM_HOLDS
                 : row->derived_order > row->claimed_order ? CLAIM_SHARPER
                                                           : CLAIM_REFUTED;
  if (row->verdict == CLAIM_REFUTED && row->derived_order == 0)
    snprintf(row->reason, sizeof row->reason, "the error does not fall");
  else if (row->verdict != CLAIM_HOLDS)
    snprintf(row->reason, sizeof row->reason, "the error goes as T^%ld", row->derived_order);
  if (proof->general < proof->order)
    snprintf(row->reason + strlen(row->reason), sizeof row->reason - strlen(row->reason), "%sof other crawlers as T^%ld",
             *row->reason ? "; " : "", (long)proof->general);
}

/* The measured slope is the derived order, or the error is enclosed by 0 throughout. */
static bool agrees(const struct claim_row *row)
{
  if (!row->proven)
    return true;
  for (int i = 0; row->exact && i < row->count; i++)
    if (!(fabs(row->points[i].err) <= row->points[i].noise))
      return false;
  return row->exact ? row->count > 0 : fabs(row->slope - (double)row->derived_order) <= AGREEMENT;
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
  if (!agrees(row)) {
    char what[120];
    if (isnan(row->slope) && !row->exact)
      snprintf(what, sizeof what, "the derived order is %ld, and no slope could be measured", row->derived_order);
    else
      snprintf(what, sizeof what, "the derived order is %ld, the measured slope %.9g", row->derived_order, row->slope);
    ledger_contradict(ledger, row, what);
  }
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
      stands = (row->verdict == CLAIM_HOLDS || row->verdict == CLAIM_SHARPER) && strcmp(row->claim, wrong->corrected) == 0
               && strcmp(row->conditions, wrong->conditions) == 0;
    }
    if (!stands)
      snprintf(ledger->contradiction, sizeof ledger->contradiction,
               "%s, %s: %s, which is to take its place, has no row that holds", wrong->claim, wrong->conditions,
               wrong->corrected);
  }
}
