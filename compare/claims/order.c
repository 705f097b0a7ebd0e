/* The claims "... + O(T^n)": decided by the derived expansion, and measured with the certified solver as T falls. The
 * claims are the rows of asymptotics' lists of formulas, each under every condition of its setting. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "asymptotics/asymptotics.h"
#include "asymptotics/derived/scoped.h"
#include "compare/answers/answer.h"
#include "compare/book/book.h"
#include "compare/claims/evidence.h"
#include "compare/claims/ledger.h"
#include "compare/claims/samples.h"

#define EXTENSION_AT_REST SCALLOP_AT_REST_START, SCALLOP_EXTENSION
#define CONTRACTION_AT_REST SCALLOP_AT_REST_START, SCALLOP_CONTRACTION
#define MOVING_EXTENSION SCALLOP_MOVING_EXTENSION, SCALLOP_EXTENSION
#define MOVING_CONTRACTION SCALLOP_MOVING_EXTENSION, SCALLOP_CONTRACTION
#define STEADY SCALLOP_STEADY, SCALLOP_EXTENSION

static const struct condition conditions[] = {
  { EXTENSION_AT_REST, "extension from rest, F1 > F2", .inside = true },
  { EXTENSION_AT_REST, "extension from rest, F1 < F2", .exchange_forces = true, .reversed = true },
  { CONTRACTION_AT_REST, "contraction from rest, F2 > F1", .inside = true,
    .exchange_forces = true }, /* bodies exchanged */
  { CONTRACTION_AT_REST, "contraction from rest, F2 < F1", .reversed = true },
  { EXTENSION_AT_REST, "extension from rest, F1 = F2", .inside = true, .equal_forces = true },
  { CONTRACTION_AT_REST, "contraction from rest, F2 = F1", .inside = true, .equal_forces = true },
  { MOVING_EXTENSION, "v0 > 0 fixed, F1 > F2", .inside = true, .v0 = CLAIM_SPEED },
  { MOVING_EXTENSION, "v0 > 0 fixed, F1 < F2", .v0 = CLAIM_SPEED, .exchange_forces = true },
  { MOVING_EXTENSION, "v0 < 0 fixed, F1 > F2", .v0 = -CLAIM_SPEED, .reversed = true },
  { MOVING_CONTRACTION, "v0 > 0 fixed, F1 > F2", .inside = true, .v0 = CLAIM_SPEED },
  { MOVING_CONTRACTION, "v0 > 0 fixed, F1 < F2", .v0 = CLAIM_SPEED, .exchange_forces = true },
  { MOVING_CONTRACTION, "v0 < 0 fixed, F1 > F2", .v0 = -CLAIM_SPEED, .reversed = true },
  { STEADY, "alpha > 1/2, F1 > F2", .inside = true },
  { STEADY, "alpha < 1/2, F1 < F2", .exchange_forces = true, .mirror_alpha = true },
  { STEADY, "alpha < 1/2, F1 > F2", .mirror_alpha = true, .reversed = true },
  { STEADY, "alpha > 1/2, F1 < F2", .exchange_forces = true, .reversed = true },
  { STEADY, "alpha > 1/2, F1 > F2, m1 a hundredth", .light_1 = true },
};
enum { CONDITIONS = sizeof conditions / sizeof *conditions };

/* Claims that no text of asymptotics stands for: that x1(t1) is of order 2, and the limit of the steady state as it is
 * derived */
static const struct scallop_formula size_of_first_switch = {
  "A_x1_first_switch_size", "(A.7)", SCALLOP_MOVING_EXTENSION, SCALLOP_REAR_AT_FIRST, 2, .text = "0"
};
static const struct scallop_formula limits[] = {
  { "limit_steady_velocity", "(26), (27)", SCALLOP_STEADY, SCALLOP_STEADY_VELOCITY, 1, .text = NULL },
  { "limit_steady_xC", "(28)", SCALLOP_STEADY, SCALLOP_STEADY_DISPLACEMENT, 4, .text = NULL },
};

/* What a row is about. ours: the formula is not the paper's. A formula of ours for an extension has rows about
 * contractions too, the bodies exchanged; any formula may be seen in a mirror, where the bodies have exchanged their
 * roles. */
struct claimed {
  const struct scallop_formula *formula;
  bool ours, of_contraction, mirrored;
};

static void name_row(char name[CLAIM_NAME], const struct claimed *claimed)
{
  snprintf(name, CLAIM_NAME, "%s%s%s", claimed->formula->name, claimed->of_contraction ? ":contraction" : "",
           claimed->mirrored ? ":mirrored" : "");
}

/* One gait's part of the ledger while it is filled */
struct part {
  const struct scallop_rational_crawler *crawler; /* with the gait                                */
  const char *only;                               /* the requested rows, NULL for all             */
  struct ledger *ledger;
  /* Each motion is solved once, and serves all the formulas about it. [1]: in a mirror */
  struct trial trial[CONDITIONS][2];
  bool opened[CONDITIONS][2], expands[CONDITIONS][2];
};

/* NULL if it has no expansion */
static const struct trial *solve(struct part *part, const struct condition *condition, bool mirrored)
{
  ptrdiff_t i = condition - conditions;
  struct trial *trial = &part->trial[i][mirrored];
  if (!part->opened[i][mirrored]) {
    part->opened[i][mirrored] = true;
    part->expands[i][mirrored] = trial_init(trial, part->crawler, condition, mirrored);
    trial->samples = part->expands[i][mirrored] ? samples_take(trial) : NULL;
  }
  return part->expands[i][mirrored] ? trial : NULL;
}

static void clear_part(struct part *part)
{
  for (int i = 0; i < 2 * CONDITIONS; i++)
    if (part->opened[i / 2][i % 2]) {
      samples_free(part->trial[i / 2][i % 2].samples);
      trial_clear(&part->trial[i / 2][i % 2]);
    }
}

/* Does a body turn in both phases of the limit? Seen in a mirror if the condition is reversed. */
static enum scallop_turns turns_in_limit(struct part *part, const struct condition *condition)
{
  const struct trial *trial = solve(part, condition, condition->reversed);
  return turns_in_modes(trial ? trial_modes(trial) : "");
}

/* The paper's formulas for the steady state are for a gait of constant acceleration, half of each phase up and half of
 * it down. */
static bool has_closed_limit(const struct part *part) { return part->crawler->gait == &scallop_gait_quadratic; }

/* What holds where the claim may not */
static struct claimed correction(struct part *part, const struct claimed *claimed, const struct condition *condition)
{
  const struct scallop_formula *f = claimed->formula;
  bool steady = f->setting == SCALLOP_STEADY;
  if (steady && !has_closed_limit(part))
    return (struct claimed){ .formula = &limits[f->quantity == SCALLOP_STEADY_DISPLACEMENT] };
  enum scallop_turns turns = steady ? turns_in_limit(part, condition) : SCALLOP_TURNS_IN_BOTH;
  for (const struct scallop_formula *g = scallop_corrected; turns != SCALLOP_TURNS_IN_BOTH && g->name; g++)
    if (g->turns == turns && g->quantity == f->quantity)
      return (struct claimed){ .formula = g, .mirrored = condition->reversed };
  if (!f->corrected)
    return (struct claimed){ .formula = f, .mirrored = condition->reversed };
  return (struct claimed){ .formula = formula_named(f->corrected),
                           .of_contraction = condition->kind == SCALLOP_CONTRACTION,
                           .mirrored = condition->reversed };
}

/* Of the motion itself again: positions and velocities change their sign in a mirror, times do not. */
static void see_in_mirror(struct proof *proof, struct claim_row *row, enum scallop_quantity quantity)
{
  if (quantity == SCALLOP_LAG || quantity == SCALLOP_FIRST_SWITCH)
    return;
  series_neg(&proof->left_out, &proof->left_out);
  for (int i = 0; i < row->count; i++)
    row->points[i].err = -row->points[i].err;
}

static void decide(struct part *part, struct claim_row *row, const struct claimed *claimed,
                   const struct condition *condition)
{
  const struct scallop_formula *f = claimed->formula;
  const struct trial *trial = solve(part, condition, claimed->mirrored);
  struct proof proof;
  proof_init(&proof);
  if (!trial || !trial_prove(&proof, trial, f)) {
    row->verdict = CLAIM_UNDECIDED;
    snprintf(row->reason, sizeof row->reason, "%s",
             *proof.why ? proof.why : "no expansion in powers of T is known for this motion");
  } else {
    const struct claimed right = correction(part, claimed, condition);
    samples_measure(row, trial, f, &proof.left_out);
    if (claimed->mirrored)
      see_in_mirror(&proof, row, f->quantity);
    ledger_judge(part->ledger, row, &proof);
    name_row(row->corrected, &right);
    if (strcmp(row->corrected, row->claim) == 0)
      *row->corrected = '\0';
  }
  proof_clear(&proof);
}

static void add_row(struct part *part, struct claimed claimed, const struct condition *condition)
{
  const struct scallop_formula *f = claimed.formula;
  bool steady = f->setting == SCALLOP_STEADY, contraction = condition->kind == SCALLOP_CONTRACTION;
  struct claim_row row = { .equation = f->equation,
                           .gait = part->crawler->gait->name,
                           .inside = condition->inside,
                           .source = claimed.ours || claimed.mirrored ? OF_CORRECTED : OF_PAPER,
                           .claimed_order = f->remainder == SCALLOP_EQUALITY ? INFINITY : f->remainder,
                           .mismatch = NAN };
  /* seen in a mirror the other body is the one that turns */
  row.quantity = formula_quantity_text(f, contraction != claimed.mirrored ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION);
  claimed.of_contraction = claimed.ours && !steady && contraction;
  snprintf(row.conditions, sizeof row.conditions, "%s", condition->text);
  name_row(row.claim, &claimed);
  if ((part->only && !formula_is_listed(part->only, row.claim)) || ledger_expects(part->ledger))
    return;
  if (f->turns != SCALLOP_TURNS_IN_BOTH && f->turns != turns_in_limit(part, condition))
    return; /* for another limit */
  decide(part, &row, &claimed, condition);
  ledger_enter(part->ledger, &row);
}

/* Is the formula for such a motion? One of ours for an extension is for a contraction too. */
static bool is_for(const struct scallop_formula *f, const struct condition *condition, bool ours)
{
  bool moving = condition->setting == SCALLOP_MOVING_EXTENSION, extension = condition->kind == SCALLOP_EXTENSION;
  if (condition->equal_forces != (f->when != NULL)) /* the paper's only other condition is F1 = F2 */
    return false;
  if (f->setting == SCALLOP_MOVING_CONTRACTION)
    return moving && !extension;
  if (f->setting == SCALLOP_MOVING_EXTENSION)
    return moving && (extension || ours);
  return condition->setting == f->setting;
}

/* A formula under all conditions that it is for; `turned`: only where the bodies' roles are reversed, in a mirror;
 * corrected: one of ours that takes the place of another, where it claims to hold, there in a mirror too. */
enum seen { AS_IT_STANDS, TURNED, CORRECTED };

static void add_formula(struct part *part, const struct scallop_formula *f, bool ours, enum seen seen)
{
  for (int i = 0; (f->remainder != 0 || seen == CORRECTED) && i < CONDITIONS; i++) {
    const struct condition *condition = &conditions[i];
    const struct claimed claimed = { .formula = f,
                                     .ours = ours,
                                     .mirrored = seen != AS_IT_STANDS && condition->reversed };
    if (is_for(f, condition, seen == CORRECTED) && (seen != TURNED || condition->reversed))
      add_row(part, claimed, condition);
  }
}

/* (A.11), (A.12): l' and l near the end of an extension, T = L = 1. */

struct end_claim {
  const char *name, *equation, *quantity;
  int order;
  bool velocity;    /* l'(T-h) = -h l''(T); otherwise l(T-h) = [l(T) +] h^2/2 l''(T)             */
  bool with_length; /* l(T) is there                                                              */
  const char *corrected;
  bool ours;
};
static const struct end_claim end_claims[] = {
  { "A_dl_near_end", "(A.11)", "l'(T-h)", 2, true, true, "", false },
  { "A_l_near_end", "(A.12)", "l(T-h)", 3, false, false, "corrected_l_near_end", false },
  { "corrected_l_near_end", "(A.12)", "l(T-h)", 3, false, true, "", true },
};

/* |l'(T-h)| without its term in h, as a series in h */
static void speed_before_end(struct series *speed, const struct scallop_piece *last, const struct ring *ring)
{
  SCOPED(series, back);
  scallop_speed_series(speed, last, NULL, ring);
  series_set_x(&back);
  series_neg(&back, &back);
  series_compose(speed, speed, &back, ring);
  series_set_zero(speed, 1);
}

/* What the claim leaves out: its first coefficient that does not vanish */
static void prove_end(struct proof *proof, const struct end_claim *claim, const struct scallop_piece *last)
{
  const struct ring ring = { 40, 256 };
  struct series *left_out = &proof->left_out;
  SCOPED(series, one);
  SCOPED(arb, x);
  speed_before_end(left_out, last, &ring);
  if (!claim->velocity) {
    series_integral(left_out, left_out, &ring);
    series_set_si(&one, claim->with_length ? 0 : 1);
    series_sub(left_out, &one, left_out, &ring);
  }
  while (proof->order < ring.length && series_coefficient_is_zero(left_out, proof->order))
    proof->order++;
  proof->known = ring.length;
  proof->general = proof->order;
  proof->found = proof->order < ring.length;
  series_coefficient(x, left_out, proof->order, ring.precision);
  proof->undecided = !arb_is_exact(x) && arb_contains_zero(x);
  proof->for_all = !proof->undecided; /* l is L times a function of t/T: L and T are its units */
}

/* The same, measured at h = 4^-k: l' and l of the gait, and h l'' and h^2/2 l'' of an extension at its end */
static void measure_end(struct claim_row *row, const struct end_claim *claim, const struct scallop_piece *last)
{
  enum { PRECISION = 1400 };
  arb_ptr x = _arb_vec_init(4), h = x, zero = x + 1, error = x + 2, rate = x + 3;
  scallop_ball_rate(rate, last, zero, PRECISION);
  for (int k = 1; k < CLAIM_POINTS; k++) {
    arb_one(h);
    arb_mul_2exp_si(h, h, -2 * k);
    if (claim->velocity) {
      scallop_ball_speed(error, last, h, PRECISION);
      arb_addmul(error, h, rate, PRECISION);
    } else {
      scallop_ball_way(error, last, h, zero, PRECISION);
      arb_mul_2exp_si(h, h, -2 * k - 1);
      arb_addmul(error, h, rate, PRECISION);
      arb_neg(error, error);
      arb_add_si(error, error, claim->with_length ? 0 : 1, PRECISION);
    }
    row->points[row->count++] = (struct scallop_order_point){ .h = ldexp(1, -2 * k),
                                                              .err = middle(error),
                                                              .noise = mag_get_d(arb_radref(error)) };
  }
  const struct scallop_order_point *finest = &row->points[row->count - 1];
  row->mismatch = fabs(log(fabs(finest[-1].err / finest[0].err)) / log(4) - (double)row->derived_order);
  _arb_vec_clear(x, 4);
}

static void add_ends(struct part *part)
{
  const struct scallop_gait *gait = part->crawler->gait;
  const struct scallop_shape *shape = &gait->phase[SCALLOP_EXTENSION];
  const struct scallop_piece *last = &shape->pieces[shape->count - 1];
  for (size_t i = 0; i < sizeof end_claims / sizeof *end_claims; i++) {
    const struct end_claim *claim = &end_claims[i];
    struct proof proof;
    struct claim_row row = { .equation = claim->equation,
                             .quantity = claim->quantity,
                             .gait = gait->name,
                             .conditions = "h -> 0 at T = 1",
                             .inside = true,
                             .source = claim->ours ? OF_CORRECTED : OF_PAPER,
                             .claimed_order = claim->order };
    snprintf(row.claim, sizeof row.claim, "%s", claim->name);
    snprintf(row.corrected, sizeof row.corrected, "%s", claim->corrected);
    if ((part->only && !formula_is_listed(part->only, claim->name)) || ledger_expects(part->ledger))
      continue;
    proof_init(&proof);
    prove_end(&proof, claim, last);
    ledger_judge(part->ledger, &row, &proof);
    measure_end(&row, claim, last);
    ledger_enter(part->ledger, &row);
    proof_clear(&proof);
  }
}

static void fill(struct part *part)
{
  for (const struct scallop_formula *f = scallop_published; f->name; f++) {
    add_formula(part, f, false, AS_IT_STANDS);
    if (strcmp(f->name, "A_x1_first_switch") == 0)
      add_formula(part, &size_of_first_switch, false, AS_IT_STANDS);
  }
  add_ends(part);
  for (const struct scallop_formula *f = scallop_corrected; f->name; f++)
    if (f->setting != SCALLOP_STEADY || has_closed_limit(part))
      add_formula(part, f, true, CORRECTED);
  add_formula(part, &limits[0], true, AS_IT_STANDS);
  add_formula(part, &limits[1], true, AS_IT_STANDS);
  for (const struct scallop_formula *f = scallop_published; f->name; f++)
    if (!f->corrected && (f->setting != SCALLOP_STEADY || has_closed_limit(part)))
      add_formula(part, f, false, TURNED);
}

void ledger_add_orders(struct ledger *ledger, const struct scallop_rational_crawler *crawler,
                       const struct scallop_gait *gait, const char *only)
{
  struct scallop_rational_crawler c;
  scallop_rational_init(&c);
  scallop_rational_copy(&c, crawler);
  for (int g = 0; gait ? g == 0 : scallop_gait_name(g) != NULL; g++) {
    int first = ledger->count;
    c.gait = gait ? gait : scallop_gait_named(scallop_gait_name(g));
    struct part part = { .crawler = &c, .only = only, .ledger = ledger };
    fill(&part);
    if (!only && scallop_gait_named(c.gait->name))
      ledger_check_corrections(ledger, first);
    clear_part(&part);
  }
  scallop_rational_clear(&c);
}
