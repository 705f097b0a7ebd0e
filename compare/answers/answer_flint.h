/* Answers in balls, every digit proven, and in series. Need FLINT. */
#ifndef SCALLOP_COMPARE_ANSWERS_ANSWER_FLINT_H
#define SCALLOP_COMPARE_ANSWERS_ANSWER_FLINT_H

#include "asymptotics/derived/scoped.h"
#include "compare/answers/answer.h"
#include "numerics/certified/certified.h"

struct ball_answer {
  enum scallop_status status;              /* not SCALLOP_OK: the other members are not set       */
  const char *why;                         /* details of the status, or NULL                      */
  const arb_struct *value[ALL_QUANTITIES]; /* NULL: the motion has no such quantity               */
  enum scallop_regime regime;
  struct scallop_modes modes[2];          /* a phase has the first only */
  struct scallop_certified_steady steady; /* value points into these */
  struct scallop_certified_phase phase;
  arb_t change, turning, cost;
};
#define BALL_PARTS(of) \
  of(scallop_certified_steady, &s->steady) of(scallop_certified_phase, &s->phase) of(arb, s->change) \
      of(arb, s->turning) of(arb, s->cost)
SCOPED_PARTS(ball_answer, struct ball_answer, BALL_PARTS)
/* Solves a motion with rational parameters. v0: NULL for a steady state. Returns false if it has no answer. */
bool answer_in_balls(struct ball_answer *answer, const struct scallop_rational_crawler *crawler, enum quantity_of of,
                     enum scallop_phase_kind phase, const fmpq_t v0, long digits);
/* Solves a motion; parameters and v0 are exactly the given doubles. */
bool answer_of_doubles(struct ball_answer *answer, const struct motion *motion, long digits);

/* Evaluates a formula of the paper at T, the period or the duration of the phase. given: the phase in balls, for a
 * formula that takes switching times as given; else NULL. Returns false if the formula has no value. */
bool published_in_balls(arb_t value, const struct scallop_formula *formula,
                        const struct scallop_rational_crawler *crawler, enum scallop_phase_kind phase, const fmpq_t v0,
                        const fmpq_t T, const struct ball_answer *given, slong precision);

struct series_answer {
  enum scallop_status status;
  const char *why;
  /* in powers of T, the period or the duration of the phase; NULL: no series */
  const struct series *value[ALL_QUANTITIES];
  const char *modes; /* for T -> 0 */
  struct scallop_expansion steady;
  struct scallop_expansion phase;
  struct series cost;
};
#define SERIES_PARTS(of) of(scallop_expansion, &s->steady) of(scallop_expansion, &s->phase) of(series, &s->cost)
SCOPED_PARTS(series_answer, struct series_answer, SERIES_PARTS)
/* Returns the power of the first term that is not known to be 0; else the first power that is not known. */
slong series_first_power(const struct series *series);
/* Derives all terms below T^order. Returns false if the motion has no series. */
bool answer_in_series(struct series_answer *answer, const struct scallop_rational_crawler *crawler, enum quantity_of of,
                      enum scallop_phase_kind phase, const fmpq_t v0, slong order, slong precision);

#endif
