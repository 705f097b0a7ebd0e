/* The claims of a book, `claims --book` and `claims --formula`: each formula for each gait, at one crawler, and at
 * random ones. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/answers/answer.h"
#include "compare/points/point_flint.h"
#include "compare/answers/quantities.h"
#include "compare/book/book.h"
#include "compare/claims/evidence.h"
#include "compare/claims/ledger.h"
#include "compare/claims/samples.h"

static struct condition condition_of(const struct scallop_formula *f)
{
  bool moving = f->setting == SCALLOP_MOVING_EXTENSION || f->setting == SCALLOP_MOVING_CONTRACTION;
  return (struct condition){
    .setting = moving ? SCALLOP_MOVING_EXTENSION : f->setting,
    .kind = f->setting == SCALLOP_MOVING_CONTRACTION ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION,
    .text = f->setting == SCALLOP_STEADY             ? "steady state"
            : f->setting == SCALLOP_AT_REST_START    ? "extension from rest"
            : f->setting == SCALLOP_MOVING_EXTENSION ? "extension, v0 > 0 fixed"
                                                     : "contraction, v0 > 0 fixed",
    .v0 = moving ? CLAIM_SPEED : 0,
    .formula = f,
  };
}

static const char *const turns_text[] = { "a body turns in both phases", "no body turns in the contraction",
                                          "no body turns in the extension" };

/* "alpha > 1/2, F1 > F2", behind the motion */
static void write_conditions(struct claim_row *row, const struct condition *condition)
{
  size_t used = (size_t)snprintf(row->conditions, sizeof row->conditions, "%s", condition->text);
  for (const char *const *when = condition->formula->when; when && *when && used < sizeof row->conditions; when++)
    used += (size_t)snprintf(row->conditions + used, sizeof row->conditions - used, ", %s", *when);
  if (condition->formula->turns != SCALLOP_TURNS_IN_BOTH && used < sizeof row->conditions)
    snprintf(row->conditions + used, sizeof row->conditions - used, ", %s", turns_text[condition->formula->turns]);
}

/* v0, and the numbers of the crawler that the conditions have changed, as "v0=8/5 F1=3/2 F2=1/2" */
static void write_change(struct claim_row *row, const struct scallop_rational_crawler *now,
                         const struct scallop_rational_crawler *before, const fmpq_t v0)
{
  fmpq_t rest;
  fmpq_init(rest);
  const fmpq *const numbers[][2] = { { v0, rest },
                                     { now->m1, before->m1 },
                                     { now->m2, before->m2 },
                                     { now->F1, before->F1 },
                                     { now->F2, before->F2 },
                                     { now->L, before->L },
                                     { now->alpha, before->alpha } };
  static const char *const names[] = { "v0", "m1", "m2", "F1", "F2", "L", "alpha" };
  size_t used = 0;
  for (int i = 0; i < 7; i++)
    if (!fmpq_equal(numbers[i][0], numbers[i][1])) {
      char *text = fmpq_get_str(NULL, 10, numbers[i][0]);
      used += (size_t)snprintf(row->measured + used, sizeof row->measured - used, "%s%s=%s", used > 0 ? " " : "",
                               names[i], text);
      flint_free(text);
    }
  fmpq_clear(rest);
}

/* Why nothing can be said of the claim, or NULL */
static const char *undecided(const struct condition *condition, const struct trial *trial, bool is_met)
{
  static char text[240];
  if (!is_met)
    return "no crawler was found for which the conditions hold";
  if (trial->why) {
    snprintf(text, sizeof text, "no expansion in powers of T is known for this motion: %s", trial->why);
    return text;
  }
  if (!trial_is_steady(trial) || !condition->formula->turns)
    return NULL;
  enum scallop_turns found = turns_in_modes(trial_modes(trial));
  if (found == condition->formula->turns)
    return NULL;
  snprintf(text, sizeof text, "the formula is for crawlers of which, as T -> 0, %s; of this crawler %s",
           turns_text[condition->formula->turns], turns_text[found]);
  return text;
}

void ledger_add_formula(struct ledger *ledger, const struct scallop_rational_crawler *crawler, bool is_given,
                        const struct scallop_formula *f)
{
  const struct condition condition = condition_of(f);
  struct claim_row row = { .equation = f->equation,
                           .quantity = formula_quantity_text(f, condition.kind),
                           .gait = crawler->gait->name,
                           .source = OF_BOOK,
                           .claimed_order = f->remainder == SCALLOP_EQUALITY ? INFINITY : f->remainder,
                           .mismatch = NAN };
  struct scallop_rational_crawler fitted;
  struct trial trial;
  struct proof proof;
  snprintf(row.claim, sizeof row.claim, "%s", f->name);
  snprintf(row.corrected, sizeof row.corrected, "%s", f->corrected ? f->corrected : "");
  write_conditions(&row, &condition);
  scallop_rational_init(&fitted);
  scallop_rational_copy(&fitted, crawler);
  row.inside = is_given ? condition_allows(&condition, &fitted) : condition_fit(&condition, &fitted);
  bool expands = trial_init(&trial, &fitted, &condition, false);
  write_change(&row, &fitted, crawler, trial.v0);
  trial.samples = expands ? samples_take(&trial) : NULL;
  proof_init(&proof);
  const char *why = undecided(&condition, &trial, is_given || row.inside);
  if (!why && !trial_prove(&proof, &trial, f))
    why = proof.why;
  if (why) {
    row.verdict = CLAIM_UNDECIDED;
    char place[FORMULA_PLACE]; /* of what is wrong with the text */
    bool in_text = strncmp(why, "character", 9) == 0;
    snprintf(row.reason, sizeof row.reason, "%s%s", in_text ? formula_place(place, f) : "", why);
  } else {
    samples_measure(&row, &trial, f, &proof.left_out);
    ledger_judge(ledger, &row, &proof);
    if (!is_given && proof.general < proof.order && (double)proof.general < row.claimed_order)
      row.verdict = CLAIM_REFUTED; /* it holds for this crawler by coincidence */
    row.leading_error = proof.term;
    proof.term = NULL;
  }
  ledger_enter(ledger, &row);
  samples_free(trial.samples);
  trial_clear(&trial);
  proof_clear(&proof);
  scallop_rational_clear(&fitted);
}

void ledger_add_book(struct ledger *ledger, const struct scallop_rational_crawler *crawler, bool is_given,
                     const struct scallop_gait *gait, const char *only)
{
  const struct scallop_formula *f;
  struct scallop_rational_crawler c;
  scallop_rational_init(&c);
  scallop_rational_copy(&c, crawler);
  for (int g = 0; gait ? g == 0 : scallop_gait_name(g) != NULL; g++) {
    c.gait = gait ? gait : scallop_gait_named(scallop_gait_name(g));
    for (int i = 0; (f = book_formula(i)); i++)
      if (f->remainder != 0 && (!only || formula_is_listed(only, f->name)) && !ledger_expects(ledger))
        ledger_add_formula(ledger, &c, is_given, f);
  }
  scallop_rational_clear(&c);
}
