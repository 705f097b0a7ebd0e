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

/* 10^k = 2^(n - 127) g with n = floor(k log2(10)) and 2^127 <= g < 2^128, g rounded up: too large by less than 1.
 * In Python: n = math.floor(k * math.log2(10)); g = -(-Fraction(10)**k // Fraction(2)**(n - 127)) */
static const struct {
  uint64_t high, low;
} powers[] = {
  { 0xbb127c53b17ec159, 0x5560c018580d5d53 }, { 0xe9d71b689dde71af, 0xaab8f01e6e10b4a7 },
  { 0x9226712162ab070d, 0xcab3961304ca70e9 }, { 0xb6b00d69bb55c8d1, 0x3d607b97c5fd0d23 },
  { 0xe45c10c42a2b3b05, 0x8cb89a7db77c506b }, { 0x8eb98a7a9a5b04e3, 0x77f3608e92adb243 },
  { 0xb267ed1940f1c61c, 0x55f038b237591ed4 }, { 0xdf01e85f912e37a3, 0x6b6c46dec52f6689 },
  { 0x8b61313bbabce2c6, 0x2323ac4b3b3da016 }, { 0xae397d8aa96c1b77, 0xabec975e0a0d081b },
  { 0xd9c7dced53c72255, 0x96e7bd358c904a22 }, { 0x881cea14545c7575, 0x7e50d64177da2e55 },
  { 0xaa242499697392d2, 0xdde50bd1d5d0b9ea }, { 0xd4ad2dbfc3d07787, 0x955e4ec64b44e865 },
  { 0x84ec3c97da624ab4, 0xbd5af13bef0b113f }, { 0xa6274bbdd0fadd61, 0xecb1ad8aeacdd58f },
  { 0xcfb11ead453994ba, 0x67de18eda5814af3 }, { 0x81ceb32c4b43fcf4, 0x80eacf948770ced8 },
  { 0xa2425ff75e14fc31, 0xa1258379a94d028e }, { 0xcad2f7f5359a3b3e, 0x096ee45813a04331 },
  { 0xfd87b5f28300ca0d, 0x8bca9d6e188853fd }, { 0x9e74d1b791e07e48, 0x775ea264cf55347e },
  { 0xc612062576589dda, 0x95364afe032a819e }, { 0xf79687aed3eec551, 0x3a83ddbd83f52205 },
  { 0x9abe14cd44753b52, 0xc4926a9672793543 }, { 0xc16d9a0095928a27, 0x75b7053c0f178294 },
  { 0xf1c90080baf72cb1, 0x5324c68b12dd6339 }, { 0x971da05074da7bee, 0xd3f6fc16ebca5e04 },
  { 0xbce5086492111aea, 0x88f4bb1ca6bcf585 }, { 0xec1e4a7db69561a5, 0x2b31e9e3d06c32e6 },
  { 0x9392ee8e921d5d07, 0x3aff322e62439fd0 }, { 0xb877aa3236a4b449, 0x09befeb9fad487c3 },
  { 0xe69594bec44de15b, 0x4c2ebe687989a9b4 }, { 0x901d7cf73ab0acd9, 0x0f9d37014bf60a11 },
  { 0xb424dc35095cd80f, 0x538484c19ef38c95 }, { 0xe12e13424bb40e13, 0x2865a5f206b06fba },
  { 0x8cbccc096f5088cb, 0xf93f87b7442e45d4 }, { 0xafebff0bcb24aafe, 0xf78f69a51539d749 },
  { 0xdbe6fecebdedd5be, 0xb573440e5a884d1c }, { 0x89705f4136b4a597, 0x31680a88f8953031 },
  { 0xabcc77118461cefc, 0xfdc20d2b36ba7c3e }, { 0xd6bf94d5e57a42bc, 0x3d32907604691b4d },
  { 0x8637bd05af6c69b5, 0xa63f9a49c2c1b110 }, { 0xa7c5ac471b478423, 0x0fcf80dc33721d54 },
  { 0xd1b71758e219652b, 0xd3c36113404ea4a9 }, { 0x83126e978d4fdf3b, 0x645a1cac083126ea },
  { 0xa3d70a3d70a3d70a, 0x3d70a3d70a3d70a4 }, { 0xcccccccccccccccc, 0xcccccccccccccccd },
  { 0x8000000000000000, 0x0000000000000000 }, { 0xa000000000000000, 0x0000000000000000 },
  { 0xc800000000000000, 0x0000000000000000 }, { 0xfa00000000000000, 0x0000000000000000 },
  { 0x9c40000000000000, 0x0000000000000000 }, { 0xc350000000000000, 0x0000000000000000 },
  { 0xf424000000000000, 0x0000000000000000 }, { 0x9896800000000000, 0x0000000000000000 },
  { 0xbebc200000000000, 0x0000000000000000 }, { 0xee6b280000000000, 0x0000000000000000 },
  { 0x9502f90000000000, 0x0000000000000000 }, { 0xba43b74000000000, 0x0000000000000000 },
  { 0xe8d4a51000000000, 0x0000000000000000 }, { 0x9184e72a00000000, 0x0000000000000000 },
  { 0xb5e620f480000000, 0x0000000000000000 }, { 0xe35fa931a0000000, 0x0000000000000000 },
  { 0x8e1bc9bf04000000, 0x0000000000000000 }, { 0xb1a2bc2ec5000000, 0x0000000000000000 },
  { 0xde0b6b3a76400000, 0x0000000000000000 }, { 0x8ac7230489e80000, 0x0000000000000000 },
  { 0xad78ebc5ac620000, 0x0000000000000000 }, { 0xd8d726b7177a8000, 0x0000000000000000 },
  { 0x878678326eac9000, 0x0000000000000000 }, { 0xa968163f0a57b400, 0x0000000000000000 },
  { 0xd3c21bcecceda100, 0x0000000000000000 }, { 0x84595161401484a0, 0x0000000000000000 },
  { 0xa56fa5b99019a5c8, 0x0000000000000000 }, { 0xcecb8f27f4200f3a, 0x0000000000000000 },
  { 0x813f3978f8940984, 0x4000000000000000 }, { 0xa18f07d736b90be5, 0x5000000000000000 },
  { 0xc9f2c9cd04674ede, 0xa400000000000000 }, { 0xfc6f7c4045812296, 0x4d00000000000000 },
  { 0x9dc5ada82b70b59d, 0xf020000000000000 }, { 0xc5371912364ce305, 0x6c28000000000000 },
  { 0xf684df56c3e01bc6, 0xc732000000000000 }, { 0x9a130b963a6c115c, 0x3c7f400000000000 },
  { 0xc097ce7bc90715b3, 0x4b9f100000000000 }, { 0xf0bdc21abb48db20, 0x1e86d40000000000 },
  { 0x96769950b50d88f4, 0x1314448000000000 }, { 0xbc143fa4e250eb31, 0x17d955a000000000 },
  { 0xeb194f8e1ae525fd, 0x5dcfab0800000000 }, { 0x92efd1b8d0cf37be, 0x5aa1cae500000000 },
  { 0xb7abc627050305ad, 0xf14a3d9e40000000 }, { 0xe596b7b0c643c719, 0x6d9ccd05d0000000 },
  { 0x8f7e32ce7bea5c6f, 0xe4820023a2000000 }, { 0xb35dbf821ae4f38b, 0xdda2802c8a800000 },
  { 0xe0352f62a19e306e, 0xd50b2037ad200000 }, { 0x8c213d9da502de45, 0x4526f422cc340000 },
  { 0xaf298d050e4395d6, 0x9670b12b7f410000 },
};

/* floor(k log2(10)) and floor(log10(2^n)), |k| <= 400, |n| <= 1024 */
static int power_of_two_in(int k) { return (int)((k * 1741647L + (2048L << 19)) >> 19) - 2048; }
static int power_of_ten_in(int n) { return (int)((n * 315653L + (1024L << 20)) >> 20) - 1024; }

/* factor 10^k = 2^(power_of_two_in(k) - 127) times this: too large by less than factor 2^-64, and too small, as what is
 * below is cut off, by less than 1. */
static wide times_power(uint64_t factor, int k)
{
  return (wide)powers[k - LEAST_POWER].high * factor + ((wide)powers[k - LEAST_POWER].low * factor >> 64);
}

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
  wide v = times_power(significand << shift, k);
  uint64_t whole = (uint64_t)(v >> 64);
  bool longer = whole >= 100000000000000000U;
  uint64_t above = powers[k - LEAST_POWER].high >> (77 - 64 - shift); /* 2^(shift - 1) g 2^-128               */
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

enum { MOST_DIGITS = 17 };

/* Copies more than count, where there must be room: a constant size takes no call. */
static char *append_digits(char *to, const char *from, int count)
{
  memcpy(to, from, MOST_DIGITS);
  return to + count;
}

static char *append_two(char *to, const char *from)
{
  memcpy(to, from, 2);
  return to + 2;
}

static char *append_zeros(char *to, int count)
{
  memset(to, '0', (size_t)count);
  return to + count;
}

static char *append_pair(char *to, uint32_t n)
{
  static const char pairs[] =
      "00010203040506070809101112131415161718192021222324252627282930313233343536373839404142434445464748"
      "49505152535455565758596061626364656667686970717273747576777879808182838485868788899091929394959697"
      "9899";
  return append_two(to, &pairs[2 * n]);
}

/* With leading zeros, n < 10^8 */
static char *append_eight(char *to, uint32_t n)
{
  uint32_t left = n / 10000, right = n % 10000;
  to = append_pair(append_pair(to, left / 100), left % 100);
  return append_pair(append_pair(to, right / 100), right % 100);
}

static char *append_exponent(char *to, int exponent)
{
  return append_pair(append_two(to, exponent < 0 ? "e-" : "e+"), (uint32_t)abs(exponent));
}

/* Digits, the first of them worth 10^exponent, |exponent| < 100, as "%.*g" lays them out. digits: a place for twice
 * MOST_DIGITS. Returns the end. */
static char *lay_out(char *to, const char *digits, int count, int exponent, int precision)
{
  int whole = exponent + 1;
  if (exponent < -4 || exponent >= precision) {
    *to++ = digits[0];
    if (count > 1)
      *to++ = '.';
    return append_exponent(append_digits(to, digits + 1, count - 1), exponent);
  }
  if (whole <= 0)
    return append_digits(append_zeros(append_two(to, "0."), -whole), digits, count);
  if (count <= whole)
    return append_zeros(append_digits(to, digits, count), whole - count);
  to = append_digits(to, digits, whole);
  *to++ = '.';
  return append_digits(to, digits + whole, count - whole);
}

/* n 10^(exponent - 16), 10^16 <= n <= 10^17 */
static char *append_seventeen(char *to, uint64_t n, int exponent, int precision)
{
  char digits[2 * MOST_DIGITS];
  if (n == 100000000000000000U) {
    n /= 10;
    exponent++;
  }
  uint32_t last = (uint32_t)(n % 100000000), count = last > 0 ? 17 : 9;
  n /= 100000000;
  digits[0] = (char)('0' + n / 100000000);
  append_eight(digits + 1, (uint32_t)(n % 100000000));
  append_eight(digits + 9, last);
  while (digits[count - 1] == '0')
    count--;
  return lay_out(to, digits, (int)count, exponent, precision);
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

size_t digits_write_plainly(char *text, double x)
{
  int length = 0;
  if (isnan(x)) /* of either sign */
    return (size_t)snprintf(text, DIGITS_TEXT, "nan");
  for (int precision = 15; precision <= DBL_DECIMAL_DIG; precision++) {
    length = snprintf(text, DIGITS_TEXT, "%.*g", precision, x);
    if (strtod(text, NULL) == x)
      break;
  }
  return (size_t)length;
}

size_t digits_write(char *text, double x)
{
  size_t length = digits_write_quickly(text, x);
  return length > 0 ? length : digits_write_plainly(text, x);
}

/* w 10^k to the nearest, 0 < w < 10^19 */
static bool nearest_double(uint64_t w, long k, double *x)
{
  const uint64_t error = 8, half = 1U << 10;
  int length; /* of w in bits, or one more */
  if (k < LEAST_POWER || k > MOST_POWER)
    return false;
  frexp((double)w, &length);
  wide v = times_power(w << (64 - length), (int)k);
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
