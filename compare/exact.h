/* The exact counterpart of what a published formula gives. */
#ifndef SCALLOP_EXACT_H
#define SCALLOP_EXACT_H

#include "asymptotics/asymptotics.h"
#include "numerics/numerics.h"

struct exact_phase {
  enum scallop_phase_kind kind;
  double v0;
  struct scallop_phase_result phase;
  double at_first, at_last; /* position of the rear body, from its start, at the first and at the last change of mode */
};

enum scallop_status exact_phase_solve(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0,
                                      struct exact_phase *exact);
/* nan where the motion has no such quantity (no switch), and for the steady ones */
double exact_quantity(const struct exact_phase *exact, enum scallop_quantity quantity);

/* A formula of one phase at the point of that phase; what it takes as given comes from the exact motion,
 * and a formula from rest is carried to a contraction by exchanging the bodies. */
double published_value(const struct scallop_formula *formula, const struct scallop_phase_point *point,
                       const struct exact_phase *exact);

/* "x1(T-dT)", "dT": what a formula gives, in the names of the bodies of that phase */
const char *formula_quantity_text(const struct scallop_formula *formula, enum scallop_phase_kind kind);

#endif
