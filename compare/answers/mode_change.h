/* Modes in words: those of a motion, with their times, and what happens where they change. */
#ifndef SCALLOP_COMPARE_ANSWERS_MODE_CHANGE_H
#define SCALLOP_COMPARE_ANSWERS_MODE_CHANGE_H

#include "compare/answers/answer.h"

enum { MODE_CHANGE_TEXT = 400 };

/* One or several causes, separated by "; ", in text, which is returned. What follows from another cause is left out: a
 * body that is held to the end of a phase makes the next one begin from rest, so what changes at its beginning is not
 * said. "no change of modes" where they are the same. Of both answers modes of extension and contraction, regime and
 * the sign of v_start are used. */
const char *mode_change_text(char text[MODE_CHANGE_TEXT], const struct answer *before, const struct answer *after);

/* "body 1 backward, body 2 forward", "body 1 stuck, body 2 forward", "both bodies at rest" */
enum { MODE_WORDS = 40 };
const char *mode_in_words(char text[MODE_WORDS], struct scallop_mode mode);

/* A mode of a motion, and how long it lasts. Times begin with the phase of a single phase, and with the extension of a
 * steady state. */
struct stretch {
  enum scallop_phase_kind phase;
  double from, until;
  struct scallop_mode mode;
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
