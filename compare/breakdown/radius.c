/* The radius of convergence of a series: from its coefficients, where they are those of a rational function; else from the singularities of
 * the branch. */
#include <limits.h>
#include <math.h>
#include <stdio.h>

#include "compare/breakdown/radius.h"

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

enum { PLACE = 120, PLACE_DIGITS = 10, PLACE_BITS = 128 };

/* "T^2 = 3.0+-4.0 i": the equations are real, so the conjugate is a singularity too, and so is minus both if mirrored. */
static void place_text(char text[PLACE], const acb_t z, slong power, bool mirrored)
{
  char *re = arb_get_str(acb_realref(z), PLACE_DIGITS, ARB_STR_NO_RADIUS),
       *im = arb_get_str(acb_imagref(z), PLACE_DIGITS, ARB_STR_NO_RADIUS);
  const char *size = *im == '-' ? im + 1 : im, *left = mirrored && *re == '-' ? re + 1 : re, *sign = mirrored ? "+-" : "";
  int used = power == 1 ? snprintf(text, PLACE, "T = ") : snprintf(text, PLACE, "T^%ld = ", (long)power);
  char *rest = text + used;
  size_t room = PLACE - (size_t)used;
  if (arb_contains_zero(acb_imagref(z)))
    snprintf(rest, room, "%s%s", sign, left);
  else if (arb_contains_zero(acb_realref(z)))
    snprintf(rest, room, "+-%s i", size);
  else
    snprintf(rest, room, "%s%s +- %s i", sign, left, size);
  flint_free(re);
  flint_free(im);
}

static void set_bounds(struct radius *r, const arb_t low, const arb_t high)
{
  arf_t end;
  arf_init(end);
  r->T = arf_get_d(arb_midref(high), ARF_RND_NEAR);
  arb_get_lbound_arf(end, low, PLACE_BITS);
  r->low = arf_get_d(end, ARF_RND_FLOOR);
  arb_get_ubound_arf(end, high, PLACE_BITS);
  r->high = arf_get_d(end, ARF_RND_CEIL);
  arf_clear(end);
}

/* The root of q with the least |z| */
static void nearest_root(struct radius *r, const fmpz_poly_t q, const struct terms *t, slong length)
{
  slong degree = fmpz_poly_degree(q);
  acb_ptr roots = _acb_vec_init(degree);
  arb_t size, least;
  char place[PLACE];
  arb_init(size);
  arb_init(least);
  arb_fmpz_poly_complex_roots(roots, q, 0, PLACE_BITS);
  slong best = 0;
  for (slong i = 0; i < degree; i++) {
    acb_abs(size, roots + i, PLACE_BITS);
    if (i == 0 || arb_lt(size, least)) {
      arb_set(least, size);
      best = i;
    }
  }
  place_text(place, roots + best, t->stride, false);
  snprintf(r->note, sizeof r->note,
           "a pole at %s: the series is that of a rational function, with %ld coefficients more than that takes", place,
           (long)(t->count - 2 * length));
  arb_root_ui(least, least, (ulong)t->stride, PLACE_BITS);
  set_bounds(r, least, least);
  arb_clear(size);
  arb_clear(least);
  _acb_vec_clear(roots, degree);
}

static bool by_poles(struct radius *r, const struct terms *t)
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
    *r = (struct radius){ .method = "poles", .T = INFINITY, .low = INFINITY, .high = INFINITY, .status = "exact" };
    if (fmpz_poly_degree(whole) > 0)
      nearest_root(r, whole, t, length);
    else
      snprintf(r->note, sizeof r->note, "the series ends: a polynomial in T");
    fmpq_poly_clear(q);
    fmpz_poly_clear(whole);
    fmpz_poly_clear(common);
  }
  _fmpq_vec_clear(a, t->count);
  _fmpq_vec_clear(c, SIZE);
  return found;
}

static bool is_zero(const struct series *s, slong order)
{
  for (slong k = s->first; k < order && k < s->known; k++)
    if (!series_coefficient_is_zero(s, k))
      return false;
  return true;
}

bool radius_from_poles(struct radius *r, const struct series *series, slong order)
{
  struct terms t = terms_of(series, order);
  if (is_zero(series, order)) {
    *r = (struct radius){ .method = "poles", .T = INFINITY, .low = INFINITY, .high = INFINITY, .status = "exact" };
    snprintf(r->note, sizeof r->note, "every coefficient below T^%ld is 0", (long)order);
    return true;
  }
  return t.count > 0 && by_poles(r, &t);
}

static enum continued_value continued(enum quantity_id quantity)
{
  switch (quantity) {
  case Q_V_START: return AT_START;
  case Q_V_MID:
  case Q_V_END: return AFTER_FIRST_PHASE;
  case Q_T1:
  case Q_DT: return LAST_CROSSING;
  default: return TRAVEL;
  }
}

void radius_from_singularity(struct radius *r, const struct scallop_singularity *s, enum quantity_id quantity)
{
  char place[PLACE] = "";
  if (s->found)
    place_text(place, s->place, s->power, s->even);
  bool shows = s->found && s->shows[continued(quantity)];
  *r = (struct radius){ .method = shows ? "singularity" : "bound", .status = "certified" };
  set_bounds(r, s->low, shows ? s->T : s->low);
  if (!shows)
    snprintf(r->note, sizeof r->note, "the series converges at least below this T; %s%s",
             s->found ? "not shown to be singular at the branch point " : "no singularity was found", place);
  else if (r->high - r->low <= 1e-12 * r->high)
    snprintf(r->note, sizeof r->note, "a branch point at %s, and no singularity nearer: both are proven", place);
  else
    snprintf(r->note, sizeof r->note,
             "a branch point at %s is proven, and no singularity below T = %.6g; between them nothing nearer was found",
             place, r->low);
}

bool singularity_of(struct scallop_singularity *s, const struct expansions *e, bool first_crossing)
{
  fmpq_t v0;
  fmpq_init(v0);
  scallop_rational_set_double(v0, e->motion->v0);
  enum scallop_status status = e->motion->of == OF_STEADY
                                   ? scallop_steady_singularity(s, &e->crawler, PLACE_BITS, NULL)
                                   : scallop_phase_singularity(s, &e->crawler, e->motion->phase, v0,
                                                               first_crossing ? 1 : INT_MAX, PLACE_BITS, NULL);
  fmpq_clear(v0);
  return status == SCALLOP_OK;
}
