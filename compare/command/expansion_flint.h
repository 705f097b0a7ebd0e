/* A motion in powers of T: its quantities as series, whose coefficients are numbers, beside certified values, or
 * formulas. Needs FLINT. */
#ifndef SCALLOP_COMPARE_COMMAND_EXPANSION_FLINT_H
#define SCALLOP_COMPARE_COMMAND_EXPANSION_FLINT_H

#include "asymptotics/symbolic/symbolic.h"
#include "compare/answers/answer_flint.h"

struct expansion {
  /* Of what: the crawler as it was written, its period or a phase from v0, or the limit T -> 0 in powers of a
   * parameter; the terms below T^order */
  const struct scallop_rational_crawler *crawler;
  enum quantity_of of;
  enum scallop_phase_kind kind;
  const fmpq *v0;
  enum limit_parameter in;
  long order;
  /* Of numbers: the digits of those that are no fractions, and whether the values are certified */
  long digits;
  bool is_certified;
  /* Of formulas of the steady state: as closed forms, each the term of T^0 */
  bool is_closed;
  struct symbols
      *symbols; /* of the coefficients, from symbols_init on: it ends after the expansion; of numbers T alone */

  /* What it is: series_answer, of which the status, why, the quantities and the modes hold */
  struct series_answer derived;
  struct symbolic_steady closed;
  struct symbolic_limit limit; /* U = v_start T, in the place of v_start */
  /* Of numbers: T, what the sums there should be, with as many bits as their errors take, and what is to be said */
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

/* Bits that so many digits take */
static inline slong bits_of_digits(long digits) { return (slong)(3.33 * (double)digits); }

#endif
