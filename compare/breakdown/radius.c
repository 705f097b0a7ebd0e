/* The radius of convergence of a series: from its coefficients, where they are those of a rational function; else from
 * the singularities of the branch. */
#include <limits.h>
#include <math.h>
#include <stdio.h>

#include "compare/breakdown/radius.h"

SCOPED_FLINT(fmpz_poly)

/* sum over j of a_j T^(first + stride j), j < count: the terms that are not 0 by symmetry */
struct terms {
  slong first, stride, count;
  const struct series *series;
};

static slong gcd(slong a, slong b) { return b == 0 ? a : gcd(b, a % b); }

static struct terms terms_of(const struct series *s, slong order)
{
  struct terms t = { .series = s };
  for (slong k = s->first; k < order && k < s->known; k++) {
    if (series_coefficient_is_zero(s, k))
      continue;
    if (t.count == 0)
      t.first = k;
    t.stride = gcd(k - t.first, t.stride);
    t.count = t.stride > 0 ? (k - t.first) / t.stride + 1 : 1; /* with those between, so far */
  }
  return t;
}

enum { MOST_POLES = 12, CONFIRMED = 4 };

/* The shortest linear recurrence of a[count] (Berlekamp and Massey, over the rationals): sum over k of c_k a[n - k] =
 * 0, c_0 = 1. Returns its length, or -1 if it is longer than MOST_POLES. */
static slong recurrence(fmpq_poly_t c, const fmpq *a, slong count)
{
  slong length = 0, shift = 1;
  SCOPED(fmpq_poly, last, next);
  SCOPED(fmpq, d, before, x);
  fmpq_poly_one(c);
  fmpq_poly_one(last);
  fmpq_one(before);
  for (slong n = 0; n < count && length <= MOST_POLES; n++, shift++) {
    fmpq_zero(d);
    for (slong k = 0; k <= length; k++) {
      fmpq_poly_get_coeff_fmpq(x, c, k);
      fmpq_addmul(d, x, &a[n - k]);
    }
    if (fmpq_is_zero(d))
      continue;
    fmpq_div(x, d, before);
    fmpq_poly_shift_left(next, last, shift);
    fmpq_poly_scalar_mul_fmpq(next, next, x);
    fmpq_poly_sub(next, c, next);
    if (2 * length <= n) {
      length = n + 1 - length;
      fmpq_poly_swap(last, c);
      fmpq_set(before, d);
      shift = 0;
    }
    fmpq_poly_swap(c, next);
  }
  return length <= MOST_POLES ? length : -1;
}

enum { PLACE = 120, PLACE_DIGITS = 10, PLACE_BITS = 128 };

/* "T^2 = 3.0+-4.0 i": the equations are real, so the conjugate is a singularity too, and so is minus both if
 * mirrored. */
static void place_text(char text[PLACE], const acb_t z, slong power, bool mirrored)
{
  char *re = arb_get_str(acb_realref(z), PLACE_DIGITS, ARB_STR_NO_RADIUS),
       *im = arb_get_str(acb_imagref(z), PLACE_DIGITS, ARB_STR_NO_RADIUS);
  const char *size = *im == '-' ? im + 1 : im, *left = mirrored && *re == '-' ? re + 1 : re,
             *sign = mirrored ? "+-" : "";
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
  SCOPED(arf, end);
  r->T = arf_get_d(arb_midref(high), ARF_RND_NEAR);
  arb_get_lbound_arf(end, low, PLACE_BITS);
  r->low = arf_get_d(end, ARF_RND_FLOOR);
  arb_get_ubound_arf(end, high, PLACE_BITS);
  r->high = arf_get_d(end, ARF_RND_CEIL);
}

/* The root of q with the least |z| */
static void nearest_root(struct radius *r, const fmpz_poly_t q, const struct terms *t, slong length)
{
  slong degree = fmpz_poly_degree(q);
  acb_ptr roots = _acb_vec_init(degree);
  char place[PLACE];
  SCOPED(arb, size, least);
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
  _acb_vec_clear(roots, degree);
}

static bool by_poles(struct radius *r, const struct terms *t)
{
  fmpq *a = _fmpq_vec_init(t->count);
  bool found = true;
  SCOPED(fmpq_poly, q);
  SCOPED(fmpz_poly, whole, common);
  for (slong j = 0; j < t->count && found; j++)
    found = series_rational_coefficient(&a[j], t->series, t->first + j * t->stride);
  slong length = found ? recurrence(q, a, t->count) : -1;
  found = length > 0 && t->count >= 2 * length + CONFIRMED;
  if (found) {
    fmpq_poly_get_numerator(whole, q);
    fmpz_poly_derivative(common, whole);
    fmpz_poly_gcd(common, common, whole);
    fmpz_poly_div(whole, whole, common); /* each root once */
    snprintf(r->note, sizeof r->note, "the series ends: a polynomial in T");
    if (fmpz_poly_degree(whole) > 0)
      nearest_root(r, whole, t, length);
  }
  _fmpq_vec_clear(a, t->count);
  return found;
}

bool radius_from_poles(struct radius *r, const struct series *series, slong order)
{
  struct terms t = terms_of(series, order);
  *r = (struct radius){ .method = "poles", .T = INFINITY, .low = INFINITY, .high = INFINITY, .status = "exact" };
  snprintf(r->note, sizeof r->note, "every coefficient below T^%ld is 0", (long)order);
  return t.count == 0 || (t.count > 1 && by_poles(r, &t));
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
  const struct motion *m = e->motion;
  return SCALLOP_OK
         == (m->of == OF_STEADY ? scallop_steady_singularity(s, &e->crawler, PLACE_BITS, NULL)
                                : scallop_phase_singularity(s, &e->crawler, m->phase, e->v0,
                                                            first_crossing ? 1 : INT_MAX, PLACE_BITS, NULL));
}
