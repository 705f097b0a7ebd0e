/* asymptotics/formula in double: what formulas are worth, which quantities they need, and what is said of those that
 * are none. */
#include "asymptotics/formula.h"
#include "tests/support/cases.h"
#include "tests/support/random_crawler.h"

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
      "(2^3)^2 = 64|2^-2^2 = 0.0625|2*-3 = -6|--3 = 3|2 ^ 3\t* 4  = 32| ( ( 2 ) )  = 2|-(1+2) = -3|2^(1+1) = 4|"
      "1--1--1 = 3");
}

/* By multiplication up to 16, as the toolkit has it */
static double power(double x, double n)
{
  double product = 1;
  if (!(fabs(n) <= 16 && n == trunc(n)))
    return pow(x, n);
  for (int left = (int)fabs(n); left > 0; left /= 2, x *= x)
    if (left % 2)
      product *= x;
  return n < 0 ? 1 / product : product;
}

/* Chains of numbers, some with a minus sign: powers come first, from the right, then the sign in front of them, then
 * products and quotients from the left, then sums and differences from the left. */
TEST(chains_of_operators)
{
  enum { MOST = 7 };
  struct random r = { 20261128 };
  for (int n = 0; n < 20000; n++) {
    char chain[40 * MOST] = "", operators[MOST + 1] = "";
    const int count = 1 + random_below(&r, MOST);
    double x[MOST] = { 0 };
    bool minus[MOST];
    for (int i = 0; i < count; i++) {
      x[i] = (1 + random_below(&r, 24)) / 8.;
      minus[i] = random_below(&r, 3) == 0;
      operators[i] = "+-*/^^"[random_below(&r, 6)];
      snprintf(chain + strlen(chain), 40, "%.*s%s%g", i > 0, &operators[i], minus[i] ? " -" : "", x[i]);
    }
    for (int i = count - 1; i >= 0; i--) {
      x[i] = i + 1 < count && operators[i + 1] == '^' ? power(x[i], x[i + 1]) : x[i];
      x[i] = minus[i] ? -x[i] : x[i];
    }
    double wanted = 0, term = x[0];
    char before = '+'; /* the term */
    for (int i = 1; i <= count; i++) {
      if (i == count || operators[i] == '+' || operators[i] == '-') {
        wanted = before == '+' ? wanted + term : wanted - term;
        before = operators[i];
        term = x[i < count ? i : 0];
      } else if (operators[i] != '^')
        term = operators[i] == '*' ? term * x[i] : term / x[i];
    }
    if (!check_near(value(chain), wanted, 0))
      fail_msg("%s = %.17g, not %.17g", chain, value(chain), wanted);
  }
}

TEST(numbers_are_decimal)
{
  check_values(
      "12.5 = 12.5|.5 = 0.5|5. = 5|1.25e-3 = 1.25e-3|1E+2 = 100|2e1-1e1 = 10|0e-999 = 0|000.0 = 0|4.9e-324 = 0x1p-1074|"
      "0.1 = 0.1|1.7976931348623157e308 = 0x1.fffffffffffffp+1023");
}

TEST(functions_and_names)
{
  check_values(
      "abs(x) = 2.385|abs(-x) = 2.385|pi = 0x1.921fb54442d18p+1|min(F1,F2) = 1.5|max(F1,F2) = 4.25|min(3,1,2) = 1|"
      "max(1, 3, 2, -7) = 3|max(2,1)-min(1,max(0,0.5))*2^2 = 0|sqrt(4)^3 = 8|-abs(-3)^2 = -9|series:dT.15*2 = 15|"
      "min_+1 = 12|exp = 13|exp(0)*exp = 13");
  const struct {
    const char *text;
    double wanted;
  } rounded[] = { { "sqrt(2)", sqrt(2) },          { "exp(1)", exp(1) },
                  { "log(T)", log(0.3) },          { "log10 (1000)", log10(1000) },
                  { "sin(T)", sin(0.3) },          { "cos(T)", cos(0.3) },
                  { "asin(T)", asin(0.3) },        { "sin(pi/2) + 2*pi", 1 + 2 * 0x1.921fb54442d18p+1 },
                  { "F1/F2", 4.25 / 1.5 },         { "log10(abs(x))", log10(2.385) },
                  { "T*x/F2", 0.3 * -2.385 / 1.5 } };
  for (size_t i = 0; i < sizeof rounded / sizeof *rounded; i++)
    CHECK_EQUAL(value(rounded[i].text), rounded[i].wanted);
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

/* Each within the half ulps of its multiplications */
TEST(powers)
{
  char text[20];
  for (double x = -3.7; x < 3.8; x += 0.0137) {
    FOR_CASES (n, "2.5|-0.5|17|-17")
      CHECK_EQUAL(power_of(n, x), pow(x, strtod(n, NULL)));
    for (int n = -16; n <= 16; n++) {
      snprintf(text, sizeof text, "%d", n);
      CHECK_EQUAL(power_of(text, x), power(x, n));
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

/* The formula is refused with this message, and nothing changes. */
static void assert_wrong(const char *text, const char *place, const char *message)
{
  char wanted[FORMULA_MESSAGE];
  struct formula formula, before;
  memset(&formula, 0x5a, sizeof formula);
  before = formula;
  const char *wrong = compile(&formula, text);
  snprintf(wanted, sizeof wanted, "character %s: %s", place, message);
  if (!wrong || strcmp(wrong, wanted) != 0)
    fail_msg("'%s': %s\nwanted: %s", text, wrong ? wrong : "nothing is wrong", wanted);
  assert_memory_equal(&formula, &before, sizeof formula);
}

/* Formulas, the place of what is wrong, and what stands for $ in the message */
TEST(what_is_wrong_is_said)
{
  static const struct {
    const char *message, *formulas;
  } all[] = {
    { "there is no formula", " = 1 | \t  = 4 " },
    { "$ is no quantity known here", "F3 = 1 'F3'|T*(F1+foo) = 7 'foo'|pi2 = 1 'pi2'" },
    { "'serie:dT.15' is no quantity known here: did you mean 'series:dT.15'?", "T+serie:dT.15 = 3 " },
    { "$ is no function: there are abs sqrt exp log log10 sin cos asin min max",
      "pi(2) = 1 'pi'|2*tan(x) = 3 'tan'|F1(2) = 1 'F1'" },
    { "$ is no function: there are abs sqrt exp log log10 sin cos asin min max: did you mean 'cos'?",
      "1+cosine(x) = 3 'cosine'" },
    { "'log' is no quantity but a function: '(' is missing after it", "log = 1 " },
    { "a number, a name or '(' is missing before $",
      "1+ = 3 the end|1**2 = 3 '*'|*2 = 1 '*'|+2 = 1 '+'|2^ = 3 the end|- = 2 the end|() = 2 ')'|abs() = 5 ')'|"
      "min(1,) = 7 ')'" },
    { "this '(' is not closed", "(1+2 = 1 |2*(1+(3) = 3 |abs(1 = 4 " },
    { "this ')' closes nothing", "1+2) = 4 " },
    { "this ',' is not between the arguments of a function", "1,2 = 2 " },
    { "a function is missing before ','", "(1,2) = 3 " },
    { "an operator is missing before $", "2x = 2 'x'|T F1 = 3 'F'|(1)(2) = 4 '('|1.2.3 = 4 '.'|2e = 2 'e'" },
    { "an operator or ')' is missing before '2'", "(1 2) = 4 " },
    { "there is no digit beside the point", ". = 1 |T*.e5 = 3 " },
    { "a number is decimal, as 16 or 1.6e1", "0x10 = 1 " },
    { "the number is too large for a double", "1e999 = 1 " },
    { "the number is too small for a double", "1+0.01e-999 = 3 " },
    { "$ has no meaning: a formula is of numbers, names, + - * / ^ ( ) and commas",
      "1%2 = 2 '%'|[T] = 1 '['|T \n = 3 the byte 0x0a|\xce\xb1 = 1 the byte 0xce|(T] = 3 ']'|_x = 1 '_'" },
    { "abs takes one argument, not 2", "abs(1,2) = 1 " },
    { "max takes two arguments or more, not 1", "1+max(T) = 3 " },
  };
  for (size_t i = 0; i < sizeof all / sizeof *all; i++)
    FOR_CASES (text, all[i].formulas) {
      char place[LONGEST_CASE], message[200];
      snprintf(place, sizeof place, "%s", wanted_of(text));
      char *what = strchr(place, ' ');
      *what++ = '\0';
      const char *mark = all[i].message + strcspn(all[i].message, "$");
      snprintf(message, sizeof message, "%.*s%s%s", (int)(mark - all[i].message), all[i].message, what,
               mark + (*mark == '$'));
      assert_wrong(text, place, message);
    }
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

/* 128 numbers and 127 operations, and one more of either; what is innermost counts, too */
TEST(limits)
{
  static const char too_long[] = "the formula is too long: it may have 256 numbers, names and operations",
                    nested[] = "too much within one another: 64 parentheses, minus signs and powers are allowed",
                    no_name[] =
                        "'nnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnn' is no quantity known here";
  static const struct {
    const char *begin;
    int count;
    const char *part, *end, *place; /* NULL: it is worth what follows */
    const char *message;
    double value;
  } limits[] = { { "1", 127, "+1", "", NULL, NULL, 128 },
                 { "-1", 127, "+1", "", NULL, NULL, 126 },
                 { "--1", 127, "+1", "", "256", too_long, 0 },
                 { "-1", 128, "+T", "", "258", too_long, 0 },
                 { "", 63, "(", "1)))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))", NULL, NULL, 1 },
                 { "", 63, "abs(", "1)))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))", NULL, NULL, 1 },
                 { "", 63, "-", "1", NULL, NULL, -1 },
                 { "", 63, "2^", "0", NULL, NULL, INFINITY },
                 { "", 64, "(", "1", "65", nested, 0 },
                 { "1+", 64, "-", "1", "67", nested, 0 },
                 { "", 64, "2^", "1", "129", nested, 0 },
                 { "1", 100, "+(1)", "", NULL, NULL, 101 },
                 { "", 63, "n", "", "1", no_name, 0 },
                 { "2*", 64, "n", "", "3", "a name of 64 characters: it may have 63", 0 },
                 { "0.", 1190, "0", "1e1191", NULL, NULL, 1 },
                 { "2*0.", 1197, "0", "1", "3", "a number of 1200 characters: it may have 1199", 0 } };
  for (size_t i = 0; i < sizeof limits / sizeof *limits; i++) {
    const char *text = repeated(limits[i].begin, limits[i].count, limits[i].part, limits[i].end);
    if (limits[i].place)
      assert_wrong(text, limits[i].place, limits[i].message);
    else
      CHECK_EQUAL(value(text), limits[i].value);
  }
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
