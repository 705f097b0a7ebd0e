/* asymptotics/formula in double: what formulas are worth, which quantities they need, and what is said of those that
 * are none. */
#include "asymptotics/formula.h"
#include "tests/support/cases.h"

#include <stdio.h>
#include <stdlib.h>

static const char *const names[] = { "F1", "F2", "T", "x", "series:dT.15", "min_", "exp", "a" };
enum { NAMES = sizeof names / sizeof *names };
static const double values[NAMES] = { 4.25, 1.5, 0.3, -2.385, 7.5, 11, 13, 0.1 };

static int place_of(void *context, const char *name)
{
  ++*(int *)context;
  for (int i = 0; i < NAMES; i++)
    if (strcmp(name, names[i]) == 0)
      return i;
  return -1;
}

/* Only one name, and one function, has a near one. */
static const char *near_to(void *context, const char *name, const char *const *functions)
{
  (void)context;
  if (functions)
    return strcmp(name, "cosine") == 0 ? functions[6] : NULL;
  return strcmp(name, "serie:dT.15") == 0 ? "series:dT.15" : NULL;
}

static const char *compile(struct formula *formula, const char *text)
{
  static char message[FORMULA_MESSAGE];
  int asked = 0;
  return formula_read(formula, text,
                      &(struct formula_names){ .place = place_of, .nearest = near_to, .context = &asked }, message);
}

static double value(const char *text)
{
  struct formula formula;
  const char *wrong = compile(&formula, text);
  if (wrong)
    fail_msg("%s: %s", text, wrong);
  return formula_double(&formula, values);
}

static void check_values(const char *cases)
{
  FOR_CASES (text, cases) {
    double wanted = strtod(wanted_of(text), NULL);
    if (!check_near(value(text), wanted, 0))
      fail_msg("%s = %.17g, not %.17g", text, value(text), wanted);
  }
}

TEST(operators_bind_as_in_print)
{
  check_values(
      "1+2*3 = 7|(1+2)*3 = 9|1/2/2 = 0.25|1/(2/2) = 1|7-2-1 = 4|7-(2-1) = 6|-2^2 = -4|(-2)^2 = 4|2^3^2 = 512|"
      "(2^3)^2 = 64|2^-3 = 0.125|2^-2^2 = 0.0625|-2^-2 = -0.25|2*-3 = -6|2--3 = 5|--3 = 3|-3*-2^2 = 12|8/2*4 = 16|"
      "2^3*4 = 32|4*2^3 = 32|1-2^2*3/4+5 = 3|2 ^ 3\t* 4  = 32| ( ( 2 ) )  = 2|-(1+2) = -3|2^(1+1) = 4|10-4/2 = 8|"
      "1--1--1 = 3|6/3-1 = 1|6-3/1 = 3|-1-1 = -2");
}

TEST(numbers_are_decimal)
{
  check_values(
      "12.5 = 12.5|.5 = 0.5|5. = 5|1.25e-3 = 1.25e-3|1E+2 = 100|2e1-1e1 = 10|0e-999 = 0|000.0 = 0|4.9e-324 = 0x1p-1074|"
      "0.1 = 0.1|1.7976931348623157e308 = 0x1.fffffffffffffp+1023");
}

TEST(functions)
{
  check_values(
      "abs(x) = 2.385|abs(-x) = 2.385|pi = 0x1.921fb54442d18p+1|min(F1,F2) = 1.5|max(F1,F2) = 4.25|min(3,1,2) = 1|"
      "max(1, 3, 2, -7) = 3|max(2,1)-min(1,max(0,0.5))*2^2 = 0|sqrt(4)^3 = 8|-abs(-3)^2 = -9");
  CHECK_EQUAL(value("sqrt(2)"), sqrt(2));
  CHECK_EQUAL(value("exp(1)"), exp(1));
  CHECK_EQUAL(value("log(T)"), log(0.3));
  CHECK_EQUAL(value("log10 (1000)"), log10(1000));
  CHECK_EQUAL(value("sin(T)"), sin(0.3));
  CHECK_EQUAL(value("cos(T)"), cos(0.3));
  CHECK_EQUAL(value("asin(T)"), asin(0.3));
  CHECK_EQUAL(value("sin(pi/2) + 2*pi"), 1 + 2 * 0x1.921fb54442d18p+1);
  CHECK_EQUAL(value("log10(abs(x))"), log10(2.385));
}

TEST(names_of_every_kind)
{
  check_values("series:dT.15*2 = 15|min_+1 = 12|exp = 13|exp(0)*exp = 13");
  CHECK_EQUAL(value("F1/F2"), 4.25 / 1.5);
  CHECK_EQUAL(value("T*x/F2"), 0.3 * -2.385 / 1.5);
}

TEST(outside_of_domains)
{
  check_values(
      "sqrt(x) = nan|log(x) = nan|asin(x) = nan|log10(0) = -inf|1/0 = inf|-1/0 = -inf|0/0 = nan|x^0.5 = nan|0^-1 = inf|"
      "exp(1e3) = inf|(0/0)^0 = 1|min(0/0,1) = nan|min(1,0/0) = nan|max(0/0,1) = nan|max(1,0/0) = nan");
}

static uint64_t bits(double x)
{
  uint64_t b;
  memcpy(&b, &x, sizeof b);
  return b;
}

TEST(a_name_alone_gives_its_bits)
{
  static const uint64_t patterns[] = { 0x8000000000000000U, 0x7ff8000000000123U, 0xfff8000000000001U,
                                       0x0000000000000001U, 0x7ff0000000000000U, 0x3fb999999999999aU };
  struct formula formula;
  double given[NAMES];
  assert_null(compile(&formula, " F2 "));
  for (size_t i = 0; i < sizeof patterns / sizeof *patterns; i++) {
    memcpy(&given[1], &patterns[i], sizeof given[1]);
    assert_true(bits(formula_double(&formula, given)) == patterns[i]);
  }
}

static double power_of(const char *exponent, double x)
{
  char text[40];
  struct formula formula;
  double given[NAMES] = { 0 };
  given[3] = x;
  snprintf(text, sizeof text, "x^%s", exponent);
  assert_null(compile(&formula, text));
  return formula_double(&formula, given);
}

/* To 16 by multiplication, each within its half ulps; the next ones are pow's. */
TEST(powers)
{
  char text[20];
  for (double x = -3.7; x < 3.8; x += 0.0137) {
    double x2 = x * x, x4 = x2 * x2;
    CHECK_EQUAL(power_of("0", x), 1);
    CHECK_EQUAL(power_of("1", x), x);
    CHECK_EQUAL(power_of("2", x), x2);
    CHECK_EQUAL(power_of("3", x), x * x2);
    CHECK_EQUAL(power_of("7", x), x * x2 * x4);
    CHECK_EQUAL(power_of("16", x), x4 * x4 * (x4 * x4));
    CHECK_EQUAL(power_of("-1", x), 1 / x);
    CHECK_EQUAL(power_of("-2", x), 1 / x2);
    CHECK_EQUAL(power_of("17", x), pow(x, 17));
    CHECK_EQUAL(power_of("-17", x), pow(x, -17));
    CHECK_EQUAL(power_of("2.5", x), pow(x, 2.5));
    CHECK_EQUAL(power_of("-0.5", x), pow(x, -0.5));
    for (int n = -16; n <= 16; n++) {
      snprintf(text, sizeof text, "%d", n);
      CHECK_RELATIVE(power_of(text, x), pow(x, n), 16 * 0x1p-53);
    }
  }
}

TEST(the_places_it_uses)
{
  struct formula formula;
  int places[FORMULA_STEPS];
  assert_null(compile(&formula, "T + F1*T - min(F1, x, T) + a"));
  assert_int_equal(formula_places(&formula, places), 4);
  assert_true(places[0] == 2 && places[1] == 0 && places[2] == 3 && places[3] == 7);
  assert_null(compile(&formula, "1+2"));
  assert_int_equal(formula_places(&formula, places), 0);
}

static const char meaning[] = " has no meaning: a formula is of numbers, names, + - * / ^ ( ) and commas";
static const struct {
  const char *text, *wrong, *more;
} formulas[] = {
  { "", "character 1: there is no formula", "" },
  { " \t ", "character 4: there is no formula", "" },
  { "F3", "character 1: 'F3' is no quantity known here", "" },
  { "T*(F1+foo)", "character 7: 'foo' is no quantity known here", "" },
  { "T+serie:dT.15", "character 3: 'serie:dT.15' is no quantity known here: did you mean 'series:dT.15'?", "" },
  { "pi2", "character 1: 'pi2' is no quantity known here", "" },
  { "pi(2)", "character 1: 'pi' is no function: there are abs sqrt exp log log10 sin cos asin min max", "" },
  { "log", "character 1: 'log' is no quantity but a function: '(' is missing after it", "" },
  { "2*tan(x)", "character 3: 'tan' is no function: there are abs sqrt exp log log10 sin cos asin min max", "" },
  { "1+cosine(x)",
    "character 3: 'cosine' is no function: there are abs sqrt exp log log10 sin cos asin min max: did you mean 'cos'?",
    "" },
  { "F1(2)", "character 1: 'F1' is no function: there are abs sqrt exp log log10 sin cos asin min max", "" },
  { "1+", "character 3: a number, a name or '(' is missing before the end", "" },
  { "1**2", "character 3: a number, a name or '(' is missing before '*'", "" },
  { "*2", "character 1: a number, a name or '(' is missing before '*'", "" },
  { "+2", "character 1: a number, a name or '(' is missing before '+'", "" },
  { "2^", "character 3: a number, a name or '(' is missing before the end", "" },
  { "-", "character 2: a number, a name or '(' is missing before the end", "" },
  { "()", "character 2: a number, a name or '(' is missing before ')'", "" },
  { "abs()", "character 5: a number, a name or '(' is missing before ')'", "" },
  { "min(1,)", "character 7: a number, a name or '(' is missing before ')'", "" },
  { "(1+2", "character 1: this '(' is not closed", "" },
  { "2*(1+(3)", "character 3: this '(' is not closed", "" },
  { "abs(1", "character 4: this '(' is not closed", "" },
  { "1+2)", "character 4: this ')' closes nothing", "" },
  { "1,2", "character 2: this ',' is not between the arguments of a function", "" },
  { "(1,2)", "character 3: a function is missing before ','", "" },
  { "2x", "character 2: an operator is missing before 'x'", "" },
  { "T F1", "character 3: an operator is missing before 'F'", "" },
  { "(1)(2)", "character 4: an operator is missing before '('", "" },
  { "(1 2)", "character 4: an operator or ')' is missing before '2'", "" },
  { "1.2.3", "character 4: an operator is missing before '.'", "" },
  { "2e", "character 2: an operator is missing before 'e'", "" },
  { ".", "character 1: there is no digit beside the point", "" },
  { "T*.e5", "character 3: there is no digit beside the point", "" },
  { "0x10", "character 1: a number is decimal, as 16 or 1.6e1", "" },
  { "1e999", "character 1: the number is too large for a double", "" },
  { "1+0.01e-999", "character 3: the number is too small for a double", "" },
  { "1%2", "character 2: '%'", meaning },
  { "[T]", "character 1: '['", meaning },
  { "T \n", "character 3: the byte 0x0a", meaning },
  { "\xce\xb1", "character 1: the byte 0xce", meaning },
  { "(T]", "character 3: ']'", meaning },
  { "_x", "character 1: '_'", meaning },
  { "abs(1,2)", "character 1: abs takes one argument, not 2", "" },
  { "1+max(T)", "character 3: max takes two arguments or more, not 1", "" },
};

TEST(what_is_wrong_is_said)
{
  for (size_t i = 0; i < sizeof formulas / sizeof *formulas; i++) {
    struct formula formula, before;
    memset(&formula, 0x5a, sizeof formula);
    before = formula;
    const char *wrong = compile(&formula, formulas[i].text);
    char wanted[200];
    snprintf(wanted, sizeof wanted, "%s%s", formulas[i].wrong, formulas[i].more);
    if (!wrong || strcmp(wrong, wanted) != 0)
      fail_msg("'%s': %s\nwanted: %s", formulas[i].text, wrong ? wrong : "nothing is wrong", wanted);
    assert_memory_equal(&formula, &before, sizeof formula);
  }
}

static void assert_wrong(const char *text, const char *wanted)
{
  struct formula formula;
  const char *wrong = compile(&formula, text);
  assert_non_null(wrong);
  assert_string_equal(wrong, wanted);
}

enum { LONGEST = 5000 };

/* begin, count times part, end */
static char *repeated(const char *begin, int count, const char *part, const char *end)
{
  static char text[LONGEST];
  int used = snprintf(text, LONGEST, "%s", begin);
  for (int i = 0; i < count; i++)
    used += snprintf(text + used, (size_t)(LONGEST - used), "%s", part);
  snprintf(text + used, (size_t)(LONGEST - used), "%s", end);
  return text;
}

TEST(limits)
{
  /* 128 numbers and 127 operations, and one more of either */
  CHECK_EQUAL(value(repeated("1", 127, "+1", "")), 128);
  CHECK_EQUAL(value(repeated("-1", 127, "+1", "")), 126);
  assert_wrong(repeated("--1", 127, "+1", ""),
               "character 256: the formula is too long: it may have 256 numbers, names and operations");
  assert_wrong(repeated("-1", 128, "+T", ""),
               "character 258: the formula is too long: it may have 256 numbers, names and operations");
  /* what is innermost counts, too */
  static const char *const openings[] = { "(", "-", "2^", "abs(" };
  for (int i = 0; i < 4; i++) {
    struct formula formula;
    char closing[FORMULA_NESTED + 1] = "1";
    if (strchr(openings[i], '('))
      memset(closing + 1, ')', FORMULA_NESTED - 1);
    assert_null(compile(&formula, repeated("", FORMULA_NESTED - 1, openings[i], closing)));
  }
  assert_wrong(repeated("", 64, "(", "1"),
               "character 65: too much within one another: 64 parentheses, minus signs and powers are allowed");
  assert_wrong(repeated("1+", 64, "-", "1"),
               "character 67: too much within one another: 64 parentheses, minus signs and powers are allowed");
  assert_wrong(repeated("", 64, "2^", "1"),
               "character 129: too much within one another: 64 parentheses, minus signs and powers are allowed");
  CHECK_EQUAL(value(repeated("1", 100, "+(1)", "")), 101);
  assert_wrong(
      repeated("", 63, "n", ""),
      "character 1: 'nnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnn' is no quantity known here");
  assert_wrong(repeated("2*", 64, "n", ""), "character 3: a name of 64 characters: it may have 63");
  CHECK_EQUAL(value(repeated("0.", 1190, "0", "1e1191")), 1);
  assert_wrong(repeated("2*0.", 1197, "0", "1"), "character 3: a number of 1200 characters: it may have 1199");
}

TEST(names_are_asked_once_each_time)
{
  struct formula formula;
  int asked = 0;
  char message[FORMULA_MESSAGE];
  assert_null(
      formula_read(&formula, "F1+log(F1)*T", &(struct formula_names){ .place = place_of, .context = &asked }, message));
  assert_int_equal(asked, 3);
}
