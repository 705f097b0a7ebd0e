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
/* The same in two steps: all but the positions, which are nan, and those, which take a second walk through the phase. */
enum scallop_status exact_phase_start(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0,
                                      struct exact_phase *exact);
enum scallop_status exact_phase_turnings(const struct scallop_crawler *crawler, struct exact_phase *exact);
/* nan where the motion has no such quantity (no switch), and for the steady ones */
double exact_quantity(const struct exact_phase *exact, enum scallop_quantity quantity);

/* A formula of one phase at the point of that phase; what it takes as given comes from the exact motion,
 * and a formula from rest is carried to a contraction by exchanging the bodies. */
double published_value(const struct scallop_formula *formula, const struct scallop_phase_point *point,
                       const struct exact_phase *exact);

/* "x1(T-dT)", "dT": what a formula gives, in the names of the bodies of that phase */
const char *formula_quantity_text(const struct scallop_formula *formula, enum scallop_phase_kind kind);

/* The modes of both phases, "++ -+ ++ | ++ +- ++". Returns text. */
enum { PERIOD_MODES_TEXT = 2 * SCALLOP_MODES_TEXT + 4 };
const char *period_modes_text(char text[PERIOD_MODES_TEXT], const struct scallop_modes modes[2]);

/* What `steady` says of a solved steady state in the column status: ok, or which interval of them there is. */
enum { STEADY_STATUS = 160 };
const char *steady_status_text(char text[STEADY_STATUS], enum scallop_status status, double v_low, double v_high);

#endif
