/* One point of a scene, and what has been computed of it: each thing when it is first asked for, and once. The same asked without a
 * solver is the plan (plan.c): what would be computed is counted. */
#ifndef SCALLOP_SCENE_STATE_H
#define SCALLOP_SCENE_STATE_H

#include "compare/answers/answer.h"
#include "compare/scenes/flint.h"

/* What is solved once at a point; the first three each for the steady state and for the phase, by enum quantity_of */
enum cell { IN_DOUBLE, IN_BALLS = 2, IN_SERIES = 4, TURNINGS = 6, FRICTION, ONSET, CELLS };

struct comparison { /* of a series with what it should be */
  bool done;
  double value, exact, error; /* error: 0 below the accuracy that is wanted */
};

/* What the plan finds: how often a stage is needed at a point, and for what first */
struct tally {
  long count;
  const char *reason;
};

struct scene_state {
  const struct scene *scene;
  struct visit visit; /* the point, and why something of it could not be had */
  struct scene_flint *flint;
  struct tally *tally; /* of each stage, where only the plan is made; else NULL */
  const char *asking;  /* the name of what is asked for */
  struct swept swept;  /* what is beside the parameters */
  bool is_outside;     /* the parameters are no point: nothing but they can be told */
  bool tells_steady;   /* the row has something of the steady state in doubles */
  bool has_cell[CELLS];
  struct motion motion[2];
  struct answer answer[2];
  enum scallop_status friction; /* of the walk that gives its work */
  double onset;
  struct scallop_crawler onset_of;
  bool has[MOST_QUANTITIES];
  double value[MOST_QUANTITIES];
  struct comparison comparison[MOST_QUANTITIES];
  char text[MOTION_MODES_TEXT + ANSWER_STATUS]; /* what state_text returns */
};

/* tally: NULL, or that of the plan, zero for each stage. False: no memory. */
bool state_init(struct scene_state *state, const struct scene *scene, struct tally *tally);
void state_clear(struct scene_state *state);

/* Goes to a point: index[g] is the place in group g of the product. */
void state_move(struct scene_state *state, const struct sweep_product *product, const long *index);

/* Before each row: what failed for another table is no matter of this one. */
void state_begin_row(struct scene_state *state);

/* A quantity by its place in the scene's list: nan where it cannot be had, and visit.why then says why. */
double state_number(struct scene_state *state, int quantity);
/* A text; of certified values so many digits. It lives until the next call. */
const char *state_text(struct scene_state *state, int quantity, long digits);
/* Asks for a quantity, number or text, so that what could not be had is known. */
void state_find(struct scene_state *state, int quantity, long digits);
/* Of a column: a formula's value. */
double state_formula(struct scene_state *state, const struct formula *formula);
/* The end of a range or of a trajectory. */
double state_end(struct scene_state *state, const struct sweep_end *end);
/* The start velocity of the scene's phase. */
double state_v0(struct scene_state *state);

#endif
