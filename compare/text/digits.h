/* Conversion of doubles to decimals that read back exactly, and of decimals to doubles; bisection of doubles.
 *
 * Each conversion has a fast form in 128-bit integers. If this cannot decide how the C library would round, the library
 * converts: text and double are the library's for every input. Needs IEEE doubles, rounding to nearest and the 128-bit
 * integers of gcc and clang. */
#ifndef SCALLOP_COMPARE_TEXT_DIGITS_H
#define SCALLOP_COMPARE_TEXT_DIGITS_H

#include <stdbool.h>

/* Sets *x between low and high, for bisection to the last bit: for (double x; halfway(&x, low, high);)
 * *(belongs_to_low(x) ? &low : &high) = x; Returns false if low and high are neighbours. */
static inline bool halfway(double *x, double low, double high)
{
  *x = low + (high - low) / 2;
  return low < *x && *x < high;
}

/* Writes x with `digits` significant digits, like "%.*g"; 0: the fewest of 15, 16 and 17 digits that read back exactly;
 * nan without a sign. */
enum { NUMBER_TEXT = 48, DIGITS_TEXT = NUMBER_TEXT };
void number_text(char text[NUMBER_TEXT], double x, long digits);

/* Returns the number of significant digits of x, from 1 to 6: up to one digit behind the first digit of `unknown`. */
int digits_known(double x, double unknown);

/* Writes x by the fast form, for digits <= 17. Returns false if the library has to decide, and for subnormal numbers,
 * nan and infinities. */
bool digits_write_quickly(char text[NUMBER_TEXT], double x, long digits);

/* Reads a number of at most 19 digits in decimal notation, -12.5 or 1.25e-3, to the nearest double. Returns false, x
 * unchanged, if strtod has to decide: another notation, not a number, more digits, zero, outside the normal range, or
 * too near a tie. */
bool digits_read(const char *text, double *x);

#endif
