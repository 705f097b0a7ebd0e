/* Radius of convergence of a series: from the coefficients of a rational function, else from singularities of the
 * branch. */
#include <limits.h>
#include <math.h>
#include <stdio.h>

#include "compare/breakdown/motion.h"
#include "compare/text/progress.h"

enum { MAX_POLES = 12, CONFIRMED = 4 };

/* Finds the denominator q of the Pade approximant p/q with p and q of about the same length, by Euclid's algorithm for
 * z^count and the polynomial with `count` coefficients. used: number of coefficients that determine q; false: further
 * coefficients do not confirm it. */
static bool find_denominator(fmpz_poly_t denominator, slong *used, const fmpz_poly_t coefficients)
{
  const slong count = fmpz_poly_length(coefficients);
  SCOPED(fmpq_poly, p, before, q, last, quotient);
  fmpq_poly_set_fmpz_poly(p, coefficients);
  fmpq_poly_set_coeff_si(before, count, 1);
  fmpq_poly_one(q);
  while (2 * fmpq_poly_length(p) > count && fmpq_poly_degree(q) <= MAX_POLES) {
    fmpq_poly_divrem(quotient, before, before, p);
    fmpq_poly_swap(before, p);
    fmpq_poly_mul(quotient, quotient, q);
    fmpq_poly_sub(last, last, quotient);
    fmpq_poly_swap(last, q);
  }
  slong length = FLINT_MAX(fmpq_poly_length(p), fmpq_poly_degree(q));
  fmpq_poly_get_numerator(denominator, q);
  *used = 2 * length;
  return length <= MAX_POLES && count >= *used + CONFIRMED;
}

enum { PLACE = 120, PLACE_DIGITS = 10, PLACE_BITS = 128 };

/* Writes "T^2 = 3.0+-4.0 i": the equations are real, so the conjugate is singular too, and minus both if mirrored. */
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

/* Finds the nearest pole of a series of fractions: without its first powers, and terms that are 0 by symmetry, it is a
 * polynomial in z = T^stride; the pole is the root of its denominator with the least |z|. */
static bool find_pole(struct radius *r, const struct series *s, slong first, slong order)
{
  char place[PLACE];
  slong used, best = 0;
  SCOPED(fmpz_poly, a, q, common);
  SCOPED(arb, size, least);
  fmpq_poly_get_numerator(a, s->rational); /* a factor does not change the poles */
  fmpz_poly_truncate(a, order - s->first);
  fmpz_poly_shift_right(a, a, first - s->first);
  ulong stride = fmpz_poly_deflation(a);
  fmpz_poly_deflate(a, a, stride);
  if (!find_denominator(q, &used, a))
    return false;
  fmpz_poly_derivative(common, q);
  fmpz_poly_gcd(common, common, q);
  fmpz_poly_div(q, q, common); /* each root once */
  acb_ptr roots = _acb_vec_init(fmpz_poly_degree(q));
  arb_fmpz_poly_complex_roots(roots, q, 0, PLACE_BITS);
  for (slong i = 0; i < fmpz_poly_degree(q); i++) {
    acb_abs(size, roots + i, PLACE_BITS);
    if (i == 0 || arb_lt(size, least)) {
      arb_set(least, size);
      best = i;
    }
  }
  place_text(place, roots + best, (slong)stride, false);
  _acb_vec_clear(roots, fmpz_poly_degree(q));
  snprintf(r->note, sizeof r->note,
           "a pole at %s: the series is that of a rational function, with %ld coefficients more than that takes", place,
           (long)(fmpz_poly_length(a) - used));
  arb_root_ui(least, least, stride, PLACE_BITS);
  set_bounds(r, least, least);
  return true;
}

bool radius_from_poles(struct radius *r, const struct series *s, slong order)
{
  const slong end = FLINT_MIN(order, s->known);
  slong first = s->first;
  while (first < end && series_coefficient_is_zero(s, first))
    first++;
  *r = (struct radius){ .method = "poles", .T = INFINITY, .low = INFINITY, .high = INFINITY, .evidence = "exact" };
  snprintf(r->note, sizeof r->note, "every coefficient below T^%ld is 0", (long)order);
  return first >= end || (s->kind == SERIES_FRACTIONS && find_pole(r, s, first, end));
}

/* Returns the value on the branch that gives the quantity. */
static enum continued_value continued(enum quantity_id q)
{
  return q == Q_V_START                 ? AT_START
         : q == Q_V_MID || q == Q_V_END ? AFTER_FIRST_PHASE
         : q == Q_T1 || q == Q_DT       ? LAST_CROSSING
                                        : TRAVEL;
}

/* Follows a phase over its crossings; t1 depends on the first alone. */
static bool find_singularity(struct study *s, int crossings)
{
  const struct motion *m = &s->motion;
  if (s->crossings != crossings) {
    progress_show("singularities ...");
    s->crossings = crossings;
    s->has_singularity = (m->of == OF_STEADY
                              ? scallop_steady_singularity(&s->singularity, &s->crawler, PLACE_BITS, NULL)
                              : scallop_phase_singularity(&s->singularity, &s->crawler, m->phase, s->v0, crossings,
                                                          PLACE_BITS, NULL))
                         == SCALLOP_OK;
  }
  return s->has_singularity;
}

bool radius_from_branch(struct radius *r, struct study *study, enum quantity_id quantity)
{
  const struct scallop_singularity *s = &study->singularity;
  char place[PLACE] = "";
  if (!find_singularity(study, quantity == Q_T1 ? 1 : INT_MAX))
    return false;
  if (s->found)
    place_text(place, s->place, s->power, s->even);
  bool shows = s->found && s->shows[continued(quantity)];
  *r = (struct radius){ .method = shows ? "singularity" : "bound", .evidence = "certified" };
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
  return true;
}

bool radius_of(struct radius *r, struct study *study, enum quantity_id quantity)
{
  const struct series *s = study_many(study, quantity);
  if (s && (radius_from_poles(r, s, STUDY_MANY) || radius_from_branch(r, study, quantity)))
    return true;
  *r = (struct radius){ "-", NAN, NAN, NAN, "-", "there is no derived series" };
  return false;
}
