#include "asymptotics/observed/rounding.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "asymptotics/observed/points.h"

enum { MOST_DIGITS = 6 };

/* Digits of the shortest decimal that reads back as x, or more than MOST_DIGITS */
static int digits_of(double x)
{
  char text[40];
  for (int digits = 1; digits <= MOST_DIGITS; digits++) {
    snprintf(text, sizeof text, "%.*e", digits - 1, x);
    if (strtod(text, NULL) == x)
      return digits;
  }
  return MOST_DIGITS + 1;
}

static double last_place(double x, int digits) { return pow(10, floor(log10(fabs(x))) - digits + 1); }

struct rounding rounding_of(const struct scallop_order_point *points, int count, int first)
{
  struct rounding r = { 0, INFINITY };
  for (int i = points_next(points, count, first); i < count; i = points_next(points, count, i + 1)) {
    int digits = digits_of(points[i].err);
    if (digits > MOST_DIGITS)
      return (struct rounding){ digits, 0 };
    r.digits = digits > r.digits ? digits : r.digits;
    r.unit = fmin(r.unit, last_place(points[i].err, digits));
  }
  return r;
}

double rounding_share(const struct rounding *r, double err)
{
  return r->unit == 0 ? 0 : fmax(last_place(err, r->digits), r->unit) / 2 / fabs(err);
}
