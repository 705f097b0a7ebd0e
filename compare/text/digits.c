#include "compare/text/digits.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

_Static_assert(FLT_RADIX == 2 && DBL_MANT_DIG == 53 && DBL_MAX_EXP == 1024 && sizeof(double) == 8, "IEEE doubles");

__extension__ typedef unsigned __int128 wide;

enum { MIN_POWER = -48, MAX_POWER = 48 };

/* 10^k = 2^two g with 2^127 <= g < 2^128. g is exact for k >= 0, because 5^k has at most 112 bits; else it is too small
 * by less than 2^10, because each step truncates less than 16. */
struct power {
  wide g;
  int two;
};
static struct power powers[MAX_POWER - MIN_POWER + 1];

static struct power normal(wide g, int two)
{
  for (; !(g >> 127); two--)
    g <<= 1;
  return (struct power){ g, two };
}

static void make_powers(void)
{
  struct power up = { (wide)1 << 127, -127 }, down = up;
  for (int k = 0; k <= MAX_POWER; k++) {
    powers[k - MIN_POWER] = up;
    powers[-k - MIN_POWER] = down;
    up = normal(up.g / 8 * 5, up.two + 4);
    down = normal(down.g / 5, down.two - 1);
  }
}

/* Returns 10^k, or NULL beyond the table. */
static const struct power *power(long k)
{
  if (powers[0].g == 0)
    make_powers();
  return k < MIN_POWER || k > MAX_POWER ? NULL : &powers[k - MIN_POWER];
}

/* Returns factor g / 2^64, too small by less than the error of g plus 1. */
static wide times(uint64_t factor, wide g) { return (g >> 64) * factor + ((wide)(uint64_t)g * factor >> 64); }

static const wide error = 1 << 11; /* bound of the error of a product, in its last place, also of twice the product */

/* Rounds w 10^k to the nearest double, 0 < w < 10^19. Returns false beyond the table, or too near a tie. */
static bool nearest_double(uint64_t w, long k, double *x)
{
  const int below = 128 - DBL_MANT_DIG, length = 64 - __builtin_clzll(w);
  const wide half = (wide)1 << (below - 1);
  const struct power *p = power(k);
  if (!p)
    return false;
  const struct power v = normal(times(w << (64 - length), p->g), p->two + length);
  const wide rest = v.g & (2 * half - 1);
  const int exponent = v.two + 127 + 1022; /* biased, minus 1: the leading bit of v.g adds 1; a carry stays correct */
  const uint64_t bits = ((uint64_t)exponent << 52) + (uint64_t)(v.g >> below) + (rest >= half);
  memcpy(x, &bits, sizeof bits);
  return rest + error < half || rest > half + error;
}

enum { MAX_DIGITS = 17 };

/* Writes digits, the first of which is worth 10^exponent, in the layout of "%.*g". digits is padded by zeros. */
static void lay_out(char *to, const char *digits, int count, int exponent, int precision)
{
  const bool has_exponent = exponent < -4 || exponent >= precision;
  const int point = has_exponent ? 1 : exponent + 1; /* digits before it, or 0 and less: zeros behind it */
  if (point > 0) {
    memcpy(to, digits, MAX_DIGITS);
    to[point] = '.';
    memcpy(to + point + 1, digits + point, MAX_DIGITS);
    to += count > point ? count + 1 : point;
  } else {
    memcpy(to, "0.000", sizeof "0.000");
    memcpy(to + 2 - point, digits, MAX_DIGITS);
    to += 2 - point + count;
  }
  *to = '\0';
  if (has_exponent)
    snprintf(to, sizeof "e+99", "e%+03d", exponent);
}

/* Writes n 10^(exponent - 16), 10^16 <= n <= 10^17. */
static void write_digits(char *text, uint64_t n, int exponent, int precision)
{
  char digits[2 * MAX_DIGITS];
  int count = MAX_DIGITS;
  if (n == 100000000000000000U) {
    n /= 10;
    exponent++;
  }
  memset(digits, '0', sizeof digits);
  uint32_t left = (uint32_t)(n / 100000000), right = (uint32_t)(n % 100000000); /* 9 digits and 8: faster than 17 */
  for (int i = 8; i >= 0; i--, left /= 10)
    digits[i] = (char)('0' + left % 10);
  for (int i = MAX_DIGITS; right > 0; right /= 10)
    digits[--i] = (char)('0' + right % 10);
  while (digits[count - 1] == '0')
    count--;
  lay_out(text, digits, count, exponent, precision);
}

/* Returns floor(log10(2^n)), |n| <= 1024. */
static int power_of_ten_in(int n) { return (int)((n * 315653L + (1024L << 20)) >> 20) - 1024; }

bool digits_write_quickly(char text[NUMBER_TEXT], double x, long digits)
{
  const uint64_t hidden = 1ULL << (DBL_MANT_DIG - 1);
  const double size = fabs(x);
  uint64_t bits;
  memcpy(&bits, &size, sizeof bits);
  if (signbit(x))
    *text++ = '-';
  if (size == 0)
    return memcpy(text, "0", 2) != NULL;
  /* Subnormal numbers, infinities and nan have other forms and an exponent beyond the table. */
  const int exponent = (int)(bits >> 52) - 1075, first = power_of_ten_in(exponent + DBL_MANT_DIG - 1);
  const struct power *p = power(16 - first);
  if (!p)
    return false;
  /* V = size 10^(16 - first), 10^16 <= V < 2 10^17, its whole part and 64 bits behind the point */
  const int shift = exponent + p->two + 128;
  const uint64_t mantissa = (bits & (hidden - 1)) | hidden;
  const wide V = times(mantissa << shift, p->g), half_ulp = p->g >> (65 - shift);
  const uint64_t whole = (uint64_t)(V >> 64);
  const uint64_t unit = whole >= 100000000000000000U ? 10 : 1;          /* of the 17th digit */
  const wide least_half = mantissa == hidden ? half_ulp / 2 : half_ulp; /* doubles below a power of 2 are nearer */
  int precision = digits > 0 ? (int)digits : 15;
  uint64_t step = unit;
  for (int i = precision; i < MAX_DIGITS; i++)
    step *= 10;
  for (; step >= unit; precision++, step /= 10) {
    const uint64_t rest = step <= 1000 ? (uint32_t)(whole % 1000) % (uint32_t)step : whole % step;
    const wide over = (wide)rest << 64 | (uint64_t)V, half = (wide)step << 63;
    const wide off = over < half ? over : 2 * half - over; /* distance of V from the nearest number of these digits */
    if (half - off < error || (digits == 0 && off + error >= least_half && off < half_ulp + error))
      return false;
    if (digits > 0 || off < least_half) { /* it reads back; with 17 digits always */
      write_digits(text, (whole - rest + (over < half ? 0 : step)) / unit, first + (unit > 1), precision);
      return true;
    }
  }
  return false;
}

void number_text(char text[NUMBER_TEXT], double x, long digits)
{
  int precision = digits > 0 ? (int)digits : 15;
  if (digits <= MAX_DIGITS && digits_write_quickly(text, x, digits))
    return;
  do
    snprintf(text, NUMBER_TEXT, "%.*g", precision, isnan(x) ? NAN : x); /* nan of either sign */
  while (digits == 0 && precision++ < DBL_DECIMAL_DIG && strtod(text, NULL) != x);
}

int digits_known(double x, double unknown)
{
  const double first = x == 0 ? -DBL_MAX_10_EXP : floor(log10(fabs(x))), known = first - floor(log10(unknown)) + 2;
  const double digits = fmax(known, first + 1); /* at least the digits before the point */
  return !(digits > 1) ? 1 : digits < 6 ? (int)digits : 6;
}

bool digits_read(const char *text, double *x)
{
  enum { MAX_READ = 19, MAX_EXPONENT = 4 };
  const bool negative = *text == '-';
  bool point = false;
  uint64_t w = 0;
  long count = 0, k = 0;
  double size;
  for (text += negative; (*text >= '0' && *text <= '9') || (*text == '.' && !point); text++) {
    if (*text == '.')
      point = true;
    else {
      w = 10 * w + (uint64_t)(*text - '0');
      count += w > 0;
      k -= point;
    }
  }
  if (w == 0 || count > MAX_READ)
    return false;
  if (*text == 'e' || *text == 'E') {
    const char *digits = text + 1 + (text[1] == '-' || text[1] == '+');
    const size_t length = strspn(digits, "0123456789");
    k += length > 0 && length <= MAX_EXPONENT ? strtol(text + 1, NULL, 10) : MAX_POWER + count;
    text = digits + length;
  }
  if (*text != '\0' || !nearest_double(w, k, &size))
    return false;
  *x = negative ? -size : size;
  return true;
}
