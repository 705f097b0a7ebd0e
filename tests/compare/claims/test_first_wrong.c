/* The corrected formulas are right below the remainder that they state, for any crawler: no coefficient of their text
 * differs from the derived expansion there. Where those of the paper go wrong: data/claims.tsv. */
#include "asymptotics/derived/derived.h"
#include "asymptotics/derived/evaluate.h"
#include "tests/support/exact.h"

enum { PRECISION = 300, ORDER = 12, NEVER = ORDER };
static const struct ring ring = { 2 * ORDER, PRECISION };

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

/* Right below the remainder that they state. Two gain an order from l0 = -lT, by F1 M (v0/m2)^2 (1/l0^2 - 1/lT^2) in
 * T^4: not so for the trapezoid. */
static void check_right(struct subject *s, const struct scallop_formula *f, enum scallop_phase_kind kind)
{
  bool gains = strcmp(f->name, "corrected_rear_end") == 0 || strcmp(f->name, "corrected_dxC") == 0;
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
static void set_at_rest(struct subject *s, bool equal_forces, enum scallop_phase_kind kind)
{
  fmpq *F1 = s->crawler.F1, *F2 = s->crawler.F2;
  fmpq_zero(s->v0);
  if (kind == SCALLOP_EXTENSION ? fmpq_cmp(F1, F2) < 0 : fmpq_cmp(F2, F1) < 0)
    fmpq_swap(F1, F2);
  if (equal_forces)
    fmpq_set(F2, F1);
}

TEST(corrected_phases)
{
  enum { MOVES, RESTS, RESTS_EQUAL, STARTS };
  struct random r = { 20260862 };
  SCOPED(subject, s);
  for (int i = 0; i < check_cases(20 * GAITS * STARTS); i++) {
    enum scallop_phase_kind kind = random_below(&r, 2) ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
    const int start = i / GAITS % STARTS;
    draw(&s, &r, gaits[i % GAITS]);
    if (start != MOVES)
      set_at_rest(&s, start == RESTS_EQUAL, kind);
    expand_phase(&s, kind);
    for (const struct scallop_formula *f = scallop_corrected; f->name; f++)
      if (f->setting == (start == MOVES ? SCALLOP_MOVING_EXTENSION : SCALLOP_AT_REST_START)
          && (start == RESTS_EQUAL) == (f->when != NULL))
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
