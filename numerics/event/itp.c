#include "numerics/event/itp.h"

#include <math.h>
#include <stdbool.h>

struct bracket { /* low < high, and f has different signs there */
  double low, high;
  double f_low, f_high;
};

/* From the smaller magnitude of two numbers to the next larger double. */
static double finest(double a, double b)
{
  double least = fmin(fabs(a), fabs(b));
  return nextafter(least, INFINITY) - least;
}

/* n with |b - a| <= 2^n ulp */
static int halvings(double a, double b) { return ilogb(b - a) - ilogb(finest(a, b)) + 1; }

/* Where the chord is 0. The values may be subnormal: their ratio is formed first. */
static double interpolated(const struct bracket *k)
{
  return k->low + (k->high - k->low) * (k->f_low / (k->f_low - k->f_high));
}

/* The next point of a bracket that was `initial` wide in the beginning and must be no wider than reach after this
 * step. */
static double next_point(const struct bracket *k, double initial, double reach)
{
  double width = k->high - k->low, middle = k->low + width / 2;
  double chord = interpolated(k), towards = copysign(1, middle - chord);
  double shift = 0.2 * width * (width / initial), free = reach - width / 2;
  double truncated = shift <= fabs(middle - chord) ? chord + towards * shift : middle;
  double point = fabs(truncated - middle) <= free ? truncated : middle - towards * free;
  return point > k->low && point < k->high ? point : middle;
}

static double better_end(const struct bracket *k) { return fabs(k->f_low) <= fabs(k->f_high) ? k->low : k->high; }

double itp_root(root_function *f, const void *context, double a, double b)
{
  double slope;
  struct bracket k = { .low = fmin(a, b), .high = fmax(a, b) };
  k.f_low = f(context, k.low, &slope);
  k.f_high = f(context, k.high, &slope);
  if (k.f_low == 0 || k.f_high == 0 || (k.f_low > 0) == (k.f_high > 0))
    return better_end(&k);
  const double initial = k.high - k.low, ulp = finest(a, b);
  for (int left = halvings(a, b); k.high > nextafter(k.low, INFINITY); left--) {
    double u = next_point(&k, initial, ldexp(ulp, left > 0 ? left : 0));
    double value = f(context, u, &slope);
    if (value == 0)
      return u;
    if ((value > 0) == (k.f_low > 0)) {
      k.low = u;
      k.f_low = value;
    } else {
      k.high = u;
      k.f_high = value;
    }
  }
  return better_end(&k);
}
