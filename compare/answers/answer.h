/* An answer: a motion solved in one arithmetic, and its quantities by their places in the table (quantities.h).
 *
 * Four arithmetics: double, the solver itself; wide, the same walk in 64 or 113 bits; balls, every digit proven; and
 * series in T. The latter two need FLINT (answer_flint.c). Statuses and accuracy are those of numerics/ and
 * asymptotics/. */
#ifndef SCALLOP_COMPARE_ANSWERS_ANSWER_H
#define SCALLOP_COMPARE_ANSWERS_ANSWER_H

#include "compare/points/point.h"
#include "compare/answers/quantities.h"
#include "numerics/wide/wide.h"

/* What is solved: the steady state of a crawler, or one phase from velocity v0. */
struct motion {
  enum quantity_of of;
  struct scallop_crawler crawler; /* T is the period, of a phase too */
  enum scallop_phase_kind phase;
  double v0;
};
static inline struct motion motion_of(const struct point *p, enum quantity_of of)
{
  return (struct motion){ of, p->crawler, p->phase, p->v0 };
}

struct answer {
  enum scallop_status status;                /* negative: nothing of what follows holds */
  struct scallop_wide value[ALL_QUANTITIES]; /* nan where the motion has no such quantity; low is 0 in double */
  enum scallop_regime regime;
  struct scallop_modes modes[2]; /* of a phase the first */
  double v_low, v_high;          /* double: the steady start velocities, equal unless SCALLOP_INTERVAL */
  struct scallop_work work;      /* double */
};
/* Returns whether there is an answer. */
bool answer_in_double(struct answer *answer, const struct motion *motion);
bool answer_in_wide(struct answer *answer, const struct motion *motion, enum scallop_width width);
/* In double, and how wrong its numbers are, as numerics/wide estimates it; nan: there is no estimate. */
bool answer_with_errors(struct answer *answer, const struct motion *motion, double errors[QUANTITIES]);
/* Fills in what an answer in double has not without a second walk through the motion: the work of friction, and of a
 * phase the positions of the rear body at the changes of mode. */
enum scallop_status answer_by_second_walk(struct answer *answer, const struct motion *motion);

/* The longest period at which an extension from rest does not stick, to the last bit; nan: no body ever sticks. The
 * crawler's T is not used. */
double sticking_onset(const struct scallop_crawler *crawler);

/* A formula, in double, for the motion: its steady state, or its phase. What the formula takes as given comes from the
 * answer, which may be NULL where it takes nothing; a formula that is printed for an extension is carried to a
 * contraction by exchanging the bodies. */
double published_value(const struct scallop_formula *formula, const struct motion *motion, const struct answer *given);

/* "++ -+ ++" of a phase, "++ -+ ++ | ++ +- ++" of a steady state. Returns text. */
enum { MOTION_MODES_TEXT = 2 * SCALLOP_MODES_TEXT + 4 };
const char *motion_modes_text(char text[MOTION_MODES_TEXT], enum quantity_of of, const struct scallop_modes modes[2]);
/* In which phases of a steady state with such modes a body turns: "++ -+ ++ | ++" has none that turns in the
 * contraction. */
enum scallop_turns turns_in_modes(const char *modes);
/* Of a phase modes[1] is empty. */
bool same_modes(const struct scallop_modes a[2], const struct scallop_modes b[2]);

/* What the column status says of an answer: ok, which interval of steady states there is, or why there is none. Returns
 * text or a text that lives for ever. */
enum { ANSWER_STATUS = 160 };
const char *answer_status_text(char text[ANSWER_STATUS], const struct answer *answer);

/* "body 1 backward, body 2 forward", "body 1 stuck, body 2 forward", "both bodies at rest" */
enum { MODE_WORDS = 40 };
const char *mode_in_words(char text[MODE_WORDS], struct scallop_mode mode);

/* A mode of a motion, and how long it lasts. Times begin with the phase of a single phase, and with the extension of a
 * steady state. */
struct stretch {
  enum scallop_phase_kind phase;
  double from, until;
  struct scallop_mode mode;
  const struct scallop_piece *piece; /* of the gait, in which it begins */
};
enum { MOST_STRETCHES = 2 * SCALLOP_MODES_KEPT };
/* The modes of a motion that was solved in double, in the order of time. Returns how many; past MOST_STRETCHES they are
 * counted and not kept. */
int stretches_of(struct stretch stretches[MOST_STRETCHES], const struct motion *motion, const struct answer *answer);

/* All of them in one line: "both bodies forward from 0 to 0.0657; body 1 backward, body 2 forward from 0.0657 to 0.659;
 * ...", with " | " between extension and contraction, and as many digits. Returns text. */
enum { MOTION_WORDS = MOST_STRETCHES * (MODE_WORDS + 64) };
const char *motion_in_words(char text[MOTION_WORDS], const struct motion *motion, const struct answer *answer,
                            int digits);

#endif
