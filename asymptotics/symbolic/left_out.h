/* The difference between the derived expansion and a formula of asymptotics.h, as a formula: a proof for all
 * parameters. */
#ifndef SCALLOP_ASYMPTOTICS_SYMBOLIC_LEFT_OUT_H
#define SCALLOP_ASYMPTOTICS_SYMBOLIC_LEFT_OUT_H

#include "asymptotics/asymptotics.h"
#include "asymptotics/formula.h"
#include "asymptotics/symbolic/symbolic.h"

struct left_out {
  /* power of the first term of derived - formula that is not always 0; most + 1: all are 0 up to T^most */
  slong order;
  char *term;         /* this term in the language of formula.h, or NULL; the caller frees it */
  bool is_number;     /* its coefficient for this crawler is a fraction */
  fmpq_t coefficient; /* value if is_number */
};
void left_out_init(struct left_out *l);
void left_out_clear(struct left_out *l);

/* Derives the difference for the steady state, a phase from rest, or a phase from v0 (by the sign of v0), and for every
 * crawler of this gait with the modes of this crawler as T -> 0. m1, m2, F1, F2, L, alpha, v0 and pi are names; F1 and
 * F2 are the same name if they are equal in a phase from rest, or by a condition of the formula. The term holds for
 * every gait with these modes if the lower terms are 0 for all of them.
 *
 * Returns NULL, or `message`, the reason of a failure: the expansion has no formulas (symbolic_expand_phase,
 * symbolic_solve_steady), or the formula has no series (formula_series); the quantity is friction work; or most is not
 * below SYMBOLIC_ORDERS. */
const char *symbolic_left_out(struct left_out *l, const struct scallop_formula *formula,
                              const struct scallop_rational_crawler *crawler, enum scallop_phase_kind kind,
                              const fmpq_t v0, slong most, char message[FORMULA_MESSAGE]);

#endif
