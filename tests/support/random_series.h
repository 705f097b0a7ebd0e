/* What the tests of series arithmetic share: random series, and comparing them. Header-only; needs FLINT. */
#ifndef SCALLOP_TESTS_SUPPORT_RANDOM_SERIES_H
#define SCALLOP_TESTS_SUPPORT_RANDOM_SERIES_H

#include "tests/support/exact.h"

enum { PRECISION = 200, LENGTH = 9, FAR = 60 }; /* FAR: beyond every power that is looked at */

static const struct ring ring = { LENGTH, PRECISION }, longer = { 3 * LENGTH, PRECISION };

static inline slong least(slong a, slong b) { return a < b ? a : b; }

/* Random terms from x^first on, the first of which is not 0; an even series now and then, for the zeros in between. */
static inline void random_terms(struct series *s, struct random *r, slong first, slong terms)
{
  SCOPED(fmpq_poly, poly);
  SCOPED(fmpq, c);
  slong step = 1 + random_below(r, 4) / 3;
  for (slong k = 0; k < terms; k += step) {
    random_fraction(c, r);
    if (k == 0 && fmpq_is_zero(c))
      fmpq_one(c);
    fmpq_poly_set_coeff_fmpq(poly, k, c);
  }
  series_set_rational_poly(s, poly, SERIES_ALL);
  series_shift(s, s, first);
}

/* Of which everything is known, or only the first few terms */
static inline void random_series(struct series *s, struct random *r, slong first)
{
  random_terms(s, r, first, 1 + random_below(r, LENGTH));
  if (random_below(r, 2))
    series_truncate(s, first + 1 + random_below(r, LENGTH));
}

/* Each coefficient times a power of pi, one way or another */
static inline void bring_in_pi(struct series *s, struct random *r)
{
  SCOPED(series, pi);
  const slong first = s->first, known = s->known;
  series_set_pi_poly(s, s->rational, random_below(r, 3), random_below(r, 3), SERIES_ALL);
  s->first = first;
  s->known = known;
  series_set_pi(&pi, NULL);
  if (random_below(r, 2))
    series_div(s, s, &pi, &longer);
  else
    series_add(s, s, &pi, &longer);
}

/* The same numbers as balls */
static inline void as_balls(struct series *to, const struct series *from)
{
  SCOPED(arb_poly, poly);
  SCOPED(arb, c);
  for (slong k = 0; k < series_terms(from); k++) {
    series_coefficient(c, from, from->first + k, PRECISION);
    arb_poly_set_coeff_arb(poly, k, c);
  }
  series_set_ball_poly(to, poly, SERIES_ALL);
  series_shift(to, to, from->first);
  series_truncate(to, from->known);
}

/* All coefficients that both know are the same. The lowest power of interest: -FAR. */
static inline void check_same(const struct series *a, const struct series *b, const char *what)
{
  slong known = least(least(a->known, b->known), FAR);
  for (slong k = -FAR; k < known; k++)
    if (!same_coefficient(a, b, k, PRECISION))
      fail_msg("%s: the coefficients of x^%ld differ", what, (long)k);
}

/* ... and s knows at least so many */
static inline void check_known(const struct series *s, slong known, const char *what)
{
  if (s->known < known)
    fail_msg("%s: known below x^%ld, not x^%ld", what, (long)s->known, (long)known);
}

/* Series to work with: SCOPED(work, w) */
enum { WORK = 8 };
typedef struct series scoped_work[WORK];
static inline void scoped_begin_work(scoped_work *w)
{
  for (int i = 0; i < WORK; i++)
    series_init(&(*w)[i]);
}
static inline void scoped_end_work(scoped_work *w)
{
  for (int i = 0; i < WORK; i++)
    series_clear(&(*w)[i]);
}

#endif
