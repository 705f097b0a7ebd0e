/* Bernstein laws (struct scallop_law) in the type `real` of the including file: value, derivatives and integral.
 * Included as text, not public. */
#include "model/model.h"

struct bernstein { /* sum of b[j] binomial(degree, j) x^j (1 - x)^(degree - j), x = (u - near)/(far - near) */
  real b[SCALLOP_LAW_MOST_DEGREE + 1];
  real near, far;
  int degree;
};

/* Returns the polynomial of a law, with the coefficient that the law implies. */
static inline struct bernstein bernstein_of(const struct scallop_law *law)
{
  const struct scallop_bernstein_law *given = &law->bernstein;
  struct bernstein f = { .near = given->near, .far = given->far, .degree = law->degree };
  real others = 0, way = given->way;
  for (int j = 0; j <= f.degree; j++) {
    f.b[j] = given->b[j];
    others += j == given->implied ? 0 : f.b[j];
  }
  for (int i = 0; i < given->more_count; i++)
    way += given->more[i];
  f.b[given->implied] = (f.degree + 1) * way / (f.far - f.near) - others;
  return f;
}

/* Returns the sum of b[j] binomial(n, j) x^j y^(n - j), x + y = 1, to a few ulp of the sum of magnitudes, also next
 * to x = 0 and y = 0. */
static inline real bernstein_sum(const real *b, int n, real x, real y)
{
  real sum = b[0], power = 1;
  for (int j = 1, choose = 1; j <= n; j++) {
    choose = choose * (n - j + 1) / j;
    power *= x;
    sum = sum * y + choose * power * b[j];
  }
  return sum;
}

/* Replaces the coefficients by b[j + 1] - b[j], of degree - 1: the slope times (far - near)/degree. */
static inline void bernstein_differences(struct bernstein *f)
{
  f->degree--;
  for (int j = 0; j <= f->degree; j++)
    f->b[j] = f->b[j + 1] - f->b[j];
}

/* Returns the derivative of this order with respect to u; order 0: the value. */
static inline real bernstein_derivative(struct bernstein f, real u, int order)
{
  real range = f.far - f.near, factor = 1;
  if (order > f.degree)
    return 0;
  for (; order > 0; order--) {
    factor *= f.degree / range;
    bernstein_differences(&f);
  }
  return factor * bernstein_sum(f.b, f.degree, (u - f.near) / range, (f.far - u) / range);
}

/* Computes the value and the derivative at u; f becomes the differences. */
static inline void bernstein_rates_at(struct bernstein *f, real u, real *value, real *slope)
{
  const real range = f->far - f->near, x = (u - f->near) / range, y = (f->far - u) / range, scale = f->degree / range;
  *value = bernstein_sum(f->b, f->degree, x, y);
  bernstein_differences(f);
  *slope = scale * bernstein_sum(f->b, f->degree, x, y);
}

/* Restricts the polynomial to low <= u <= high, by de Casteljau's rule. The mean of its coefficients is then its
 * mean value there. */
static inline void bernstein_cut(struct bernstein *f, real low, real high)
{
  real range = f->far - f->near, x = (high - f->near) / range, y = (f->far - high) / range;
  for (int k = 0; k < f->degree; k++) /* b[j] from near to high */
    for (int j = f->degree; j > k; j--)
      f->b[j] = y * f->b[j - 1] + x * f->b[j];
  x = (low - f->near) / (high - f->near);
  y = (high - low) / (high - f->near);
  for (int k = 0; k < f->degree; k++) /* then from low to high */
    for (int j = 0; j < f->degree - k; j++)
      f->b[j] = y * f->b[j] + x * f->b[j + 1];
  f->near = low;
  f->far = high;
}

static inline real bernstein_total(const struct bernstein *f)
{
  real sum = 0;
  for (int j = 0; j <= f->degree; j++)
    sum += f->b[j];
  return sum;
}

/* Returns the integral over u between the two offsets, positive in either order. */
static inline real bernstein_integral(struct bernstein f, real from, real to)
{
  if (from == to)
    return 0;
  bernstein_cut(&f, from < to ? from : to, from < to ? to : from);
  return bernstein_total(&f) / (f.degree + 1) * (f.far - f.near);
}

/* Returns the value at `to` minus the value at `from`, to a few ulp of (to - from) max |slope|, however near the
 * offsets are to each other. The mean of the slope is formed without a difference of two values, as their digits would
 * cancel: it is the mean of n + 1 coefficients, each (n + 1)/(far - near) times a difference. */
static inline real bernstein_rise(struct bernstein f, real from, real to)
{
  real range = f.far - f.near;
  if (from == to)
    return 0;
  bernstein_differences(&f);
  bernstein_cut(&f, from < to ? from : to, from < to ? to : from);
  return bernstein_total(&f) / range * (to - from);
}
