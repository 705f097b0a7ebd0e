/* Doubles: halfway to another, as decimals that read back exactly, and decimals as doubles.
 *
 * Each way has a quick form, in 128-bit integers, that knows when it cannot tell how C's library would round, and then
 * leaves the answer to it: the same text and the same double for every input. Needs IEEE doubles, rounding to nearest
 * and the 128-bit integers of gcc and clang. */
#ifndef SCALLOP_COMPARE_TEXT_DIGITS_H
#define SCALLOP_COMPARE_TEXT_DIGITS_H

#include <stdbool.h>

/* Bisection to the last bit: for (double x; halfway(&x, low, high);) *(belongs_to_low(x) ? &low : &high) = x;
 * False: low and high are neighbours. */
static inline bool halfway(double *x, double low, double high)
{
  *x = low + (high - low) / 2;
  return low < *x && *x < high;
}

/* x with so many significant digits; for digits = 0 as "%.*g" writes it with as few of 15, 16 and 17 digits as read
 * back exactly; nan without a sign. */
enum { NUMBER_TEXT = 48, DIGITS_TEXT = NUMBER_TEXT };
void number_text(char text[NUMBER_TEXT], double x, long digits);

/* The significant digits of x, from 1 to 6, of which the last but one is that of the first digit of what is unknown */
int digits_known(double x, double unknown);

/* The quick form alone, for digits <= 17. False: left to the library; so are subnormal numbers, nan and the
 * infinities. */
bool digits_write_quickly(char text[NUMBER_TEXT], double x, long digits);

/* The double nearest to a number of at most 19 digits in plain decimal notation, -12.5 or 1.25e-3, and nothing else.
 * False: left to strtod, and x is unchanged: another notation or no number, more digits, zero, outside the normal
 * range, or too near a tie. */
bool digits_read(const char *text, double *x);

#endif
