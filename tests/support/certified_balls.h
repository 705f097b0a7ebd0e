/* What the tests of the certified solver share: balls seen from the outside, and modes. Header-only; needs FLINT. */
#ifndef SCALLOP_TESTS_SUPPORT_CERTIFIED_BALLS_H
#define SCALLOP_TESTS_SUPPORT_CERTIFIED_BALLS_H

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

/* A double beside the certified number */
static inline void check_number(double got, const arb_t wanted, double tolerance, const struct scallop_crawler *c,
                                const char *what)
{
  if (fabs(got - middle(wanted)) <= tolerance)
    return;
  print_crawler(c);
  fail_msg("%s: %.17g, and %.17g is wanted", what, got, middle(wanted));
}

/* binary128 beside it */
static inline void check_wide(const struct scallop_wide *got, const arb_t wanted, double tolerance,
                              const struct scallop_crawler *c)
{
  SCOPED(arb, value, low);
  arb_set_d(value, got->high);
  arb_set_d(low, got->low);
  arb_add(value, value, low, 400);
  double far = apart(value, wanted);
  if (far <= tolerance)
    return;
  print_crawler(c);
  fail_msg("binary128: %.17g, off by %.3g", got->high, far);
}

static inline void check_overlap(const arb_t x, const arb_t y, const char *what)
{
  if (!arb_overlaps(x, y))
    fail_msg("%s: %.17g and %.17g do not overlap", what, middle(x), middle(y));
}

#endif
