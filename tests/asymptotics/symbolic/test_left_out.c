/* What formulas leave out, as a formula, against the same in numbers: by another evaluator, and by another
 * derivation. */
#include <stdlib.h>
#include <string.h>

#include "asymptotics/derived/evaluate.h"
#include "asymptotics/derived/expansion.h"
#include "asymptotics/derived/formula_flint.h"
#include "asymptotics/published/read.h"
#include "asymptotics/symbolic/left_out.h"
#include "tests/support/cases.h"
#include "tests/support/exact.h"
#include "tests/support/random_gait.h"
#include "tests/support/solved.h"

enum { TERMS = 10, PRECISION = 300, CRAWLERS = 2 };

SCOPED_KIND(left_out, struct left_out)

enum { LETTERS = 4 };
static int place_of(void *context, const char *name)
{
  static const char letters[] = "TmFz";
  const char *found = strchr(letters, *name);
  return (void)context, found ? (int)(found - letters) : -1;
}

/* Of m = m1 and F = F1, two symbols, or of m = 3/7 and F = -5/2, as a series with exact coefficients; z has no
 * formula. */
static const char *evaluate(struct series *value, struct symbols *s, const char *text, char message[FORMULA_MESSAGE])
{
  static const struct formula_names names = { .place = place_of };
  const struct ring ring = { s ? TERMS : TERMS + 4, s ? 2 : 64 };
  struct formula formula;
  SCOPED(series, T, m, F, z);
  SCOPED(fmpq, number);
  assert_null(formula_read(&formula, text, &names, message));
  series_set_x(&T);
  fmpq_set_si(number, 3, 7);
  series_set_rational(&m, number);
  fmpq_set_si(number, -5, 2);
  series_set_rational(&F, number);
  series_set_unknown(&z);
  if (s) {
    symbols_init(s);
    symbols_add(s, NAMED_m1, 0, SCALLOP_EXTENSION);
    symbols_add(s, NAMED_F1, 0, SCALLOP_EXTENSION);
    symbols_begin(s);
    series_set_ratio(&m, symbolic_place(s, 0));
    series_set_ratio(&F, symbolic_place(s, 1));
  }
  const struct series values[LETTERS] = { T, m, F, z };
  return formula_series(value, &formula, values, s ? &s->names : NULL, &ring, message);
}

TEST(a_formula_in_symbols_is_the_one_in_numbers)
{
  static const char texts[] =
      "0|m|-T|T - T|0.25*m - F/3*T^2|(m + F)^3/(T^2*(m - F))|1/(m*T + F*T^3)^2|(1 + m*T)^-3*T|-(F - T)^2/(F^2 - T^2)|"
      "(m^2 - F^2)/(m - F) - m - F + T^5|(1/(1 - T) - 1 - T - T^2)/T^7|0*m + (m*F)^0 + 0/F|(T^3 - T^2*(T - m*F))/(T*F)|"
      "((2*m*F)^64/(2*m*F)^63)^-1";
  fmpq *numbers = _fmpq_vec_init(2);
  SCOPED(fmpq, got, wanted);
  fmpq_set_si(numbers, 3, 7);
  fmpq_set_si(numbers + 1, -5, 2);
  FOR_CASES (text, texts) {
    ENDED_BY(symbols_end) struct symbols s;
    SCOPED(series, value, numeric);
    char message[FORMULA_MESSAGE];
    if (evaluate(&value, &s, text, message) || evaluate(&numeric, NULL, text, message))
      fail_msg("%s: %s", text, message);
    assert_true(value.known >= 3);
    if (value.known < SERIES_ALL)
      assert_null(symbolic_coefficient(&s, &value, value.known));
    for (slong k = -10; k < value.known && k < TERMS; k++) {
      assert_true(symbolic_value(got, symbolic_coefficient(&s, &value, k), &s, numbers));
      assert_true(series_rational_coefficient(wanted, &numeric, k));
      if (!fmpq_equal(got, wanted))
        fail_msg("%s: T^%ld", text, (long)k);
    }
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
    ENDED_BY(symbols_end) struct symbols s;
    SCOPED(series, value);
    char message[FORMULA_MESSAGE] = "";
    value.first = 22;
    if (!evaluate(&value, &s, cases[i][0], message) || strcmp(message, cases[i][1]) != 0 || value.first != 22)
      fail_msg("%s: %s", cases[i][0], message);
  }
}

static enum scallop_phase_kind kind_of(const struct scallop_formula *f)
{
  return f->setting == SCALLOP_MOVING_CONTRACTION ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION;
}

/* derived - formula in numbers */
static bool left_out_in_numbers(struct series *difference, const struct scallop_formula *f,
                                const struct scallop_rational_crawler *c, const fmpq_t v0)
{
  const struct ring ring = { TERMS + 8, PRECISION };
  const bool steady = f->setting == SCALLOP_STEADY;
  char message[FORMULA_MESSAGE];
  SCOPED(scallop_expansion, e);
  SCOPED(scallop_symbols, symbols);
  SCOPED(series, value);
  if ((steady ? scallop_expand_steady(c, TERMS, PRECISION, &e, NULL)
              : scallop_expand_phase(c, kind_of(f), v0, TERMS, PRECISION, NULL, &e, NULL))
      != SCALLOP_OK)
    return false;
  scallop_symbols_set(&symbols, c, kind_of(f), steady ? NULL : v0, NULL, &ring);
  series_set(&symbols.value[SCALLOP_SYMBOL_t1], &e.t1);
  series_set(&symbols.value[SCALLOP_SYMBOL_dT], &e.dT);
  series_set(&symbols.value[SCALLOP_SYMBOL_x_switch], &e.rear_at_last);
  assert_null(scallop_formula_expand(&value, f, &symbols, kind_of(f), &ring, message));
  series_sub(difference, scallop_expansion_of(&e, f->quantity), &value, &ring);
  return true;
}

/* The term's coefficient by the text: its value where T, the duration of the phase or the period, is 1 */
static void value_of_text(arb_t value, const char *text, const struct scallop_formula *f,
                          const struct scallop_rational_crawler *c, const fmpq_t v0)
{
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
    scallop_rational_fraction(fraction, &at, kind_of(f));
  fmpq_inv(at.T, fraction);
  assert_int_equal(scallop_formula_ball(value, read, &at, kind_of(f), v0, NULL, PRECISION), SCALLOP_OK);
  scallop_formula_free(read);
}

/* Returns whether there was something to compare. */
static bool check_formula(const struct scallop_formula *f, const struct scallop_rational_crawler *c, const fmpq_t v0)
{
  const bool rational = scallop_gait_is_rational(c->gait);
  char message[FORMULA_MESSAGE] = "";
  SCOPED(series, difference);
  SCOPED(left_out, l);
  SCOPED(fmpq, wanted);
  SCOPED(arb, ball, of_text);
  if (!left_out_in_numbers(&difference, f, c, v0))
    return false;
  slong power = next_nonzero(&difference, -4, TERMS);
  if (power == TERMS)
    return false;
  if (symbolic_left_out(&l, f, c, kind_of(f), v0, power, message)) {
    if (rational || f->setting != SCALLOP_STEADY)
      fail_msg("%s: %s", f->name, message);
    return false;
  }
  assert_int_equal(l.order, power);
  assert_int_equal(l.is_number, rational);
  series_coefficient(ball, &difference, power, PRECISION);
  bool right = !rational
               || (series_rational_coefficient(wanted, &difference, power) && fmpq_equal(l.coefficient, wanted));
  if (strlen(l.term) < 900 && !strstr(l.term, "l3_") && !strstr(l.term, "l5_") && !strstr(l.term, "l6_")) {
    value_of_text(of_text, l.term, f, c, v0);
    right = right && arb_overlaps(ball, of_text) && arb_rel_accuracy_bits(of_text) >= 100;
  }
  if (!right) {
    print_exact_crawler(c);
    fail_msg("%s: T^%ld: %s", f->name, (long)power, l.term);
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

struct told { /* of one formula at one crawler, the paper's but for F2 */
  const char *text;
  slong most;
  const char *left_out; /* or the message, or "" */
  enum scallop_quantity quantity;
  enum scallop_setting setting;
  bool sine, equal_forces;
};

/* Where names of one thing meet: M and m1 + m2, 1 - alpha and alpha, derivatives of l and numbers of amplitudes, equal
 * forces */
static const struct told other_words[] = {
  { "(F1 - F2)/(m1 + m2)*T", 3, "2*F1*T^3*(F1 - F2)/(m2*M*lT)", .quantity = SCALLOP_VELOCITY_AT_END },
  { "v0 + (F1 - F2)/(m1 + m2)*T", 3, "2*F1*T^3*(F1 - F2)/(m2*M*lT)", .quantity = SCALLOP_VELOCITY_AT_END },
  { "(F1 - F2)/(4*m2*L)*T^3", 5, "-T^5*(F1 - F2)^2/(16*m2^2*L^2)", .quantity = SCALLOP_LAG },
  { "(F1 - F2)/(4*m2*L)*T^3", 3, "-T^3*(4*L + lT)*(F1 - F2)/(4*m2*L*lT)", .quantity = SCALLOP_LAG, .sine = true },
  { "-(m2 - alpha*0)/M*L_kin*0 - m2*L/M", 2, "T^2*(F1 - F2)/(2*M)", .quantity = SCALLOP_REAR_AT_END },
  { "m1*m2*l0/4*(2*alpha - 1)*(F1 - F2)/(M*(m1*F1*alpha^2 + m2*F2*(1 - alpha)^2))/T", 1,
    "alpha*(1 - alpha)*T*(F1 - F2)*(m1*F1*alpha + m2*F2*(1 - alpha))/(2*M*(m1*F1*alpha^2 + m2*F2*(1 - alpha)^2))",
    .quantity = SCALLOP_STEADY_V_MID, .setting = SCALLOP_STEADY },
  { "L", -1, "m1*m2*L*(2*alpha - 1)*(F1 - F2)/(M*T*(m1*F1*alpha^2 + m2*F2*(1 - alpha)^2))",
    .quantity = SCALLOP_STEADY_MEAN_VELOCITY, .setting = SCALLOP_STEADY },
  { "T", 1, "-T", .quantity = SCALLOP_VELOCITY_AT_END, .equal_forces = true },
  { "T", 0, "this quantity is not derived as a formula", .quantity = SCALLOP_STEADY_FRICTION_WORK,
    .setting = SCALLOP_STEADY },
  { "T", 16, "the order is not below 16", .quantity = SCALLOP_VELOCITY_AT_END },
  { "T", -1, "the closed form of the steady state is for rational gaits", .quantity = SCALLOP_STEADY_VELOCITY,
    .setting = SCALLOP_STEADY, .sine = true },
  { "T", 1,
    "alpha = 1/2 or F1 = F2: the start velocity is 0 for T -> 0, and bodies turn otherwise than for any alpha, F1 and "
    "F2 near these",
    .quantity = SCALLOP_STEADY_VELOCITY, .setting = SCALLOP_STEADY, .equal_forces = true },
  { "pi*T", 1, "-T*(pi*M - F1 + F2)/M", .quantity = SCALLOP_VELOCITY_AT_END },
  { "(F1 - F2)*T/M - 4*F1*(F1 - F2)/(m2*M*pi^2*L)*T^3", 4, "", .quantity = SCALLOP_VELOCITY_AT_END, .sine = true },
  /* right for this crawler, and for no other */
  { "3*T/2", 3, "-T*(3*M - 2*F1 + 2*F2)/(2*M)", .quantity = SCALLOP_VELOCITY_AT_END },
  { "T", 1, "v0", .quantity = SCALLOP_VELOCITY_AT_END, .setting = SCALLOP_MOVING_EXTENSION },
  { "(F1 - F2)*T/M + 0*T^-20", 3, "2*F1*T^3*(F1 - F2)/(m2*M*lT)", .quantity = SCALLOP_VELOCITY_AT_END },
  { "(F1 - F2)*T/M + T^-20 - T^-20", 3, "too few terms are known", .quantity = SCALLOP_VELOCITY_AT_END },
  { "sqrt(T^2)", 1, "character 1: sqrt is no rational function", .quantity = SCALLOP_VELOCITY_AT_END },
  { "(F1", 3, "character 1: this '(' is not closed", .quantity = SCALLOP_VELOCITY_AT_END },
};

TEST(formulas_in_other_words)
{
  for (size_t i = 0; i < sizeof other_words / sizeof *other_words; i++) {
    const struct told *t = &other_words[i];
    const struct scallop_formula f = { .name = "f", .setting = t->setting, .quantity = t->quantity, .text = t->text };
    char message[FORMULA_MESSAGE] = "";
    SCOPED(scallop_rational, c);
    SCOPED(left_out, l);
    SCOPED(fmpq, v0);
    if (t->setting == SCALLOP_MOVING_EXTENSION)
      fmpq_one(v0);
    const struct scallop_crawler paper = scallop_crawler_default();
    scallop_rational_of(&c, &paper);
    c.gait = t->sine ? &scallop_gait_sinusoidal : &scallop_gait_quadratic;
    if (t->equal_forces)
      fmpq_set(c.F2, c.F1);
    const char *wrong = symbolic_left_out(&l, &f, &c, SCALLOP_EXTENSION, v0, t->most, message);
    const char *said = wrong ? wrong : l.term ? l.term : "";
    if (strcmp(said, t->left_out) != 0)
      fail_msg("%s: %s", t->text, said);
    assert_true(wrong || (l.order > t->most) == !l.term);
  }
}
