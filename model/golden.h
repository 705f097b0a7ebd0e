/* The minimum of a function with one valley, by golden section. Header-only; not public. */
#ifndef SCALLOP_MODEL_GOLDEN_H
#define SCALLOP_MODEL_GOLDEN_H

#include <stdbool.h>

typedef double golden_function(void *context, double x);

/* Returns the argument of the minimum of f between a and b, to within width. One value of f per step. */
static inline double golden_least(golden_function *f, void *context, double a, double b, double width)
{
  const double golden = 0.6180339887498949;
  double x[2] = { b - golden * (b - a), a + golden * (b - a) }, y[2] = { f(context, x[0]), f(context, x[1]) };
  while (b - a > width) {
    bool left = y[0] < y[1];
    *(left ? &b : &a) = x[left];
    x[left] = x[!left];
    y[left] = y[!left];
    x[!left] = left ? b - golden * (b - a) : a + golden * (b - a);
    y[!left] = f(context, x[!left]);
  }
  return a + (b - a) / 2;
}

#endif
