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

/* V = x 10^k with 17 or 18 digits before the point, 10^16 <= V < 2 10^17, as whole + 2^-64 fraction: wrong by less than
 * 2^-64. */
struct magnified {
  uint64_t whole, fraction;
  uint64_t above,
      below;     /* half the way to the next double and to the one before, in 2^-FINE, too small by less than 2 */
  int exponent;  /* of ten, in the first digit                                                          */
  uint32_t unit; /* of the 17th digit: 1 or 10                                                          */
};
enum { FINE = 52 }; /* numbers below 2^10 are compared in this unit                                             */

/* significand 2^exponent, 2^52 <= significand < 2^53. False: beyond the table */
static bool magnify(uint64_t significand, int exponent, struct magnified *m)
{
  int first = power_of_ten_in(exponent + DBL_MANT_DIG - 1), k = 16 - first;
  if (k < LEAST_POWER || k > MOST_POWER)
    return false;
  int shift = exponent + power_of_two_in(k) + 1; /* from 2 to 5; with it the whole part of V is 64 bits up       */
  wide g = power(k), v = times(significand << shift, g);
  uint64_t whole = (uint64_t)(v >> 64);
  bool longer = whole >= 100000000000000000U;
  uint64_t above = (uint64_t)(g >> (77 - shift)); /* 2^(shift - 1) g 2^-128 */
  *m = (struct magnified){ .whole = whole,
                           .fraction = (uint64_t)v,
                           .above = above,
                           .below = significand == 1ULL << (DBL_MANT_DIG - 1) ? above / 2 : above,
                           .exponent = first + longer,
                           .unit = longer ? 10 : 1 };
  return true;
}

enum answer { NO, YES, UNDECIDED };

/* V to the nearest multiple of step, which divides 1000. Does *rounded 10^-k read back as x? certainly: that is
 * known. */
static enum answer reads_back(const struct magnified *m, uint32_t step, bool certainly, uint64_t *rounded)
{
  const uint64_t error = 4; /* more than that of any comparison here */
  uint32_t rest = (uint32_t)(m->whole % 1000) % step;
  uint64_t all = (uint64_t)step << FINE, over = (uint64_t)rest << FINE | m->fraction >> (64 - FINE);
  bool up = over > all / 2, tie = over + error > all / 2 && over < all / 2 + error;
  uint64_t distance = up ? all - over : over, reach = up ? m->above : m->below;
  if (!certainly && distance >= reach + error)
    return NO;
  if (tie || (!certainly && distance + error > reach))
    return UNDECIDED;
  *rounded = m->whole - rest + (up ? step : 0);
  return YES;
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
  memcpy(to, exponent < 0 ? "e-" : "e+", 2);
  return append_pair(to + 2, (uint32_t)abs(exponent));
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

static char *append_finite(char *to, uint64_t significand, int exponent)
{
  struct magnified m;
  enum answer answer;
  uint64_t rounded;
  uint32_t step = 100;
  int precision = 15;
  if (!magnify(significand, exponent, &m))
    return NULL;
  for (; (answer = reads_back(&m, step * m.unit, precision == 17, &rounded)) == NO; step /= 10)
    precision++;
  return answer == YES ? append_seventeen(to, m.unit == 1 ? rounded : rounded / 10, m.exponent, precision) : NULL;
}

size_t digits_write_quickly(char *text, double x)
{
  char *end = text;
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  if (bits >> 63)
    *end++ = '-';
  if (x == 0)
    *end++ = '0';
  else /* what has not this form, subnormal numbers, infinities and nan, has an exponent beyond the table */
    end = append_finite(end, (bits & 0xfffffffffffffU) | 1ULL << 52, (int)(bits >> 52 & 0x7ff) - 1075);
  if (!end)
    return 0;
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

/* w 10^k to the nearest, 0 < w < 10^19 */
static bool nearest_double(uint64_t w, long k, double *x)
{
  const uint64_t error = 8, half = 1U << 10;
  int length; /* of w in bits, or one more */
  if (k < LEAST_POWER || k > MOST_POWER)
    return false;
  frexp((double)w, &length);
  wide v = times(w << (64 - length), power((int)k));
  int exponent = power_of_two_in((int)k) + length; /* of the first of the 128 bits of v  */
  for (; !(v >> 127); v <<= 1)                     /* twice at most: wrong by less than 4 */
    exponent--;
  uint64_t high = (uint64_t)(v >> 64), low = (uint64_t)v, over = high & (2 * half - 1);
  if ((over == half && low < error) || (over == half - 1 && low > UINT64_MAX - error))
    return false;
  uint64_t bits = ((uint64_t)(exponent + 1022) << 52) + (high >> 11) + (over >= half); /* with all carries */
  memcpy(x, &bits, sizeof bits);
  return true;
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
