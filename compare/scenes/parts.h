/* What the files of this folder share. Not public. */
#ifndef SCALLOP_COMPARE_SCENES_PARTS_H
#define SCALLOP_COMPARE_SCENES_PARTS_H

#include <math.h>
#include <stdio.h>

#include "compare/config/config.h"
#include "asymptotics/observed/order.h"
#include "compare/scenes/scene.h"

struct reading {
  struct scene *scene;
  struct config *config;               /* the scene's */
  const struct scene_options *options; /* of the command line */
};

/* vary.c, want.c: vary = ... and want = ... */
bool read_vary(const struct reading *r, const config_setting_t *vary);
bool read_wants(const struct reading *r, const config_setting_t *want);
/* command.c: the options of a want that is the table of another command; members: of any want */
bool read_command(const struct reading *r, const config_setting_t *at, struct scene_want *w,
                  const struct member *members);

/* columns.c: columns by their formulas, or those that a kind of want has. w->sheet grows. */
bool add_columns(const struct reading *r, const config_setting_t *at, struct scene_want *w, const char *const *texts);
extern const char *const order_columns[]; /* behind the columns of a want of orders */
bool usual_columns(const struct reading *r, const config_setting_t *at, struct scene_want *w);
/* Checks the series of a want: those of `of`, or else the usual ones of its source and order, which become those of the
 * want. */
extern const char *const series_sources[];
bool find_series(const struct reading *r, const config_setting_t *at, struct scene_want *w);
bool has_column(const struct scene_want *w, const char *name);
/* The quantities of the columns and orders of a want, and of where a trajectory ends, perhaps several times. Returns
 * how many. */
enum { WANT_QUANTITIES = SCENE_COLUMNS * FORMULA_STEPS };
int want_quantities(const struct scene_want *want, int places[WANT_QUANTITIES]);
/* NULL, or why a want of a scene like this one has no such quantity */
const char *want_refuses(const struct sheet *sheet, const struct quantity *quantity);
/* A number, or a formula of parameters and sticking_onset (*onset: it is one of these). */
bool read_end(const struct reading *r, const config_setting_t *at, struct sweep_end *end, bool *onset);

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
  struct at *at;
  struct output *output;
  long points, unsolved, failed_checks;
  bool failed;            /* a table can no longer be written */
  char why[POINT_STATUS]; /* the first reason of those unsolved */
};

/* output.c: the '#' lines and the names of the columns */
void output_begin(const struct running *r, struct output *o);

/* orders.c: a point's errors; and, after the last T, the rows */
void orders_collect(const struct running *r, struct output *o);
void orders_finish(struct running *r, struct output *o);

#endif
