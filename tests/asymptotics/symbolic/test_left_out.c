/* What formulas leave out, as a formula, against the same in numbers: by another evaluator, and by another
 * derivation. */
#include <stdlib.h>
#include <string.h>

#include "asymptotics/derived/evaluate.h"
#include "asymptotics/derived/expansion.h"
#include "asymptotics/derived/formula_flint.h"
#include "asymptotics/published/read.h"
#include "asymptotics/symbolic/left_out.h"
#include "tests/support/exact.h"
#include "tests/support/random_gait.h"
#include "tests/support/solved.h"

enum { TERMS = 10, PRECISION = 300, CRAWLERS = 3 };

static int place_of(void *context, const char *name)
{
  (void)context;
  return strcmp(name, "T") == 0   ? 0
         : strcmp(name, "m") == 0 ? 1
         : strcmp(name, "F") == 0 ? 2
         : strcmp(name, "z") == 0 ? 3
                                  : -1;
}

static const struct formula_names names = { .place = place_of };

/* Of m = m1 and F = F1, two symbols; z has no formula. */
static const char *in_symbols(struct series *value, struct symbols *s, const char *text, char message[FORMULA_MESSAGE])
{
  struct formula formula;
  assert_null(formula_read(&formula, text, &names, message));
  symbols_init(s);
  symbols_add(s, NAMED_m1, 0, SCALLOP_EXTENSION);
  symbols_add(s, NAMED_F1, 0, SCALLOP_EXTENSION);
  symbols_begin(s);
  SCOPED(series, T, m, F, z);
  series_set_x(&T);
  series_set_ratio(&m, symbolic_place(s, 0));
  series_set_ratio(&F, symbolic_place(s, 1));
  series_set_unknown(&z);
  const struct series values[] = { T, m, F, z };
  return formula_series(value, &formula, values, &s->names, &(const struct ring){ TERMS, 2 }, message);
}

/* The same with m = 3/7 and F = -5/2, as a series with exact coefficients */
static void in_numbers(struct series *value, const char *text)
{
  const struct ring ring = { TERMS + 4, 64 };
  struct formula formula;
  char message[FORMULA_MESSAGE];
  SCOPED(series, T, m, F, z);
  SCOPED(fmpq, number);
  assert_null(formula_read(&formula, text, &names, message));
  series_set_x(&T);
  fmpq_set_si(number, 3, 7);
  series_set_rational(&m, number);
  fmpq_set_si(number, -5, 2);
  series_set_rational(&F, number);
  const struct series values[] = { T, m, F, z };
  assert_null(formula_series(value, &formula, values, NULL, &ring, message));
}

TEST(a_formula_in_symbols_is_the_one_in_numbers)
{
  static const char *const texts[] = { "0",
                                       "m",
                                       "-T",
                                       "T - T",
                                       "0.25*m - F/3*T^2",
                                       "(m + F)^3/(T^2*(m - F))",
                                       "1/(m*T + F*T^3)^2",
                                       "(1 + m*T)^-3*T",
                                       "-(F - T)^2/(F^2 - T^2)",
                                       "(m^2 - F^2)/(m - F) - m - F + T^5",
                                       "(1/(1 - T) - 1 - T - T^2)/T^7",
                                       "0*m + (m*F)^0 + 0/F",
                                       "(T^3 - T^2*(T - m*F))/(T*F)",
                                       "((2*m*F)^64/(2*m*F)^63)^-1" };
  enum { TEXTS = sizeof texts / sizeof *texts };
  fmpq *numbers = _fmpq_vec_init(2);
  SCOPED(fmpq, got, wanted);
  fmpq_set_si(numbers, 3, 7);
  fmpq_set_si(numbers + 1, -5, 2);
  for (int i = 0; i < TEXTS; i++) {
    struct symbols s;
    SCOPED(series, value);
    char message[FORMULA_MESSAGE];
    SCOPED(series, numeric);
    if (in_symbols(&value, &s, texts[i], message))
      fail_msg("%s: %s", texts[i], message);
    in_numbers(&numeric, texts[i]);
    assert_true(value.known >= 3);
    if (value.known < SERIES_ALL)
      assert_null(symbolic_coefficient(&s, &value, value.known));
    for (slong k = -10; k < value.known && k < TERMS; k++) {
      assert_true(symbolic_value(got, symbolic_coefficient(&s, &value, k), &s, numbers));
      assert_true(series_rational_coefficient(wanted, &numeric, k));
      if (!fmpq_equal(got, wanted))
        fail_msg("%s: T^%ld", texts[i], (long)k);
    }
    symbols_end(&s);
  }
  _fmpq_vec_clear(numbers, 2);
}

TEST(what_has_no_formula_is_refused_by_name)
{
  static const char *const cases[][2] = {
    { "1 + pi", "character 5: pi is no rational number" },
    { "T*sqrt(m^2)", "character 3: sqrt is no rational function" },
    { "min(m, F)", "character 1: min is no rational function" },
    { "T + z", "character 5: z does not exist for this motion" },
    { "m^(1/2)", "character 2: ^ is a formula for whole powers from -64 to 64 only" },
    { "m^F", "character 2: ^ is a formula for whole powers from -64 to 64 only" },
    { "m^T", "character 2: ^ is a formula for whole powers from -64 to 64 only" },
    { "m^(1 + T)", "character 2: ^ is a formula for whole powers from -64 to 64 only" },
    { "m^65", "character 2: ^ is a formula for whole powers from -64 to 64 only" },
    { "m/(F - F)", "character 2: / divides by what may be 0" },
    { "(m - m)^-1", "character 8: ^ divides by what may be 0" },
    { "((m + F + 1)^18)^2", "character 17: ^ grows beyond 200 terms, degree 2000 or 20000 bits" },
    { "((m^64)^64)", "character 8: ^ grows beyond 200 terms, degree 2000 or 20000 bits" },
    { "(1e50^64)^2", "character 10: ^ grows beyond 200 terms, degree 2000 or 20000 bits" },
    { "((T^64)^64)*T", "character 12: * grows beyond 200 terms, degree 2000 or 20000 bits" },
    { "1/(m + F + 1)^40", "character 14: ^ grows beyond 200 terms, degree 2000 or 20000 bits" },
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    struct symbols s;
    SCOPED(series, value);
    char message[FORMULA_MESSAGE] = "";
    value.first = 22;
    assert_non_null(in_symbols(&value, &s, cases[i][0], message));
    assert_string_equal(message, cases[i][1]);
    assert_int_equal(value.first, 22);
    symbols_end(&s);
  }
}

/* derived - formula in numbers */
static bool left_out_in_numbers(struct series *difference, const struct scallop_formula *f,
                                const struct scallop_rational_crawler *c, const fmpq_t v0)
{
  const struct ring ring = { TERMS + 8, PRECISION };
  const bool steady = f->setting == SCALLOP_STEADY;
  const enum scallop_phase_kind kind = f->setting == SCALLOP_MOVING_CONTRACTION ? SCALLOP_CONTRACTION
                                                                                : SCALLOP_EXTENSION;
  struct scallop_symbols symbols;
  char message[FORMULA_MESSAGE];
  SCOPED(scallop_expansion, phase);
  SCOPED(scallop_expansion, period);
  SCOPED(series, value);
  if ((steady ? scallop_expand_steady(c, TERMS, PRECISION, &period, NULL)
              : scallop_expand_phase(c, kind, v0, TERMS, PRECISION, NULL, &phase, NULL))
      != SCALLOP_OK)
    return false;
  scallop_symbols_init(&symbols);
  scallop_symbols_set(&symbols, c, kind, steady ? NULL : v0, NULL, &ring);
  series_set(&symbols.value[SCALLOP_SYMBOL_t1], &phase.t1);
  series_set(&symbols.value[SCALLOP_SYMBOL_dT], &phase.dT);
  series_set(&symbols.value[SCALLOP_SYMBOL_x_switch], &phase.rear_at_last);
  assert_null(scallop_formula_expand(&value, f, &symbols, kind, &ring, message));
  series_sub(difference, scallop_expansion_of(steady ? &period : &phase, f->quantity), &value, &ring);
  scallop_symbols_clear(&symbols);
  return true;
}

/* The term's coefficient by the text: its value where T, the duration of the phase or the period, is 1 */
static void value_of_text(arb_t value, const char *text, const struct scallop_formula *f,
                          const struct scallop_rational_crawler *c, const fmpq_t v0)
{
  const enum scallop_phase_kind kind = f->setting == SCALLOP_MOVING_CONTRACTION ? SCALLOP_CONTRACTION
                                                                                : SCALLOP_EXTENSION;
  const struct scallop_formula term = { .setting = f->setting, .text = text };
  char message[SCALLOP_FORMULA_MESSAGE];
  struct scallop_read_formula *read = scallop_formula_read(&term, message);
  SCOPED(scallop_rational, at);
  SCOPED(fmpq, fraction);
  if (!read)
    fail_msg("%s: %s", text, message);
  scallop_rational_copy(&at, c);
  fmpq_one(fraction);
  if (f->setting != SCALLOP_STEADY)
    scallop_rational_fraction(fraction, &at, kind);
  fmpq_inv(at.T, fraction);
  assert_int_equal(scallop_formula_ball(value, read, &at, kind, v0, NULL, PRECISION), SCALLOP_OK);
  scallop_formula_free(read);
}

/* Returns whether there was something to compare. */
static bool check_formula(const struct scallop_formula *f, const struct scallop_rational_crawler *c, const fmpq_t v0)
{
  const bool rational = scallop_gait_is_rational(c->gait);
  char message[FORMULA_MESSAGE] = "";
  SCOPED(series, difference);
  const enum scallop_phase_kind kind = f->setting == SCALLOP_MOVING_CONTRACTION ? SCALLOP_CONTRACTION
                                                                                : SCALLOP_EXTENSION;
  ENDED_BY(left_out_clear) struct left_out l = { .term = NULL };
  SCOPED(fmpq, wanted);
  SCOPED(arb, ball, of_text);
  left_out_init(&l);
  if (!left_out_in_numbers(&difference, f, c, v0))
    return false;
  slong power = next_nonzero(&difference, -4, TERMS);
  if (power == TERMS)
    return false;
  if (symbolic_left_out(&l, f, c, kind, v0, power, message)) {
    if (rational || f->setting != SCALLOP_STEADY)
      fail_msg("%s: %s", f->name, message);
    return false;
  }
  assert_int_equal(l.order, power);
  assert_int_equal(l.is_number, rational);
  const char *text = l.term;
  series_coefficient(ball, &difference, power, PRECISION);
  if (rational && (!series_rational_coefficient(wanted, &difference, power) || !fmpq_equal(l.coefficient, wanted))) {
    print_exact_crawler(c);
    fail_msg("%s: T^%ld: %s", f->name, (long)power, text);
  }
  if (strlen(text) < 900 && !strstr(text, "l3_") && !strstr(text, "l5_") && !strstr(text, "l6_")) {
    value_of_text(of_text, text, f, c, v0);
    if (!arb_overlaps(ball, of_text) || arb_rel_accuracy_bits(of_text) < 100) {
      print_exact_crawler(c);
      fail_msg("%s: %s", f->name, text);
    }
  }
  return true;
}

/* Every formula of the paper's formula file, at crawlers like the paper's and others: an order that one of them has is
 * not in question here, only what stands there. */
static int check_formula_file(const struct scallop_gait *gait, struct random *r)
{
  const struct scallop_formula *const lists[] = { scallop_published, scallop_corrected };
  SCOPED(scallop_rational, c);
  SCOPED(fmpq, v0, none);
  int compared = 0;
  random_exact_crawler(&c, r, gait);
  random_positive(v0, r);
  for (int i = 0; i < 2; i++)
    for (const struct scallop_formula *f = lists[i]; f->name; f++)
      compared += check_formula(f, &c, f->setting == SCALLOP_AT_REST_START ? none : v0);
  return compared;
}

TEST(what_the_papers_formulas_leave_out)
{
  struct random r = { 20261123 };
  struct random_gait made;
  int compared = 0, sinusoidal = 0;
  for (long i = 0; i < check_cases(CRAWLERS); i++) {
    compared += check_formula_file(&scallop_gait_quadratic, &r);
    compared += check_formula_file(random_gait(&r, TRAPEZOIDAL, &made), &r);
    sinusoidal += check_formula_file(&scallop_gait_sinusoidal, &r);
  }
  assert_true(compared > 2 * 25 && sinusoidal > 20);
  print_message("%d leading errors of rational gaits, %d of the sinusoidal one\n", compared, sinusoidal);
}

struct told { /* of one formula at one crawler */
  const char *text, *gait, *F2;
  enum scallop_setting setting;
  enum scallop_quantity quantity;
  slong most;
  const char *left_out; /* or the message, or "" */
};

/* Where names of one thing meet: M and m1 + m2, 1 - alpha and alpha, derivatives of l and numbers of amplitudes, equal
 * forces */
static const struct told other_words[] = {
  { "(F1 - F2)/(m1 + m2)*T", "quadratic", "1", SCALLOP_AT_REST_START, SCALLOP_VELOCITY_AT_END, 3,
    "2*F1*T^3*(F1 - F2)/(m2*M*lT)" },
  { "v0 + (F1 - F2)/(m1 + m2)*T", "quadratic", "1", SCALLOP_AT_REST_START, SCALLOP_VELOCITY_AT_END, 3,
    "2*F1*T^3*(F1 - F2)/(m2*M*lT)" },
  { "(F1 - F2)/(4*m2*L)*T^3", "quadratic", "1", SCALLOP_AT_REST_START, SCALLOP_LAG, 5,
    "-T^5*(F1 - F2)^2/(16*m2^2*L^2)" },
  { "(F1 - F2)/(4*m2*L)*T^3", "sinusoidal", "1", SCALLOP_AT_REST_START, SCALLOP_LAG, 3,
    "-T^3*(4*L + lT)*(F1 - F2)/(4*m2*L*lT)" },
  { "-(m2 - alpha*0)/M*L_kin*0 - m2*L/M", "quadratic", "1", SCALLOP_AT_REST_START, SCALLOP_REAR_AT_END, 2,
    "T^2*(F1 - F2)/(2*M)" },
  { "m1*m2*l0/4*(2*alpha - 1)*(F1 - F2)/(M*(m1*F1*alpha^2 + m2*F2*(1 - alpha)^2))/T", "quadratic", "1", SCALLOP_STEADY,
    SCALLOP_STEADY_V_MID, 1,
    "alpha*(1 - alpha)*T*(F1 - F2)*(m1*F1*alpha + m2*F2*(1 - alpha))/(2*M*(m1*F1*alpha^2 + m2*F2*(1 - alpha)^2))" },
  { "L", "quadratic", "1", SCALLOP_STEADY, SCALLOP_STEADY_MEAN_VELOCITY, -1,
    "m1*m2*L*(2*alpha - 1)*(F1 - F2)/(M*T*(m1*F1*alpha^2 + m2*F2*(1 - alpha)^2))" },
  { "T", "quadratic", "4", SCALLOP_AT_REST_START, SCALLOP_VELOCITY_AT_END, 1, "-T" },
  { "T", "quadratic", "1", SCALLOP_STEADY, SCALLOP_STEADY_FRICTION_WORK, 0,
    "this quantity is not derived as a formula" },
  { "T", "quadratic", "1", SCALLOP_AT_REST_START, SCALLOP_VELOCITY_AT_END, 16, "the order is not below 16" },
  { "T", "sinusoidal", "1", SCALLOP_STEADY, SCALLOP_STEADY_VELOCITY, -1,
    "the closed form of the steady state is for rational gaits" },
  { "T", "quadratic", "4", SCALLOP_STEADY, SCALLOP_STEADY_VELOCITY, 1,
    "alpha = 1/2 or F1 = F2: the start velocity is 0 for T -> 0, and bodies turn otherwise than for any alpha, F1 "
    "and F2 "
    "near these" },
  { "pi*T", "quadratic", "1", SCALLOP_AT_REST_START, SCALLOP_VELOCITY_AT_END, 1, "-T*(pi*M - F1 + F2)/M" },
  { "(F1 - F2)*T/M - 4*F1*(F1 - F2)/(m2*M*pi^2*L)*T^3", "sinusoidal", "1", SCALLOP_AT_REST_START,
    SCALLOP_VELOCITY_AT_END, 4, "" },
  /* right for this crawler, and for no other */
  { "3*T/2", "quadratic", "1", SCALLOP_AT_REST_START, SCALLOP_VELOCITY_AT_END, 3, "-T*(3*M - 2*F1 + 2*F2)/(2*M)" },
  { "T", "quadratic", "1", SCALLOP_MOVING_EXTENSION, SCALLOP_VELOCITY_AT_END, 1, "v0" },
  { "(F1 - F2)*T/M + 0*T^-20", "quadratic", "1", SCALLOP_AT_REST_START, SCALLOP_VELOCITY_AT_END, 3,
    "2*F1*T^3*(F1 - F2)/(m2*M*lT)" },
  { "(F1 - F2)*T/M + T^-20 - T^-20", "quadratic", "1", SCALLOP_AT_REST_START, SCALLOP_VELOCITY_AT_END, 3,
    "too few terms are known" },
  { "sqrt(T^2)", "quadratic", "1", SCALLOP_AT_REST_START, SCALLOP_VELOCITY_AT_END, 1,
    "character 1: sqrt is no rational function" },
  { "(F1", "quadratic", "1", SCALLOP_AT_REST_START, SCALLOP_VELOCITY_AT_END, 3, "character 1: this '(' is not closed" },
};

TEST(formulas_in_other_words)
{
  for (size_t i = 0; i < sizeof other_words / sizeof *other_words; i++) {
    const struct told *t = &other_words[i];
    const struct scallop_formula f = { .name = "f", .setting = t->setting, .quantity = t->quantity, .text = t->text };
    char message[FORMULA_MESSAGE] = "";
    SCOPED(scallop_rational, c);
    ENDED_BY(left_out_clear) struct left_out l = { .term = NULL };
    SCOPED(fmpq, v0);
    left_out_init(&l);
    if (t->setting == SCALLOP_MOVING_EXTENSION)
      fmpq_one(v0);
    const struct scallop_crawler paper = scallop_crawler_default();
    scallop_rational_of(&c, &paper);
    c.gait = scallop_gait_named(t->gait);
    assert_true(scallop_rational_parse(c.F2, t->F2));
    const char *wrong = symbolic_left_out(&l, &f, &c, SCALLOP_EXTENSION, v0, t->most, message);
    const char *said = wrong ? wrong : l.term ? l.term : "";
    if (strcmp(said, t->left_out) != 0)
      fail_msg("%s: %s", t->text, said);
    assert_true(wrong || (l.order > t->most) == !l.term);
  }
}

/* pi is a symbol that has no value among fractions: 1 stands for it. */
TEST(pi_is_a_symbol)
{
  const struct scallop_crawler paper = scallop_crawler_default();
  struct symbols s;
  SCOPED(scallop_rational, c);
  SCOPED(fmpq, v0);
  fmpq *values = _fmpq_vec_init(1);
  scallop_rational_of(&c, &paper);
  symbols_init(&s);
  symbols_add(&s, NAMED_pi, 0, SCALLOP_EXTENSION);
  symbols_begin(&s);
  symbols_values(values, &s, &c, v0, NULL);
  assert_true(fmpq_is_one(values));
  assert_string_equal(s.list[0].name, "pi");
  symbols_end(&s);
  _fmpq_vec_clear(values, 1);
}
