/* What happens to a steady state where its modes change, in words. */
#ifndef SCALLOP_MODE_CHANGE_H
#define SCALLOP_MODE_CHANGE_H

#include <stdbool.h>

#include "numerics/numerics.h"

struct mode_state {              /* a steady state on one side of the change                         */
  struct scallop_modes modes[2]; /* of extension and contraction                                     */
  enum scallop_regime regime;
  double v_start; /* its sign matters                                                               */
};

/* Of both phases, as far as modes are kept. */
bool same_modes(const struct scallop_modes a[2], const struct scallop_modes b[2]);

enum { MODE_CHANGE_TEXT = 400 };

/* One or several causes, separated by "; ", in text, which is returned. What follows from another cause is left out: a body that
 * is held to the end of a phase makes the next one begin from rest, so what changes at its beginning is not said.
 * "no change of modes" where they are the same. */
const char *mode_change_text(char text[MODE_CHANGE_TEXT], const struct mode_state *before, const struct mode_state *after);

#endif
