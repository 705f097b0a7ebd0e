#include "model/law.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

/* Long double, if it is wider than double, reduces the rounding of the many terms of a Bernstein polynomial. In
 * WebAssembly it is binary128 in software, a hundred times slower; tests/explorer/core.js measures the rounding of
 * double there. */
#ifdef __wasm__
typedef double real;
#define ROUNDING (DBL_EPSILON / 2)
#else
typedef long double real;
#define ROUNDING (LDBL_EPSILON / 2)
#endif
#include "model/bernstein.h"
#include "model/root.h"

double law_rise(const struct scallop_law *law, double from, double to)
{
  return (double)bernstein_rise(bernstein_of(law), from, to);
}

/* Returns the integral of |l'| from near to u. */
static real way(const struct bernstein *f, real u)
{
  real sums[SCALLOP_LAW_MOST_DEGREE + 2], range = f->far - f->near;
  int n = f->degree;
  sums[0] = 0;
  for (int j = 0; j <= n; j++)
    sums[j + 1] = sums[j] + f->b[j];
  return range / (n + 1) * bernstein_sum(sums, n + 1, (u - f->near) / range, (f->far - u) / range);
}

static double bernstein_length(const struct scallop_piece *p, double u)
{
  const struct bernstein f = bernstein_of(p->law);
  return (double)(p->direction * (p->law->base + law_sense(p) * way(&f, u)));
}

static void bernstein_rates(const struct scallop_piece *p, double u, double *velocity, double *acceleration)
{
  struct bernstein f = bernstein_of(p->law);
  real value, slope;
  bernstein_rates_at(&f, u, &value, &slope);
  *velocity = (double)(p->direction * value);
  *acceleration = (double)(p->direction * law_sense(p) * slope);
}

static double bernstein_velocity(const struct scallop_piece *p, double u)
{
  double velocity, acceleration;
  bernstein_rates(p, u, &velocity, &acceleration);
  return velocity;
}

static double bernstein_acceleration(const struct scallop_piece *p, double u)
{
  double velocity, acceleration;
  bernstein_rates(p, u, &velocity, &acceleration);
  return acceleration;
}

static real polynomial_third(const struct scallop_law *law, real u)
{
  real sum = 0;
  for (int k = law->degree; k >= 3; k--)
    sum = sum * u + (real)law->polynomial.c[k] * k * (k - 1) * (k - 2);
  return sum / law->polynomial.denominator;
}

/* Returns d^3 |l'|/du^3 at offset u; nan without a law. */
static double third_derivative(const struct scallop_piece *p, double u)
{
  const real pi = (real)3.14159265358979323846264338327950288L;
  if (!p->law)
    return p->linear ? 0 : NAN;
  switch (p->law->kind) {
  case SCALLOP_LAW_POLYNOMIAL: return (double)polynomial_third(p->law, u);
  case SCALLOP_LAW_SINE: return (double)(-pi * pi * pi * pi / 2 * cosl(pi * u));
  case SCALLOP_LAW_BERNSTEIN: return (double)bernstein_derivative(bernstein_of(p->law), u, 3);
  case SCALLOP_LAW_RAMP: break;
  }
  return 0;
}

double scallop_fourth_derivative(const struct scallop_shape *shape, bool at_end)
{
  const struct scallop_piece *piece = &shape->pieces[at_end ? shape->count - 1 : 0];
  return piece->direction * law_sense(piece) * third_derivative(piece, at_end ? piece->end : piece->begin);
}

struct slope_search {
  struct bernstein of;
  real wanted; /* the requested value of d|l'|/du */
};

static real slope_beyond(const void *context, real u, real *slope)
{
  const struct slope_search *s = context;
  *slope = bernstein_derivative(s->of, u, 2);
  return bernstein_derivative(s->of, u, 1) - s->wanted;
}

static double bernstein_when(const struct scallop_piece *p, double a)
{
  const struct slope_search s = { bernstein_of(p->law), (real)(p->direction * law_sense(p)) * a };
  struct root_end begin = { .u = p->begin }, end = { .u = p->end };
  begin.f = slope_beyond(&s, begin.u, &begin.slope);
  end.f = slope_beyond(&s, end.u, &end.slope);
  bool same_side = (begin.f > 0 && end.f > 0) || (begin.f < 0 && end.f < 0);
  return same_side ? NAN : (double)root_between(slope_beyond, &s, begin, end);
}

const struct scallop_curve law_curve_bernstein = { bernstein_length, bernstein_velocity, bernstein_acceleration,
                                                   bernstein_when, bernstein_rates };

static bool same(const double *a, const double *b, int count)
{
  for (int i = 0; i < count; i++)
    if (a[i] != b[i])
      return false;
  return true;
}

static bool same_ramp(const struct scallop_ramp_law *a, const struct scallop_ramp_law *b)
{
  return a->start == b->start && a->slope == b->slope && a->divisor == b->divisor && same(a->parts, b->parts, 3);
}

static bool same_bernstein(const struct scallop_bernstein_law *a, const struct scallop_bernstein_law *b, int degree)
{
  return a->near == b->near && a->far == b->far && a->way == b->way && a->implied == b->implied
         && same(a->b, b->b, degree + 1) && a->more_count == b->more_count && same(a->more, b->more, a->more_count);
}

bool law_same(const struct scallop_law *a, const struct scallop_law *b)
{
  if (a == b)
    return true;
  if (a->kind != b->kind || a->degree != b->degree)
    return false;
  switch (a->kind) {
  case SCALLOP_LAW_POLYNOMIAL:
    return a->polynomial.denominator == b->polynomial.denominator
           && same(a->polynomial.c, b->polynomial.c, a->degree + 1);
  case SCALLOP_LAW_RAMP: return same_ramp(&a->ramp, &b->ramp);
  case SCALLOP_LAW_BERNSTEIN: return same_bernstein(&a->bernstein, &b->bernstein, a->degree);
  case SCALLOP_LAW_SINE: break;
  }
  return true;
}
