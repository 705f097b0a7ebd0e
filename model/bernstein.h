/* A Bernstein law (struct scallop_law) in the type `real`, which is to be defined before. No header in the usual sense,
 * and not public. */
#include "model/model.h"

struct bernstein { /* sum of b[j] binomial(degree, j) x^j (1 - x)^(degree - j), x = (u - near)/(far - near) */
  real b[SCALLOP_LAW_MOST_DEGREE + 1];
  real near, far;
  int degree;
};

/* With the coefficient that the law only implies */
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

/* The part between two offsets, low <= high, by de Casteljau's rule: the mean of its coefficients is that of the
 * polynomial there. */
static inline void bernstein_cut(struct bernstein *f, real low, real high)
{
  real range = f->far - f->near, x = (high - f->near) / range, y = (f->far - high) / range;
  for (int k = 0; k < f->degree; k++) /* b[j] becomes that of near to high */
    for (int j = f->degree; j > k; j--)
      f->b[j] = y * f->b[j - 1] + x * f->b[j];
  x = (low - f->near) / (high - f->near);
  y = (high - low) / (high - f->near);
  for (int k = 0; k < f->degree; k++) /* and of low to high */
    for (int j = 0; j < f->degree - k; j++)
      f->b[j] = y * f->b[j] + x * f->b[j + 1];
  f->near = low;
  f->far = high;
}
