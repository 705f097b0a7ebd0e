/* Doubles as decimals that read back exactly, and decimals as doubles.
 *
 * Each way has a quick form, in 128-bit integers, that knows when it cannot tell how C's library would round, and then
 * leaves the answer to it: the same text and the same double for every input. Needs IEEE doubles, rounding to nearest
 * and the 128-bit integers of gcc and clang. */
#ifndef SCALLOP_COMPARE_TEXT_DIGITS_H
#define SCALLOP_COMPARE_TEXT_DIGITS_H

#include <stdbool.h>
#include <stddef.h>

enum { DIGITS_TEXT = 48 };

/* x as "%.*g" writes it with as few of 15, 16 and 17 digits as read back exactly; nan without a sign. text is a place
 * for DIGITS_TEXT bytes, all of which may be written. Returns the length. */
size_t digits_write(char *text, double x);

/* x with so many significant digits, or, for digits = 0, as digits_write writes it. Returns the length. */
enum { NUMBER_TEXT = DIGITS_TEXT };
size_t number_text(char text[NUMBER_TEXT], double x, long digits);

/* The quick form alone. 0: left to the library; so are subnormal numbers, nan and the infinities. */
size_t digits_write_quickly(char *text, double x);

/* The double nearest to a number of at most 19 digits in plain decimal notation, -12.5 or 1.25e-3, and nothing else.
 * False: left to strtod, and x is unchanged: another notation or no number, more digits, zero, outside the normal
 * range, or too near a tie. */
bool digits_read(const char *text, double *x);

#endif
