/* What the files of this folder share. Not public. */
#ifndef SCALLOP_COMPARE_SCENES_PARTS_H
#define SCALLOP_COMPARE_SCENES_PARTS_H

#include <math.h>
#include <stdio.h>

#include "compare/answers/answer.h"
#include "compare/answers/points.h"
#include "compare/config/config.h"
#include "asymptotics/observed/order.h"
#include "compare/scenes/scene.h"

enum { MOST_CERTIFIED_DIGITS = 10000 };

struct reading {
  struct scene *scene;
  struct config *config;               /* the scene's */
  const struct scene_options *options; /* of the command line */
};

/* plan.c: fills in scene->plan, from the kinds of its quantities. Nothing is solved. */
void make_plan(struct scene *scene);

/* vary.c, want.c: vary = ... and want = ... */
bool read_vary(const struct reading *r, const config_setting_t *vary);
bool read_wants(const struct reading *r, const config_setting_t *want);
/* command.c: the options of a want that is the table of another command; members: of any want */
bool read_command(const struct reading *r, const config_setting_t *at, struct scene_want *w,
                  const struct member *members);

/* columns.c: columns by their formulas, or those that a kind of want has. w->columns grows. */
bool add_columns(const struct reading *r, const config_setting_t *at, struct scene_want *w, const char *const *texts);
extern const char *const order_columns[]; /* behind the columns of a want of orders */
bool usual_columns(const struct reading *r, const config_setting_t *at, struct scene_want *w);
/* Checks the series of a want: those of `of`, or else the usual ones of its source and order, which become those of the
 * want. */
extern const char *const series_sources[];
bool find_series(const struct reading *r, const config_setting_t *at, struct scene_want *w);
bool has_column(const struct scene_want *w, const char *name);
/* Has a scene like this one that quantity? False: it is said why not. */
bool check_quantity(const struct reading *r, const config_setting_t *at, const struct scene_want *w, int place);
/* A number, or a formula of parameters and sticking_onset (*onset: it is one of these). */
bool read_end(const struct reading *r, const config_setting_t *at, struct sweep_end *end, bool *onset);
/* There is no quantity of that name. Returns false. */
bool refuse_quantity(const struct reading *r, const config_setting_t *at, const char *name);

/* One point of a scene, and what has been computed of it: each thing when it is first asked for, and once. The same
 * asked without a solver is the plan: what would be computed is counted. */

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
  struct point point;
  double v0;                 /* the start of the phase, for what is of it */
  char why[POINT_STATUS];    /* the first thing that could not be done, or "" */
  long failures;             /* so far */
  struct scene_flint *flint; /* NULL: none of the scene needs it */
  struct tally *tally;       /* of each stage, where only the plan is made; else NULL */
  const char *asking;        /* the name of what is asked for */
  struct swept swept;        /* what is beside the parameters */
  bool is_outside;           /* the parameters are no point: nothing but they can be told */
  bool tells_steady;         /* the row has something of the steady state in doubles */
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

/* Notes why something cannot be done, if it is the first. Returns nan. */
static inline double state_fail(struct scene_state *s, const char *why)
{
  s->failures++;
  if (s->why[0] == '\0')
    snprintf(s->why, sizeof s->why, "%s", why);
  return NAN;
}

/* flint.c: what a point needs FLINT for: certified answers, and series, which are kept for the last crawlers. Weak:
 * `scallop` is linked without this table, and the plan hands such a scene over to the program that has it. */
extern const struct scene_flint_functions {
  struct scene_flint *(*create)(void); /* NULL: no memory */
  void (*free)(struct scene_flint *flint);
  /* Goes to the point of the state; the start of its phase is taken from there with the first thing that is of the
   * phase. */
  void (*move)(const struct scene_state *state);
  /* Solves the steady state or the phase of the point, for the functions below. */
  void (*certify)(const struct scene_state *state, enum quantity_of of);
  /* The sum of a derived series, or of its first term, at the point. */
  double (*sum)(struct scene_state *state, const struct quantity *series);
  /* Of a series and the quantity of the certified answer that it is to be; the error is 0 below the accuracy that the
   * scene wants. */
  struct comparison (*compare)(struct scene_state *state, const struct quantity *series, int quantity);
  /* A certified value with so many digits; it lives until the next call. */
  const char *(*text)(struct scene_state *state, const struct quantity *q, long digits);
} scene_flint __attribute__((weak, visibility("hidden")));

/* state.c. tally: NULL, or that of the plan, zero for each stage. False: no memory. */
bool state_init(struct scene_state *state, const struct scene *scene, struct tally *tally);
void state_clear(struct scene_state *state);

/* Goes to a point: index[g] is the place in group g of the product. */
void state_move(struct scene_state *state, const struct sweep_product *product, const long *index);

/* Before each row: what failed for another table is no matter of this one. */
void state_begin_row(struct scene_state *state);

/* A quantity by its place in the scene's list: nan where it cannot be had, and why then says why. */
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

/* A table that is being made */
struct output {
  const struct scene_want *want;
  struct style style;
  struct table table;
  bool is_open;
  /* orders: the errors of each series at each T so far */
  struct scallop_order_point *errors;
  long times;
};

struct running {
  const struct scene *scene;
  const struct scene_options *options;
  struct scene_state *state;
  struct output *output;
  long points, unsolved, failed_checks;
  bool failed;            /* a table can no longer be written */
  char why[POINT_STATUS]; /* the first reason of those unsolved */
};

/* output.c: the '#' lines and the names of the columns; and the columns of the want at the point, which are a row, or
 * begin one of orders */
void output_begin(const struct running *r, struct output *o);
void output_row(const struct running *r, struct output *o);

/* orders.c: a point's errors; and, after the last T, the rows */
void orders_collect(const struct running *r, struct output *o);
void orders_finish(struct running *r, struct output *o);

#endif
