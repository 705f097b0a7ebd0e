/* One point of a scene, and what has been computed of it: each thing when it is first asked for, and once. */
#ifndef SCALLOP_SCENE_STATE_H
#define SCALLOP_SCENE_STATE_H

#include "compare/answers/answer.h"
#include "compare/answers/points.h"
#include "compare/scenes/flint.h"

struct scene_comparison { /* of a series with what it should be                                      */
  bool done;
  double value, exact, error; /* error: 0 below the accuracy that is wanted                       */
};

struct scene_state {
  const struct scene *scene;
  struct point at;        /* the parameters */
  struct swept swept;     /* what is beside them */
  char why[POINT_STATUS]; /* the first thing that could not be done, or "" */
  bool has_answer[2], has_turnings, has_friction;
  enum scallop_status friction; /* of the walk that gives its work */
  struct motion motion[2];      /* of the steady state and of the phase, by enum quantity_of */
  struct answer answer[2];
  bool is_outside;   /* the parameters are no point: nothing but they can be told               */
  bool tells_steady; /* the row has something of the steady state in doubles                     */
  long failures;     /* told to state_fail so far                                               */
  bool has_onset;    /* of these parameters, whatever T is                                         */
  double onset;
  struct scallop_crawler onset_of;
  bool has[MOST_QUANTITIES];
  double value[MOST_QUANTITIES];
  struct scene_comparison comparison[MOST_QUANTITIES];
  char text[MOTION_MODES_TEXT + ANSWER_STATUS]; /* what state_text returns                            */
  struct scene_asked asked;                     /* for series and certified values                              */
};

void state_init(struct scene_state *state, const struct scene *scene);
void state_clear(struct scene_state *state);

/* Goes to a point: index[g] is the place in group g of the product. */
void state_move(struct scene_state *state, const struct sweep_product *product, const long *index);

/* Before each row: what failed for another table is no matter of this one. */
void state_begin_row(struct scene_state *state);

/* A quantity by its place in the scene's list: nan where it cannot be had, and state->why then says why. */
double state_number(struct scene_state *state, int quantity);
/* A text; of certified values so many digits. It lives until the next call. */
const char *state_text(struct scene_state *state, int quantity, long digits);
/* Of a column: a formula's value. */
double state_formula(struct scene_state *state, const struct formula *formula);
/* The end of a range or of a trajectory. */
double state_end(struct scene_state *state, const struct sweep_end *end);
/* The start velocity of the scene's phase. */
double state_v0(struct scene_state *state);
/* Notes why something cannot be done, if it is the first. Returns nan. */
double state_fail(struct scene_state *state, const char *why);

#endif
