/* The radius of convergence of a series, from its coefficients. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "compare/breakdown_parts.h"

#include <flint/fmpq_vec.h>
#if __FLINT_RELEASE >= 30000
#include <flint/arb_fmpz_poly.h>
#else
#include <arb_fmpz_poly.h>
#endif

/* sum over j of a_j T^(first + stride j): the terms that are not 0 by symmetry */
struct terms {
  slong first, stride, count;
  const struct series *series;
};

static slong gcd(slong a, slong b) { return b == 0 ? a : gcd(b, a % b); }

/* count = 0 for a series with fewer than two terms */
static struct terms terms_of(const struct series *s, slong order)
{
  struct terms t = { .series = s };
  bool found = false;
  slong last = 0;
  for (slong k = s->first; k < order && k < s->known; k++) {
    if (series_coefficient_is_zero(s, k))
      continue;
    if (found)
      t.stride = gcd(k - t.first, t.stride);
    else
      t.first = k;
    found = true;
    last = k;
  }
  t.count = t.stride > 0 ? (last - t.first) / t.stride + 1 : 0;
  return t;
}

/* ---- poles of a rational function ---- */

enum { MOST_POLES = 12, CONFIRMED = 4 };

/* The shortest linear recurrence of a[count] (Berlekamp and Massey, over the rationals): sum over k of c[k] a[n - k] = 0, c[0] = 1.
 * Returns its length, or -1 if it is longer than MOST_POLES. */
static slong recurrence(fmpq *c, const fmpq *a, slong count)
{
  enum { SIZE = 2 * MOST_POLES + 2 };
  fmpq *last = _fmpq_vec_init(SIZE), *kept = _fmpq_vec_init(SIZE);
  fmpq_t d, before, factor;
  fmpq_init(d);
  fmpq_init(before);
  fmpq_init(factor);
  slong length = 0, shift = 1;
  fmpq_one(&c[0]);
  fmpq_one(&last[0]);
  fmpq_one(before);
  for (slong n = 0; n < count && length <= MOST_POLES; n++, shift++) {
    fmpq_zero(d);
    for (slong k = 0; k <= length; k++)
      fmpq_addmul(d, &c[k], &a[n - k]);
    if (fmpq_is_zero(d))
      continue;
    for (slong k = 0; k < SIZE; k++)
      fmpq_set(&kept[k], &c[k]);
    fmpq_div(factor, d, before);
    for (slong k = 0; k + shift < SIZE; k++)
      fmpq_submul(&c[k + shift], factor, &last[k]);
    if (2 * length > n)
      continue;
    length = n + 1 - length;
    for (slong k = 0; k < SIZE; k++)
      fmpq_set(&last[k], &kept[k]);
    fmpq_set(before, d);
    shift = 0;
  }
  fmpq_clear(d);
  fmpq_clear(before);
  fmpq_clear(factor);
  _fmpq_vec_clear(last, SIZE);
  _fmpq_vec_clear(kept, SIZE);
  return length <= MOST_POLES ? length : -1;
}

static void tell_pole(struct radius_estimate *e, const acb_t z, const struct terms *t, slong length)
{
  enum { DIGITS = 10 };
  char *re = arb_get_str(acb_realref(z), DIGITS, ARB_STR_NO_RADIUS),
       *im = arb_get_str(acb_imagref(z), DIGITS, ARB_STR_NO_RADIUS);
  bool real = arb_is_zero(acb_imagref(z)), imaginary = arb_contains_zero(acb_realref(z));
  const char *size = *im == '-' ? im + 1 : im;
  char place[120];
  if (real)
    snprintf(place, sizeof place, "%s", re);
  else
    snprintf(place, sizeof place, "%s+-%s i", imaginary ? "" : re, size);
  snprintf(e->note, sizeof e->note,
           "a pole at T^%ld = %s: the series is that of a rational function, with %ld coefficients more than that takes",
           (long)t->stride, place, (long)(t->count - 2 * length));
  flint_free(re);
  flint_free(im);
}

/* The root of q with the least |z|, in the estimate. */
static void nearest_root(struct radius_estimate *e, const fmpz_poly_t q, const struct terms *t, slong length)
{
  slong degree = fmpz_poly_degree(q);
  acb_ptr roots = _acb_vec_init(degree);
  arb_t size, least;
  arb_init(size);
  arb_init(least);
  arb_fmpz_poly_complex_roots(roots, q, 0, 128);
  slong best = 0;
  for (slong i = 0; i < degree; i++) {
    acb_abs(size, roots + i, 128);
    if (i == 0 || arb_lt(size, least)) {
      arb_set(least, size);
      best = i;
    }
  }
  tell_pole(e, roots + best, t, length);
  arb_root_ui(least, least, (ulong)t->stride, 128);
  e->T = arf_get_d(arb_midref(least), ARF_RND_NEAR);
  arf_t end;
  arf_init(end);
  arb_get_lbound_arf(end, least, 128);
  e->low = arf_get_d(end, ARF_RND_FLOOR);
  arb_get_ubound_arf(end, least, 128);
  e->high = arf_get_d(end, ARF_RND_CEIL);
  arf_clear(end);
  arb_clear(size);
  arb_clear(least);
  _acb_vec_clear(roots, degree);
}

static bool by_poles(struct radius_estimate *e, const struct terms *t)
{
  enum { SIZE = 2 * MOST_POLES + 2 };
  fmpq *a = _fmpq_vec_init(t->count), *c = _fmpq_vec_init(SIZE);
  bool found = true;
  for (slong j = 0; j < t->count && found; j++)
    found = series_rational_coefficient(&a[j], t->series, t->first + j * t->stride);
  slong length = found ? recurrence(c, a, t->count) : -1;
  found = length > 0 && t->count >= 2 * length + CONFIRMED;
  if (found) {
    fmpq_poly_t q;
    fmpz_poly_t whole, common;
    fmpq_poly_init(q);
    fmpz_poly_init(whole);
    fmpz_poly_init(common);
    for (slong k = 0; k <= length; k++)
      fmpq_poly_set_coeff_fmpq(q, k, &c[k]);
    fmpq_poly_get_numerator(whole, q);
    fmpz_poly_derivative(common, whole);
    fmpz_poly_gcd(common, common, whole);
    fmpz_poly_div(whole, whole, common); /* each root once */
    *e = (struct radius_estimate){ .method = "poles", .T = INFINITY, .low = INFINITY, .high = INFINITY };
    if (fmpz_poly_degree(whole) > 0)
      nearest_root(e, whole, t, length);
    else
      snprintf(e->note, sizeof e->note, "the series ends: a polynomial in T");
    fmpq_poly_clear(q);
    fmpz_poly_clear(whole);
    fmpz_poly_clear(common);
  }
  _fmpq_vec_clear(a, t->count);
  _fmpq_vec_clear(c, SIZE);
  return found;
}

/* ---- estimates ----
 *
 * Near its singularity at distance R a function goes as (1 - z/R)^p, and its coefficients as R^-j j^(-1-p): the ratio of neighbours is
 * (1 - (1 + p)/j)/R. For a pair R exp(+-i theta) they oscillate, and the ratio is one of determinants. All go to their limits as 1/j,
 * and that is taken away by the last two: j q_j - (j - 1) q_(j-1). */

/* log |a_j| and the sign, for j < count */
struct logarithms {
  double *size;
  int *sign;
};

static double nth_root(double x, slong n) { return exp(log(x) / (double)n); }

/* The estimates at the last place and at three quarters of it are the ends of what is told. */
static void set_estimate(struct radius_estimate *e, const char *method, const char *note, double last, double before,
                         slong stride)
{
  double a = nth_root(last, stride), b = nth_root(before, stride);
  *e = (struct radius_estimate){ .method = method, .T = a, .low = fmin(a, 2 * a - b), .high = fmax(a, 2 * a - b) };
  e->low = fmin(e->low, b);
  e->high = fmax(e->high, b);
  snprintf(e->note, sizeof e->note, "%s", note);
}

/* |a_(j-1)/a_j|, extrapolated; nan where the signs do not repeat. */
static double by_ratio(const struct logarithms *l, slong j)
{
  for (slong k = j - 3; k <= j; k++)
    if (l->sign[k] * l->sign[k - 1] != l->sign[j] * l->sign[j - 1])
      return NAN;
  double q = exp(l->size[j] - l->size[j - 1] - (l->size[j - 1] - l->size[j - 2])), n = (double)j;
  return exp(l->size[j - 2] - l->size[j - 1]) / (n * q - (n - 1));
}

/* a_(j+1) a_(j-1) - a_j^2 over that for j - 1, the size of a_j^2/a_(j-1)^2 taken out: both in numbers of ordinary size */
static double determinant(const struct logarithms *l, slong j)
{
  return l->sign[j + 1] * l->sign[j - 1] * exp(l->size[j + 1] + l->size[j - 1] - 2 * l->size[j]) - 1;
}

static double squared_ratio(const struct logarithms *l, slong j)
{
  return determinant(l, j) / determinant(l, j - 1) * exp(2 * (l->size[j] - l->size[j - 1]));
}

/* Mercer and Roberts: R^-2 for R exp(+-i theta), -R^-2 for +-R */
static double by_three_terms(const struct logarithms *l, slong j)
{
  double n = (double)j, scale = exp(2 * (l->size[j - 2] - l->size[j - 1]));
  double limit = n * squared_ratio(l, j) * scale - (n - 1) * squared_ratio(l, j - 1) * scale;
  return sqrt(fabs(scale / limit));
}

/* log |a_j| = A - j log R - B log j through three places that are far apart */
static double by_root(const struct logarithms *l, slong j)
{
  const slong places[3] = { j / 3, 2 * j / 3, j };
  double x[3], y[3];
  for (int i = 0; i < 3; i++) {
    x[i] = (double)places[i];
    y[i] = l->size[places[i]];
  }
  double u1 = x[1] - x[0], u2 = x[2] - x[0], v1 = log(x[1] / x[0]), v2 = log(x[2] / x[0]);
  double w1 = y[1] - y[0], w2 = y[2] - y[0];
  return exp(-(w1 * v2 - w2 * v1) / (u1 * v2 - u2 * v1));
}

static bool take_logarithms(struct logarithms *l, const struct terms *t, slong precision)
{
  bool sound = true;
  arb_t a;
  arb_init(a);
  for (slong j = 0; j < t->count; j++) {
    series_coefficient(a, t->series, t->first + j * t->stride, precision);
    l->sign[j] = arb_is_positive(a) ? 1 : arb_is_negative(a) ? -1 : 0;
    arb_abs(a, a);
    arb_log(a, a, precision);
    l->size[j] = arf_get_d(arb_midref(a), ARF_RND_NEAR);
    sound = sound && l->sign[j] != 0;
  }
  arb_clear(a);
  return sound;
}

int radius_from_poles(struct radius_estimate e[RADIUS_METHODS], const struct series *series, slong order)
{
  struct terms t = terms_of(series, order);
  return t.count > 0 && by_poles(e, &t) ? 1 : 0;
}

int radius_from_growth(struct radius_estimate e[RADIUS_METHODS], const struct series *series, slong order, slong precision)
{
  enum { LEAST = 16 };
  static const struct {
    double (*estimate)(const struct logarithms *, slong);
    const char *method, *note;
  } methods[] = { { by_ratio, "ratio", "ratio of neighbouring coefficients, extrapolated in 1/n (Domb and Sykes)" },
                  { by_three_terms, "three-term", "ratio of determinants of three, extrapolated (Mercer and Roberts)" },
                  { by_root, "root", "n-th root, with a power of n taken out" } };
  struct terms t = terms_of(series, order);
  if (t.count < LEAST)
    return 0;
  struct logarithms l = { calloc((size_t)t.count, sizeof *l.size), calloc((size_t)t.count, sizeof *l.sign) };
  int found = 0;
  if (l.size && l.sign && take_logarithms(&l, &t, precision))
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
      slong last = t.count - 2;
      double R = methods[i].estimate(&l, last), earlier = methods[i].estimate(&l, 3 * last / 4);
      if (isfinite(R) && R > 0 && isfinite(earlier) && earlier > 0)
        set_estimate(&e[found++], methods[i].method, methods[i].note, R, earlier, t.stride);
    }
  free(l.size);
  free(l.sign);
  return found;
}

int radius_estimates(struct radius_estimate e[RADIUS_METHODS], const struct series *series, slong order, slong precision)
{
  return radius_from_poles(e, series, order) == 1 ? 1 : radius_from_growth(e, series, order, precision);
}
