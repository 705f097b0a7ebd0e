/* What the tests of derived expansions share: random motions with their expansions.
 * Header-only; needs FLINT. */
#ifndef SCALLOP_TESTS_SUPPORT_EXPANSIONS_H
#define SCALLOP_TESTS_SUPPORT_EXPANSIONS_H

#include "asymptotics/derived/derived.h"
#include "tests/support/exact.h"

enum { PRECISION = 400, ORDER = 14 };

/* The first of every_gait; all SMOOTH_GAITS have a series of the steady state */
enum { REVERSIBLE = 2, WITH_SERIES_OF_PHASES = 3 };

struct subject {
  struct scallop_rational_crawler crawler;
  fmpq_t v0;
  struct scallop_expansion phase;
  struct scallop_expansion steady;
};
#define SUBJECT(of) \
  of(scallop_rational, &s->crawler) of(fmpq, s->v0) of(scallop_expansion, &s->phase) of(scallop_expansion, &s->steady)
SCOPED_PARTS(subject, struct subject, SUBJECT)

/* A start velocity of any sign or 0 */
static inline void draw(struct subject *s, struct random *r, const struct scallop_gait *gait)
{
  random_exact_crawler(&s->crawler, r, gait);
  random_fraction(s->v0, r);
  if (random_below(r, 3) == 0)
    fmpq_zero(s->v0);
}

static inline void expand_phase(struct subject *s, int kind, slong order)
{
  assert_int_equal(
      scallop_expand_phase(&s->crawler, (enum scallop_phase_kind)kind, s->v0, order, PRECISION, NULL, &s->phase, NULL),
      SCALLOP_OK);
}

static inline bool expand_steady(struct subject *s, slong order)
{
  return scallop_expand_steady(&s->crawler, order, PRECISION, &s->steady, NULL) == SCALLOP_OK;
}

#endif
