/* The radius of convergence of a series, from its coefficients. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "compare/breakdown_parts.h"

#if __FLINT_RELEASE >= 30000
#include <flint/acb_poly.h>
#include <flint/arb_fmpz_poly.h>
#include <flint/arb_mat.h>
#else
#include <acb_poly.h>
#include <arb_fmpz_poly.h>
#include <arb_mat.h>
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
 * (1 - (1 + p)/j)/R, from which the last two take the 1/j: j q_j - (j - 1) q_(j-1). Where there are several singularities at about
 * that distance the ratio oscillates; a Pade approximant has its poles near each of them. */

struct growth {
  const struct terms *terms;
  slong precision;
  double *size; /* log |a_j|, and the sign                                                     */
  int *sign;
};

static double nth_root(double x, slong n) { return exp(log(x) / (double)n); }

/* |a_(j-1)/a_j|, extrapolated; nan where the signs did not repeat from the middle on. */
static double by_ratio(const struct growth *g, slong j)
{
  for (slong k = j / 2; k <= j; k++)
    if (g->sign[k] * g->sign[k - 1] != g->sign[j] * g->sign[j - 1])
      return NAN;
  double q = exp(g->size[j] - g->size[j - 1] - (g->size[j - 1] - g->size[j - 2])), n = (double)j;
  return exp(g->size[j - 2] - g->size[j - 1]) / (n * q - (n - 1));
}

/* log |a_j| = A - j log R - B log j through three places that are far apart */
static double by_root(const struct growth *g, slong j)
{
  const slong places[3] = { j / 3, 2 * j / 3, j };
  double x[3], y[3];
  for (int i = 0; i < 3; i++) {
    x[i] = (double)places[i];
    y[i] = g->size[places[i]];
  }
  double u1 = x[1] - x[0], u2 = x[2] - x[0], v1 = log(x[1] / x[0]), v2 = log(x[2] / x[0]);
  double w1 = y[1] - y[0], w2 = y[2] - y[0];
  return exp(-(w1 * v2 - w2 * v1) / (u1 * v2 - u2 * v1));
}

static void coefficient_of(arb_t a, const struct growth *g, slong j)
{
  series_coefficient(a, g->terms->series, g->terms->first + j * g->terms->stride, g->precision);
}

/* numerator/denominator, from a_0 to a_2n. */
struct pade {
  acb_poly_t numerator, denominator;
  slong n;
};

/* sum over k <= n of q_k a_(m-k) = 0 for m = n + 1, ..., 2n, q_0 = 1. False: it has fewer poles. */
static bool find_denominator(struct pade *p, const struct growth *g)
{
  slong n = p->n;
  arb_mat_t a, b, q;
  arb_mat_init(a, n, n);
  arb_mat_init(b, n, 1);
  arb_mat_init(q, n, 1);
  for (slong row = 0; row < n; row++)
    for (slong k = 0; k <= n; k++)
      coefficient_of(k == 0 ? arb_mat_entry(b, row, 0) : arb_mat_entry(a, row, k - 1), g, n + 1 + row - k);
  arb_mat_neg(b, b);
  bool found = n > 0 && arb_mat_solve(q, a, b, g->precision);
  acb_poly_one(p->denominator);
  for (slong k = 1; found && k <= n; k++) {
    acb_t c;
    acb_init(c);
    arb_get_mid_arb(acb_realref(c), arb_mat_entry(q, k - 1, 0));
    acb_poly_set_coeff_acb(p->denominator, k, c);
    acb_clear(c);
  }
  arb_mat_clear(a);
  arb_mat_clear(b);
  arb_mat_clear(q);
  return found;
}

static void find_numerator(struct pade *p, const struct growth *g)
{
  acb_t a;
  acb_init(a);
  for (slong k = 0; k <= p->n; k++) {
    coefficient_of(acb_realref(a), g, k);
    acb_poly_set_coeff_acb(p->numerator, k, a);
  }
  acb_poly_mullow(p->numerator, p->numerator, p->denominator, p->n + 1, g->precision);
  acb_clear(a);
}

/* Has a pole a share in the last coefficient, a_2n? Others, with a zero beside them, are of no meaning. */
static bool matters(const struct pade *p, const acb_t pole, const arb_t last, slong precision)
{
  enum { LEAST_SHARE = 1000 };
  acb_t value, residue, slope;
  arb_t share;
  acb_init(value);
  acb_init(residue);
  acb_init(slope);
  arb_init(share);
  acb_poly_evaluate(residue, p->numerator, pole, precision);
  acb_poly_evaluate2(value, slope, p->denominator, pole, precision);
  acb_div(residue, residue, slope, precision);
  acb_pow_ui(slope, pole, (ulong)(2 * p->n + 1), precision);
  acb_div(residue, residue, slope, precision);
  acb_abs(share, residue, precision);
  arb_mul_ui(share, share, LEAST_SHARE, precision);
  bool does = arf_cmpabs(arb_midref(share), arb_midref(last)) > 0;
  acb_clear(value);
  acb_clear(residue);
  acb_clear(slope);
  arb_clear(share);
  return does;
}

/* The least |z| of the poles that matter, not proven; nan if they are not found. */
static double nearest_pole(const struct pade *p, const arb_t last, slong precision)
{
  acb_ptr poles = _acb_vec_init(p->n);
  arb_t size;
  double least = NAN;
  arb_init(size);
  acb_poly_find_roots(poles, p->denominator, NULL, 0, precision);
  for (slong i = 0; i < p->n; i++) {
    acb_get_mid(poles + i, poles + i);
    acb_abs(size, poles + i, precision);
    double here = arf_get_d(arb_midref(size), ARF_RND_NEAR);
    if (!(here >= least) && matters(p, poles + i, last, precision))
      least = here;
  }
  arb_clear(size);
  _acb_vec_clear(poles, p->n);
  return least;
}

/* From a_0 to a_j, or one less */
static double by_pade(const struct growth *g, slong j)
{
  struct pade p = { .n = j / 2 };
  arb_t last;
  arb_init(last);
  acb_poly_init(p.numerator);
  acb_poly_init(p.denominator);
  double least = NAN;
  if (find_denominator(&p, g)) {
    find_numerator(&p, g);
    coefficient_of(last, g, 2 * p.n);
    least = nearest_pole(&p, last, g->precision);
  }
  acb_poly_clear(p.numerator);
  acb_poly_clear(p.denominator);
  arb_clear(last);
  return least;
}

/* From the last coefficient; and the ends of what the same says from one, two, three, an eighth and a quarter less. False: one of these
 * says nothing, or they contradict each other. */
static bool set_estimate(struct radius_estimate *e, double (*estimate)(const struct growth *, slong), const struct growth *g)
{
  slong last = g->terms->count - 1;
  const slong places[] = { last, last - 1, last - 2, last - 3, last - last / 8, last - last / 4 };
  for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
    double T = nth_root(estimate(g, places[i]), g->terms->stride);
    if (!isfinite(T) || T <= 0)
      return false;
    e->T = i == 0 ? T : e->T;
    e->low = i == 0 ? T : fmin(e->low, T);
    e->high = i == 0 ? T : fmax(e->high, T);
  }
  return e->high <= 2 * e->low;
}

static bool take_logarithms(struct growth *g)
{
  bool sound = true;
  arb_t a;
  arb_init(a);
  for (slong j = 0; j < g->terms->count; j++) {
    coefficient_of(a, g, j);
    g->sign[j] = arb_is_positive(a) ? 1 : arb_is_negative(a) ? -1 : 0;
    arb_abs(a, a);
    arb_log(a, a, g->precision);
    g->size[j] = arf_get_d(arb_midref(a), ARF_RND_NEAR);
    sound = sound && g->sign[j] != 0;
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
    double (*estimate)(const struct growth *, slong);
    const char *method, *note;
  } methods[] = { { by_pade, "Pade", "nearest pole of the diagonal Pade approximant that the coefficients show" },
                  { by_ratio, "ratio", "ratio of neighbouring coefficients, extrapolated in 1/n (Domb and Sykes)" },
                  { by_root, "root", "n-th root, with a power of n taken out" } };
  struct terms t = terms_of(series, order);
  if (t.count < LEAST)
    return 0;
  struct growth g = { &t, precision, calloc((size_t)t.count, sizeof *g.size), calloc((size_t)t.count, sizeof *g.sign) };
  int found = 0;
  if (g.size && g.sign && take_logarithms(&g))
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
      struct radius_estimate *estimate = &e[found];
      *estimate = (struct radius_estimate){ .method = methods[i].method };
      snprintf(estimate->note, sizeof estimate->note, "%s", methods[i].note);
      found += set_estimate(estimate, methods[i].estimate, &g);
    }
  free(g.size);
  free(g.sign);
  return found;
}

int radius_estimates(struct radius_estimate e[RADIUS_METHODS], const struct series *series, slong order, slong precision)
{
  return radius_from_poles(e, series, order) == 1 ? 1 : radius_from_growth(e, series, order, precision);
}
