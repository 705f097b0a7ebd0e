/* Where each formula goes wrong: the first coefficient in which its text differs from the derived expansion. */
#include "asymptotics/derived/derived.h"
#include "asymptotics/derived/evaluate.h"
#include "tests/support/exact.h"

enum { PRECISION = 300, ORDER = 12, NEVER = ORDER };
static const struct ring ring = { 2 * ORDER, PRECISION };

/* For the quadratic gait. Each motion is a chain of straight lines there, every switching time a quotient; a script of
 * its own, with fractions and nothing of this program, compared these formulas with it at T = 1e-15 and 1e-18. */
static const struct {
  const char *name;
  slong inside;  /* from rest F1 > F2; moving v0 > 0; steady (F1 - F2)(alpha - 1/2) > 0 */
  slong outside; /* the other way round */
} wanted[] = {
  { "rest_v1_switch", NEVER, 1 },
  { "rest_dT_unexpanded", NEVER, 3 },
  { "rest_dT", 5, 3 },
  { "rest_x1_switch", 4, 4 },
  { "rest_v1_end", 3, 3 },
  { "rest_x1_end", 6, 6 },
  { "rest_x2_end", 6, 6 },
  { "rest_xC_end", 6, 6 },
  { "text_extension_velocity_change", 3, 2 },
  { "text_extension_xC_end", 5, 3 },
  { "text_contraction_velocity_change", 3, 2 },
  { "text_contraction_xC_end", 5, 3 },
  { "text_steady_velocity_l0_lT", 1, -1 },
  { "text_steady_velocity", 1, -1 },
  { "text_steady_xC", 4, 0 },
  { "A_v1_first_switch", NEVER, 0 },
  { "A_t1_unexpanded", NEVER, 2 },
  { "A_t1", 6, 2 },
  { "A_x1_first_switch", NEVER, 2 },
  { "A_v1_switch", NEVER, 1 },
  { "A_v1_switch_from_v0", NEVER, 0 },
  { "A_dT_unexpanded", NEVER, 2 },
  { "rest_dT_product", 7, 3 },
  { "A_dT_product", 6, 2 },
  { "A_dT", 5, 2 },
  { "A_x1_switch_from_times", NEVER, 1 },
  { "A_x1_switch_collected", NEVER, 1 },
  { "A_x1_switch", 4, 2 },
  { "A_v1_end_from_dT", NEVER, 0 },
  { "A_v1_end", 3, 2 },
  { "A_x1_end_from_dT", NEVER, 2 },
  { "A_x1_end_from_dT_short", 4, 2 },
  { "A_x1_end", 3, 3 },
  { "A_vC_end", 3, 2 },
  { "A_xC_end", 3, 3 },
  { "B_t1_unexpanded", NEVER, 2 },
  { "B_t1", 6, 2 },
  { "B_x2_first_switch", NEVER, 2 },
  { "B_dT_unexpanded", NEVER, 2 },
  { "B_dT_product", 6, 2 },
  { "B_dT", 5, 2 },
  { "B_x2_switch_from_times", NEVER, 1 },
  { "B_x2_switch_collected", 2, 1 },
  { "B_x2_switch", 4, 2 },
  { "B_v2_end_from_dT", NEVER, 0 },
  { "B_v2_end", 0, 0 },
  { "B_x2_end_from_dT", 0, 0 },
  { "B_x2_end", 5, 3 },
  { "B_vC_end", 0, 0 },
  { "B_xC_end", 5, 3 },
};
enum { WANTED = sizeof wanted / sizeof *wanted };

struct subject {
  struct scallop_rational_crawler crawler;
  struct scallop_expansion phase;
  struct scallop_expansion steady;
  struct scallop_symbols symbols;
  fmpq_t v0, pi_squared;
};
#define SUBJECT(of) \
  of(scallop_rational, &s->crawler) of(scallop_expansion, &s->phase) of(scallop_expansion, &s->steady) \
      of(scallop_symbols, &s->symbols) of(fmpq, s->v0) of(fmpq, s->pi_squared)
SCOPED_PARTS(subject, struct subject, SUBJECT)

/* The first power in which the formula is wrong, NEVER if there is none below T^ORDER */
static slong first_wrong(struct subject *s, const struct scallop_formula *f, enum scallop_phase_kind kind)
{
  const struct series *right = scallop_expansion_of(f->setting == SCALLOP_STEADY ? &s->steady : &s->phase, f->quantity);
  SCOPED(series, text);
  assert_non_null(right);
  char message[FORMULA_MESSAGE];
  assert_null(scallop_formula_expand(&text, f, &s->symbols, kind, &ring, message));
  series_sub(&text, &text, right, &ring);
  assert_true(text.known >= ORDER);
  return next_nonzero(&text, -2, NEVER);
}

/* pi^2 is some fraction here: then every coefficient is exact. */
static void expand_phase(struct subject *s, enum scallop_phase_kind kind)
{
  assert_int_equal(scallop_expand_phase(&s->crawler, kind, s->v0, ORDER, PRECISION, s->pi_squared, &s->phase, NULL),
                   SCALLOP_OK);
  scallop_symbols_set(&s->symbols, &s->crawler, kind, s->v0, s->pi_squared, &ring);
  series_set(&s->symbols.value[SCALLOP_SYMBOL_t1], &s->phase.t1);
  series_set(&s->symbols.value[SCALLOP_SYMBOL_dT], &s->phase.dT);
  series_set(&s->symbols.value[SCALLOP_SYMBOL_x_switch], &s->phase.rear_at_last);
}

static bool expand_steady(struct subject *s)
{
  scallop_symbols_set(&s->symbols, &s->crawler, SCALLOP_EXTENSION, NULL, NULL, &ring);
  return scallop_expand_steady(&s->crawler, ORDER, PRECISION, &s->steady, NULL) == SCALLOP_OK;
}

static void draw(struct subject *s, struct random *r, const struct scallop_gait *gait)
{
  struct scallop_crawler c = random_crawler(r, ORDINARY, gait); /* of 53 bits: small fractions coincide now and then */
  scallop_rational_of(&s->crawler, &c);
  scallop_rational_set_double(s->v0, random_between(r, 0.5, 5));
  fmpq_set_si(s->pi_squared, 9 + random_below(r, 90), 10);
}

static void set_order(fmpq_t larger, fmpq_t smaller)
{
  if (fmpq_cmp(larger, smaller) < 0)
    fmpq_swap(larger, smaller);
}

static void check_wrong(struct subject *s, const struct scallop_formula *f, enum scallop_phase_kind kind, slong power)
{
  slong found = first_wrong(s, f, kind);
  if (found != power) {
    print_exact_crawler(&s->crawler);
    fail_msg("%s in phase %d, v0=%g: first wrong in T^%ld, not T^%ld", f->name, kind, fraction_d(s->v0), (long)found,
             (long)power);
  }
}

/* One formula in one phase, inside its conditions or outside of them */
static void check_phase_formula(struct subject *s, int k, enum scallop_phase_kind kind, bool inside)
{
  const struct scallop_formula *f = scallop_formula_named(wanted[k].name);
  struct scallop_rational_crawler *c = &s->crawler;
  bool rest = f->setting == SCALLOP_AT_REST_START, rear_is_1 = kind == SCALLOP_EXTENSION;
  if (rest) {
    fmpq_zero(s->v0);
    set_order(rear_is_1 == inside ? c->F1 : c->F2, rear_is_1 == inside ? c->F2 : c->F1);
  } else if (!inside)
    fmpq_neg(s->v0, s->v0);
  expand_phase(s, kind);
  check_wrong(s, f, kind, inside ? wanted[k].inside : wanted[k].outside);
}

static void check_steady_formula(struct subject *s, int k, bool inside)
{
  struct scallop_rational_crawler *c = &s->crawler;
  SCOPED(fmpq, rest);
  scallop_rational_fraction(rest, c, SCALLOP_CONTRACTION);
  bool positive = (fmpq_cmp(c->F1, c->F2) > 0) == (fmpq_cmp(c->alpha, rest) > 0);
  if (positive != inside)
    fmpq_swap(c->F1, c->F2);
  const char *all_turn = inside ? "++ -+ ++ | ++ +- ++" : "-- -+ -- | -- +- --";
  if (expand_steady(s) && strcmp(s->steady.modes, all_turn) == 0)
    check_wrong(s, scallop_formula_named(wanted[k].name), SCALLOP_EXTENSION,
                inside ? wanted[k].inside : wanted[k].outside);
}

TEST(published_for_the_quadratic_gait)
{
  struct random r = { 20260861 };
  SCOPED(subject, s);
  for (int k = 0; k < WANTED; k++) {
    const struct scallop_formula *f = scallop_formula_named(wanted[k].name);
    assert_non_null(f);
    for (int i = 0; i < check_cases(12); i++) {
      bool inside = i % 2 == 0;
      draw(&s, &r, &scallop_gait_quadratic);
      if (f->setting == SCALLOP_STEADY)
        check_steady_formula(&s, k, inside);
      else if (f->setting == SCALLOP_MOVING_CONTRACTION || i % 4 < 2)
        check_phase_formula(&s, k, SCALLOP_CONTRACTION, inside);
      else
        check_phase_formula(&s, k, SCALLOP_EXTENSION, inside);
    }
  }
  int known = 0; /* all but those of section 4.1, for F1 = F2 */
  for (const struct scallop_formula *f = scallop_published; f->name; f++)
    known += f->when == NULL;
  assert_int_equal(known, WANTED);
}

/* Right below the remainder that they state. Two gain an order from l0 = -lT, by F1 M (v0/m2)^2 (1/l0^2 - 1/lT^2) in
 * T^4: not so for the trapezoid. */
static void check_right(struct subject *s, const struct scallop_formula *f, enum scallop_phase_kind kind)
{
  bool gains = strcmp(f->name, "corrected_rear_end") == 0 || strcmp(f->name, "corrected_xC_end") == 0;
  slong found = first_wrong(s, f, kind);
  slong order = f->remainder == SCALLOP_EQUALITY ? NEVER : f->remainder - (gains && s->crawler.gait == &trapezoid_gait);
  if (found < order) {
    print_exact_crawler(&s->crawler);
    fail_msg("%s in phase %d: wrong in T^%ld", f->name, kind, (long)found);
  }
}

static const struct scallop_gait *const gaits[] = { &scallop_gait_quadratic, &scallop_gait_sinusoidal,
                                                    &trapezoid_gait };
enum { GAITS = 3 };

/* From rest the body that turns has the larger friction. */
static void set_start(struct subject *s, enum scallop_setting start, bool equal_forces, enum scallop_phase_kind kind)
{
  struct scallop_rational_crawler *c = &s->crawler;
  bool rear_is_1 = kind == SCALLOP_EXTENSION;
  if (start == SCALLOP_MOVING_EXTENSION)
    return;
  fmpq_zero(s->v0);
  set_order(rear_is_1 ? c->F1 : c->F2, rear_is_1 ? c->F2 : c->F1);
  if (equal_forces)
    fmpq_mul_si(c->F2, c->F1, 1);
}

TEST(corrected_phases)
{
  static const enum scallop_setting starts[] = { SCALLOP_MOVING_EXTENSION, SCALLOP_AT_REST_START,
                                                 SCALLOP_AT_REST_START };
  enum { STARTS = sizeof starts / sizeof *starts, LAST = STARTS - 1 };
  struct random r = { 20260862 };
  SCOPED(subject, s);
  for (int i = 0; i < check_cases(20 * GAITS * STARTS); i++) {
    enum scallop_phase_kind kind = random_below(&r, 2) ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
    enum scallop_setting start = starts[i / GAITS % STARTS];
    draw(&s, &r, gaits[i % GAITS]);
    bool equal_forces = i / GAITS % STARTS == LAST;
    set_start(&s, start, equal_forces, kind);
    expand_phase(&s, kind);
    for (const struct scallop_formula *f = scallop_corrected; f->name; f++)
      if (f->setting == start && equal_forces == (f->when != NULL))
        check_right(&s, f, kind);
  }
}

/* Where a body does not turn at all in one of the phases: the names say which. Like (26) to (28) they are for the
 * quadratic gait. */
TEST(corrected_steady_states)
{
  struct random r = { 20260863 };
  int found[2] = { 0, 0 };
  SCOPED(subject, s);
  for (int i = 0; i < 400; i++) { /* one body a hundredth of the other, or so */
    random_exact_crawler(&s.crawler, &r, &scallop_gait_quadratic);
    fmpq *light = i % 2 ? s.crawler.m1 : s.crawler.m2;
    fmpq_div_2exp(light, light, 6);
    assert_true(expand_steady(&s));
    for (const struct scallop_formula *f = scallop_corrected; f->name; f++) {
      bool extension = strstr(f->name, "_no_turn_extension") != NULL;
      const char *modes = extension ? "++ | ++ +- ++" : "++ -+ ++ | ++";
      if (f->setting != SCALLOP_STEADY || strcmp(s.steady.modes, modes) != 0)
        continue;
      check_right(&s, f, SCALLOP_EXTENSION);
      found[extension]++;
    }
  }
  assert_true(found[0] >= 20 && found[1] >= 20);
}
