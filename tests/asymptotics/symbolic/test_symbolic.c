/* Formulas against the numbers that asymptotics/derived gets by another arithmetic: expansions and closed forms exactly
 * equal, at crawlers that the formulas were not derived from; the limit as a series in what makes it small against the
 * limit in balls. And formulas written down: read back, and beside other languages. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/derived/expansion.h"
#include "asymptotics/derived/formula_flint.h"
#include "asymptotics/symbolic/language.h"
#include "tests/support/exact.h"
#include "tests/support/odd_gaits.h"
#include "tests/support/random_gait.h"
#include "tests/support/solved.h"

enum { ORDER = 8, STEADY_ORDER = 14, LIMIT_ORDER = 5, PRECISION = 128, LIMIT_PRECISION = 600, CRAWLERS = 300 };

/* Formulas in names, and the values that these have at a crawler */
struct named {
  struct symbols symbols;
  fmpq *values;
};
static void named_init(struct named *n)
{
  symbols_init(&n->symbols);
  n->values = _fmpq_vec_init(MOST_SYMBOLS);
}
static void named_clear(struct named *n)
{
  symbols_end(&n->symbols);
  _fmpq_vec_clear(n->values, MOST_SYMBOLS);
}
SCOPED_KIND(named, struct named)

static int compared;

/* All coefficients below x^order */
static void check_series(const struct series *numeric, const struct series *series, slong order, struct named *n,
                         const struct scallop_rational_crawler *c, int which)
{
  SCOPED(fmpq, got, wanted);
  for (slong k = -2; k < order; k++) {
    assert_true(series_rational_coefficient(wanted, numeric, k));
    symbolic coefficient = symbolic_coefficient(&n->symbols, series, k);
    if (!coefficient || !symbolic_value(got, coefficient, &n->symbols, n->values) || !fmpq_equal(got, wanted)) {
      print_exact_crawler(c);
      fail_msg("quantity %d, T^%ld", which, (long)k);
    }
    compared += !fmpq_is_zero(wanted);
  }
}

/* The formula of one crawler at another with the same sign of F1 - F2 and a start velocity with the same sign: in a
 * phase they have the same modes. Equal forces from rest are those of F1 > F2. False where this gait has no series */
static bool check_phase(const struct scallop_gait *gait, bool equal_forces, struct random *r)
{
  SCOPED(scallop_rational, from, at);
  SCOPED(scallop_expansion, numeric, phase);
  SCOPED(fmpq, v0, pi_squared);
  SCOPED(named, n);
  int sign = equal_forces ? 0 : random_below(r, 3) - 1;
  enum scallop_phase_kind kind = random_below(r, 2) ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION;
  random_exact_crawler(&from, r, gait);
  random_positive(v0, r);
  fmpq_mul_si(v0, v0, sign);
  if (equal_forces)
    fmpq_set(from.F2, from.F1);
  if (symbolic_expand_phase(&n.symbols, &from, kind, v0, ORDER, &phase, NULL) != SCALLOP_OK)
    return false;
  do
    random_exact_crawler(&at, r, gait);
  while (fmpq_cmp(at.F1, at.F2) * fmpq_cmp(from.F1, from.F2) < 0);
  if (equal_forces)
    fmpq_set(at.F2, at.F1);
  random_positive(v0, r);
  fmpq_mul_si(v0, v0, sign);
  random_positive(pi_squared, r);
  assert_int_equal(scallop_expand_phase(&at, kind, v0, ORDER, PRECISION, pi_squared, &numeric, NULL), SCALLOP_OK);
  if (!equal_forces) { /* a body may turn at once */
    assert_string_equal(phase.modes, numeric.modes);
    assert_true(phase.switches == numeric.switches);
  }
  symbols_values(n.values, &n.symbols, &at, v0, pi_squared);
  for (int q = 0; q <= SCALLOP_VELOCITY_AT_END; q++)
    if (!series_is_unknown(&numeric.of[q]))
      check_series(&numeric.of[q], &phase.of[q], ORDER, &n, &at, q);
  return true;
}

static const struct scallop_gait *draw_gait(struct random *r, struct random_gait *made)
{
  static const enum random_gait_kind kinds[] = { TRAPEZOIDAL, SKEWED, POLYNOMIAL, POLYNOMIAL, SPLINE };
  int of = random_below(r, 10);
  return of < ALL_GAITS ? every_gait[of] : random_gait(r, kinds[of - ALL_GAITS], made);
}

TEST(phases)
{
  struct random r = { 20261122 };
  struct random_gait made;
  long done = 0, most = check_cases(CRAWLERS);
  compared = 0;
  for (long i = 0; i < most; i++)
    done += check_phase(draw_gait(&r, &made), false, &r);
  assert_true(done > most / 2);
  print_message("%ld formulas of phases, %d coefficients\n", done, compared);
  for (int i = 0; i < 4; i++)
    assert_true(check_phase(&scallop_gait_quadratic, true, &r));
}

/* At a T so small that the modes are those of T -> 0, and yet far from it, a closed form is the certified steady state:
 * it has no remainder. */
static bool check_closed(const symbolic formulas[3], const char *modes, const struct named *n,
                         const struct scallop_rational_crawler *c)
{
  SCOPED(scallop_certified_steady, exact);
  SCOPED(fmpq, value);
  char there[BOTH_MODES_TEXT];
  if (scallop_certified_steady(c, 60, &exact, NULL) != SCALLOP_OK || strcmp(both_modes(exact.modes, there), modes) != 0)
    return false;
  const arb_struct *const balls[] = { exact.v_start, exact.v_mid, exact.displacement };
  for (int q = 0; q < 3; q++) {
    assert_true(symbolic_value(value, formulas[q], &n->symbols, n->values));
    if (!arb_contains_fmpq(balls[q], value) || arb_rel_accuracy_bits(balls[q]) < 190) {
      print_exact_crawler(c);
      fail_msg("closed form %d", q);
    }
  }
  return true;
}

/* The formulas of one crawler, where it has them, at itself and at others that have the same modes */
static void check_steady(const struct scallop_gait *gait, struct random *r, int *done, int *crawlers, int *closed)
{
  enum { AT = 8 };
  SCOPED(scallop_rational, c);
  SCOPED(scallop_expansion, numeric);
  SCOPED(named, n);
  struct symbolic_steady steady;
  SCOPED(series, v_start, v_mid, displacement);
  struct series *const series[] = { &v_start, &v_mid, &displacement };
  random_exact_crawler(&c, r, gait);
  if (symbolic_solve_steady(&n.symbols, &c, &steady, NULL) != SCALLOP_OK)
    return;
  ++*done;
  const symbolic formulas[] = { steady.v_start, steady.v_mid, steady.displacement };
  for (int q = 0; q < 3; q++)
    symbolic_in_T(series[q], &n.symbols, formulas[q], STEADY_ORDER + 1);
  for (int i = 0; i < AT; i++, random_exact_crawler(&c, r, gait)) {
    if (scallop_expand_steady(&c, STEADY_ORDER, PRECISION, &numeric, NULL) != SCALLOP_OK
        || strcmp(numeric.modes, steady.modes) != 0)
      continue;
    const struct series *const wanted[] = { &numeric.v_start, &numeric.v_mid, &numeric.displacement };
    set_small_T(&c, 0.3);
    symbols_values(n.values, &n.symbols, &c, NULL, NULL);
    for (int q = 0; q < 3; q++)
      check_series(wanted[q], series[q], STEADY_ORDER, &n, &c, q);
    *closed += i < 2 && check_closed(formulas, steady.modes, &n, &c);
    ++*crawlers;
  }
}

TEST(steady_states)
{
  struct random r = { 20261123 };
  struct random_gait made;
  int done = 0, crawlers = 0, closed = 0, most = (int)check_cases(CRAWLERS / 7);
  compared = 0;
  for (int i = 0; i < most; i++)
    check_steady(i % 6 ? &scallop_gait_quadratic : draw_gait(&r, &made), &r, &done, &crawlers, &closed);
  assert_true(done > most / 2 && crawlers > most && closed > most / 3);
  print_message("%d closed forms at %d crawlers, %d of them certified, %d coefficients\n", done, crawlers, closed,
                compared);
}

/* 2 alpha - 1 or F1/F2 - 1, or both, become some 2^-far, with the signs that they had. */
static void make_small(struct scallop_rational_crawler *c, enum limit_parameter in, int far)
{
  SCOPED(fmpq, small, half);
  fmpq_set_si(half, 1, 2);
  fmpq_one(small);
  fmpq_div_2exp(small, small, (flint_bitcnt_t)far);
  if (in != LIMIT_IN_FRICTION) {
    fmpq_mul_si(small, small, fmpq_cmp(c->alpha, half));
    fmpq_add(c->alpha, half, small);
    fmpq_abs(small, small);
  }
  if (in != LIMIT_IN_ALPHA) {
    fmpq_mul_si(small, small, fmpq_cmp(c->F1, c->F2) > 0 ? 1 : -1);
    fmpq_add_si(small, small, 1);
    fmpq_mul(c->F1, c->F2, small);
  }
}

static double worst;

/* What the terms leave out is of the order of the first one that is left out: the error of those below parameter^n is
 * the next one that is not 0, to a factor that differs from 1 by about the parameter. */
static bool check_limit(struct random *r, const struct scallop_gait *gait, enum limit_parameter in)
{
  enum { FAR = 24 };
  SCOPED(scallop_rational, c);
  SCOPED(scallop_expansion, numeric);
  SCOPED(fmpq, term, pi_squared);
  SCOPED(arb, U, pi, error, next, excess);
  SCOPED(named, n);
  SCOPED(symbolic_limit, limit);
  int terms = 0;
  random_exact_crawler(&c, r, gait);
  make_small(&c, in, FAR);
  if (symbolic_expand_limit(&n.symbols, &c, in, LIMIT_ORDER, &limit, NULL) != SCALLOP_OK
      || scallop_expand_steady(&c, 1, LIMIT_PRECISION, &numeric, NULL) != SCALLOP_OK)
    return false;
  assert_string_equal(numeric.modes, limit.modes);
  series_coefficient(U, &numeric.v_start, -1, LIMIT_PRECISION);
  assert_int_equal(limit.sign, arf_sgn(arb_midref(U)));
  arb_const_pi(pi, LIMIT_PRECISION + 8);
  arb_sqr(pi, pi, LIMIT_PRECISION + 8);
  arf_get_fmpq(pi_squared, arb_midref(pi)); /* wrong by less than 2^-LIMIT_PRECISION */
  symbols_values(n.values, &n.symbols, &c, NULL, pi_squared);
  assert_true(series_coefficient_is_zero(&limit.term, 0));
  arb_set(error, U);
  for (slong k = 1; k < LIMIT_ORDER; k++) {
    assert_true(symbolic_value(term, symbolic_coefficient(&n.symbols, &limit.term, k), &n.symbols, n.values));
    if (fmpq_is_zero(term))
      continue;
    arb_set_fmpq(next, term, LIMIT_PRECISION);
    arb_div(excess, error, next, LIMIT_PRECISION);
    arb_sub_si(excess, excess, 1, LIMIT_PRECISION);
    worst = fmax(worst, at_most(excess));
    arb_sub(error, error, next, LIMIT_PRECISION);
    terms++;
  }
  /* and the rest is as small as the first term that is left out may be */
  arb_div(error, error, U, LIMIT_PRECISION);
  CHECK_AT_MOST(at_most(error), ldexp(1, -FAR * (LIMIT_ORDER - 1) + 40));
  return terms > 0;
}

TEST(terms_of_limits)
{
  struct random r = { 2013 };
  struct random_gait made;
  long done = 0, most = check_cases(18);
  for (long i = 0; i < most; i++) {
    int of = random_below(&r, 4);
    const struct scallop_gait *gait = of == 0   ? &scallop_gait_sinusoidal
                                      : of == 1 ? &scallop_gait_quadratic
                                                : random_gait(&r, of == 2 ? POLYNOMIAL : SPLINE, &made);
    done += check_limit(&r, gait, (enum limit_parameter)(i % LIMIT_PARAMETERS));
  }
  CHECK_AT_MOST(worst, 1e-4);
  assert_true(done > most / 4);
  print_message("%ld limits, error/term - 1 at most %.2g\n", done, worst);
}

/* The first term in the product is (27), with all the digits, and for the quadratic gait the only one: the closed
 * form's first coefficient, of the crawler with U of that sign; L_kin = L or pi^2 L/8. */
TEST(first_term_is_27)
{
  SCOPED(scallop_rational, c);
  SCOPED(fmpq, got, wanted, pi_squared);
  struct random r = { 27 };
  int same = 0;
  for (int i = 0; i < 20; i++) {
    bool sine = i % 2;
    struct symbolic_steady steady;
    SCOPED(named, n, closed);
    SCOPED(symbolic_limit, limit);
    SCOPED(series, series);
    random_exact_crawler(&c, &r, sine ? &scallop_gait_sinusoidal : &scallop_gait_quadratic);
    fmpq_set_si(pi_squared, 8 + i, 3);
    assert_int_equal(symbolic_expand_limit(&n.symbols, &c, LIMIT_IN_PRODUCT, LIMIT_ORDER, &limit, NULL), SCALLOP_OK);
    symbols_values(n.values, &n.symbols, &c, NULL, pi_squared);
    assert_true(symbolic_value(got, symbolic_coefficient(&n.symbols, &limit.term, 1), &n.symbols, n.values));
    for (slong k = 2; k < LIMIT_ORDER && !sine; k++)
      assert_true(series_coefficient_is_zero(&limit.term, k));
    c.gait = &scallop_gait_quadratic;
    if (symbolic_solve_steady(&closed.symbols, &c, &steady, NULL) != SCALLOP_OK
        || strcmp(steady.modes, limit.modes) != 0)
      continue;
    symbolic_in_T(&series, &closed.symbols, steady.v_start, 1);
    symbols_values(closed.values, &closed.symbols, &c, NULL, NULL);
    symbolic first = symbolic_coefficient(&closed.symbols, &series, -1);
    assert_true(symbolic_value(wanted, first, &closed.symbols, closed.values));
    if (sine) {
      fmpq_mul(wanted, wanted, pi_squared);
      fmpq_div_2exp(wanted, wanted, 3);
    }
    assert_true(fmpq_equal(got, wanted));
    same++;
  }
  assert_true(same > 2);
}

static double side(const char *text, const struct scallop_rational_crawler *c, const char *U)
{
  const struct scallop_part parts[] = { { "U", U }, { NULL, NULL } };
  const struct scallop_formula f = { .setting = SCALLOP_STEADY, .text = text, .parts = parts };
  char message[FORMULA_MESSAGE];
  struct scallop_read_formula *read = scallop_formula_read(&f, message);
  SCOPED(arb, value);
  if (!read)
    fail_msg("%s: %s", text, message);
  assert_int_equal(scallop_formula_ball(value, read, c, SCALLOP_EXTENSION, NULL, NULL, 128), SCALLOP_OK);
  scallop_formula_free(read);
  return middle(value);
}

/* U put into the equation. Both sides are sums of a few terms with the sign of U, each right to some ulp; asin near 1
 * loses half of the digits, and those that near it are passed over. */
TEST(equation_of_the_sinusoidal_gait_holds)
{
  SCOPED(scallop_rational, c);
  SCOPED(scallop_expansion, numeric);
  SCOPED(arb, U);
  struct random r = { 26 };
  long checked = 0, most = check_cases(100);
  for (long i = 0; i < most; i++) {
    random_exact_crawler(&c, &r, &scallop_gait_sinusoidal);
    if (scallop_expand_steady(&c, 1, 128, &numeric, NULL) != SCALLOP_OK || !strstr(numeric.modes, "-+ ")
        || !strstr(numeric.modes, "+- "))
      continue;
    series_coefficient(U, &numeric.v_start, -1, 64);
    char text[400], of_U[40];
    snprintf(of_U, sizeof of_U, "%.17g", middle(U));
    snprintf(text, sizeof text, "%s", symbolic_limit_equation(&c));
    char *right = strstr(text, " = ");
    *right = '\0';
    CHECK_RELATIVE(side(text, &c, of_U), side(right + 3, &c, of_U), 1e-7);
    checked++;
  }
  assert_true(checked > most / 10);
  random_exact_crawler(&c, &r, &scallop_gait_quadratic);
  fmpq_add_si(c.F1, c.F2, 1);
  fmpq_set_si(c.alpha, 3, 4);
  assert_non_null(strstr(symbolic_limit_equation(&c), "m2 |l'| < M U/T"));
  fmpq_set_si(c.alpha, 1, 4);
  assert_non_null(strstr(symbolic_limit_equation(&c), "m1 |l'| < -M U/T"));
  fmpq_set(c.F2, c.F1);
  assert_null(symbolic_limit_equation(&c));
}

enum asked { PHASE, STEADY, LIMIT };

/* With a reason, also if it is not asked for, and without any name */
static void refuses(enum asked asked, const struct scallop_rational_crawler *c, slong order, const char *wanted)
{
  for (int i = 0; i < 2; i++) {
    SCOPED(fmpq, v0);
    SCOPED(named, n);
    SCOPED(scallop_expansion, phase);
    SCOPED(symbolic_limit, limit);
    struct symbolic_steady steady;
    const char *why = "", **to = i ? NULL : &why;
    enum scallop_status status = asked == PHASE
                                     ? symbolic_expand_phase(&n.symbols, c, SCALLOP_EXTENSION, v0, order, &phase, to)
                                 : asked == STEADY
                                     ? symbolic_solve_steady(&n.symbols, c, &steady, to)
                                     : symbolic_expand_limit(&n.symbols, c, LIMIT_IN_ALPHA, order, &limit, to);
    if (status != SCALLOP_EDOMAIN || (to && !strstr(why, wanted)) || n.symbols.count)
      fail_msg("question %d, order %ld: %s, not %s", asked, (long)order, why, wanted);
  }
}

TEST(what_has_no_formula_is_refused)
{
  SCOPED(scallop_rational, c);
  struct random r = { 4 };
  random_exact_crawler(&c, &r, &scallop_gait_sinusoidal);
  refuses(STEADY, &c, ORDER, "not linear");
  refuses(PHASE, &c, 0, "1 to 16");
  refuses(PHASE, &c, SYMBOLIC_ORDERS + 1, "1 to 16");
  refuses(LIMIT, &c, 0, "1 to 10");
  refuses(LIMIT, &c, SYMBOLIC_LIMIT_ORDERS + 1, "1 to 10");
  c.gait = &minimum_jerk_gait;
  refuses(PHASE, &c, ORDER, "l'' = 0");
  refuses(LIMIT, &c, LIMIT_ORDER, "l'' = 0");
  c.gait = &sawtooth_gait;
  refuses(LIMIT, &c, LIMIT_ORDER, "jumps");
  c.gait = &there_and_back_gait;
  refuses(LIMIT, &c, LIMIT_ORDER, "changes its sign");
  c.gait = &scallop_gait_quadratic;
  fmpq_set_si(c.alpha, 1, 2);
  refuses(STEADY, &c, ORDER, "alpha = 1/2");
  fmpq_set(c.F2, c.F1);
  refuses(LIMIT, &c, LIMIT_ORDER, "F1 = F2");
  fmpq_set_si(c.alpha, 2, 1);
  refuses(STEADY, &c, ORDER, "domain");
  refuses(LIMIT, &c, LIMIT_ORDER, "domain");
}

TEST(too_many_terms_give_the_work_up)
{
  static const struct {
    slong most, order;
    bool given_up;
  } cases[] = { { 4000, LIMIT_ORDER, true }, { 4000, 2, false }, { 1, 4, true } };
  SCOPED(scallop_rational, c);
  struct random r = { 6 };
  random_exact_crawler(&c, &r, &scallop_gait_sinusoidal);
  for (int i = 0; i < 3; i++) {
    SCOPED(named, n);
    SCOPED(symbolic_limit, limit);
    const char *why = "";
    n.symbols.most_terms = cases[i].most;
    assert_int_equal(symbolic_expand_limit(&n.symbols, &c, LIMIT_IN_ALPHA, cases[i].order, &limit, &why),
                     cases[i].given_up ? SCALLOP_EDOMAIN : SCALLOP_OK);
    assert_true(n.symbols.names.terms < 8000);
    if (i == 0)
      assert_string_equal(
          why, "the limit takes more than 4000 terms with --order 5: ask for a lower one, or for numbers without "
               "--symbolic");
  }
}

static int place_of(void *context, const char *name)
{
  const struct symbols *s = context;
  for (int i = 0; i < s->count; i++)
    if (strcmp(s->list[i].name, name) == 0)
      return i;
  return -1;
}

/* What the text says at the values, times T^power. False: the text is longer than a formula may be. */
static bool read_back(fmpq_t value, const struct written *written, struct named *n)
{
  const struct ring ring = { 1, 64 };
  const struct formula_names names = { .place = place_of, .context = &n->symbols };
  struct series at[MOST_SYMBOLS];
  struct formula formula;
  char message[FORMULA_MESSAGE];
  SCOPED(series, result);
  if (formula_read(&formula, written->text, &names, message))
    return assert_non_null(strstr(message, "256")), false;
  for (int i = 0; i < n->symbols.count; i++) {
    series_init(&at[i]);
    series_set_rational(&at[i], n->values + i);
  }
  assert_null(formula_series(&result, &formula, at, NULL, &ring, message));
  assert_true(series_rational_coefficient(value, &result, 0));
  if (written->negative)
    fmpq_neg(value, value);
  for (int i = 0; i < n->symbols.count; i++)
    series_clear(&at[i]);
  return true;
}

static int read_texts;

static void check_text(symbolic a, struct named *n)
{
  SCOPED(fmpq, wanted, got);
  struct written written = symbolic_written(&n->symbols, a, 0, &language_text);
  assert_true(symbolic_value(wanted, a, &n->symbols, n->values));
  if (read_back(got, &written, n)) {
    read_texts++;
    if (!fmpq_equal(got, wanted))
      fail_msg("%s", written.text);
  }
  free(written.text);
}

TEST(texts_read_back)
{
  SCOPED(scallop_rational, c);
  SCOPED(fmpq, v0, pi_squared);
  struct random r = { 1303 };
  long most = check_cases(20);
  read_texts = 0;
  for (long i = 0; i < most; i++) {
    struct symbolic_steady steady;
    SCOPED(named, n, closed);
    SCOPED(scallop_expansion, phase);
    SCOPED(series, series);
    random_exact_crawler(&c, &r, i % 2 ? &scallop_gait_quadratic : &scallop_gait_sinusoidal);
    random_fraction(v0, &r);
    random_positive(pi_squared, &r);
    assert_int_equal(symbolic_expand_phase(&n.symbols, &c, SCALLOP_EXTENSION, v0, 7, &phase, NULL), SCALLOP_OK);
    symbols_values(n.values, &n.symbols, &c, v0, pi_squared);
    for (slong k = 0; k < 7; k++) {
      check_text(symbolic_coefficient(&n.symbols, &phase.dT, k), &n);
      check_text(symbolic_coefficient(&n.symbols, &phase.dxC, k), &n);
    }
    if (symbolic_solve_steady(&closed.symbols, &c, &steady, NULL) != SCALLOP_OK)
      continue;
    symbols_values(closed.values, &closed.symbols, &c, NULL, NULL);
    symbolic_in_T(&series, &closed.symbols, steady.displacement, 8);
    check_text(steady.v_start, &closed);
    for (slong k = 0; k < 8; k++)
      check_text(symbolic_coefficient(&closed.symbols, &series, k), &closed);
  }
  assert_true(read_texts > 10 * most);
  print_message("%d texts read\n", read_texts);
}

static const struct language *const languages[] = { &language_text, &language_python, &language_latex };
enum { LANGUAGES = 3 };

static void check_written(struct written written, bool negative, const char *wanted)
{
  assert_string_equal(written.text, wanted);
  assert_true(written.negative == negative);
  free(written.text);
}

static void list(struct symbols *s)
{
  static const enum symbol_meaning names[] = { NAMED_m1, NAMED_F1, NAMED_F2, NAMED_alpha, NAMED_beta, NAMED_T };
  for (size_t i = 0; i < sizeof names / sizeof *names; i++)
    symbols_add(s, names[i], 0, SCALLOP_EXTENSION);
  symbols_add(s, NAMED_AT_START, 3, SCALLOP_EXTENSION);
  symbols_add(s, NAMED_AT_END, 3, SCALLOP_CONTRACTION);
  symbols_add(s, NAMED_pi, 0, SCALLOP_EXTENSION);
  symbols_begin(s);
}

TEST(each_language)
{
  SCOPED(named, n);
  struct symbols *s = &n.symbols;
  list(s);
  symbolic m1 = symbolic_named(s, NAMED_m1), F1 = symbolic_named(s, NAMED_F1), F2 = symbolic_named(s, NAMED_F2);
  symbolic alpha = symbolic_named(s, NAMED_alpha), beta = symbolic_named(s, NAMED_beta), T = symbolic_named(s, NAMED_T);
  symbolic zero = symbolic_number(s, 0, 1), half = symbolic_number(s, -1, 2), sum = symbolic_sub(s, F1, F2);
  /* alpha - beta is 2 alpha - 1, alpha + beta is 1, and beta alone is 1 - alpha */
  symbolic times = symbolic_mul(s, symbolic_sub(s, symbolic_mul(s, alpha, alpha), symbolic_mul(s, beta, beta)), beta);
  /* by powers of T, with factored coefficients; derivatives, the second phase's with a name of its own */
  symbolic of_T = symbolic_sub(s, symbolic_mul(s, m1, symbolic_place(s, 6)),
                               symbolic_mul(s, symbolic_mul(s, T, T), symbolic_mul(s, sum, symbolic_place(s, 7))));
  const struct {
    symbolic a;
    slong power;
    bool negative;
    const char *wanted[LANGUAGES];
  } rows[] = {
    { zero, 0, false, { "0", "0", "0" } },
    { half, 0, true, { "1/2", "1/2", "\\frac{1}{2}" } },
    { symbolic_div(s, sum, m1), 0, false, { "(F1 - F2)/m1", "(F1 - F2)/m1", "\\frac{F_{1} - F_{2}}{m_{1}}" } },
    { symbolic_mul(s, sum, sum),
      -2,
      false,
      { "(F1 - F2)^2/T^2", "(F1 - F2)**2/T**2", "\\frac{(F_{1} - F_{2})^{2}}{T^{2}}" } },
    { times,
      1,
      false,
      { "(1 - alpha)*T*(2*alpha - 1)", "(1 - alpha)*T*(2*alpha - 1)", "(1 - \\alpha) T (2 \\alpha - 1)" } },
    { of_T,
      0,
      false,
      { "(m1*l3_0 - l3_T_c*T^2*(F1 - F2))", "(m1*l3_0 - l3_T_c*T**2*(F1 - F2))",
        "(m_{1} l_{3,0} - l_{3,T,c} T^{2} (F_{1} - F_{2}))" } },
  };
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
    for (int k = 0; k < LANGUAGES; k++)
      check_written(symbolic_written(s, rows[i].a, rows[i].power, languages[k]), rows[i].negative, rows[i].wanted[k]);
  static const char *const decimals[LANGUAGES] = { "1.25e-7*T^2", "1.25e-7*T**2", "1.25 \\cdot 10^{-7} T^{2}" };
  for (int k = 0; k < LANGUAGES; k++) {
    check_written(decimal_written("-1.25", 0, languages[k]), true, "1.25");
    check_written(decimal_written("1.25e-7", 2, languages[k]), false, decimals[k]);
  }
}

/* pi has no value among fractions: 1 stands for it. */
TEST(symbols_that_are_used)
{
  const struct scallop_crawler paper = scallop_crawler_default();
  SCOPED(scallop_rational, c);
  SCOPED(named, n);
  struct symbols *s = &n.symbols;
  list(s);
  scallop_rational_of(&c, &paper);
  symbols_values(n.values, s, &c, NULL, NULL);
  assert_true(fmpq_is_one(n.values + s->count - 1));
  bool used[MOST_SYMBOLS] = { false };
  used[1] = true; /* stays */
  symbolic_uses(symbolic_div(s, symbolic_place(s, 0), symbolic_place(s, 3)), s, used);
  for (int i = 0; i < s->count; i++)
    assert_true(used[i] == (i == 0 || i == 1 || i == 3));
  char *name = symbol_written(&s->list[4], &language_python), *index = symbol_written(&s->list[0], &language_latex);
  assert_string_equal(name, "(1 - alpha)");
  assert_string_equal(index, "m_{1}");
  free(name);
  free(index);
}
