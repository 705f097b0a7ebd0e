/* Bisection to the last bit: for (double x; halfway(&x, low, high);) *(belongs_to_low(x) ? &low : &high) = x; */
#ifndef SCALLOP_COMPARE_TEXT_HALFWAY_H
#define SCALLOP_COMPARE_TEXT_HALFWAY_H

#include <stdbool.h>

/* Sets *x between low and high. False: they are neighbours. */
static inline bool halfway(double *x, double low, double high)
{
  *x = low + (high - low) / 2;
  return low < *x && *x < high;
}

#endif
