/* What happens to a motion where its modes change, in words. */
#ifndef SCALLOP_MODE_CHANGE_H
#define SCALLOP_MODE_CHANGE_H

#include "compare/answers/answer.h"

enum { MODE_CHANGE_TEXT = 400 };

/* One or several causes, separated by "; ", in text, which is returned. What follows from another cause is left out: a body that
 * is held to the end of a phase makes the next one begin from rest, so what changes at its beginning is not said.
 * "no change of modes" where they are the same. Of both answers modes of extension and contraction, regime and the sign of v_start
 * are used. */
const char *mode_change_text(char text[MODE_CHANGE_TEXT], const struct answer *before, const struct answer *after);

#endif
