/* What the tests of the certified solver share: balls seen from the outside, and modes. Header-only; needs FLINT. */
#ifndef CERTIFIED_BALLS_H
#define CERTIFIED_BALLS_H

#include "tests/scoped.h"
#include "tests/solved.h"

static inline double nearest(const arb_t x) { return arf_get_d(arb_midref(x), ARF_RND_NEAR); }

/* At least how far apart, seen from the outside: |x - y| with the radii of both. */
static inline double apart(const arb_t x, const arb_t y)
{
  SCOPED(arb, d);
  SCOPED(arf, most);
  arb_sub(d, x, y, 400);
  arb_get_abs_ubound_arf(most, d, 53);
  return arf_get_d(most, ARF_RND_UP);
}

/* Of the crawler with exactly these doubles, where there must be an answer */
static inline void certify_phase(struct scallop_certified_phase *p, const struct scallop_crawler *c, int kind, double v0,
                                 long digits)
{
  SCOPED(scallop_rational, exact);
  SCOPED(fmpq, start);
  scallop_rational_of(&exact, c);
  scallop_rational_set_double(start, v0);
  assert_int_equal(scallop_certified_phase(&exact, (enum scallop_phase_kind)kind, start, digits, p, NULL), SCALLOP_OK);
}

static inline void certify_steady(struct scallop_certified_steady *s, const struct scallop_crawler *c, long digits)
{
  SCOPED(scallop_rational, exact);
  scallop_rational_of(&exact, c);
  assert_int_equal(scallop_certified_steady(&exact, digits, s, NULL), SCALLOP_OK);
}

static inline void check_overlap(const arb_t x, const arb_t y, const char *what)
{
  if (!arb_overlaps(x, y))
    fail_msg("%s: %.17g and %.17g do not overlap", what, nearest(x), nearest(y));
}

#endif
