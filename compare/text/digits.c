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

enum { MOST_DIGITS = 17, ZEROS = 4, PIECE = MOST_DIGITS + ZEROS };

/* Copies PIECE bytes, of which count stay: a constant size takes no call. */
static char *append(char *to, const char *from, int count)
{
  memcpy(to, from, PIECE);
  return to + count;
}

static char *append_pair(char *to, uint32_t n)
{
  static const char pairs[] =
      "00010203040506070809101112131415161718192021222324252627282930313233343536373839404142434445464748"
      "49505152535455565758596061626364656667686970717273747576777879808182838485868788899091929394959697"
      "9899";
  memcpy(to, &pairs[2 * n], 2);
  return to + 2;
}

/* With leading zeros, n < 10^8 */
static char *append_eight(char *to, uint32_t n)
{
  uint32_t left = n / 10000, right = n % 10000;
  to = append_pair(append_pair(to, left / 100), left % 100);
  return append_pair(append_pair(to, right / 100), right % 100);
}

/* Digits, the first of them worth 10^exponent, |exponent| < 100, as "%.*g" lays them out. There are ZEROS before them
 * and PIECE behind. Returns the end. */
static char *lay_out(char *to, const char *digits, int count, int exponent, int precision)
{
  const bool has_exponent = exponent < -ZEROS || exponent >= precision;
  const int zeros = has_exponent || exponent >= 0 ? 0 : -exponent,
            whole = has_exponent || exponent < 0 ? 1 : exponent + 1;
  to = append(to, digits - zeros, whole);
  if (count + zeros > whole) {
    *to++ = '.';
    to = append(to, digits - zeros + whole, count + zeros - whole);
  }
  if (!has_exponent)
    return to;
  *to++ = 'e';
  *to++ = exponent < 0 ? '-' : '+';
  return append_pair(to, (uint32_t)abs(exponent));
}

/* n 10^(exponent - 16), 10^16 <= n <= 10^17 */
static char *append_seventeen(char *to, uint64_t n, int exponent, int precision)
{
  char padded[ZEROS + MOST_DIGITS + PIECE], *digits = padded + ZEROS;
  int count = MOST_DIGITS;
  memset(padded, '0', sizeof padded);
  if (n == 100000000000000000U) {
    n /= 10;
    exponent++;
  }
  uint64_t left = n / 100000000, first = left / 100000000;
  digits[0] += (char)first;
  append_eight(digits + 1, (uint32_t)(left - 100000000 * first));
  append_eight(digits + 9, (uint32_t)(n - 100000000 * left));
  while (digits[count - 1] == '0')
    count--;
  return lay_out(to, digits, count, exponent, precision);
}

size_t digits_write_quickly(char *text, double x)
{
  const wide error = 4; /* in V, in units of 2^-64, and some more */
  const double size = fabs(x);
  char *end = text;
  double back = -1;
  uint64_t bits, n = 0;
  memcpy(&bits, &size, sizeof bits);
  if (signbit(x))
    *end++ = '-';
  if (size == 0) {
    memcpy(end, "0", 2);
    return (size_t)(end + 1 - text);
  }
  /* What has not this form, subnormal numbers, infinities and nan, has an exponent beyond the table. */
  const int exponent = (int)(bits >> 52) - 1075, first = power_of_ten_in(exponent + DBL_MANT_DIG - 1), k = 16 - first;
  if (k < LEAST_POWER || k > MOST_POWER)
    return 0;
  /* V = size 10^k, 10^16 <= V < 2 10^17, its whole part and 64 bits behind the point */
  const wide V = times(((bits & 0xfffffffffffffU) | 1ULL << 52) << (exponent + power_of_two_in(k) + 1), power(k));
  const uint64_t whole = (uint64_t)(V >> 64);
  const uint32_t unit = whole >= 100000000000000000U ? 10 : 1; /* of the 17th digit */
  int precision = 15;
  for (uint32_t step = 100 * unit; back != size; precision++, step /= 10) {
    if (step < unit) /* 17 digits read back */
      return 0;
    const uint32_t rest = (uint32_t)(whole % 1000) % step;
    const wide over = (wide)rest << 64 | (uint64_t)V, half = (wide)step << 63;
    if ((over < half ? half - over : over - half) < error)
      return 0;
    n = whole - rest + (over < half ? 0 : step);
    if (!nearest_double(n, -k, &back) && (back == size || nextafter(back, INFINITY) == size))
      return 0;
  }
  end = append_seventeen(end, n / unit, first + (unit > 1), precision - 1);
  *end = '\0';
  return (size_t)(end - text);
}

size_t digits_write(char *text, double x)
{
  size_t length = digits_write_quickly(text, x);
  if (length > 0)
    return length;
  if (isnan(x)) /* of either sign */
    return (size_t)snprintf(text, DIGITS_TEXT, "nan");
  for (int precision = 15; precision <= DBL_DECIMAL_DIG; precision++) {
    length = (size_t)snprintf(text, DIGITS_TEXT, "%.*g", precision, x);
    if (strtod(text, NULL) == x)
      break;
  }
  return length;
}

/* A whole number of at most four digits is added to *exponent. Returns the end, or NULL. */
static const char *read_exponent(const char *text, long *exponent)
{
  bool negative = *text == '-';
  long value = 0;
  text += negative || *text == '+';
  const char *first = text;
  for (; *text >= '0' && *text <= '9' && text < first + 4; text++)
    value = 10 * value + (*text - '0');
  *exponent += negative ? -value : value;
  return text > first ? text : NULL;
}

bool digits_read(const char *text, double *x)
{
  enum { MOST_READ = 19 };
  bool negative = *text == '-', point = false;
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
  if (*text == 'e' || *text == 'E')
    text = read_exponent(text + 1, &k);
  if (!text || *text != '\0' || !nearest_double(w, k, &size))
    return false;
  *x = negative ? -size : size;
  return true;
}

size_t number_text(char text[NUMBER_TEXT], double x, long digits)
{
  if (digits == 0 || isnan(x))
    return digits_write(text, x);
  return (size_t)snprintf(text, NUMBER_TEXT, "%.*g", (int)digits, x);
}
