/* A motion in words: its modes, with their times. */
#ifndef SCALLOP_COMPARE_ANSWERS_STRETCHES_H
#define SCALLOP_COMPARE_ANSWERS_STRETCHES_H

#include "compare/answers/answer.h"

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
