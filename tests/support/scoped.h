/* All that can be SCOPED (model/exact/scoped.h). Header-only; needs FLINT. */
#ifndef SCALLOP_TESTS_SUPPORT_SCOPED_H
#define SCALLOP_TESTS_SUPPORT_SCOPED_H

#include "asymptotics/derived/scoped.h"
#include "numerics/certified/certify.h"

static inline double middle(const arb_t x) { return arf_get_d(arb_midref(x), ARF_RND_NEAR); }

#endif
