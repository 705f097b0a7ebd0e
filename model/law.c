#include "model/law.h"

#include <math.h>
#include <stddef.h>

/* ---- straight lines ---- */

static double time_offset(const struct scallop_piece *p, double u) { return p->anchor == SCALLOP_FROM_START ? u : -u; }

static double ramp_length(const struct scallop_piece *p, double u)
{
  double t = time_offset(p, u);
  return p->direction * p->law->numerator[6] + t * (p->velocity + 0.5 * p->acceleration * t);
}

static double ramp_velocity(const struct scallop_piece *p, double u)
{
  return p->velocity + p->acceleration * time_offset(p, u);
}

static double ramp_acceleration(const struct scallop_piece *p, double u)
{
  (void)u;
  return p->acceleration;
}

static double ramp_when(const struct scallop_piece *p, double a) { return a == p->acceleration ? p->begin : NAN; }

const struct scallop_curve law_curve_ramp = { ramp_length, ramp_velocity, ramp_acceleration, ramp_when, NULL };

static double rest_length(const struct scallop_piece *p, double u)
{
  (void)u;
  return p->law->numerator[6];
}

const struct scallop_curve law_curve_rest = { rest_length, ramp_velocity, ramp_acceleration, ramp_when, NULL };

/* ---- Bernstein's polynomials: in long double, which where it is wider rounds off what their many terms add up to ---- */

enum { MOST = SCALLOP_LAW_MOST_DEGREE };

void law_coefficients(const struct scallop_law *law, long double *b)
{
  int n = law->degree, implied = (int)law->numerator[n + 3];
  long double others = 0, range = (long double)law->numerator[n + 2] - law->numerator[n + 1];
  for (int j = 0; j <= n; j++) {
    b[j] = law->numerator[j];
    others += j == implied ? 0 : b[j];
  }
  for (int i = 1; i < law->denominator; i++)
    b[implied] += law->numerator[n + 4 + i];
  b[implied] = (n + 1) * b[implied] / range - others;
}

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
  long double b[MOST + 2], x, y, range;
  int degree;
};

static struct place place_at(const struct scallop_law *law, double u)
{
  struct place at = { .degree = law->degree };
  long double near = law->numerator[law->degree + 1], far = law->numerator[law->degree + 2];
  at.range = far - near;
  at.x = (u - near) / at.range;
  at.y = (far - u) / at.range;
  law_coefficients(law, at.b);
  return at;
}

static long double speed(const struct place *at) { return law_bernstein(at->b, at->degree, at->x, at->y); }

/* d|l'|/du */
static long double slope(const struct place *at)
{
  long double d[MOST] = { 0 };
  for (int j = 0; j < at->degree; j++)
    d[j] = at->b[j + 1] - at->b[j];
  return at->degree / at->range * law_bernstein(d, at->degree - 1, at->x, at->y);
}

/* What |l'| covers from near on */
static long double way(const struct place *at)
{
  long double sums[MOST + 2];
  int n = at->degree;
  sums[0] = 0;
  for (int j = 0; j <= n; j++)
    sums[j + 1] = sums[j] + at->b[j];
  return at->range / (n + 1) * law_bernstein(sums, n + 1, at->x, at->y);
}

/* The slope from near on cut down to the part between from and to, by de Casteljau's rule: its mean there is formed without a difference of two
 * speeds, which may be much larger than what they differ by. */
double law_rise(const struct scallop_law *law, double from, double to)
{
  struct place at = place_at(law, fmax(from, to));
  int n = at.degree - 1;
  long double low = fmin(from, to), high = fmax(from, to), sum = 0, near = law->numerator[law->degree + 1];
  long double x = (low - near) / (high - near), y = (high - low) / (high - near);
  if (from == to)
    return 0;
  for (int j = 0; j <= n; j++)
    at.b[j] = at.b[j + 1] - at.b[j];
  for (int k = 0; k < n; k++) /* the part up to high */
    for (int j = n; j > k; j--)
      at.b[j] = at.y * at.b[j - 1] + at.x * at.b[j];
  for (int k = 0; k < n; k++) /* and of that the part from low on */
    for (int j = 0; j < n - k; j++)
      at.b[j] = y * at.b[j] + x * at.b[j + 1];
  for (int j = 0; j <= n; j++)
    sum += at.b[j];
  return (double)(sum / at.range * (to - (long double)from)); /* (n + 1) slopes, the mean of n + 1 */
}

static int sense(const struct scallop_piece *p) { return p->anchor == SCALLOP_FROM_START ? 1 : -1; }

static double bernstein_length(const struct scallop_piece *p, double u)
{
  struct place at = place_at(p->law, u);
  return (double)(p->direction * (p->law->numerator[p->law->degree + 4] + sense(p) * way(&at)));
}

static double bernstein_velocity(const struct scallop_piece *p, double u)
{
  struct place at = place_at(p->law, u);
  return (double)(p->direction * speed(&at));
}

static double bernstein_acceleration(const struct scallop_piece *p, double u)
{
  struct place at = place_at(p->law, u);
  return (double)(p->direction * sense(p) * slope(&at));
}

static void bernstein_rates(const struct scallop_piece *p, double u, double *velocity, double *acceleration)
{
  struct place at = place_at(p->law, u);
  *velocity = (double)(p->direction * speed(&at));
  *acceleration = (double)(p->direction * sense(p) * slope(&at));
}

/* Where d|l'|/du = wanted between lo and hi, on either side of which it differs in sign from that; it is monotone there. Regula falsi
 * in the manner of Illinois (Dowell & Jarratt, BIT 11, 1971). Where the slope goes with a power of u and the root is many orders of magnitude
 * below hi, that would only double lo: the logarithm of u is halved then. */
static double slope_root(const struct scallop_law *law, long double wanted, double lo, double hi, long double f_lo,
                         long double f_hi)
{
  enum { STEPS = 200, FEW = 16 };
  const double far = 0x1p40;
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
  double lo = p->anchor == SCALLOP_FROM_START ? p->begin : p->end, hi = p->anchor == SCALLOP_FROM_START ? p->end : p->begin;
  long double wanted = (long double)(p->direction * sense(p)) * a;
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

/* ---- comparison ---- */

static int numbers_of(const struct scallop_law *law)
{
  return law->kind == SCALLOP_LAW_POLYNOMIAL  ? law->degree + 1
         : law->kind == SCALLOP_LAW_RAMP      ? 6
         : law->kind == SCALLOP_LAW_BERNSTEIN ? law->degree + 4
                                              : 0;
}

bool law_same(const struct scallop_law *a, const struct scallop_law *b)
{
  if (a == b)
    return true;
  if (a->kind != b->kind || a->degree != b->degree
      || ((a->kind == SCALLOP_LAW_POLYNOMIAL || a->kind == SCALLOP_LAW_BERNSTEIN) && a->denominator != b->denominator))
    return false;
  for (int i = 0; i < numbers_of(a); i++)
    if (a->numerator[i] != b->numerator[i])
      return false;
  if (a->kind != SCALLOP_LAW_BERNSTEIN)
    return true;
  for (int i = 1; i < a->denominator; i++)
    if (a->numerator[a->degree + 4 + i] != b->numerator[b->degree + 4 + i])
      return false;
  return true;
}
