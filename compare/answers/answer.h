/* Answers: a motion solved in one arithmetic, and its quantities by enum quantity_id (quantities.h).
 *
 * The four arithmetics: double, the solver itself; wide, the same algorithm in 64 or 113 bits; balls, every digit
 * proven; and series in T. Balls and series need FLINT (answer_flint.c). Statuses and accuracy are documented in
 * numerics/ and asymptotics/. */
#ifndef SCALLOP_COMPARE_ANSWERS_ANSWER_H
#define SCALLOP_COMPARE_ANSWERS_ANSWER_H

#include "compare/points/point.h"
#include "compare/answers/quantities.h"
#include "numerics/wide/wide.h"

/* The problem: the steady state of a crawler, or one phase from velocity v0. */
struct motion {
  enum quantity_of of;
  struct scallop_crawler crawler; /* T is the period, also for a phase */
  enum scallop_phase_kind phase;
  double v0;
};
static inline struct motion motion_of(const struct point *p, enum quantity_of of)
{
  return (struct motion){ of, p->crawler, p->phase, p->v0 };
}

struct answer {
  enum scallop_status status;                /* negative: the other members are not set */
  struct scallop_wide value[ALL_QUANTITIES]; /* nan: the motion has no such quantity; in double low is 0 */
  enum scallop_regime regime;
  struct scallop_modes modes[2]; /* a phase has the first only */
  double v_low, v_high;          /* double: the steady start velocities, equal unless SCALLOP_INTERVAL */
  struct scallop_work work;      /* double */
};
/* Solves the motion. Returns false if it has no answer. */
bool answer_in_double(struct answer *answer, const struct motion *motion);
bool answer_in_wide(struct answer *answer, const struct motion *motion, enum scallop_width width);
/* Solves in double and estimates the error of each number (numerics/wide); nan: no estimate. */
bool answer_with_errors(struct answer *answer, const struct motion *motion, double errors[QUANTITIES]);
/* Adds the values that take a second pass through a motion solved in double: the work of friction; for a phase, the
 * positions of the rear body at the changes of mode. */
enum scallop_status answer_complete(struct answer *answer, const struct motion *motion);

/* Returns the longest period at which an extension from rest does not stick, to the last bit; nan: no body ever sticks.
 * The crawler's T is not used. */
double sticking_onset(const struct scallop_crawler *crawler);

/* Returns the value of a formula, in double, for the motion: its steady state, or its phase. given: the answer that
 * provides switching times and positions; NULL if the formula takes no such value. A formula that is printed for an
 * extension is applied to a contraction by exchanging the bodies. */
double published_value(const struct scallop_formula *formula, const struct motion *motion, const struct answer *given);

/* Writes the modes, "++ -+ ++" for a phase, "++ -+ ++ | ++ +- ++" for a steady state. Returns text. */
enum { MOTION_MODES_TEXT = 2 * SCALLOP_MODES_TEXT + 4 };
const char *motion_modes_text(char text[MOTION_MODES_TEXT], enum quantity_of of, const struct scallop_modes modes[2]);
/* Returns the phases of a steady state in which a body turns: with "++ -+ ++ | ++" not in the contraction. */
enum scallop_turns turns_in_modes(const char *modes);
/* Returns true if the modes are equal. For a phase modes[1] is empty. */
bool same_modes(const struct scallop_modes a[2], const struct scallop_modes b[2]);

/* Returns the text of the column status: ok, the interval of steady states, or why the motion has no answer. It is
 * either in text or static. */
enum { ANSWER_STATUS = 160 };
const char *answer_status_text(char text[ANSWER_STATUS], const struct answer *answer);

/* Writes "body 1 backward, body 2 forward", "body 1 stuck, body 2 forward", "both bodies at rest". Returns text. */
enum { MODE_WORDS = 40 };
const char *mode_in_words(char text[MODE_WORDS], struct scallop_mode mode);

/* A segment of a motion in one mode. Times begin with the single phase, or with the extension of a steady state. */
struct mode_segment {
  enum scallop_phase_kind phase;
  double from, until;
  struct scallop_mode mode;
  const struct scallop_piece *piece; /* the piece of the gait in which the segment begins */
};
enum { MAX_SEGMENTS = 2 * SCALLOP_MODES_KEPT };
/* Finds the segments of a motion that was solved in double, in the order of time. Returns their number; segments past
 * MAX_SEGMENTS are counted, not stored. */
int motion_segments(struct mode_segment segments[MAX_SEGMENTS], const struct motion *motion,
                    const struct answer *answer);

/* Writes the segments in one line: "both bodies forward from 0 to 0.0657; body 1 backward, body 2 forward from 0.0657
 * to 0.659; ...", with " | " between extension and contraction. Returns text. */
enum { MOTION_WORDS = MAX_SEGMENTS * (MODE_WORDS + 64) };
const char *motion_in_words(char text[MOTION_WORDS], const struct motion *motion, const struct answer *answer,
                            int digits);

#endif
