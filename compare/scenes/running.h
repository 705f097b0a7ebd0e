/* What the files of a running scene share. Not public. */
#ifndef SCALLOP_SCENE_RUNNING_H
#define SCALLOP_SCENE_RUNNING_H

#include "compare/order/order.h"
#include "compare/scenes/run.h"
#include "compare/scenes/state.h"

enum { LEADS = 16 };

struct output {
  const struct scene_want *want;
  const char *file;
  struct options options; /* of the table                                                            */
  struct table table;
  bool is_open, tells_steady;
  long rows;
  /* orders: the errors of each series at each T so far */
  struct order_point *errors;
  long times;
  /* commands: what tells the points apart */
  int leads;
  const char *lead_name[LEADS];
  int lead_quantity[LEADS];
};

struct running {
  const struct scene *scene;
  const struct plan *plan;
  const struct options *options;
  struct scene_state *state;
  struct output *output;
  long points, unsolved, failed_checks;
  char why[POINT_STATUS]; /* the first reason of those unsolved                                       */
  enum exit_code code;
};

/* head.c: the '#' lines of a table */
void head_write(const struct running *r, struct output *o);

/* orders.c: the header row, false where there is no memory; a point's errors; and, after the last T, the rows */
bool orders_begin(const struct running *r, struct output *o);
void orders_collect(const struct running *r, struct output *o);
void orders_finish(struct running *r, struct output *o);

/* commands.c: what tells the points apart, in front of the rows; and the command at a point */
void command_leads(const struct running *r, struct output *o);
bool command_makes_map(const struct scene_want *want);
enum exit_code command_at_point(const struct running *r, struct output *o);

#endif
