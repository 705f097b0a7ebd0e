/* The one table of quantities: what can be asked of a point, and in which words and units. A new one is a row here and its value in
 * each of the arithmetics that have it (answer.c, answer_flint.c). */
#ifndef SCALLOP_QUANTITIES_H
#define SCALLOP_QUANTITIES_H

#include <stdbool.h>

#include "asymptotics/asymptotics.h"

/* What a quantity is of: the steady state, or one phase from a start velocity. */
enum quantity_of { OF_STEADY, OF_PHASE };

enum quantity_id {
  Q_FROUDE,
  Q_V_START,
  Q_V_MID,
  Q_DISPLACEMENT,
  Q_MEAN_VELOCITY,
  Q_MULTIPLIER,
  Q_T1,
  Q_DT,
  Q_V_END,
  Q_DX1,
  Q_DX2,
  Q_DXC,
  QUANTITIES,
  /* Columns where their names are asked for: in double they take a second walk. */
  Q_FRICTION_WORK = QUANTITIES,
  Q_COST_OF_TRANSPORT,
  NAMED_QUANTITIES,
  /* No columns, but what formulas of the paper are about: the position of the rear body, from its start, at the first and at the last
   * change of mode; v_end less v0; the velocity of a body that turns, 0. */
  Q_AT_FIRST = NAMED_QUANTITIES,
  Q_AT_LAST,
  Q_CHANGE,
  Q_TURNING,
  ALL_QUANTITIES
};

struct quantity_row {
  const char *name;
  const char *unit;     /* of the parameters' units; 1: a number without one  */
  const char *sentence; /* what it is                                         */
  enum quantity_of of;
  bool has_series; /* in powers of T */
};
extern const struct quantity_row quantity_rows[NAMED_QUANTITIES];

/* The columns of a motion: the first, and the one after the last; they stand together. */
enum quantity_id quantity_first(enum quantity_of of);
enum quantity_id quantity_end(enum quantity_of of);

/* That of this name, or NAMED_QUANTITIES. */
enum quantity_id quantity_of_name(const char *name);

/* What a formula of the paper is about, in a phase of this kind. */
enum quantity_id quantity_of_formula(const struct scallop_formula *formula, enum scallop_phase_kind kind);
/* The same in the paper's symbols and the names of the bodies of that phase: "x1(T-dT)", "dT". */
const char *formula_quantity_text(const struct scallop_formula *formula, enum scallop_phase_kind kind);
/* Does the formula take switching times, or a position at one, as given? */
bool formula_takes_given(const struct scallop_formula *formula);

#endif
