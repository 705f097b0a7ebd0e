/* Claims "... + O(T^n)": decided by the derived expansion, and measured with the certified solver as T decreases. They
 * are the rows of asymptotics' lists of formulas, each under every condition of its setting. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/claims/decide.h"

static const struct condition conditions[] = {
  { SCALLOP_AT_REST_START, SCALLOP_EXTENSION, "extension from rest, F1 > F2", .inside = true },
  { SCALLOP_AT_REST_START, SCALLOP_EXTENSION, "extension from rest, F1 < F2", .reversed = true },
  { SCALLOP_AT_REST_START, SCALLOP_CONTRACTION, "contraction from rest, F2 > F1", .inside = true },
  { SCALLOP_AT_REST_START, SCALLOP_CONTRACTION, "contraction from rest, F2 < F1", .reversed = true },
  { SCALLOP_AT_REST_START, SCALLOP_EXTENSION, "extension from rest, F1 = F2", .inside = true, .equal_forces = true },
  { SCALLOP_AT_REST_START, SCALLOP_CONTRACTION, "contraction from rest, F2 = F1", .inside = true,
    .equal_forces = true },
  { SCALLOP_MOVING_EXTENSION, SCALLOP_EXTENSION, "v0 > 0 fixed, F1 > F2", .inside = true, .v0 = CLAIM_SPEED },
  { SCALLOP_MOVING_EXTENSION, SCALLOP_EXTENSION, "v0 > 0 fixed, F1 < F2", .v0 = CLAIM_SPEED },
  { SCALLOP_MOVING_EXTENSION, SCALLOP_EXTENSION, "v0 < 0 fixed, F1 > F2", .v0 = -CLAIM_SPEED, .reversed = true },
  { SCALLOP_MOVING_CONTRACTION, SCALLOP_CONTRACTION, "v0 > 0 fixed, F1 > F2", .inside = true, .v0 = CLAIM_SPEED },
  { SCALLOP_MOVING_CONTRACTION, SCALLOP_CONTRACTION, "v0 > 0 fixed, F1 < F2", .v0 = CLAIM_SPEED },
  { SCALLOP_MOVING_CONTRACTION, SCALLOP_CONTRACTION, "v0 < 0 fixed, F1 > F2", .v0 = -CLAIM_SPEED, .reversed = true },
  { SCALLOP_STEADY, SCALLOP_EXTENSION, "alpha > 1/2, F1 > F2", .inside = true },
  { SCALLOP_STEADY, SCALLOP_EXTENSION, "alpha < 1/2, F1 < F2", .inside = false },
  { SCALLOP_STEADY, SCALLOP_EXTENSION, "alpha < 1/2, F1 > F2", .reversed = true },
  { SCALLOP_STEADY, SCALLOP_EXTENSION, "alpha > 1/2, F1 < F2", .reversed = true },
  { SCALLOP_STEADY, SCALLOP_EXTENSION, "alpha > 1/2, F1 > F2, m1 a hundredth", .inside = false },
  { SCALLOP_AT_REST_START, SCALLOP_EXTENSION, "h -> 0 at T = 1", .inside = true, .at_end = true },
};
enum { CONDITIONS = sizeof conditions / sizeof *conditions, AT_END = CONDITIONS - 1 };

/* Claims without a row in asymptotics: x1(t1) is of order 2; the derived limit of the steady state; l' and l near the
 * end of an extension, at the time h = T before it */
static const struct scallop_formula size_of_first_switch = {
  "eqA7_x1_first_switch_size", "(A.7)", SCALLOP_MOVING_EXTENSION, SCALLOP_REAR_AT_FIRST, 2, .text = "0"
};
static const struct scallop_formula limits[] = {
  { "limit_v_start", "(26), (27)", SCALLOP_STEADY, SCALLOP_STEADY_VELOCITY, 1, .text = NULL },
  { "limit_displacement", "(28)", SCALLOP_STEADY, SCALLOP_STEADY_DISPLACEMENT, 4, .text = NULL },
};
static const char *const when[] = { "T = 1", NULL };
static const struct scallop_formula ends[] = {
  { "eqA11_dl_near_end", "(A.11)", .quantity = SCALLOP_REAR_AT_END, .remainder = 2, .text = "-T*lT", .when = when },
  { "eqA12_l_near_end", "(A.12)", .quantity = SCALLOP_FRONT_AT_END, .remainder = 3, .text = "T^2/2*lT", .when = when,
    .corrected = "corrected_l_near_end" },
  { "corrected_l_near_end", "(A.12)", .quantity = SCALLOP_FRONT_AT_END, .remainder = 3, .text = "L + T^2/2*lT",
    .when = when },
};

/* Names the row. A formula of ours for an extension also has rows for contractions, with the bodies exchanged; any
 * formula may be mirrored. */
static void name_row(char name[CLAIM_NAME], const struct scallop_formula *f, bool of_contraction, bool mirrored)
{
  snprintf(name, CLAIM_NAME, "%s%s%s", f->name, of_contraction ? ":contraction" : "", mirrored ? ":mirrored" : "");
}

/* Rows of one gait, and their motions */
struct part {
  const struct scallop_rational_crawler *crawler; /* with the gait                                */
  const char *only;                               /* the requested rows, NULL for all             */
  struct claim_table *claims;
  struct trial trial[CONDITIONS][2]; /* each motion is solved once for all its formulas; [1]: mirrored */
};

static struct trial *solve(struct part *part, const struct condition *condition, bool mirrored)
{
  struct trial *trial = &part->trial[condition - conditions][mirrored];
  if (!trial->condition)
    trial_begin(trial, part->crawler, condition, mirrored);
  return trial;
}

/* Returns the phases of the limit in which a body turns; mirrored if the condition is reversed. */
static enum scallop_turns turns_in_limit(struct part *part, const struct condition *condition)
{
  const struct trial *trial = solve(part, condition, condition->reversed);
  return turns_in_modes(trial->series.status == SCALLOP_OK ? trial->series.modes : "");
}

/* The paper's formulas for the steady state assume constant |l''|, with opposite signs in the halves of each phase. */
static bool has_closed_limit(const struct part *part) { return part->crawler->gait == &scallop_gait_quadratic; }

/* Names the formula to use if f is refuted. */
static void name_correction(char name[CLAIM_NAME], struct part *part, const struct scallop_formula *f,
                            const struct condition *condition)
{
  const struct scallop_formula *right = f->corrected ? formula_named(f->corrected) : f;
  bool steady = f->setting == SCALLOP_STEADY, closed = !steady || has_closed_limit(part);
  enum scallop_turns turns = steady && closed ? turns_in_limit(part, condition) : SCALLOP_TURNS_IN_BOTH;
  for (const struct scallop_formula *g = scallop_corrected; turns != SCALLOP_TURNS_IN_BOTH && g->name; g++)
    if (g->turns == turns && g->quantity == f->quantity)
      right = g;
  if (!closed)
    right = &limits[f->quantity == SCALLOP_STEADY_DISPLACEMENT];
  bool of_contraction = f->corrected && right->turns == SCALLOP_TURNS_IN_BOTH && condition->kind == SCALLOP_CONTRACTION;
  name_row(name, right, of_contraction, closed && condition->reversed);
}

static void add_row(struct part *part, const struct scallop_formula *f, const struct condition *condition,
                    bool of_paper, bool mirrored)
{
  bool steady = f->setting == SCALLOP_STEADY, contraction = condition->kind == SCALLOP_CONTRACTION;
  struct claim_row row = row_of_formula(f, part->crawler->gait, condition);
  row.source = of_paper && !mirrored ? OF_PAPER : OF_CORRECTED;
  if (mirrored) /* the other body turns */
    row.quantity = formula_quantity_text(f, contraction ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION);
  if (condition->at_end)
    row.quantity = f->quantity == SCALLOP_REAR_AT_END ? "l'(T-h)" : "l(T-h)";
  name_row(row.claim, f, !of_paper && !steady && contraction, mirrored);
  if ((part->only && !formula_is_listed(part->only, row.claim)) || claim_table_expects(part->claims))
    return;
  if (f->turns != SCALLOP_TURNS_IN_BOTH && f->turns != turns_in_limit(part, condition))
    return; /* for another limit */
  if (!condition->at_end)
    name_correction(row.corrected, part, f, condition);
  if (strcmp(row.corrected, row.claim) == 0)
    *row.corrected = '\0';
  struct trial *trial = solve(part, condition, mirrored);
  claim_table_decide(part->claims, &row, trial, f, trial->series.status == SCALLOP_OK ? NULL : "");
}

/* Returns true if the formula applies to the motion. A formula of ours for an extension applies to a contraction too.
 * The paper's only other condition is F1 = F2. */
static bool is_for(const struct scallop_formula *f, const struct condition *condition, bool ours)
{
  bool turns_over = ours && f->setting == SCALLOP_MOVING_EXTENSION && condition->setting == SCALLOP_MOVING_CONTRACTION;
  return (condition->setting == f->setting || turns_over) && condition->equal_forces == (f->when != NULL);
}

/* Form of a formula: unchanged, under all its conditions; mirrored, under the reversed ones; or a formula of ours in
 * place of another, under all its conditions, mirrored under the reversed ones. */
enum form { UNCHANGED, MIRRORED, CORRECTED };

static void add_formula(struct part *part, const struct scallop_formula *f, enum form form)
{
  bool of_paper = f->text && form != CORRECTED;
  if (f->remainder == 0 && form != CORRECTED)
    return;
  for (const struct condition *c = conditions; c < conditions + AT_END; c++)
    if (is_for(f, c, form == CORRECTED) && (form != MIRRORED || c->reversed))
      add_row(part, f, c, of_paper, form != UNCHANGED && c->reversed);
}

static void fill(struct part *part)
{
  for (const struct scallop_formula *f = scallop_published; f->name; f++) {
    add_formula(part, f, UNCHANGED);
    if (strcmp(f->name, "eqA7_x1_first_switch") == 0)
      add_formula(part, &size_of_first_switch, UNCHANGED);
  }
  for (int i = 0; i < 3; i++)
    add_row(part, &ends[i], &conditions[AT_END], i < 2, false);
  for (const struct scallop_formula *f = scallop_corrected; f->name; f++)
    if (f->setting != SCALLOP_STEADY || has_closed_limit(part))
      add_formula(part, f, CORRECTED);
  add_formula(part, &limits[0], UNCHANGED);
  add_formula(part, &limits[1], UNCHANGED);
  for (const struct scallop_formula *f = scallop_published; f->name; f++)
    if (!f->corrected && (f->setting != SCALLOP_STEADY || has_closed_limit(part)))
      add_formula(part, f, MIRRORED);
}

/* Records a contradiction unless every refuted row from `first` on names a formula that has a row for the same
 * conditions, and it holds. */
static void check_corrections(struct claim_table *claims, int first)
{
  for (int i = first; i < claims->count; i++) {
    const struct claim_row *wrong = &claims->rows[i];
    bool replaced = wrong->verdict != CLAIM_REFUTED;
    for (int j = first; j < claims->count && !replaced; j++) {
      const struct claim_row *row = &claims->rows[j];
      replaced = row->verdict <= CLAIM_SHARPER && strcmp(row->claim, wrong->corrected) == 0
                 && strcmp(row->conditions, wrong->conditions) == 0;
    }
    if (!replaced)
      claim_table_contradict(claims, wrong, "its correction, '%s', has no row that holds", wrong->corrected);
  }
}

void claim_table_add_orders(struct claim_table *claims, const struct scallop_rational_crawler *crawler,
                            const char *only)
{
  const int first = claims->count;
  struct part part = { .crawler = crawler, .only = only, .claims = claims };
  fill(&part);
  if (!only && !claims->is_forecast && scallop_gait_named(crawler->gait->name))
    check_corrections(claims, first);
  for (int i = 0; i < 2 * CONDITIONS; i++)
    if (part.trial[i / 2][i % 2].condition)
      trial_clear(&part.trial[i / 2][i % 2]);
}
