/* The operations of a formula in doubles. */
#include "asymptotics/formula.h"

#include <math.h>

static const double PI = 0x1.921fb54442d18p+1;

static double negate(double x) { return -x; }

static double (*const of_one[])(double) = {
  [FORMULA_NEGATE] = negate, [FORMULA_ABS] = fabs, [FORMULA_SQRT] = sqrt, [FORMULA_EXP] = exp,   [FORMULA_LOG] = log,
  [FORMULA_LOG10] = log10,   [FORMULA_SIN] = sin,  [FORMULA_COS] = cos,   [FORMULA_ASIN] = asin,
};

static double power(double base, double exponent)
{
  double size = fabs(exponent), product = 1;
  if (!(size <= FORMULA_PRODUCTS) || size != floor(size))
    return pow(base, exponent);
  for (int left = (int)size; left > 0; left /= 2) {
    if (left % 2 == 1)
      product *= base;
    base *= base;
  }
  return exponent < 0 ? 1 / product : product;
}

static double of_two(enum formula_operation operation, double a, double b)
{
  switch (operation) {
  case FORMULA_ADD: return a + b;
  case FORMULA_SUBTRACT: return a - b;
  case FORMULA_MULTIPLY: return a * b;
  case FORMULA_DIVIDE: return a / b;
  case FORMULA_POWER: return power(a, b);
  case FORMULA_MIN: return a < b || isnan(a) ? a : b;
  default: return a > b || isnan(a) ? a : b;
  }
}

double formula_double(const struct formula *formula, const double *values)
{
  double below[FORMULA_DEPTH + 1], *top = below, last = 0; /* the last value, and those below it */
  for (const struct formula_step *s = formula->steps, *end = s + formula->count; s < end; s++) {
    if (s->operation < FORMULA_NEGATE) {
      *top++ = last;
      last = s->operation == FORMULA_NUMBER ? s->number : s->operation == FORMULA_PI ? PI : values[s->place];
    } else if (s->operation < FORMULA_ADD)
      last = of_one[s->operation](last);
    else {
      top--; /* formula_read has put both operands there: NOLINTNEXTLINE(clang-analyzer-core.CallAndMessage) */
      last = of_two(s->operation, *top, last);
    }
  }
  return last;
}
