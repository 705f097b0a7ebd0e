/* Answers in balls, every digit proven, and in series. Need FLINT. */
#ifndef SCALLOP_COMPARE_ANSWERS_ANSWER_FLINT_H
#define SCALLOP_COMPARE_ANSWERS_ANSWER_FLINT_H

#include "asymptotics/derived/scoped.h"
#include "compare/answers/answer.h"
#include "numerics/certified/certified.h"

struct ball_answer {
  enum scallop_status status;              /* not SCALLOP_OK: nothing of what follows holds       */
  const char *why;                         /* more about that, or NULL                            */
  const arb_struct *value[ALL_QUANTITIES]; /* NULL where the motion has no such quantity          */
  enum scallop_regime regime;
  struct scallop_modes modes[2];          /* of a phase the first                             */
  struct scallop_certified_steady steady; /* the values themselves */
  struct scallop_certified_phase phase;
  arb_t change, turning, cost;
};
#define BALL_PARTS(of) \
  of(scallop_certified_steady, &s->steady) of(scallop_certified_phase, &s->phase) of(arb, s->change) \
      of(arb, s->turning) of(arb, s->cost)
SCOPED_PARTS(ball_answer, struct ball_answer, BALL_PARTS)
/* The motion in fractions: the crawler as it was written, or exactly the doubles of a motion. v0: NULL of a steady
 * state. */
bool answer_in_balls(struct ball_answer *answer, const struct scallop_rational_crawler *crawler, enum quantity_of of,
                     enum scallop_phase_kind phase, const fmpq_t v0, long digits);
/* Parameters and v0 are taken for exactly the doubles they are. */
bool answer_of_doubles(struct ball_answer *answer, const struct motion *motion, long digits);

/* A formula of the paper at T, the period or the duration of the phase. given: the phase in balls, for a formula that
 * takes switching times as given; else NULL. False: the formula has no value. */
bool published_in_balls(arb_t value, const struct scallop_formula *formula,
                        const struct scallop_rational_crawler *crawler, enum scallop_phase_kind phase, const fmpq_t v0,
                        const fmpq_t T, const struct ball_answer *given, slong precision);

struct series_answer {
  enum scallop_status status;
  const char *why;
  /* in powers of T, the period or the duration of the phase; NULL where there is none */
  const struct series *value[ALL_QUANTITIES];
  const char *modes; /* for T -> 0 */
  struct scallop_expansion steady;
  struct scallop_expansion phase;
  struct series cost;
};
#define SERIES_PARTS(of) of(scallop_expansion, &s->steady) of(scallop_expansion, &s->phase) of(series, &s->cost)
SCOPED_PARTS(series_answer, struct series_answer, SERIES_PARTS)
/* The power of its first term that is not known to be 0; without one the first that is not known at all. */
slong series_first_power(const struct series *series);
/* All terms below T^order. */
bool answer_in_series(struct series_answer *answer, const struct scallop_rational_crawler *crawler, enum quantity_of of,
                      enum scallop_phase_kind phase, const fmpq_t v0, slong order, slong precision);

#endif
