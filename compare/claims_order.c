/* The claims "... + O(T^n)": decided by the derived expansion, and measured with the certified solver as T falls. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "asymptotics/asymptotics.h"
#include "compare/claims.h"
#include "compare/decimal.h"
#include "compare/exact.h"
#include "compare/ledger.h"

/* The order is fitted over the smallest T. */
enum { FITTED = 12, DIGITS = 12 };
/* What is left of the next terms there, many times over. */
static const double AGREEMENT = 1e-6;
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
enum { MOST_CONDITIONS = 5, SETTINGS = 3, MOST_ROWS = 1024 };

const char *claim_verdict_text(enum claim_verdict verdict)
{
  static const char *const text[] = { "holds", "sharper", "refuted", "undecided" };
  return text[verdict];
}

bool claim_is_listed(const char *list, const char *name)
{
  size_t length = strlen(name);
  if (strcmp(list, "all") == 0)
    return true;
  for (const char *at = strstr(list, name); at; at = strstr(at + 1, name))
    if ((at == list || at[-1] == ',') && (at[length] == ',' || at[length] == '\0'))
      return true;
  return false;
}

/* ---- one gait's ledger ---- */

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

static char contradiction[300]; /* the last one */

static void contradict(struct book *book, const struct claim_row *row, const char *what)
{
  snprintf(contradiction, sizeof contradiction, "%s, %s, %s: %s", row->claim, row->gait, row->conditions, what);
  book->contradiction = contradiction;
}

static const struct condition *conditions_of(enum scallop_setting setting, int kind)
{
  return setting == SCALLOP_STEADY          ? steady
         : setting != SCALLOP_AT_REST_START ? moving
         : kind == SCALLOP_EXTENSION        ? extension_from_rest
                                            : contraction_from_rest;
}

/* Each motion is solved once, and serves all the formulas about it. NULL if it has no expansion. */
static struct ledger_case *case_of(struct book *book, enum scallop_setting setting, int kind, int condition, bool mirrored)
{
  int s = setting == SCALLOP_AT_REST_START ? 0 : setting == SCALLOP_STEADY ? 2 : 1;
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

/* ---- verdicts ---- */

static void set_coefficient(struct claim_row *row, const struct series *coefficient)
{
  fmpq_t q;
  arb_t x;
  fmpq_init(q);
  arb_init(x);
  bool is_rational = series_rational_coefficient(q, coefficient, 0);
  series_coefficient(x, coefficient, 0, 128);
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

static void judge(struct claim_row *row, const struct ledger_proof *proof)
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
    row->verdict = CLAIM_SHARPER;
    snprintf(row->reason, sizeof row->reason, "every coefficient below T^%ld vanishes", (long)proof->known);
    return;
  }
  set_coefficient(row, &proof->coefficient);
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

static void enter(struct book *book, struct claim_row *row, struct order_point *points)
{
  int tail = row->count < FITTED ? row->count : FITTED;
  for (int i = 0; i < row->count; i++) {
    points[i].pairwise = i + 1 < row->count
                             ? log(fabs(points[i].err / points[i + 1].err)) / log(points[i].h / points[i + 1].h)
                             : NAN;
    points[i].use = row->exact ? ORDER_ZERO : ORDER_COARSE;
  }
  row->fit = order_estimate(points + row->count - tail, tail);
  row->points = points;
  if (!agrees(row)) {
    char what[120];
    snprintf(what, sizeof what, "the derived order is %ld, the measured slope %.9g", row->derived_order, row->slope);
    contradict(book, row, what);
  }
  if (row->verdict != CLAIM_REFUTED)
    *row->corrected = '\0';
  if (book->count < MOST_ROWS) {
    struct entry *e = &book->entries[book->count++];
    memcpy(e->claim, row->claim, sizeof e->claim);
    memcpy(e->corrected, row->corrected, sizeof e->corrected);
    e->conditions = row->conditions;
    e->stands = row->verdict == CLAIM_HOLDS || row->verdict == CLAIM_SHARPER;
    if (row->verdict == CLAIM_REFUTED && !*row->corrected)
      contradict(book, row, "refuted, and nothing is named that holds");
  }
  book->sink(book->context, row);
}

/* Every formula named as right where another is wrong has its row for the same conditions, and holds. */
static void check_corrections(struct book *book)
{
  for (int i = 0; i < book->count; i++) {
    const struct entry *wrong = &book->entries[i];
    bool stands = !*wrong->corrected;
    for (int j = 0; j < book->count && !stands; j++)
      stands = book->entries[j].stands && strcmp(book->entries[j].claim, wrong->corrected) == 0
               && strcmp(book->entries[j].conditions, wrong->conditions) == 0;
    if (!stands) {
      snprintf(contradiction, sizeof contradiction, "%s, %s: %s, which is to take its place, has no row that holds",
               wrong->claim, wrong->conditions, wrong->corrected);
      book->contradiction = contradiction;
    }
  }
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

/* The paper's formulas for the steady state are for a gait of constant acceleration. */
static bool has_closed_limit(const struct book *book) { return scallop_gait_is_rational(book->crawler->gait); }

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
                           .claimed_order = claimed->order,
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
    judge(&row, &proof);
    row.count = ledger_measure(points, &row.slope, c, claimed->formula, claimed->quantity, claimed->limit);
    name_correction(book, &row, claimed, condition, kind);
  }
  enter(book, &row, points);
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
  int first = f->setting == SCALLOP_MOVING_CONTRACTION, last = f->setting == SCALLOP_AT_REST_START ? 1 : first;
  for (int kind = first; f->remainder > 0 && kind <= last; kind++)
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
  const struct condition *conditions = conditions_of(f->setting, SCALLOP_EXTENSION);
  bool is_steady = f->setting == SCALLOP_STEADY;
  for (int kind = 0; kind < (is_steady ? 1 : 2); kind++)
    for (int i = 0; conditions[i].text; i++) {
      const char *turn = is_steady && has_closed_limit(book) ? no_turn(book, i) : "";
      size_t length = strlen(f->name), ending = strlen(turn);
      if (!is_steady || (*turn && length > ending && strcmp(f->name + length - ending, turn) == 0))
        add_row(book, &claimed, kind, i, conditions[i].reversed);
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

/* ---- (A.11), (A.12): l' and l near the end of an extension, T = L = 1 ---- */

struct end_claim {
  const char *name, *equation, *quantity;
  int order;
  bool velocity;    /* l'(T-h) = -h l''(T); otherwise l(T-h) = [l(T) +] h^2/2 l''(T)             */
  bool with_length; /* l(T) is there                                                              */
  const char *corrected;
};
static const struct end_claim end_claims[] = {
  { "A_dl_near_end", "(A.11)", "l'(T-h)", 2, true, true, "" },
  { "A_l_near_end", "(A.12)", "l(T-h)", 3, false, false, "corrected_l_near_end" },
  { "corrected_l_near_end", "(A.12)", "l(T-h)", 3, false, true, "" },
};

/* |l'(T-h)| without its term in h, as a series in h */
static void speed_before_end(struct series *speed, const struct scallop_piece *last, const fmpq_t pi_squared,
                             const struct ring *ring)
{
  fmpq_t zero;
  fmpq_poly_t exact;
  struct series back;
  fmpq_init(zero);
  fmpq_poly_init(exact);
  series_init(&back);
  if (scallop_rational_speed_series(exact, last, zero, ring->length, pi_squared))
    series_set_rational_poly(speed, exact, ring->length);
  else {
    arb_t u;
    arb_poly_t balls;
    arb_init(u);
    arb_poly_init(balls);
    scallop_ball_speed_series(balls, last, u, ring->length, ring->precision);
    series_set_ball_poly(speed, balls, ring->length);
    arb_clear(u);
    arb_poly_clear(balls);
  }
  series_set_x(&back);
  series_neg(&back, &back);
  series_compose(speed, speed, &back, ring);
  series_set_zero(speed, 1);
  fmpq_clear(zero);
  fmpq_poly_clear(exact);
  series_clear(&back);
}

/* What the claim leaves out: its first coefficient that does not vanish */
static void prove_end(struct ledger_proof *proof, const struct end_claim *claim, const struct scallop_piece *last)
{
  const struct ring ring = { 40, 256 };
  struct series left_out, one;
  arb_t x;
  fmpq_t q;
  series_init(&left_out);
  series_init(&one);
  arb_init(x);
  fmpq_init(q);
  speed_before_end(&left_out, last, NULL, &ring);
  if (!claim->velocity) {
    series_integral(&left_out, &left_out, &ring);
    series_set_si(&one, claim->with_length ? 0 : 1);
    series_sub(&left_out, &one, &left_out, &ring);
  }
  while (proof->order < ring.length && series_coefficient_is_zero(&left_out, proof->order))
    proof->order++;
  proof->known = ring.length;
  proof->general = proof->order;
  proof->found = proof->order < ring.length;
  if (series_rational_coefficient(q, &left_out, proof->order))
    series_set_rational(&proof->coefficient, q);
  else {
    series_coefficient(x, &left_out, proof->order, ring.precision);
    proof->undecided = arb_contains_zero(x);
    series_set_ball(&proof->coefficient, x);
  }
  series_clear(&left_out);
  series_clear(&one);
  arb_clear(x);
  fmpq_clear(q);
}

/* The same, measured at h = 4^-k */
static void measure_end(struct claim_row *row, struct order_point points[LEDGER_SAMPLES], const struct end_claim *claim,
                        const struct scallop_piece *last)
{
  enum { PRECISION = 1400 };
  arb_t h, zero, error, rate;
  arb_init(h);
  arb_init(zero);
  arb_init(error);
  arb_init(rate);
  scallop_ball_rate(rate, last, zero, PRECISION); /* l''(T) of an extension */
  for (int k = 1; k < LEDGER_SAMPLES; k++) {
    arb_one(h);
    arb_mul_2exp_si(h, h, -2 * k);
    if (claim->velocity) {
      scallop_ball_speed(error, last, h, PRECISION);
      arb_addmul(error, h, rate, PRECISION);
    } else {
      scallop_ball_way(error, last, h, zero, PRECISION);
      arb_neg(error, error);
      arb_add_si(error, error, claim->with_length ? 0 : 1, PRECISION);
      arb_mul(zero, h, h, PRECISION);
      arb_mul_2exp_si(zero, zero, -1);
      arb_submul(error, zero, rate, PRECISION);
      arb_zero(zero);
    }
    points[row->count++] = (struct order_point){ .h = ldexp(1, -2 * k),
                                                 .err = arf_get_d(arb_midref(error), ARF_RND_NEAR),
                                                 .noise = mag_get_d(arb_radref(error)) };
  }
  const struct order_point *finest = &points[row->count - 1];
  row->slope = log(fabs(finest[-1].err / finest[0].err)) / log(4);
  arb_clear(h);
  arb_clear(zero);
  arb_clear(error);
  arb_clear(rate);
}

static void add_end_claims(struct book *book)
{
  const struct scallop_shape *shape = &book->crawler->gait->phase[SCALLOP_EXTENSION];
  const struct scallop_piece *last = &shape->pieces[shape->count - 1];
  for (size_t i = 0; i < sizeof end_claims / sizeof *end_claims; i++) {
    const struct end_claim *claim = &end_claims[i];
    if (book->only && !claim_is_listed(book->only, claim->name))
      continue;
    struct order_point points[LEDGER_SAMPLES];
    struct ledger_proof proof;
    struct claim_row row = { .equation = claim->equation,
                             .quantity = claim->quantity,
                             .gait = book->crawler->gait->name,
                             .conditions = "h -> 0 at T = 1",
                             .inside = true,
                             .ours = strncmp(claim->name, "corrected", 9) == 0,
                             .claimed_order = claim->order };
    snprintf(row.claim, sizeof row.claim, "%s", claim->name);
    snprintf(row.corrected, sizeof row.corrected, "%s", claim->corrected);
    ledger_proof_init(&proof);
    prove_end(&proof, claim, last);
    judge(&row, &proof);
    measure_end(&row, points, claim, last);
    enter(book, &row, points);
    ledger_proof_clear(&proof);
  }
}

/* ---- all of it ---- */

static bool lists_formula(const char *list, const struct scallop_formula *formulas)
{
  static const char *const endings[] = { "", ":contraction", ":mirrored", ":contraction:mirrored" };
  char name[80];
  for (const struct scallop_formula *f = formulas; f->name; f++)
    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++) {
      snprintf(name, sizeof name, "%s%s", f->name, endings[i]);
      if (f->remainder > 0 && claim_is_listed(list, name))
        return true;
    }
  return false;
}

bool claims_have_order(const char *list)
{
  static const char *const others[] = { "A_x1_first_switch_size", "limit_steady_velocity", "limit_steady_xC" };
  bool found = lists_formula(list, scallop_published) || lists_formula(list, scallop_corrected);
  for (size_t i = 0; i < sizeof others / sizeof *others; i++)
    found |= claim_is_listed(list, others[i]);
  for (size_t i = 0; i < sizeof end_claims / sizeof *end_claims; i++)
    found |= claim_is_listed(list, end_claims[i].name);
  return found;
}

static void fill(struct book *book)
{
  for (const struct scallop_formula *f = scallop_published; f->name; f++)
    add_formula(book, f, false);
  add_end_claims(book);
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
  for (int g = 0; scallop_gait_name(g); g++) {
    c.gait = scallop_gait_named(scallop_gait_name(g));
    if (gait && c.gait != gait)
      continue;
    struct book book = { .crawler = &c, .only = only, .sink = sink, .context = context, .entries = entries };
    fill(&book);
    if (!only)
      check_corrections(&book);
    close_cases(&book);
    wrong = book.contradiction ? book.contradiction : wrong;
  }
  scallop_rational_clear(&c);
  return wrong;
}
