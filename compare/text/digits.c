#include "compare/text/digits.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

_Static_assert(FLT_RADIX == 2 && DBL_MANT_DIG == 53 && DBL_MAX_EXP == 1024 && sizeof(double) == 8, "IEEE doubles");

__extension__ typedef unsigned __int128 wide;

enum { LEAST_POWER = -48, MOST_POWER = 48 };

/* 10^k = 2^(n - 127) g with n = floor(k log2(10)) and 2^127 <= g < 2^128, g rounded up: too large by less than 1, and
 * exact for k >= 0, where 5^k has at most 112 bits. */
static wide powers[MOST_POWER - LEAST_POWER + 1];

static void make_powers(void)
{
  wide five = 1;
  for (int k = 0; k <= MOST_POWER; k++, five *= 5) {
    wide g = five, rest = (wide)1 << 127, inverse = 0;
    while (!(g >> 127))
      g <<= 1;
    for (int bit = 0; bit < 128; bit++) { /* 2^255 / g, digit by digit */
      bool is_one = rest >> 127 || 2 * rest >= g;
      rest = 2 * rest - (is_one ? g : 0);
      inverse = 2 * inverse + is_one;
    }
    powers[-k - LEAST_POWER] = inverse + 1;
    powers[k - LEAST_POWER] = g;
  }
}

/* floor(k log2(10)) and floor(log10(2^n)), |k| <= 400, |n| <= 1024 */
static int power_of_two_in(int k) { return (int)((k * 1741647L + (2048L << 19)) >> 19) - 2048; }
static int power_of_ten_in(int n) { return (int)((n * 315653L + (1024L << 20)) >> 20) - 1024; }

static wide power(int k)
{
  if (powers[0] == 0)
    make_powers();
  return powers[k - LEAST_POWER];
}

/* factor 10^k = 2^(power_of_two_in(k) - 127) times this, g being power(k): too large by less than factor 2^-64, and too
 * small, as what is below is cut off, by less than 1. */
static wide times(uint64_t factor, wide g) { return (g >> 64) * factor + ((wide)(uint64_t)g * factor >> 64); }

/* w 10^k to the nearest, 0 < w < 10^19. False: beyond the table, or too near a tie of *x and the next double */
static bool nearest_double(uint64_t w, long k, double *x)
{
  const uint64_t error = 8, half = 1U << 10;
  const int length = 64 - __builtin_clzll(w);
  if (k < LEAST_POWER || k > MOST_POWER)
    return false;
  wide v = times(w << (64 - length), power((int)k));
  int exponent = power_of_two_in((int)k) + length; /* of the first of the 128 bits of v  */
  if (!(v >> 127)) {                               /* wrong by less than 2 then          */
    v <<= 1;
    exponent--;
  }
  uint64_t high = (uint64_t)(v >> 64), low = (uint64_t)v, over = high & (2 * half - 1);
  bool tie = (over == half && low < error) || (over == half - 1 && low > UINT64_MAX - error);
  uint64_t bits = ((uint64_t)(exponent + 1022) << 52) + (high >> 11) + (over >= half && !tie); /* with all carries */
  memcpy(x, &bits, sizeof bits);
  return !tie;
}

enum { MOST_DIGITS = 17 };

/* Digits, the first of them worth 10^exponent, |exponent| < 100, as "%.*g" lays them out. Behind the count of them
 * there are zeros. */
static void lay_out(char *to, const char *digits, int count, int exponent, int precision)
{
  const bool has_exponent = exponent < -4 || exponent >= precision;
  const int whole = has_exponent ? 1 : exponent + 1; /* digits before the point, or 0 and less: zeros behind it */
  if (whole > 0) {
    memcpy(to, digits, MOST_DIGITS);
    to += whole;
    digits += whole;
    count -= whole;
    if (count > 0)
      *to++ = '.';
  } else {
    memcpy(to, "0.000", sizeof "0.000");
    to += 2 - whole;
  }
  if (count > 0) {
    memcpy(to, digits, MOST_DIGITS);
    to += count;
  }
  if (has_exponent) {
    *to++ = 'e';
    *to++ = exponent < 0 ? '-' : '+';
    *to++ = (char)('0' + abs(exponent) / 10);
    *to++ = (char)('0' + abs(exponent) % 10);
  }
  *to = '\0';
}

/* n 10^(exponent - 16), 10^16 <= n <= 10^17 */
static void write_digits(char *text, uint64_t n, int exponent, int precision)
{
  char digits[2 * MOST_DIGITS];
  int count = MOST_DIGITS;
  if (n == 100000000000000000U) {
    n /= 10;
    exponent++;
  }
  memset(digits, '0', sizeof digits);
  uint32_t left = (uint32_t)(n / 100000000), right = (uint32_t)(n % 100000000); /* 9 digits and 8: faster than 17 */
  for (int i = 8; i >= 0; i--, left /= 10)
    digits[i] = (char)('0' + left % 10);
  for (int i = MOST_DIGITS; right > 0; right /= 10)
    digits[--i] = (char)('0' + right % 10);
  while (digits[count - 1] == '0')
    count--;
  lay_out(text, digits, count, exponent, precision);
}

bool digits_write_quickly(char text[NUMBER_TEXT], double x)
{
  const wide error = 4; /* in V, in units of 2^-64, and some more */
  const uint64_t hidden = 1ULL << (DBL_MANT_DIG - 1);
  const double size = fabs(x);
  uint64_t bits;
  memcpy(&bits, &size, sizeof bits);
  if (signbit(x))
    *text++ = '-';
  if (size == 0)
    return memcpy(text, "0", 2) != NULL;
  /* What has not this form, subnormal numbers, infinities and nan, has an exponent beyond the table. */
  const int exponent = (int)(bits >> 52) - 1075, first = power_of_ten_in(exponent + DBL_MANT_DIG - 1), k = 16 - first;
  if (k < LEAST_POWER || k > MOST_POWER)
    return false;
  /* V = size 10^k, 10^16 <= V < 2 10^17, its whole part and 64 bits behind the point */
  const int shift = exponent + power_of_two_in(k) + 1;
  const uint64_t mantissa = (bits & (hidden - 1)) | hidden;
  const wide g = power(k), V = times(mantissa << shift, g), half_ulp = g >> (65 - shift);
  const uint64_t whole = (uint64_t)(V >> 64);
  const uint32_t unit = whole >= 100000000000000000U ? 10 : 1;          /* of the 17th digit */
  const wide least_half = mantissa == hidden ? half_ulp / 2 : half_ulp; /* doubles below a power of 2 are nearer */
  int precision = 15;
  for (uint32_t step = 100 * unit; step >= unit; precision++, step /= 10) {
    const uint32_t rest = (uint32_t)(whole % 1000) % step;
    const wide over = (wide)rest << 64 | (uint64_t)V, half = (wide)step << 63;
    const wide off = over < half ? over : 2 * half - over; /* of the number of so many digits that is nearest to V */
    if (half - off < error || (off + error >= least_half && off < half_ulp + error))
      return false;
    if (off < least_half) { /* it reads back, as one of 17 digits always does */
      write_digits(text, (whole - rest + (over < half ? 0 : step)) / unit, first + (unit > 1), precision);
      return true;
    }
  }
  return false;
}

void number_text(char text[NUMBER_TEXT], double x, long digits)
{
  int precision = digits > 0 ? (int)digits : 15;
  if (digits == 0 && digits_write_quickly(text, x))
    return;
  do
    snprintf(text, NUMBER_TEXT, "%.*g", precision, isnan(x) ? NAN : x); /* nan of either sign */
  while (digits == 0 && precision++ < DBL_DECIMAL_DIG && strtod(text, NULL) != x);
}

bool digits_read(const char *text, double *x)
{
  enum { MOST_READ = 19, MOST_OF_EXPONENT = 4 };
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
  if (w == 0 || count > MOST_READ)
    return false;
  if (*text == 'e' || *text == 'E') {
    const char *digits = text + 1 + (text[1] == '-' || text[1] == '+');
    const size_t length = strspn(digits, "0123456789");
    k += length > 0 && length <= MOST_OF_EXPONENT ? strtol(text + 1, NULL, 10) : MOST_POWER + count;
    text = digits + length;
  }
  if (*text != '\0' || !nearest_double(w, k, &size))
    return false;
  *x = negative ? -size : size;
  return true;
}
