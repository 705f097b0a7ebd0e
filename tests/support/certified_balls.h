/* What the tests of the certified solver share: balls seen from the outside, and modes. Header-only; needs FLINT. */
#ifndef SCALLOP_TESTS_SUPPORT_CERTIFIED_BALLS_H
#define SCALLOP_TESTS_SUPPORT_CERTIFIED_BALLS_H

#include <stdio.h>

#include "numerics/wide/wide.h"
#include "tests/support/random_crawler.h"
#include "tests/support/scoped.h"
#include "tests/support/solved.h"

/* At least how far apart, seen from the outside: |x - y| with the radii of both. */
static inline double apart(const arb_t x, const arb_t y)
{
  SCOPED(arb, d);
  SCOPED(arf, most);
  arb_sub(d, x, y, 400);
  arb_get_abs_ubound_arf(most, d, 53);
  return arf_get_d(most, ARF_RND_UP);
}

/* "m1 m2 F1 F2 L T alpha": each an integer, or a fraction like 6/7, or a decimal */
static inline void crawler_of_fractions(struct scallop_rational_crawler *c, const char *text,
                                        const struct scallop_gait *gait)
{
  fmpq *const to[PARAMETERS] = { c->m1, c->m2, c->F1, c->F2, c->L, c->T, c->alpha };
  char number[80];
  for (int i = 0, length; i < PARAMETERS; i++, text += length) {
    assert_int_equal(sscanf(text, "%79s%n", number, &length), 1);
    assert_true(strchr(number, '/') ? fmpq_set_str(to[i], number, 10) == 0 : scallop_rational_parse(to[i], number));
  }
  c->gait = gait;
}

static inline void certified(enum scallop_status status, const char *why, const struct scallop_crawler *c)
{
  if (status == SCALLOP_OK)
    return;
  print_crawler(c);
  fail_msg("%s", why);
}

/* Of the crawler with exactly these doubles, where there must be an answer */
static inline void certify_phase(struct scallop_certified_phase *p, const struct scallop_crawler *c, int kind,
                                 double v0, long digits)
{
  const char *why = "";
  SCOPED(scallop_rational, exact);
  SCOPED(fmpq, start);
  scallop_rational_of(&exact, c);
  scallop_rational_set_double(start, v0);
  certified(scallop_certified_phase(&exact, (enum scallop_phase_kind)kind, start, digits, p, &why), why, c);
}

static inline void certify_steady(struct scallop_certified_steady *s, const struct scallop_crawler *c, long digits)
{
  const char *why = "";
  SCOPED(scallop_rational, exact);
  scallop_rational_of(&exact, c);
  certified(scallop_certified_steady(&exact, digits, s, &why), why, c);
}

static inline void check_overlap(const arb_t x, const arb_t y, const char *what)
{
  if (!arb_overlaps(x, y))
    fail_msg("%s: %.17g and %.17g do not overlap", what, middle(x), middle(y));
}

#endif
