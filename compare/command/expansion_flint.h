/* Expansion of a motion in powers of T: its quantities as series with coefficients that are numbers, with certified
 * values, or formulas. Needs FLINT. */
#ifndef SCALLOP_COMPARE_COMMAND_EXPANSION_FLINT_H
#define SCALLOP_COMPARE_COMMAND_EXPANSION_FLINT_H

#include "asymptotics/symbolic/symbolic.h"
#include "compare/answers/answer_flint.h"

struct expansion {
  /* Input: the crawler in decimals as typed; its period, a phase from v0, or the limit T -> 0 in powers of a parameter;
   * the terms are those below T^order */
  const struct scallop_rational_crawler *crawler;
  enum quantity_of of;
  enum scallop_phase_kind kind;
  const fmpq *v0;
  enum limit_parameter in;
  long order;
  /* Numbers: digits of coefficients that are not fractions; certified values are computed */
  long digits;
  bool is_certified;
  bool is_closed;          /* formulas of the steady state: closed forms, each as the term of T^0 */
  struct symbols *symbols; /* of the coefficients, initialised, and freed after the expansion; for numbers T alone */

  /* Result: status, why, quantities and modes */
  struct series_answer derived;
  struct symbolic_steady closed;
  struct symbolic_limit limit; /* U = v_start T, in the place of v_start */
  /* Result in numbers: T, exact values with the precision that errors of the sums require, and their status */
  fmpq_t T;
  arb_t at;
  struct ball_answer exact;
  slong precision;
  char status[2 * SCALLOP_MODES_TEXT + 240];
};
#define EXPANSION(of) \
  of(series_answer, &s->derived) of(symbolic_limit, &s->limit) of(fmpq, s->T) of(arb, s->at) of(ball_answer, &s->exact)
SCOPED_PARTS(expansion, struct expansion, EXPANSION)

typedef void expander(struct expansion *e);
expander expand_numbers, expand_formulas, expand_limit;

/* Returns the bits of a number of decimal digits. */
static inline slong bits_of_digits(long digits) { return (slong)(3.33 * (double)digits); }

#endif
