/* The limit as a series in what makes it small, against the limit that asymptotics/derived finds in balls. */
#include <math.h>
#include <string.h>

#include "asymptotics/derived/formula_flint.h"
#include "asymptotics/symbolic/symbolic.h"
#include "tests/support/exact.h"
#include "tests/support/odd_gaits.h"
#include "tests/support/random_gait.h"

enum { ORDER = 5, PRECISION = 600 };

/* 2 alpha - 1 or F1/F2 - 1, or both, become some 2^-far, with the signs that they had. */
static void make_small(struct scallop_rational_crawler *c, enum limit_parameter in, int far)
{
  SCOPED(fmpq, small, half);
  fmpq_set_si(half, 1, 2);
  fmpq_set_si(small, 1, 1);
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

/* pi^2, wrong by less than 2^-PRECISION */
static void set_pi_squared(fmpq_t pi_squared)
{
  SCOPED(arb, pi);
  arb_const_pi(pi, PRECISION + 8);
  arb_mul(pi, pi, pi, PRECISION + 8);
  arf_get_fmpq(pi_squared, arb_midref(pi));
}

static double worst;

/* What the terms leave out is of the order of the first one that is left out: the error of those below parameter^n is
 * the next one that is not 0, to a factor that differs from 1 by about the parameter. */
static bool check_limit(struct random *r, const struct scallop_gait *gait, enum limit_parameter in)
{
  enum { FAR = 24 };
  SCOPED(scallop_rational, c);
  SCOPED(scallop_expansion, numeric);
  SCOPED(fmpq, term, sum, pi_squared);
  SCOPED(arb, U, error, next);
  struct symbols s;
  SCOPED(symbolic_limit, limit);
  int compared = 0;
  random_exact_crawler(&c, r, gait);
  make_small(&c, in, FAR);
  symbols_init(&s);
  if (symbolic_expand_limit(&s, &c, in, ORDER, &limit, NULL) != SCALLOP_OK)
    return false;
  if (scallop_expand_steady(&c, 1, PRECISION, &numeric, NULL) != SCALLOP_OK) {
    symbols_end(&s);
    return false;
  }
  assert_string_equal(numeric.modes, limit.modes);
  series_coefficient(U, &numeric.v_start, -1, PRECISION);
  assert_int_equal(limit.sign, arf_sgn(arb_midref(U)));
  set_pi_squared(pi_squared);
  fmpq *values = _fmpq_vec_init(s.count);
  symbols_values(values, &s, &c, NULL, pi_squared);
  assert_true(series_coefficient_is_zero(&limit.term, 0));
  for (slong k = 1; k < ORDER; k++) {
    assert_true(symbolic_value(term, symbolic_coefficient(&s, &limit.term, k), &s, values));
    arb_set_fmpq(next, sum, PRECISION);
    arb_sub(error, U, next, PRECISION);
    arb_set_fmpq(next, term, PRECISION);
    fmpq_add(sum, sum, term);
    if (fmpq_is_zero(term))
      continue;
    arb_div(error, error, next, PRECISION);
    arb_sub_si(error, error, 1, PRECISION);
    worst = fmax(worst, at_most(error));
    compared++;
  }
  /* and the rest is as small as the first term that is left out may be */
  arb_set_fmpq(next, sum, PRECISION);
  arb_sub(error, U, next, PRECISION);
  arb_div(error, error, U, PRECISION);
  CHECK_AT_MOST(at_most(error), ldexp(1, -FAR * (ORDER - 1) + 40));
  _fmpq_vec_clear(values, s.count);
  symbols_end(&s);
  return compared > 0;
}

TEST(terms)
{
  struct random r = { 2013 };
  struct random_gait made;
  long done = 0, most = check_cases(30);
  for (long i = 0; i < most; i++) {
    int of = random_below(&r, 4);
    const struct scallop_gait *gait = of == 0   ? &scallop_gait_sinusoidal
                                      : of == 1 ? &scallop_gait_quadratic
                                      : of == 2 ? random_gait(&r, POLYNOMIAL, &made)
                                                : random_gait(&r, SPLINE, &made);
    done += check_limit(&r, gait, (enum limit_parameter)(i % LIMIT_PARAMETERS));
  }
  CHECK_AT_MOST(worst, 1e-4);
  assert_true(done > most / 4);
  print_message("%ld limits, error/term - 1 at most %.2g\n", done, worst);
}

/* The first term in the product is (27), with all the digits, and for the quadratic gait the only one. */
TEST(first_term_is_27)
{
  SCOPED(scallop_rational, c);
  SCOPED(fmpq, got, wanted, pi_squared);
  struct random r = { 27 };
  for (int i = 0; i < 20; i++) {
    bool sine = i % 2;
    struct symbols s;
    SCOPED(symbolic_limit, limit);
    random_exact_crawler(&c, &r, sine ? &scallop_gait_sinusoidal : &scallop_gait_quadratic);
    fmpq_set_si(pi_squared, 8 + i, 3);
    symbols_init(&s);
    assert_int_equal(symbolic_expand_limit(&s, &c, LIMIT_IN_PRODUCT, ORDER, &limit, NULL), SCALLOP_OK);
    fmpq *values = _fmpq_vec_init(MOST_SYMBOLS);
    symbols_values(values, &s, &c, NULL, pi_squared);
    assert_true(symbolic_value(got, symbolic_coefficient(&s, &limit.term, 1), &s, values));
    for (slong k = 2; k < ORDER && !sine; k++)
      assert_true(series_coefficient_is_zero(&limit.term, k));
    symbols_end(&s);
    /* the closed form's first coefficient, of the crawler with U of that sign; L_kin = L or pi^2 L/8 */
    struct symbolic_steady steady;
    symbols_init(&s);
    c.gait = &scallop_gait_quadratic;
    if (symbolic_solve_steady(&s, &c, &steady, NULL) == SCALLOP_OK && strcmp(steady.modes, limit.modes) == 0) {
      SCOPED(series, series);
      symbolic_in_T(&series, &s, steady.v_start, 1);
      symbols_values(values, &s, &c, NULL, NULL);
      assert_true(symbolic_value(wanted, symbolic_coefficient(&s, &series, -1), &s, values));
      if (sine) {
        fmpq_mul(wanted, wanted, pi_squared);
        fmpq_div_2exp(wanted, wanted, 3);
      }
      assert_true(fmpq_equal(got, wanted));
      symbols_end(&s);
    }
    _fmpq_vec_clear(values, MOST_SYMBOLS);
  }
}

static int place_of(void *context, const char *name)
{
  const char *const *names = context;
  for (int i = 0; names[i]; i++)
    if (strcmp(names[i], name) == 0)
      return i;
  return -1;
}

static double side(const char *text, const double *values)
{
  static const char *const names[] = { "m1", "m2", "F1", "F2", "L", "alpha", "M", "U", NULL };
  const struct formula_names known = { .place = place_of, .context = (void *)names };
  struct formula formula;
  char message[FORMULA_MESSAGE];
  assert_null(formula_read(&formula, text, &known, message));
  return formula_double(&formula, values);
}

/* U put into the equation. Both sides are sums of a few terms with the sign of U, each right to some ulp; asin near 1
 * loses half of the digits, and those that near it are passed over. */
TEST(equation_of_the_sinusoidal_gait_holds)
{
  SCOPED(scallop_rational, c);
  SCOPED(scallop_expansion, numeric);
  SCOPED(arb, U);
  struct random r = { 26 };
  int checked = 0;
  for (long i = 0, most = check_cases(200); i < most; i++) {
    random_exact_crawler(&c, &r, &scallop_gait_sinusoidal);
    if (scallop_expand_steady(&c, 1, 128, &numeric, NULL) != SCALLOP_OK || !strstr(numeric.modes, "-+ ")
        || !strstr(numeric.modes, "+- "))
      continue;
    series_coefficient(U, &numeric.v_start, -1, 64);
    double m1 = fraction_d(c.m1), m2 = fraction_d(c.m2);
    const double values[] = {
      m1, m2, fraction_d(c.F1), fraction_d(c.F2), fraction_d(c.L), fraction_d(c.alpha), m1 + m2, middle(U)
    };
    char text[400];
    const char *equation = symbolic_limit_equation(&c);
    snprintf(text, sizeof text, "%s", equation);
    char *right = strstr(text, " = ");
    *right = '\0';
    double left = side(text, values), wanted = side(right + 3, values);
    CHECK_RELATIVE(left, wanted, 1e-7);
    checked++;
  }
  assert_true(checked > 20);
}

static void refuses(const struct scallop_rational_crawler *c, slong order, const char *wanted)
{
  struct symbols s;
  SCOPED(symbolic_limit, limit);
  const char *why = "";
  symbols_init(&s);
  assert_int_equal(symbolic_expand_limit(&s, c, LIMIT_IN_ALPHA, order, &limit, &why), SCALLOP_EDOMAIN);
  assert_non_null(strstr(why, wanted));
  assert_int_equal(symbolic_expand_limit(&s, c, LIMIT_IN_ALPHA, order, &limit, NULL), SCALLOP_EDOMAIN);
  assert_int_equal(s.count, 0);
}

TEST(what_has_no_expansion_is_refused)
{
  SCOPED(scallop_rational, c);
  struct random r = { 4 };
  random_exact_crawler(&c, &r, &scallop_gait_sinusoidal);
  refuses(&c, 0, "1 to 10");
  refuses(&c, SYMBOLIC_LIMIT_ORDERS + 1, "1 to 10");
  c.gait = &minimum_jerk_gait;
  refuses(&c, ORDER, "l'' = 0");
  c.gait = &sawtooth_gait;
  refuses(&c, ORDER, "jumps");
  c.gait = &there_and_back_gait;
  refuses(&c, ORDER, "changes its sign");
  c.gait = &scallop_gait_quadratic;
  fmpq_set(c.F2, c.F1);
  refuses(&c, ORDER, "F1 = F2");
  assert_null(symbolic_limit_equation(&c));
  fmpq_zero(c.m1);
  refuses(&c, ORDER, "domain");
}

TEST(too_many_terms_give_the_work_up)
{
  SCOPED(scallop_rational, c);
  struct random r = { 6 };
  struct symbols s;
  SCOPED(symbolic_limit, limit);
  const char *why = "";
  random_exact_crawler(&c, &r, &scallop_gait_sinusoidal);
  symbols_init(&s);
  s.most_terms = 4000;
  assert_int_equal(symbolic_expand_limit(&s, &c, LIMIT_IN_ALPHA, ORDER, &limit, &why), SCALLOP_EDOMAIN);
  assert_string_equal(
      why, "the limit takes more than 4000 terms with --order 5: ask for a lower one, or for numbers without "
           "--symbolic");
  assert_true(s.names.terms < 8000);
  symbols_end(&s);
  symbols_init(&s);
  s.most_terms = 4000;
  assert_int_equal(symbolic_expand_limit(&s, &c, LIMIT_IN_ALPHA, 2, &limit, &why), SCALLOP_OK);
  symbols_end(&s);
  symbols_init(&s);
  s.most_terms = 1;
  assert_int_equal(symbolic_expand_limit(&s, &c, LIMIT_IN_ALPHA, 4, &limit, &why), SCALLOP_EDOMAIN);
  symbols_end(&s);
}

TEST(equations_in_words)
{
  SCOPED(scallop_rational, c);
  struct random r = { 5 };
  random_exact_crawler(&c, &r, &scallop_gait_quadratic);
  fmpq_set_si(c.alpha, 3, 4);
  fmpq_add_si(c.F1, c.F2, 1);
  assert_non_null(strstr(symbolic_limit_equation(&c), "m2 |l'| < M U/T"));
  fmpq_set_si(c.alpha, 1, 4);
  assert_non_null(strstr(symbolic_limit_equation(&c), "m1 |l'| < -M U/T"));
}
