/* Text as an exact fraction, and back: all bytes as text, and eight of them as a double. What strtod takes for a finite
 * number is taken, and strtod's double is the one nearest to the fraction. */
#include "compare/points/point_flint.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/fuzz/target.h"
#include "tests/support/scoped.h"

/* Is |x - double| at most half of the way from there to the next one on that side? */
static bool is_nearest(const fmpq_t x, double value)
{
  SCOPED(fmpq, here, next);
  scallop_rational_set_double(here, value);
  double beyond = nextafter(value, fmpq_cmp(x, here) < 0 ? -INFINITY : INFINITY);
  scallop_rational_set_double(next, isfinite(beyond) ? beyond : value);
  fmpq_sub(next, next, here);
  if (!isfinite(beyond)) /* as wide as the gap on the other side */
    scallop_rational_set_double(next, value - nextafter(value, 0));
  fmpq_sub(here, x, here);
  fmpq_abs(here, here);
  fmpq_abs(next, next);
  fmpq_add(here, here, here);
  return fmpq_cmp(here, next) <= 0;
}

/* A number in C's notation; not the words that strtod takes as well, and no exponent beyond a long or 10^5. */
static bool is_plain_number(const char *text, double *value)
{
  char *end;
  *value = strtod(text, &end);
  const char *mark = strpbrk(text, strpbrk(text, "xX") ? "pP" : "eE");
  long exponent = mark ? strtol(mark + 1, NULL, 10) : 0;
  return end != text && *end == '\0' && !isspace((unsigned char)*text) && text[strcspn(text, "iInN")] == '\0'
         && labs(exponent) <= 100000;
}

static void try_text(const char *text)
{
  double wanted;
  SCOPED(fmpq, x, untouched);
  fmpq_set_si(untouched, 22, 7);
  fmpq_set(x, untouched);
  bool number = is_plain_number(text, &wanted), read = scallop_rational_parse(x, text);
  if (read != number)
    fuzz_fail("'%s' is %s, strtod has %g", text, read ? "read" : "refused", wanted);
  if (!read && !fmpq_equal(x, untouched))
    fuzz_fail("'%s' is refused, and something changed", text);
  if (read && isfinite(wanted) && !is_nearest(x, wanted))
    fuzz_fail("'%s' is a fraction to which %a is not the nearest double", text, wanted);
}

/* The crawler as people mean it: the decimals that its doubles are printed as */
static void mean_decimals(double value)
{
  struct scallop_crawler crawler = { value, value, value, value, value, value, value, NULL };
  SCOPED(scallop_rational, exact);
  rational_crawler(&exact, &crawler);
  if (!is_nearest(exact.m1, value) || !fmpq_equal(exact.m1, exact.alpha))
    fuzz_fail("%a is meant as a decimal to which it is not the nearest", value);
}

/* The digits of a ball are those of the number, to a unit of the last; rounded up, the largest are beyond every
 * double. */
static void write_digits(double value, long digits)
{
  SCOPED(arb, ball);
  arb_set_d(ball, value);
  char *text = decimal_text(ball, digits);
  double back = strtod(text, NULL);
  if (isfinite(back) && !(fabs(back - value) <= fabs(value) * pow(10, 1 - (double)digits) + 0x1p-1074))
    fuzz_fail("%a with %ld digits is '%s'", value, digits, text);
  flint_free(text);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
  double x;
  char *text = fuzz_text(data, size);
  if (size <= 300) /* exponents of 10^5 take time */
    try_text(text);
  free(text);
  if (size < sizeof x)
    return 0;
  memcpy(&x, data, sizeof x);
  if (isfinite(x)) {
    mean_decimals(x);
    write_digits(x, 1 + data[size - 1] % 20);
  }
  return 0;
}
