#include "model/law.h"

#include <math.h>
#include <stddef.h>

/* Long double rounds off, where it is wider, what the many terms of a Bernstein polynomial add up to. */
typedef long double real;
#include "model/bernstein.h"

long double law_bernstein(const long double *b, int n, long double x, long double y)
{
  long double sum = b[0], factor = 1;
  for (int j = 1; j <= n; j++) {
    factor *= x * (n - j + 1) / j;
    sum = sum * y + factor * b[j];
  }
  return sum;
}

struct place { /* in the range of a law: x from near, y from far                                                  */
  struct bernstein of;
  long double x, y;
};

static struct place place_at(const struct scallop_law *law, double u)
{
  struct place at = { .of = bernstein_of(law) };
  at.x = (u - at.of.near) / (at.of.far - at.of.near);
  at.y = (at.of.far - u) / (at.of.far - at.of.near);
  return at;
}

static long double speed(const struct place *at) { return law_bernstein(at->of.b, at->of.degree, at->x, at->y); }

/* b[j + 1] - b[j], of degree - 1: times degree/(far - near) the slope d|l'|/du */
static void differences(struct bernstein *f)
{
  f->degree--;
  for (int j = 0; j <= f->degree; j++)
    f->b[j] = f->b[j + 1] - f->b[j];
}

static long double slope(const struct place *at)
{
  struct bernstein d = at->of;
  differences(&d);
  return at->of.degree / (at->of.far - at->of.near) * law_bernstein(d.b, d.degree, at->x, at->y);
}

/* What |l'| covers from near on */
static long double way(const struct place *at)
{
  long double sums[SCALLOP_LAW_MOST_DEGREE + 2];
  int n = at->of.degree;
  sums[0] = 0;
  for (int j = 0; j <= n; j++)
    sums[j + 1] = sums[j] + at->of.b[j];
  return (at->of.far - at->of.near) / (n + 1) * law_bernstein(sums, n + 1, at->x, at->y);
}

/* The mean of the slope between from and to is formed without a difference of two speeds, which may be much larger than
 * what they differ by. */
double law_rise(const struct scallop_law *law, double from, double to)
{
  struct bernstein f = bernstein_of(law);
  long double range = f.far - f.near, sum = 0;
  if (from == to)
    return 0;
  differences(&f);
  bernstein_cut(&f, fmin(from, to), fmax(from, to));
  for (int j = 0; j <= f.degree; j++)
    sum += f.b[j];
  return (double)(sum / range * (to - (long double)from)); /* (n + 1) slopes, the mean of n + 1 */
}

static double bernstein_length(const struct scallop_piece *p, double u)
{
  struct place at = place_at(p->law, u);
  return (double)(p->direction * (p->law->base + law_sense(p) * way(&at)));
}

static double bernstein_velocity(const struct scallop_piece *p, double u)
{
  struct place at = place_at(p->law, u);
  return (double)(p->direction * speed(&at));
}

static double bernstein_acceleration(const struct scallop_piece *p, double u)
{
  struct place at = place_at(p->law, u);
  return (double)(p->direction * law_sense(p) * slope(&at));
}

static void bernstein_rates(const struct scallop_piece *p, double u, double *velocity, double *acceleration)
{
  struct place at = place_at(p->law, u);
  *velocity = (double)(p->direction * speed(&at));
  *acceleration = (double)(p->direction * law_sense(p) * slope(&at));
}

static long double bernstein_third(const struct scallop_law *law, double u)
{
  struct place at = place_at(law, u);
  struct bernstein d = at.of;
  long double factor = 1;
  if (d.degree < 3)
    return 0;
  for (int k = 0; k < 3; k++) {
    factor *= d.degree / (at.of.far - at.of.near);
    differences(&d);
  }
  return factor * law_bernstein(d.b, d.degree, at.x, at.y);
}

static long double polynomial_third(const struct scallop_law *law, double u)
{
  long double sum = 0;
  for (int k = law->degree; k >= 3; k--)
    sum = sum * u + (long double)law->polynomial.c[k] * k * (k - 1) * (k - 2);
  return sum / law->polynomial.denominator;
}

/* d^3 |l'|/du^3 at offset u; nan where there is no law */
static double third_derivative(const struct scallop_piece *p, double u)
{
  const long double pi = 3.14159265358979323846264338327950288L;
  if (!p->law)
    return p->linear ? 0 : NAN;
  switch (p->law->kind) {
  case SCALLOP_LAW_POLYNOMIAL: return (double)polynomial_third(p->law, u);
  case SCALLOP_LAW_SINE: return (double)(-pi * pi * pi * pi / 2 * cosl(pi * u));
  case SCALLOP_LAW_BERNSTEIN: return (double)bernstein_third(p->law, u);
  case SCALLOP_LAW_RAMP: break;
  }
  return 0;
}

double scallop_fourth_derivative(const struct scallop_shape *shape, bool at_end)
{
  const struct scallop_piece *piece = &shape->pieces[at_end ? shape->count - 1 : 0];
  return piece->direction * law_sense(piece) * third_derivative(piece, at_end ? piece->end : piece->begin);
}

/* Where d|l'|/du = wanted between lo and hi, on either side of which it differs in sign from that; it is monotone
 * there. Regula falsi in the manner of Illinois (Dowell & Jarratt, BIT 11, 1971). Where the slope goes with a power of
 * u and the root is far below hi, a step only doubles lo, or halves the value at hi: after a few such steps the
 * logarithm of u is halved, until hi is less than twice lo. */
static double slope_root(const struct scallop_law *law, long double wanted, double lo, double hi, long double f_lo,
                         long double f_hi)
{
  enum { STEPS = 200, FEW = 16 };
  const double far = 2;
  for (int i = 0, kept = 0; i < STEPS; i++) {
    bool far_apart = i >= FEW && lo > 0 && hi > far * lo;
    double u = far_apart ? sqrt(lo) * sqrt(hi) : (double)(lo + (hi - lo) * (f_lo / (f_lo - f_hi)));
    if (!(u > lo && u < hi))
      return fabsl(f_lo) < fabsl(f_hi) ? lo : hi;
    struct place at = place_at(law, u);
    long double f = slope(&at) - wanted;
    if (f == 0)
      return u;
    bool low = (f > 0) == (f_lo > 0);
    if (low) {
      lo = u;
      f_lo = f;
      f_hi *= kept > 0 ? 0.5L : 1;
    } else {
      hi = u;
      f_hi = f;
      f_lo *= kept < 0 ? 0.5L : 1;
    }
    kept = far_apart ? 0 : low ? 1 : -1;
  }
  return lo; /* GCOVR_EXCL_LINE: halving ends before STEPS */
}

static double bernstein_when(const struct scallop_piece *p, double a)
{
  const struct scallop_law *law = p->law;
  double lo = p->anchor == SCALLOP_FROM_START ? p->begin : p->end,
         hi = p->anchor == SCALLOP_FROM_START ? p->end : p->begin;
  long double wanted = (long double)(p->direction * law_sense(p)) * a;
  struct place low = place_at(law, lo), high = place_at(law, hi);
  long double f_lo = slope(&low) - wanted, f_hi = slope(&high) - wanted;
  if ((f_lo > 0 && f_hi > 0) || (f_lo < 0 && f_hi < 0))
    return NAN;
  if (law->degree == 2) /* the slope is linear */
    return f_lo == f_hi ? lo : (double)(lo + (hi - lo) * (f_lo / (f_lo - f_hi)));
  return f_lo == 0 ? lo : f_hi == 0 ? hi : slope_root(law, wanted, lo, hi, f_lo, f_hi);
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
