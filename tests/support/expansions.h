/* What the tests of derived expansions share: gaits that have them, expansions to compare, and comparing them.
 * Header-only; needs FLINT. */
#ifndef SCALLOP_TESTS_SUPPORT_EXPANSIONS_H
#define SCALLOP_TESTS_SUPPORT_EXPANSIONS_H

#include "asymptotics/derived/derived.h"
#include "tests/support/exact.h"

enum { PRECISION = 400, ORDER = 14, PHASE = 8, STEADY = 3 };

static const struct scallop_gait *const gaits[] = { &scallop_gait_quadratic, &scallop_gait_sinusoidal, &trapezoid_gait,
                                                    &minimum_jerk_gait };
enum { REVERSIBLE = 2, WITH_SERIES_OF_PHASES = 3, GAITS = 4 };

static inline struct series *phase_series(struct scallop_expansion *e, int i)
{
  struct series *const all[PHASE] = { &e->v_end, &e->dx1, &e->dx2,           &e->dxC,
                                      &e->t1,    &e->dT,  &e->rear_at_first, &e->rear_at_last };
  return all[i];
}
static const int phase_length[PHASE] = { 0, 1, 1, 1, 0, 0, 1, 1 }; /* v_end: length/time, dx: length, t: time */
static const int phase_time[PHASE] = { -1, 0, 0, 0, 1, 1, 0, 0 };

static inline struct series *steady_series(struct scallop_expansion *e, int i)
{
  struct series *const all[STEADY] = { &e->v_start, &e->v_mid, &e->displacement };
  return all[i];
}

static inline bool expand_phase(struct scallop_expansion *e, const struct scallop_rational_crawler *c, int kind,
                                const fmpq_t v0, slong order)
{
  return scallop_expand_phase(c, (enum scallop_phase_kind)kind, v0, order, PRECISION, NULL, e, NULL) == SCALLOP_OK;
}

static inline bool expand_steady(struct scallop_expansion *e, const struct scallop_rational_crawler *c, slong order)
{
  return scallop_expand_steady(c, order, PRECISION, e, NULL) == SCALLOP_OK;
}

/* b = factor unit^power a for the coefficients of every x^power below order */
static inline void check_scaled(const struct series *a, const struct series *b, const fmpq_t factor, const fmpq_t unit,
                                slong order, const char *what)
{
  const struct ring ring = { ORDER + 4, PRECISION };
  SCOPED(fmpq, f);
  SCOPED(series, scaled);
  assert_true(a->known >= order && b->known >= order);
  for (slong k = -1; k < order; k++) {
    fmpq_pow_si(f, unit, k);
    fmpq_mul(f, f, factor);
    series_scale(&scaled, a, f, &ring);
    if (!same_coefficient(&scaled, b, k, PRECISION) || a->kind != b->kind)
      fail_msg("%s: T^%ld", what, (long)k);
  }
}

static inline void check_equal(const struct series *a, const struct series *b, int sign, slong order, const char *what)
{
  SCOPED(fmpq, factor, unit);
  fmpq_set_si(factor, sign, 1);
  fmpq_set_si(unit, 1, 1);
  check_scaled(a, b, factor, unit, order, what);
}

struct pair {
  struct scallop_rational_crawler crawler[2];
  struct scallop_expansion phase[2];
  struct scallop_expansion steady[2];
  fmpq_t v0[2];
};
static inline void pair_init(struct pair *p)
{
  for (int i = 0; i < 2; i++) {
    scallop_rational_init(&p->crawler[i]);
    scallop_expansion_init(&p->phase[i]);
    scallop_expansion_init(&p->steady[i]);
    fmpq_init(p->v0[i]);
  }
}
static inline void pair_clear(struct pair *p)
{
  for (int i = 0; i < 2; i++) {
    scallop_rational_clear(&p->crawler[i]);
    scallop_expansion_clear(&p->phase[i]);
    scallop_expansion_clear(&p->steady[i]);
    fmpq_clear(p->v0[i]);
  }
}
SCOPED_KIND(pair, struct pair)

/* The same crawler twice, and a start velocity of any sign or 0 */
static inline void draw(struct pair *p, struct random *r, const struct scallop_gait *gait)
{
  random_exact_crawler(&p->crawler[0], r, gait);
  scallop_rational_copy(&p->crawler[1], &p->crawler[0]);
  random_fraction(p->v0[0], r);
  if (random_below(r, 3) == 0)
    fmpq_zero(p->v0[0]);
  fmpq_set(p->v0[1], p->v0[0]);
}

#endif
