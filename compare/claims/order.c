/* The claims "... + O(T^n)": decided by the derived expansion, and measured with the certified solver as T falls. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "asymptotics/asymptotics.h"
#include "compare/claims/book.h"
#include "compare/answers/answer.h"

static const double SPEED = 0.37;

static const struct condition extension_from_rest[] = {
  { .text = "extension from rest, F1 > F2", .inside = true },
  { .text = "extension from rest, F1 < F2", .exchange_forces = true, .reversed = true },
  { .text = NULL }
};
static const struct condition contraction_from_rest[] = { /* the bodies exchanged */
                                                          { .text = "contraction from rest, F2 > F1",
                                                            .inside = true,
                                                            .exchange_forces = true },
                                                          { .text = "contraction from rest, F2 < F1", .reversed = true },
                                                          { .text = NULL }
};
static const struct condition equal_forces[][2] = {
  { { .text = "extension from rest, F1 = F2", .inside = true, .equal_forces = true }, { .text = NULL } },
  { { .text = "contraction from rest, F2 = F1", .inside = true, .equal_forces = true }, { .text = NULL } },
};
static const struct condition moving[] = { { .text = "v0 > 0 fixed, F1 > F2", .inside = true, .v0 = SPEED },
                                           { .text = "v0 > 0 fixed, F1 < F2", .v0 = SPEED, .exchange_forces = true },
                                           { .text = "v0 < 0 fixed, F1 > F2", .v0 = -SPEED, .reversed = true },
                                           { .text = NULL } };
static const struct condition steady[] = { { .text = "alpha > 1/2, F1 > F2", .inside = true },
                                           { .text = "alpha < 1/2, F1 < F2", .exchange_forces = true, .mirror_alpha = true },
                                           { .text = "alpha < 1/2, F1 > F2", .mirror_alpha = true, .reversed = true },
                                           { .text = "alpha > 1/2, F1 < F2", .exchange_forces = true, .reversed = true },
                                           { .text = "alpha > 1/2, F1 > F2, m1 a hundredth", .light_1 = true },
                                           { .text = NULL } };
static const struct condition *conditions_of(enum scallop_setting setting, int kind)
{
  switch (setting) {
  case SCALLOP_AT_REST_START: return kind == SCALLOP_EXTENSION ? extension_from_rest : contraction_from_rest;
  case SCALLOP_AT_REST_EQUAL_FORCES: return equal_forces[kind];
  case SCALLOP_STEADY: return steady;
  case SCALLOP_MOVING_EXTENSION:
  case SCALLOP_MOVING_CONTRACTION: break;
  }
  return moving;
}

static bool is_from_rest(enum scallop_setting setting)
{
  return setting == SCALLOP_AT_REST_START || setting == SCALLOP_AT_REST_EQUAL_FORCES;
}

/* Each motion is solved once, and serves all the formulas about it. NULL if it has no expansion. */
static struct ledger_case *case_of(struct book *book, enum scallop_setting setting, int kind, int condition, bool mirrored)
{
  int s = setting == SCALLOP_MOVING_CONTRACTION ? SCALLOP_MOVING_EXTENSION : setting;
  struct ledger_case *c = &book->cases[s][kind][condition][mirrored];
  if (!book->opened[s][kind][condition][mirrored]) {
    book->opened[s][kind][condition][mirrored] = true;
    if (ledger_case_init(c, book->crawler, setting, (enum scallop_phase_kind)kind, &conditions_of(setting, kind)[condition],
                         mirrored)
        != SCALLOP_OK) {
      ledger_case_clear(c);
      c->condition = NULL;
    }
  }
  return c->condition ? c : NULL;
}

static void close_cases(struct book *book)
{
  for (int s = 0; s < SETTINGS; s++)
    for (int kind = 0; kind < 2; kind++)
      for (int i = 0; i < MOST_CONDITIONS; i++)
        for (int m = 0; m < 2; m++)
          if (book->cases[s][kind][i][m].condition)
            ledger_case_clear(&book->cases[s][kind][i][m]);
}

/* ---- rows ---- */

struct claimed {
  const struct scallop_formula *formula; /* NULL: the quantity itself                             */
  const char *name, *equation;
  enum scallop_setting setting;
  enum scallop_quantity quantity;
  int order;
  bool limit; /* the limit of the steady state as derived                                         */
};

/* In the limit no body turns in one of the phases (seen in a mirror if the condition is reversed): its ending in the names of
 * the corrected formulas, or "". */
static const char *no_turn(struct book *book, int condition)
{
  const struct ledger_case *c = case_of(book, SCALLOP_STEADY, SCALLOP_EXTENSION, condition, steady[condition].reversed);
  const char *modes = c ? ledger_case_modes(c) : "";
  const char *bar = strchr(modes, '|');
  return !bar ? "" : strcmp(bar, "| ++") == 0 ? "_no_turn" : strncmp(modes, "++ |", 4) == 0 ? "_no_turn_extension" : "";
}

/* The paper's formulas for the steady state are for a gait of constant acceleration, half of each phase up and half of it down. */
static bool has_closed_limit(const struct book *book) { return book->crawler->gait == &scallop_gait_quadratic; }

static void name_correction(struct book *book, struct claim_row *row, const struct claimed *claimed,
                            const struct condition *condition, int kind)
{
  const struct scallop_formula *f = claimed->formula;
  const char *mirror = condition->reversed ? ":mirrored" : "";
  if (claimed->setting != SCALLOP_STEADY) {
    snprintf(row->corrected, sizeof row->corrected, "%s%s%s", f && f->corrected ? f->corrected : claimed->name,
             f && f->corrected && kind == SCALLOP_CONTRACTION ? ":contraction" : "", mirror);
  } else {
    const char *what = claimed->quantity == SCALLOP_STEADY_VELOCITY ? "velocity" : "xC";
    const char *turn = no_turn(book, (int)(condition - steady));
    if (!has_closed_limit(book))
      snprintf(row->corrected, sizeof row->corrected, "limit_steady_%s", what);
    else if (*turn)
      snprintf(row->corrected, sizeof row->corrected, "corrected_steady_%s%s%s", what, turn, mirror);
    else
      snprintf(row->corrected, sizeof row->corrected, "%s%s", claimed->name, mirror);
  }
  if (strcmp(row->corrected, row->claim) == 0)
    *row->corrected = '\0';
}

static const char *label(const struct claimed *claimed, int kind, bool mirrored)
{
  /* seen in a mirror the other body is the one that turns */
  const struct scallop_formula f = { .setting = claimed->setting, .quantity = claimed->quantity };
  return formula_quantity_text(&f, (enum scallop_phase_kind)(mirrored ? 1 - kind : kind));
}

/* Of the motion itself again: positions and velocities change their sign in a mirror, times do not. */
static void see_in_mirror(struct ledger_proof *proof, struct order_point *points, int count, enum scallop_quantity quantity)
{
  if (quantity == SCALLOP_LAG || quantity == SCALLOP_FIRST_SWITCH)
    return;
  series_neg(&proof->coefficient, &proof->coefficient);
  for (int i = 0; i < count; i++)
    points[i].err = -points[i].err;
}

static void add_row(struct book *book, const struct claimed *claimed, int kind, int index, bool mirrored)
{
  const struct condition *condition = &conditions_of(claimed->setting, kind)[index];
  struct order_point points[LEDGER_SAMPLES];
  struct ledger_proof proof;
  struct claim_row row = { .equation = claimed->equation,
                           .gait = book->crawler->gait->name,
                           .quantity = label(claimed, kind, mirrored),
                           .conditions = condition->text,
                           .inside = condition->inside,
                           .claimed_order = claimed->order == SCALLOP_EQUALITY ? INFINITY : claimed->order,
                           .slope = NAN };
  bool is_new = claimed->formula && !claimed->formula->phase && !claimed->formula->steady;
  row.ours = mirrored || is_new || claimed->limit;
  bool both_kinds = is_new && claimed->setting != SCALLOP_STEADY;
  snprintf(row.claim, sizeof row.claim, "%s%s%s", claimed->name,
           both_kinds && kind == SCALLOP_CONTRACTION ? ":contraction" : "", mirrored ? ":mirrored" : "");
  if (book->only && !claim_is_listed(book->only, row.claim))
    return;
  struct ledger_case *c = case_of(book, claimed->setting, kind, index, mirrored);
  ledger_proof_init(&proof);
  if (!c || !ledger_prove(&proof, c, claimed->formula, claimed->quantity, claimed->limit)) {
    row.verdict = CLAIM_UNDECIDED;
    snprintf(row.reason, sizeof row.reason, "this motion has no expansion in powers of T");
  } else {
    row.count = ledger_measure(points, &row.slope, c, claimed->formula, claimed->quantity, claimed->limit);
    if (mirrored)
      see_in_mirror(&proof, points, row.count, claimed->quantity);
    claim_judge(&row, &proof);
    name_correction(book, &row, claimed, condition, kind);
  }
  book_enter(book, &row, points);
  ledger_proof_clear(&proof);
}

/* Under all conditions as it stands, or under those that reverse the roles of the bodies, in a mirror. */
static void add_rows(struct book *book, const struct claimed *claimed, int kind, bool mirrored)
{
  const struct condition *conditions = conditions_of(claimed->setting, kind);
  for (int i = 0; conditions[i].text; i++)
    if (!mirrored || conditions[i].reversed)
      add_row(book, claimed, kind, i, mirrored);
}

static void add_formula(struct book *book, const struct scallop_formula *f, bool mirrored)
{
  const struct claimed claimed = { f, f->name, f->equation, f->setting, f->quantity, f->remainder, false };
  int first = f->setting == SCALLOP_MOVING_CONTRACTION, last = is_from_rest(f->setting) ? 1 : first;
  for (int kind = first; f->remainder != 0 && kind <= last; kind++)
    add_rows(book, &claimed, kind, mirrored);
  if (f->phase == A_x1_first_switch && !mirrored) {
    const struct claimed size = { NULL, "A_x1_first_switch_size", f->equation, f->setting, f->quantity, 2, false };
    add_rows(book, &size, SCALLOP_EXTENSION, false);
  }
}

/* A formula of ours, where it claims to hold */
static void add_corrected(struct book *book, const struct scallop_formula *f)
{
  const struct claimed claimed = { f, f->name, f->equation, f->setting, f->quantity, f->remainder, false };
  bool is_steady = f->setting == SCALLOP_STEADY;
  for (int kind = 0; kind < (is_steady ? 1 : 2); kind++) {
    const struct condition *conditions = conditions_of(f->setting, kind);
    for (int i = 0; conditions[i].text; i++) {
      const char *turn = is_steady && has_closed_limit(book) ? no_turn(book, i) : "";
      size_t length = strlen(f->name), ending = strlen(turn);
      if (!is_steady || (*turn && length > ending && strcmp(f->name + length - ending, turn) == 0))
        add_row(book, &claimed, kind, i, conditions[i].reversed);
    }
  }
}

static void add_limits(struct book *book)
{
  const struct claimed velocity = { .name = "limit_steady_velocity",
                                    .equation = "(26), (27)",
                                    .setting = SCALLOP_STEADY,
                                    .quantity = SCALLOP_STEADY_VELOCITY,
                                    .order = 1,
                                    .limit = true };
  const struct claimed displacement = { .name = "limit_steady_xC",
                                        .equation = "(28)",
                                        .setting = SCALLOP_STEADY,
                                        .quantity = SCALLOP_STEADY_DISPLACEMENT,
                                        .order = 4,
                                        .limit = true };
  add_rows(book, &velocity, SCALLOP_EXTENSION, false);
  add_rows(book, &displacement, SCALLOP_EXTENSION, false);
}

/* ---- all of it ---- */

static bool lists_formula(const char *list, const struct scallop_formula *formulas)
{
  static const char *const endings[] = { "", ":contraction", ":mirrored", ":contraction:mirrored" };
  char name[80];
  for (const struct scallop_formula *f = formulas; f->name; f++)
    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++) {
      snprintf(name, sizeof name, "%s%s", f->name, endings[i]);
      if (f->remainder != 0 && claim_is_listed(list, name))
        return true;
    }
  return false;
}

bool claims_have_order(const char *list)
{
  static const char *const others[] = { "A_x1_first_switch_size", "limit_steady_velocity", "limit_steady_xC" };
  bool found = lists_formula(list, scallop_equal_forces) || lists_formula(list, scallop_published)
               || lists_formula(list, scallop_corrected);
  for (size_t i = 0; i < sizeof others / sizeof *others; i++)
    found |= claim_is_listed(list, others[i]);
  return found || claims_of_ends_listed(list);
}

static void fill(struct book *book)
{
  for (const struct scallop_formula *f = scallop_equal_forces; f->name; f++)
    add_formula(book, f, false);
  for (const struct scallop_formula *f = scallop_published; f->name; f++)
    add_formula(book, f, false);
  book_add_ends(book);
  for (const struct scallop_formula *f = scallop_corrected; f->name; f++)
    add_corrected(book, f);
  add_limits(book);
  for (const struct scallop_formula *f = scallop_published; f->name; f++)
    if (!f->corrected && (f->setting != SCALLOP_STEADY || has_closed_limit(book)))
      add_formula(book, f, true);
}

const char *claims_of_order(const struct scallop_rational_crawler *crawler, const struct scallop_gait *gait,
                            const char *only, claim_sink *sink, void *context)
{
  static struct entry entries[MOST_ROWS];
  struct scallop_rational_crawler c;
  const char *wrong = NULL;
  scallop_rational_init(&c);
  scallop_rational_copy(&c, crawler);
  for (int g = 0; gait ? g == 0 : scallop_gait_name(g) != NULL; g++) {
    c.gait = gait ? gait : scallop_gait_named(scallop_gait_name(g));
    struct book book = { .crawler = &c, .only = only, .sink = sink, .context = context, .entries = entries };
    fill(&book);
    if (!only
        && scallop_gait_named(
            c.gait->name)) /* the corrections are for the gaits of the paper: with others they may not hold, either */
      book_check_corrections(&book);
    close_cases(&book);
    wrong = book.contradiction ? book.contradiction : wrong;
  }
  scallop_rational_clear(&c);
  return wrong;
}
