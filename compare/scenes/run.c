/* A scene is run: its tables are opened, its points are visited once, and the tables take their places. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/scenes/parts.h"
#include "compare/text/plot.h"

struct tracing {
  struct running *r;
  struct output *o;
  double until;
};

static bool write_sample(void *context, const struct scallop_sample *s)
{
  struct tracing *t = context;
  struct at *at = t->r->at;
  const double numbers[SAMPLE_VALUES] = { s->t, s->x1, s->x2, s->xC, s->v1, s->v2, s->l };
  count_add(COUNT_SAMPLES, 1);
  if (s->t > t->until)
    return false;
  for (int i = 0; i < t->r->scene->asked.quantities.count; i++) {
    const struct quantity *q = &t->r->scene->asked.quantities.item[i];
    if (q->kind != QUANTITY_SAMPLE)
      continue;
    at->value[i] = numbers[q->which];
    at->has[i] = true;
  }
  sheet_row(&t->o->want->sheet, &t->o->table, at);
  return !table_failed(&t->o->table);
}

static void trace(struct running *r, struct output *o)
{
  const struct scene_want *w = o->want;
  double v0 = at_v0(r->at);
  struct tracing t = { r, o, w->until.is_formula ? at_formula(r->at, &w->until.formula) : w->until.number };
  if (r->at->why[0] != '\0' || isnan(v0))
    return;
  enum scallop_status status = scallop_trajectory(&r->at->point.crawler, v0, w->periods, w->samples, write_sample, &t);
  count_add(COUNT_TRAJECTORIES, 1);
  if (status < 0) {
    at_fail(r->at, scallop_status_text(status));
    table_note(&o->table, "incomplete: %s", scallop_status_text(status));
  }
}

static void at_want(struct running *r, struct output *o, bool last_of_times)
{
  if (o->want->kind == WANT_ROWS)
    sheet_row(&o->want->sheet, &o->table, r->at);
  else if (o->want->kind == WANT_TRAJECTORY)
    trace(r, o);
  else if (o->want->kind == WANT_ORDERS) {
    orders_collect(r, o);
    if (last_of_times)
      orders_finish(r, o);
  }
}

static void at_point(struct running *r, bool last_of_times)
{
  const char *why = r->at->why;
  bool unsolved = false;
  r->points++;
  for (int i = 0; i < r->scene->wants; i++) {
    struct output *o = &r->output[i];
    at_begin_row(r->at);
    at_want(r, o, last_of_times);
    if (*why != '\0' && r->unsolved == 0 && !unsolved)
      snprintf(r->why, sizeof r->why, "%s", why);
    unsolved |= *why != '\0';
    r->failed |= o->is_open && table_failed(&o->table);
  }
  r->unsolved += unsolved;
}

static void each_point(struct running *r, const struct sweep_product *product)
{
  long index[SWEEP_GROUPS] = { 0 };
  int last = product->groups - 1;
  do {
    at_sweep(r->at, &r->scene->base, product, index);
    at_point(r, last >= 0 && index[last] == product->group[last].count - 1);
  } while (sweep_next(product, index) && !r->failed);
}

static bool open_tables(struct running *r)
{
  for (int i = 0; i < r->scene->wants; i++) {
    struct output *o = &r->output[i];
    o->want = &r->scene->want[i];
    o->style = r->options->request.style;
    o->style.format = o->want->format;
    o->style.digits = o->want->digits;
    if (o->want->kind == WANT_COMMAND) /* which opens its table itself */
      continue;
    if (!table_open_at(&o->table, &o->style, o->want->file))
      return false;
    o->is_open = true;
    output_begin(r, o);
    o->errors = calloc((size_t)o->want->series * SCENE_TIMES + 1, sizeof *o->errors);
    if (!o->errors) {
      complain(r->options->request.style.command, "out of memory");
      return false;
    }
  }
  return true;
}

static enum exit_code worse(enum exit_code a, enum exit_code b) { return a > b ? a : b; }

/* Tables of commands are made when all others are complete, and each is in its place when the command ends. */
static enum exit_code run_commands(const struct running *r)
{
  enum exit_code code = EXIT_DONE;
  for (int i = 0; i < r->scene->wants && code != EXIT_FILE; i++)
    if (r->scene->want[i].kind == WANT_COMMAND) {
      count_add(COUNT_COMMANDS, 1);
      code = worse(code, r->scene->run_command(r->scene, &r->scene->want[i], r->options, false));
    }
  return code;
}

/* Every table is complete on the disk before the first takes its place. */
static bool flush_tables(struct running *r)
{
  bool whole = true;
  for (int i = 0; i < r->scene->wants; i++)
    whole &= !r->output[i].is_open || table_flush(&r->output[i].table);
  return whole;
}

static void tell_written(const struct running *r, const char *file)
{
  if (file && !r->options->request.style.quiet)
    fprintf(stderr, "scallop %s: wrote %s\n", r->options->request.style.command, file);
}

/* All or none: where something went wrong the earlier files stay. */
static enum exit_code close_tables(struct running *r, bool keep)
{
  enum exit_code code = EXIT_DONE;
  for (int i = 0; i < r->scene->wants; i++) {
    struct output *o = &r->output[i];
    if (o->is_open && !keep && !table_failed(&o->table))
      table_abandon(&o->table);
    else if (o->is_open && !table_close(&o->table))
      code = EXIT_FILE;
    else if (keep)
      tell_written(r, o->want->file);
    free(o->errors);
  }
  return code;
}

static enum exit_code draw_plots(const struct running *r)
{
  enum exit_code code = EXIT_DONE;
  for (int i = 0; i < r->scene->wants; i++) {
    const struct scene_want *w = &r->scene->want[i];
    if (!w->has_plot)
      continue;
    bool drawn = plot_draw(&w->plot, r->options->request.style.command);
    code = drawn ? code : EXIT_FILE;
    count_add(COUNT_PLOTS, drawn);
    if (drawn)
      tell_written(r, w->plot.file);
  }
  return code;
}

static void tell(const struct running *r)
{
  const char *command = r->options->request.style.command;
  if (r->unsolved > 0)
    complain(command, "%s: %ld of %ld points could not be solved, the first: %s", r->scene->name, r->unsolved,
             r->points, r->why);
  if (r->failed_checks > 0)
    complain(command, "%s: orders that are not as expected: %ld: the column 'verdict' says how", r->scene->name,
             r->failed_checks);
}

/* Visits all points. The exit code of what is then in its place. */
static enum exit_code run_points(struct running *r)
{
  bool opened = open_tables(r);
  for (int i = 0; opened && i < r->scene->sweep.products; i++)
    each_point(r, &r->scene->sweep.product[i]);
  enum exit_code code = opened && flush_tables(r) ? run_commands(r) : EXIT_FILE;
  bool keep = code != EXIT_FILE && code != EXIT_USAGE;
  if (close_tables(r, keep) != EXIT_DONE)
    return EXIT_FILE;
  if (!keep)
    return code;
  tell(r);
  if (draw_plots(r) != EXIT_DONE)
    return EXIT_FILE;
  if (r->unsolved > 0)
    return EXIT_UNSOLVED;
  return r->failed_checks > 0 ? worse(code, EXIT_CHECK_FAILED) : code;
}

enum exit_code scene_run(const struct scene *scene, const struct scene_options *options)
{
  struct running r = { .scene = scene, .options = options };
  enum exit_code code = EXIT_UNSOLVED;
  struct at *at = r.at = malloc(sizeof *at);
  r.output = calloc((size_t)scene->wants, sizeof *r.output);
  if (!at || !at_init(at, &scene->asked) || !r.output)
    complain(options->request.style.command, "out of memory");
  else
    code = run_points(&r);
  if (at)
    at_clear(at);
  free(at);
  free(r.output);
  return code;
}
