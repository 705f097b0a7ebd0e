/* What the tests of series and bounds share: random fractions, crawlers with exact parameters, and balls seen from
 * the outside. Header-only; needs FLINT. */
#ifndef SCALLOP_TESTS_SUPPORT_EXACT_H
#define SCALLOP_TESTS_SUPPORT_EXACT_H

#include "tests/support/random_crawler.h"
#include "tests/support/scoped.h"

/* A fraction of small numbers, in (0, 10) or with either sign */
static inline void random_positive(fmpq_t x, struct random *r)
{
  ulong below = 1 + (ulong)random_below(r, 9);
  fmpq_set_si(x, 1 + random_below(r, (int)below * 10 - 1), below);
}

static inline void random_fraction(fmpq_t x, struct random *r)
{
  fmpq_set_si(x, random_below(r, 41) - 20, 1 + (ulong)random_below(r, 9));
}

static inline double fraction_d(const fmpq_t x) { return fmpq_get_d(x); }

/* Every parameter of small numbers; alpha between 1/40 and 39/40 and not 1/2. T = 1. */
static inline void random_exact_crawler(struct scallop_rational_crawler *c, struct random *r,
                                        const struct scallop_gait *gait)
{
  fmpq *sizes[] = { c->m1, c->m2, c->F1, c->F2, c->L };
  for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
    random_positive(sizes[i], r);
  if (fmpq_equal(c->F1, c->F2))
    fmpq_add_si(c->F1, c->F1, 1);
  int of_forty = 1 + random_below(r, 38);
  fmpq_set_si(c->alpha, of_forty < 20 ? of_forty : of_forty + 1, 40);
  fmpq_set_si(c->T, 1, 1);
  c->gait = gait;
}

/* eps = T^2 (F1 + F2)/(M L) */
static inline double exact_eps(const struct scallop_rational_crawler *c)
{
  double T = fraction_d(c->T), M = fraction_d(c->m1) + fraction_d(c->m2);
  return T * T * (fraction_d(c->F1) + fraction_d(c->F2)) / (M * fraction_d(c->L));
}

/* T becomes a power of 2, the largest with eps at most this. */
static inline void set_small_T(struct scallop_rational_crawler *c, double eps)
{
  fmpq_set_si(c->T, 1, 1);
  int exponent = (int)floor(0.5 * log2(eps / exact_eps(c)));
  if (exponent < 0)
    fmpq_div_2exp(c->T, c->T, (flint_bitcnt_t)-exponent);
  else
    fmpq_mul_2exp(c->T, c->T, (flint_bitcnt_t)exponent);
}

static inline void print_exact_crawler(const struct scallop_rational_crawler *c)
{
  static const char *const names[] = { "m1", "m2", "F1", "F2", "L", "T", "alpha" };
  const fmpq *const all[] = { c->m1, c->m2, c->F1, c->F2, c->L, c->T, c->alpha };
  for (int i = 0; i < 7; i++) {
    char *text = fmpq_get_str(NULL, 10, all[i]);
    print_error("%s=%s ", names[i], text);
    flint_free(text);
  }
  print_error("%s\n", c->gait->name);
}

/* The largest and the smallest that |x| can be */
static inline double at_most(const arb_t x)
{
  SCOPED(arf, bound);
  arb_get_abs_ubound_arf(bound, x, 53);
  return arf_get_d(bound, ARF_RND_UP);
}

static inline double at_least(const arb_t x)
{
  SCOPED(arf, bound);
  arb_get_abs_lbound_arf(bound, x, 53);
  return arf_get_d(bound, ARF_RND_DOWN);
}

/* The first power from `from` on, below `to`, whose coefficient is not 0 for certain; `to` if there is none */
static inline slong next_nonzero(const struct series *s, slong from, slong to)
{
  SCOPED(arb, c);
  for (; from < to; from++) {
    series_coefficient(c, s, from, 64);
    if (!arb_contains_zero(c))
      break;
  }
  return from;
}

/* Both coefficients of x^power, as fractions if both are, and as balls that overlap otherwise */
static inline bool same_coefficient(const struct series *a, const struct series *b, slong power, slong precision)
{
  SCOPED(fmpq, p, q);
  SCOPED(arb, x, y);
  if (series_rational_coefficient(p, a, power) && series_rational_coefficient(q, b, power))
    return fmpq_equal(p, q);
  series_coefficient(x, a, power, precision);
  series_coefficient(y, b, power, precision);
  return arb_overlaps(x, y);
}

#endif
