/* The quick ways of writing and reading a double against C's library: the same bytes and the same bits, whatever the
 * number, and quick wherever a table has its numbers.
 *
 * test_digits N: N times as many numbers as in `make check`. */
#include "tests/support/cases.h"

#include <float.h>
#include <stdio.h>
#include <stdlib.h>

#include "compare/text/digits.h"
#include "tests/support/random_crawler.h"

static long often = 1;

/* As "%.*g" with 15, 16 and 17 digits, here written out once more */
static void wanted_text(char *text, double x)
{
  int precision = 15;
  do
    snprintf(text, DIGITS_TEXT, "%.*g", precision, x);
  while (strtod(text, NULL) != x && precision++ < 17);
}

/* Does the quick way decide? If so it must be right; the whole way must be right in any case. */
static bool check_writing(double x)
{
  char wanted[DIGITS_TEXT], text[DIGITS_TEXT], whole[DIGITS_TEXT];
  wanted_text(wanted, x);
  bool quickly = digits_write_quickly(text, x, 0);
  number_text(whole, x, 0);
  if ((quickly && strcmp(text, wanted) != 0) || strcmp(whole, wanted) != 0)
    fail_msg("%a is written '%s', quickly '%s', and is '%s'", x, whole, quickly ? text : "", wanted);
  for (int digits = 1; digits <= 17; digits++) {
    snprintf(wanted, sizeof wanted, "%.*g", digits, x);
    number_text(whole, x, digits);
    if ((digits_write_quickly(text, x, digits) && strcmp(text, wanted) != 0) || strcmp(whole, wanted) != 0)
      fail_msg("%a with %d digits is written '%s', quickly '%s', and is '%s'", x, digits, whole, text, wanted);
  }
  return quickly;
}

static bool check_reading(const char *text)
{
  const double untouched = 0x1.23456789abcdep-7;
  double got = untouched, wanted = strtod(text, NULL);
  bool read = digits_read(text, &got);
  if (!read)
    wanted = untouched;
  if (got != wanted || signbit(got) != signbit(wanted))
    fail_msg("'%s' is read as %a, not %a", text, got, wanted);
  return read;
}

static double any_bits(struct random *r)
{
  double x;
  uint64_t bits = random_bits(r);
  memcpy(&x, &bits, sizeof x);
  return isnan(x) ? 0 : x;
}

static double usual(struct random *r) { return (random_below(r, 2) ? -1 : 1) * random_decades(r, 1e-30, 1e30); }

static double result(struct random *r) { return random_between(r, -20, 20); }

static double short_decimal(struct random *r)
{
  char text[DIGITS_TEXT];
  snprintf(text, sizeof text, "%.*g", 1 + random_below(r, 17), random_decades(r, 1e-10, 1e10));
  return strtod(text, NULL);
}

static double whole(struct random *r) { return (double)(int64_t)(random_bits(r) >> random_below(r, 64)); }

/* Few bits: many end in 5 exactly where 15, 16 or 17 digits end */
static double dyadic(struct random *r)
{
  return ldexp((double)(random_bits(r) >> (11 + random_below(r, 53))), -random_below(r, 80));
}

static double around(struct random *r, double x)
{
  for (int steps = random_below(r, 4); steps > 0; steps--)
    x = nextafter(x, random_below(r, 2) ? INFINITY : 0);
  return x;
}

static double near_power_of_two(struct random *r) { return around(r, ldexp(1, random_below(r, 2098) - 1074)); }

static double near_power_of_ten(struct random *r) { return around(r, pow(10, random_below(r, 632) - 323)); }

static const struct kind {
  const char *name;
  double (*number)(struct random *r);
  /* the share that must be: numbers of 17 digits with few behind the point are often ties */
  double quick;
} kinds[] = {
  { "any bits", any_bits, 0.1 },
  { "60 decades", usual, 0.98 },
  { "results", result, 0.99999 },
  { "short decimals", short_decimal, 0.99999 },
  { "whole numbers", whole, 0.97 },
  { "few bits", dyadic, 0.9 },
  { "powers of two", near_power_of_two, 0.1 },
  { "powers of ten", near_power_of_ten, 0.1 },
};
enum { KINDS = sizeof kinds / sizeof *kinds };

static void check_share(const struct kind *kind, const char *what, long quick, long count)
{
  if (!((double)quick >= kind->quick * (double)count))
    fail_msg("%s: only %ld of %ld are %s quickly", kind->name, quick, count, what);
}

TEST(writes_what_the_library_writes)
{
  const long count = 50000 * often;
  for (int k = 0; k < KINDS; k++) {
    struct random r = { 1303 + (uint64_t)k };
    long quick = 0;
    for (long i = 0; i < count; i++)
      quick += check_writing(kinds[k].number(&r));
    check_share(&kinds[k], "written", quick, count);
  }
}

TEST(writes_these)
{
  static const char cases[] =
      "0 = 0|-0 = -0|1 = 1|-1 = -1|0.1 = 0.1|0x1.3333333333334p-2 = 0.30000000000000004|0x1.5555555555555p-2 = "
      "0.3333333333333333|"
      "0x1.5555555555555p-1 = 0.6666666666666666|123456789012345 = 123456789012345|1234567890123456 = 1234567890123456|"
      "100000 = 100000|1e14 = 100000000000000|1e15 = 1e+15|1e16 = 1e+16|1e22 = 1e+22|1e23 = 1e+23|"
      "9007199254740993e1 = 9.007199254740994e+16|0.0001 = 0.0001|0.00012345 = 0.00012345|0.00001 = 1e-05|1.5e-7 = "
      "1.5e-07|"
      "1e100 = 1e+100|-2.5e-100 = -2.5e-100|999999999999999 = 999999999999999|0.9999999999999999 = 0.9999999999999999|"
      "9.9999999999999995e-08 = 1e-07|0x1.fffffffffffffp+1023 = 1.7976931348623157e+308|0x1p-1022 = "
      "2.2250738585072014e-308|"
      "0x1p-1074 = 4.94065645841247e-324|inf = inf|-inf = -inf|nan = nan|-nan = nan";
  FOR_CASES (given, cases) {
    char text[DIGITS_TEXT];
    const char *wanted = wanted_of(given);
    number_text(text, strtod(given, NULL), 0);
    assert_string_equal(text, wanted);
  }
}

/* Around the ties of 16 and 17 digits: whole numbers between 2^53 and 10^18 that end in 5, 50 or 500 */
TEST(leaves_ties_to_the_library)
{
  struct random r = { 77 };
  for (long i = 0; i < 10000 * often; i++) {
    double step = (double[]){ 5, 25, 50, 500 }[random_below(&r, 4)];
    double size = random_decades(&r, 1e13, 1e18);
    check_writing(around(&r, step * floor(size / step)));
    check_writing(around(&r, step * floor(size / step) / 1024));
  }
}

TEST(reads_what_the_library_reads)
{
  const long count = 50000 * often;
  char text[DIGITS_TEXT];
  for (int k = 0; k < KINDS; k++) {
    struct random r = { 4711 + (uint64_t)k };
    long quick = 0;
    for (long i = 0; i < count; i++) {
      double x = kinds[k].number(&r);
      snprintf(text, sizeof text, random_below(&r, 2) ? "%.*g" : "%.*e", 1 + random_below(&r, 18), x);
      quick += check_reading(text) || x == 0;
    }
    check_share(&kinds[k], "read", quick, count);
  }
}

/* Halfway between two doubles, and a unit of the last of 19 digits beside it */
TEST(reads_ties_as_the_library_does)
{
  struct random r = { 99 };
  char text[DIGITS_TEXT];
  for (long i = 0; i < 20000 * often; i++) {
    int shift = 1 + random_below(&r, 10);
    uint64_t halfway = ((1ULL << 53 | random_bits(&r) >> 11) << shift) - (1ULL << (shift - 1));
    snprintf(text, sizeof text, "%llu", (unsigned long long)halfway + (unsigned long long)random_below(&r, 3) - 1);
    check_reading(text);
    snprintf(text, sizeof text, "%llu.5", (unsigned long long)(1ULL << 52 | random_bits(&r) >> 12));
    check_reading(text);
  }
}

/* Quickly, or not at all */
TEST(reads_these_and_leaves_the_rest_to_the_library)
{
  static const char
      quick[] = "1|-1|0.7|.5|5.|007.50|1e3|1E+3|2.5e-3|1234567890123456789|0.0000000000000000001234567890123456789|"
                "9999999999999999999|1e0012|-.25e1",
      left[] = "|-|+1| 1|1 |1\n|1e|1e+|e5|1e5.0|.|-.|1.2.3|--1|1,5|0x1p3|nan|inf|1e99|1e-99|1e400|0|-0.0|1_0|1e00001|"
               "1e123456789|1d5|1-|12345678901234567890|0.12345678901234567890|9007199254740993|1e-400|4e-324";
  static const double rest[] = { NAN, INFINITY, -INFINITY, 0x1p-1074, 0x1p-1023, DBL_MIN, 1e100, 1e-100 };
  FOR_CASES (text, quick)
    assert_true(check_reading(text));
  FOR_CASES (text, left) {
    double x = 42;
    if (digits_read(text, &x) || x != 42)
      fail_msg("'%s' is read as %a", text, x);
  }
  char written[DIGITS_TEXT];
  for (size_t i = 0; i < sizeof rest / sizeof *rest; i++)
    assert_false(digits_write_quickly(written, rest[i], 0));
}

int main(int count, char **arguments)
{
  if (count > 1)
    often = strtol(arguments[1], NULL, 10);
  return check_run(NULL, NULL);
}
