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

static inline void check_overlap(const arb_t x, const arb_t y, const char *what)
{
  if (!arb_overlaps(x, y)) {
    print_error("%s: %.17g and %.17g do not overlap\n", what, nearest(x), nearest(y));
    fail();
  }
}

#endif
