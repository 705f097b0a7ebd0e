/* What is read from text: formulas as series and in balls, numbers into fractions. */
#include "tests/support/cases.h"

#include <stdio.h>

#include "asymptotics/derived/formula_flint.h"
#include "tests/support/random_series.h"

/* x is the variable, three is 3, half is 1/2, none is 0. */
static const char *const names[] = { "x", "three", "half", "none" };
enum { NAMES = 4 };

static int place_of(void *context, const char *name)
{
  (void)context;
  for (int i = 0; i < NAMES; i++)
    if (strcmp(names[i], name) == 0)
      return i;
  return -1;
}

static const char *evaluate_or_say(struct series *value, const char *text)
{
  static char message[FORMULA_MESSAGE];
  struct formula formula;
  const struct formula_names known = { .place = place_of };
  struct series values[NAMES];
  const char *wrong = formula_read(&formula, text, &known, message);
  if (wrong)
    return wrong;
  for (int i = 0; i < NAMES; i++)
    series_init(&values[i]);
  series_set_x(&values[0]);
  series_set_si(&values[1], 3);
  series_set_si(&values[2], 2);
  series_set_si(&values[3], 1);
  assert_true(series_div(&values[2], &values[3], &values[2], &ring));
  series_set_si(&values[3], 0);
  wrong = formula_series(value, &formula, values, NULL, &ring, message);
  for (int i = 0; i < NAMES; i++)
    series_clear(&values[i]);
  return wrong;
}

static bool evaluate(struct series *value, const char *text) { return !evaluate_or_say(value, text); }

/* Each is what stands behind it, and nothing but a number. */
static void check_numbers(const char *cases)
{
  SCOPED(series, value);
  SCOPED(fmpq, wanted, got);
  FOR_CASES (text, cases) {
    assert_int_equal(fmpq_set_str(wanted, wanted_of(text), 10), 0);
    if (!evaluate(&value, text) || !series_rational_coefficient(got, &value, 0) || !fmpq_equal(got, wanted)
        || next_nonzero(&value, 1, LENGTH) < LENGTH || next_nonzero(&value, -LENGTH, 0) < 0)
      fail_msg("%s is something else", text);
  }
}

TEST(powers)
{
  check_numbers(
      "2^10 = 1024|7^1 = 7|7^0 = 1|none^0 = 1|none^3 = 0|(1 + three)^2 = 16|half^3 = 1/8|2 ^ 3 = 8|2^-1 = 1/2|"
      "2^(2) = 4|2^3^2 = 512|2^(4/2) = 4|half^-3 = 8|(x^2 + 3*x)^2/x^2 - x^2 - 6*x = 9");
}

/* 0.1 is a tenth, not the double. */
TEST(decimals_are_exact) { check_numbers("0.1 = 1/10|1.5 = 3/2|25e-2*4 = 1|.5 + 1e3 = 2001/2|0e-999999 = 0"); }

/* 1/(1 - x)^2 and (1 + x)^3/x, by what everybody knows of them */
TEST(series_in_the_variable)
{
  static const slong binomial[] = { 1, 3, 3, 1 };
  SCOPED(series, value);
  SCOPED(fmpq, c);
  assert_true(evaluate(&value, "1/(1 - x)^2"));
  assert_int_equal(value.known, LENGTH);
  for (slong k = 0; k < LENGTH; k++) {
    assert_true(series_rational_coefficient(c, &value, k));
    assert_true(fmpq_equal_si(c, k + 1));
  }
  assert_true(evaluate(&value, "(1 + x)^3/x"));
  for (slong k = 0; k < 4; k++) {
    assert_true(series_rational_coefficient(c, &value, k - 1));
    assert_true(fmpq_equal_si(c, binomial[k]));
  }
}

TEST(refusals_change_nothing)
{
  static const char bad[] =
      "| |unknown|1 + unknown|1 +|1 -|1 *|1 /|* 2|/ 2|+ 1|1 + + 2|1 ** 2|(1|1)|()|((1)|(1))|1 2|1 three|three x|2x|"
      "2(3)|1/0|1/none|1/(x-x)|1/(3-three)|2^|x^x|x^half|(-2)^half|none^-1|none^-65|sqrt(-1)|log(x)|exp(1/x)|"
      "asin(2)|abs(sin(pi))|min(exp(1),exp(1))|max(1,log(x))|thre|threes|1 + 1 ?|1;|#|1,2|-|x^|"
      "half/(half - 1/2)";
  struct random r = { 20260812 };
  SCOPED(work, w);
  random_terms(&w[0], &r, -2, 6);
  series_set(&w[1], &w[0]);
  FOR_CASES (text, bad) {
    if (evaluate(&w[0], text))
      fail_msg("\"%s\" is taken", text);
    assert_true(w[0].kind == SERIES_FRACTIONS && w[0].first == w[1].first && w[0].known == SERIES_ALL);
    check_same(&w[0], &w[1], text);
  }
}

/* Roots and functions that are fractions; a ball stands for no fraction. */
TEST(exact_functions)
{
  check_numbers("sqrt(9/4) = 3/2|8^(1/3) = 2|(8/27)^(-2/three) = 9/4|sqrt(none) = 0|none^half = 0|none^65 = 0|2^1.0 = "
                "2|exp(none) = 1|log(1) = 0|sin(none) = 0|cos(none) = 1|exp(x - x) = 1|sqrt(x^2) - x = "
                "0|sqrt(x^-4)*x^2 = 1|(8*x^3)^(5/3)/x^5 = 32|(x^64)^half/x^32 = 1|(x^100 - x^100)^64 = 0");
  SCOPED(series, value);
  SCOPED(fmpq, c);
  FOR_CASES (text, "2^half|exp(1)|log(2)|sin(1)|2^65|sqrt(2)*x|exp(pi)|sqrt(pi)|sin(pi)|pi^0.5|4^(1/65)")
    assert_true(evaluate(&value, text) && value.kind == SERIES_BALLS && value.known == SERIES_ALL);
  assert_true(evaluate(&value, "sqrt(1 + 2*x + x^2)") && value.kind == SERIES_FRACTIONS && value.known == LENGTH);
  assert_true(series_rational_coefficient(c, &value, 1) && fmpq_is_one(c) && next_nonzero(&value, 2, LENGTH) == LENGTH);
}

/* The series at x = 2^-10 against C's library: what the series leaves off is at most 2^-53 of it, for (1 + x)^70, and
 * each formula multiplies few ulp by less than 4. */
TEST(functions_at_a_small_x)
{
  static const char formulas[] =
      "sqrt(2 + x)|exp(1 - 3*x)|log(2 + x)|sin(1 + x)|cos(half + x)|sin(x)|(2 + x)^2.5|(1 + x)^(1/3)|(three - "
      "x)^-0.7|sqrt(x^2 + x^3)|sqrt(three/x^2 + 1)|(x^3 + x^4)^(2/3)|(x + 1)^70|(-2 - "
      "x)^-67|exp(log(2)*sin(x))|sin(pi*x)/x|exp(2*x + 1)|cos(x)/x|(x - 2)^66|log(1 + x)/x|sqrt(exp(x)*4)";
  const double values[NAMES] = { 0x1p-10, 3, 0.5, 0 };
  const struct formula_names known = { .place = place_of };
  char message[FORMULA_MESSAGE];
  struct formula formula;
  SCOPED(series, value);
  SCOPED(arb, x, got);
  arb_set_d(x, values[0]);
  FOR_CASES (text, formulas) {
    const char *wrong = evaluate_or_say(&value, text);
    if (wrong)
      fail_msg("%s: %s", text, wrong);
    assert_null(formula_read(&formula, text, &known, message));
    series_value(got, &value, x, value.known, PRECISION);
    assert_true(arb_rel_accuracy_bits(got) > PRECISION - 40);
    CHECK_RELATIVE(middle(got), formula_double(&formula, values), 16 * 0x1p-53);
  }
}

TEST(what_a_series_cannot_do)
{
  static const char *const refusals[][2] = {
    { "1 + sqrt(x)", "character 5: sqrt gives a power of T that is not whole" },
    { "x^half", "character 2: ^ gives a power of T that is not whole" },
    { "1 + (x^2)^4097", "character 10: ^ gives a power of T beyond 4096" },
    { "(x^65)^64 + 1", "character 7: ^ gives a power of T beyond 4096" },
    { "sqrt(-2)", "character 1: sqrt of what is negative" },
    { "(x - 2)^half", "character 8: ^ of what is negative" },
    { "sin(pi)^0.2", "character 8: ^ of what may be 0" },
    { "sqrt(1/x - exp(1)/exp(1)/x)", "character 1: sqrt of what may be 0" },
    { "2 + log(x)", "character 5: log of a power of T: a series has no logarithm of T" },
    { "log(x - 1)", "character 1: log of what is negative" },
    { "log(none)", "character 1: log of what may be 0" },
    { "exp(1/x)", "character 1: exp of a negative power of T is not a series" },
    { "sin(x^-2)", "character 1: sin of a negative power of T is not a series" },
    { "cos(-2/x)", "character 1: cos of a negative power of T is not a series" },
    { "exp(1e300)", "character 1: exp is too large" },
    { "2 + asin(x)", "character 5: asin has no series in T" },
    { "abs(x)", "character 1: abs has no series in T" },
    { "log10(1 + x)", "character 1: log10 has no series in T" },
    { "min(x, 1)", "character 1: min has no series in T" },
    { "max(x, 1, three)", "character 1: max has no series in T" },
    { "(1 + x)^x", "character 8: ^ has a series for powers that are fractions only" },
    { "2^pi", "character 2: ^ has a series for powers that are fractions only" },
    { "3^1e300", "character 2: ^ is too large" },
    { "2 + 1/(x - x)", "character 6: / divides by what may be 0" },
    { "three + none^-2", "character 13: ^ divides by what may be 0" },
    { "(((2^64)^64)^63)^5", "character 17: ^ is too large" },
    { "(((x/2^64)^64)^63)^-5", "character 19: ^ is too large" },
  };
  SCOPED(series, value);
  for (size_t i = 0; i < sizeof refusals / sizeof *refusals; i++) {
    const char *wrong = evaluate_or_say(&value, refusals[i][0]);
    assert_non_null(wrong);
    assert_string_equal(wrong, refusals[i][1]);
  }
  SCOPED(fmpq, number);
  assert_true(evaluate(&value, "(((2^64)^64)^63)^4") && series_rational_coefficient(number, &value, 0));
  assert_true(fmpz_bits(fmpq_numref(number)) == 1 + 64 * 64 * 63 * 4 && fmpz_is_one(fmpq_denref(number)));
}

/* pi is a name, of which rational functions are known; its value is enclosed, to any precision. */
TEST(pi_is_exact)
{
  SCOPED(series, value);
  SCOPED(arb, got, pi);
  assert_true(evaluate(&value, "pi*x/3"));
  series_coefficient(got, &value, 1, PRECISION);
  arb_mul_ui(got, got, 3, PRECISION);
  arb_const_pi(pi, 2 * PRECISION);
  assert_true(value.kind == SERIES_NAMED && arb_contains(got, pi) && arb_rel_accuracy_bits(got) > PRECISION - 8);
  FOR_CASES (text, "pi*0|pi*x - x*pi|1/pi - 1/(pi + x) - x/(pi*(pi + x))|(pi + x)^7/(pi + x)^6 - pi - x|(1/(pi - 22/7) "
                   "- 1/(pi + x))*(pi - 22/7) - (22/7 + x)/(pi + x)") {
    assert_true(evaluate(&value, text));
    assert_int_equal(next_nonzero(&value, -2, least(value.known, LENGTH)), least(value.known, LENGTH));
  }
  SCOPED(fmpq, third);
  assert_true(evaluate(&value, "(pi^2 - 1)/(3*pi + 3)/(pi - 1)") && series_rational_coefficient(third, &value, 0));
  assert_true(fmpz_equal_si(fmpq_numref(third), 1) && fmpz_equal_si(fmpq_denref(third), 3));
  assert_true(evaluate(&value, "pi") && !series_rational_coefficient(third, &value, 0));
}

/* In balls: every operation encloses the same one in double, and 0.1 is a tenth. */
TEST(in_balls)
{
  static const char *const formulas[] = { "three/7 - -none", "half^three",    "2^half",    "2^-3",
                                          "abs(-three)",     "sqrt(three)",   "exp(half)", "log(three)",
                                          "log10(three)",    "sin(half)",     "cos(half)", "asin(half)",
                                          "min(3, half)",    "max(1,half,3)", "2*pi*0.25" };
  const struct formula_names known = { .place = place_of };
  const double values[NAMES] = { 0.75, 3, 0.5, 0 };
  char message[FORMULA_MESSAGE];
  struct formula formula;
  arb_ptr balls = _arb_vec_init(NAMES);
  SCOPED(arb, got, tenth);
  for (int i = 0; i < NAMES; i++)
    arb_set_d(balls + i, values[i]);
  for (size_t i = 0; i < sizeof formulas / sizeof *formulas; i++) {
    assert_null(formula_read(&formula, formulas[i], &known, message));
    formula_ball(got, &formula, balls, PRECISION);
    CHECK_RELATIVE(middle(got), formula_double(&formula, values), 4 * 0x1p-53);
    assert_true(arb_rel_accuracy_bits(got) > PRECISION - 10);
  }
  assert_null(formula_read(&formula, "0.1", &known, message));
  formula_ball(got, &formula, balls, PRECISION);
  arb_set_ui(tenth, 1);
  arb_div_ui(tenth, tenth, 10, 2 * PRECISION);
  assert_true(arb_contains(got, tenth) && arb_rel_accuracy_bits(got) > PRECISION - 3);
  static const char *const outside[] = { "1/none", "sqrt(-1)", "log(none)", "asin(3)", "(-1)^half", "none^-1" };
  for (size_t i = 0; i < sizeof outside / sizeof *outside; i++) {
    assert_null(formula_read(&formula, outside[i], &known, message));
    formula_ball(got, &formula, balls, PRECISION);
    assert_false(arb_is_finite(got));
  }
  _arb_vec_clear(balls, NAMES);
}

/* Random formulas, spelled and evaluated side by side */
enum { TEXT = 4096 };

static void random_formula(char text[TEXT], fmpq_t value, struct random *r, int depth)
{
  static const char signs[] = "+-*/";
  int sign = random_below(r, 4);
  if (depth == 0) {
    int number = 1 + random_below(r, 9);
    fmpq_set_si(value, number, 1);
    snprintf(text, TEXT, "%d", number);
    return;
  }
  char left[TEXT], right[TEXT];
  SCOPED(fmpq, other);
  random_formula(left, value, r, depth - 1);
  random_formula(right, other, r, random_below(r, depth));
  if (sign == 3 && fmpq_is_zero(other))
    sign = 2;
  assert_true(strlen(left) + strlen(right) + 8 < TEXT);
  snprintf(text, TEXT, sign < 2 ? "(%s)%c(%s)" : "((%s)%c(%s))", left, signs[sign], right);
  (sign == 0 ? fmpq_add : sign == 1 ? fmpq_sub : sign == 2 ? fmpq_mul : fmpq_div)(value, value, other);
}

TEST(random_formulas)
{
  struct random r = { 20260813 };
  static char text[TEXT];
  SCOPED(series, value);
  SCOPED(fmpq, wanted, got);
  for (int i = 0; i < 300; i++) {
    random_formula(text, wanted, &r, 1 + random_below(&r, 5));
    assert_true(evaluate(&value, text) && series_rational_coefficient(got, &value, 0));
    if (!fmpq_equal(got, wanted))
      fail_msg("%s", text);
  }
}

/* Each is the fraction behind it, which FLINT reads by itself. */
TEST(numbers)
{
  static const char good[] =
      "0.7 = 7/10|.5 = 1/2|5. = 5|+3 = 3|-3 = -3|-.25 = -1/4|0 = 0|-0 = 0|0.0 = 0|007 = 7|1e3 = 1000|1E3 = 1000|"
      "1e+3 = 1000|25e-2 = 1/4|1.5e1 = 15|5.e1 = 50|.5e1 = 5|0x1.8p-3 = 3/16|0x10 = 16|0X1P4 = 16|0x.8 = 1/2|"
      "0xaB = 171|-0x1p0 = -1|0x1e5 = 485|0x1.p+1 = 2|1e-0 = 1|0e99999 = 0|1e-30 = 1/1000000000000000000000000000000|"
      "123456789012345678901234567890.5 = 246913578024691357802469135781/2";
  SCOPED(fmpq, got, wanted);
  FOR_CASES (text, good) {
    assert_int_equal(fmpq_set_str(wanted, wanted_of(text), 10), 0);
    if (!scallop_rational_parse(got, text) || !fmpq_equal(got, wanted))
      fail_msg("%s is not read as that", text);
  }
}

TEST(what_is_no_number)
{
  static const char bad[] =
      "| |1e|1e+|1e-|abc|1e999999|1e-999999|inf|nan|-inf|1 | 1|--1|+-1|-|+|.|-.|1..2|1.2.3|1,5|1_000|0x|0x.|0xg|0x1p|"
      "1p3|1f|1e5.5|1e 5|1e+ 5|e5|1/2|1d5|1-|infinity|0x1.8p-3 |1e1e1|1e100001|1e99999999999999999999";
  SCOPED(fmpq, x, before);
  fmpq_set_si(before, 22, 7);
  fmpq_set(x, before);
  FOR_CASES (text, bad)
    if (scallop_rational_parse(x, text) || !fmpq_equal(x, before))
      fail_msg("\"%s\" is taken", text);
}

/* In hexadecimal, and in decimals with all of its digits, a double is read as the number it is. */
TEST(doubles_in_and_out)
{
  struct random r = { 20260814 };
  static char text[2000];
  SCOPED(fmpq, parsed, exact);
  for (int i = 0; i < 500; i++) {
    double value = random_decades(&r, 1e-300, 1e300) * (random_below(&r, 2) ? 1 : -1);
    scallop_rational_set_double(exact, value);
    snprintf(text, sizeof text, "%a", value);
    assert_true(scallop_rational_parse(parsed, text) && fmpq_equal(parsed, exact));
    snprintf(text, sizeof text, "%.1100e", value);
    assert_true(scallop_rational_parse(parsed, text) && fmpq_equal(parsed, exact));
  }
}
