/* What a formula of asymptotics.h leaves out of the derived expansion, as a formula: a proof for all parameters. */
#ifndef SCALLOP_ASYMPTOTICS_SYMBOLIC_LEFT_OUT_H
#define SCALLOP_ASYMPTOTICS_SYMBOLIC_LEFT_OUT_H

#include "asymptotics/asymptotics.h"
#include "asymptotics/formula.h"
#include "asymptotics/symbolic/symbolic.h"

struct left_out {
  /* of the first term of derived - formula that is not 0 for all parameters; most + 1: there is none up to T^most */
  slong order;
  char *term;         /* that term, in the language of formula.h, or NULL; to be freed with free                 */
  bool is_number;     /* its coefficient is a fraction for this crawler                                   */
  fmpq_t coefficient; /* then that                                                                    */
};
void left_out_init(struct left_out *l);
void left_out_clear(struct left_out *l);

/* Of the steady state, of a phase from rest, or of one from v0, whose sign counts, for every crawler of this gait that
 * has the modes of this one as T -> 0: m1, m2, F1, F2, L, alpha, v0 and pi are names, F1 and F2 the same one from rest
 * where they are equal, and where a condition of the formula says so. The term is about every gait with those modes,
 * where the lower terms are 0 for all of these.
 *
 * Returns NULL, or `message`: why this is not known. The expansion has no formulas (symbolic_expand_phase,
 * symbolic_solve_steady), or the formula (formula_symbolic); it gives the friction work; or most is not below
 * SYMBOLIC_ORDERS. */
const char *symbolic_left_out(struct left_out *l, const struct scallop_formula *formula,
                              const struct scallop_rational_crawler *crawler, enum scallop_phase_kind kind,
                              const fmpq_t v0, slong most, char message[FORMULA_MESSAGE]);

#endif
