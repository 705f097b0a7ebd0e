#include "compare/scene_run.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/order.h"
#include "compare/plot.h"
#include "compare/scene_state.h"

enum { LEADS = 16, MOST_ARGUMENTS = 128 };

struct output {
  const struct scene_want *want;
  const char *file;
  struct options options; /* of the table                                                            */
  struct table table;
  bool is_open;
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

/* ---- heads of tables ---- */

static bool varies(const struct scene *s, const char *parameter)
{
  for (int p = 0; p < s->products; p++)
    for (int g = 0; g < s->product[p].groups; g++)
      for (int v = 0; v < s->product[p].group[g].variables; v++) {
        const struct scene_variable *variable = &s->product[p].group[g].variable[v];
        const char *name = variable->target == TARGET_F1_OVER_F2   ? "F1"
                           : variable->target == TARGET_M1_OVER_M2 ? "m1"
                           : variable->target == TARGET_FROUDE     ? "T"
                                                                   : variable->name;
        if (variable->target != TARGET_LABEL && strcmp(name, parameter) == 0)
          return true;
      }
  return false;
}

/* The parameters that stay the same */
static void note_parameters(struct table *t, const struct scene *s)
{
  char text[1024];
  size_t used = 0;
  for (const char *const *name = crawler_parameters; *name && used < sizeof text; name++) {
    char number[NUMBER_TEXT];
    if (varies(s, *name))
      continue;
    if (crawler_place(*name) < CRAWLER_NUMBERS)
      number_text(number, crawler_parameter(&s->base.crawler, *name), 0);
    used += (size_t)snprintf(text + used, sizeof text - used, " %s=%s", *name,
                             crawler_place(*name) < CRAWLER_NUMBERS ? number : s->base.crawler.gait->name);
  }
  if (used > 0)
    table_note(t, "parameters:%s", text);
}

static bool is_of_start(const struct quantities *all, int place)
{
  const struct quantity *q = &all->item[place];
  return quantity_is_of_phase(all, q) || q->kind == QUANTITY_V0 || q->kind == QUANTITY_PHASE_NAME;
}

/* Does anything in this table depend on the phase and its start? */
static bool has_start(const struct scene *s, const struct scene_want *w)
{
  bool has = w->kind == WANT_TRAJECTORY;
  for (int i = 0; i < w->columns; i++) {
    int places[ARITHMETIC_STEPS];
    int count = w->column[i].quantity < 0 ? arithmetic_places(&w->column[i].formula, places) : 1;
    if (w->column[i].quantity >= 0)
      places[0] = w->column[i].quantity;
    for (int k = 0; k < count; k++)
      has |= is_of_start(&s->quantities, places[k]);
  }
  for (int i = 0; i < w->series; i++)
    has |= is_of_start(&s->quantities, w->of[i]);
  return has;
}

static void note_start(struct table *t, const struct scene *s, const struct scene_want *w)
{
  char v0[NUMBER_TEXT];
  if (!has_start(s, w))
    return;
  number_text(v0, s->base.v0, 0);
  const char *start = s->varies_v0 ? "v0" : s->start == START_REST ? "rest" : s->start == START_STEADY ? "steady" : v0;
  if (w->kind == WANT_TRAJECTORY)
    table_note(t, "start: %s", start);
  else
    table_note(t, "phase: %s, from %s", s->phase == SCALLOP_EXTENSION ? "extension" : "contraction", start);
}

static void begin_table(struct running *r, struct output *o)
{
  struct table *t = &o->table;
  const struct scene *s = r->scene;
  table_note(t, "scallop " SCALLOP_VERSION);
  table_note(t, "command: run %s.cfg", s->name);
  if (s->title)
    table_note(t, "%s", s->title);
  for (int i = 0; i < s->notes; i++)
    table_note(t, "%s", s->note[i]);
  note_parameters(t, s);
  note_start(t, s, o->want);
}

static void begin_columns(struct output *o)
{
  const char *names[SCENE_COLUMNS + 1] = { NULL };
  for (int i = 0; i < o->want->columns; i++)
    names[i] = o->want->column[i].name;
  table_columns(&o->table, names);
  table_begin_rows(&o->table);
}

/* ---- rows ---- */

static void write_columns(struct running *r, struct output *o)
{
  const struct scene_want *w = o->want;
  for (int i = 0; i < w->columns; i++) {
    const struct scene_column *c = &w->column[i];
    const struct quantity *q = c->quantity >= 0 ? &r->scene->quantities.item[c->quantity] : NULL;
    if (!q)
      table_number(&o->table, state_formula(r->state, &c->formula));
    else if (q->kind == QUANTITY_CERTIFIED)
      table_digits(&o->table, state_text(r->state, c->quantity, o->options.digits > 0 ? o->options.digits : 17));
    else if (quantity_is_text(q))
      table_text(&o->table, state_text(r->state, c->quantity, 0));
    else
      table_number(&o->table, state_number(r->state, c->quantity));
  }
  o->rows++;
  count_add(COUNT_ROWS, 1);
}

/* ---- trajectories ---- */

struct tracing {
  struct running *r;
  struct output *o;
  double until;
};

static bool write_sample(void *context, const struct scallop_sample *s)
{
  struct tracing *t = context;
  struct scene_state *state = t->r->state;
  const double numbers[SAMPLE_VALUES] = { s->t, s->x1, s->x2, s->xC, s->v1, s->v2, s->l };
  if (s->t > t->until)
    return false;
  for (int i = 0; i < t->r->scene->quantities.count; i++) {
    const struct quantity *q = &t->r->scene->quantities.item[i];
    if (q->kind != QUANTITY_SAMPLE)
      continue;
    state->value[i] = numbers[q->which];
    state->has[i] = true;
  }
  write_columns(t->r, t->o);
  return !table_failed(&t->o->table);
}

static void trace(struct running *r, struct output *o)
{
  const struct scene_want *w = o->want;
  double v0 = state_v0(r->state);
  struct tracing t = { r, o, state_end(r->state, &w->until) };
  if (r->state->why[0] != '\0' || isnan(v0))
    return;
  enum scallop_status status = counted_trajectory(&r->state->at.crawler, v0, w->periods, w->samples, write_sample, &t);
  if (status < 0) {
    state_fail(r->state, scallop_status_text(status));
    table_note(&o->table, "incomplete: %s", scallop_status_text(status));
  }
}

/* ---- orders ---- */

static const char *const order_columns[] = { "series", "order",  "order_lo",  "order_hi", "points",
                                             "state",  "expect", "tolerance", "verdict",  NULL };

static void begin_orders(struct running *r, struct output *o)
{
  const struct quantities *all = &r->scene->quantities;
  for (int i = 0; i < all->labels; i++)
    table_columns(&o->table, (const char *const[]){ all->label[i], NULL });
  for (const char *const *name = crawler_parameters; *name; name++)
    if (strcmp(*name, "T") != 0)
      table_columns(&o->table, (const char *const[]){ *name, NULL });
  table_columns(&o->table, order_columns);
  table_begin_rows(&o->table);
  o->errors = calloc((size_t)o->want->series * SCENE_TIMES, sizeof *o->errors);
}

static const char *fit_text(enum order_state state)
{
  static const char *const text[] = { "fitted", "invalid", "insufficient", "floor-limited", "not-asymptotic", "exact" };
  return text[state];
}

/* Doubles are wrong by some ulp of what they are the difference of. */
static double noise(struct running *r, const struct quantity *error)
{
  const struct scene_comparison *c = &r->state->comparison[error->of];
  return r->plan->needs.certified_errors ? 0 : 8 * 2.2e-16 * fmax(fabs(c->exact), fabs(c->exact + c->error));
}

static void collect(struct running *r, struct output *o)
{
  for (int i = 0; i < o->want->series; i++) {
    double error = state_number(r->state, o->want->of[i]);
    o->errors[i * SCENE_TIMES + o->times] = (struct order_point){
      .h = r->state->at.crawler.T, .err = error, .noise = noise(r, &r->scene->quantities.item[o->want->of[i]])
    };
  }
  o->times++;
}

static void write_order(struct running *r, struct output *o, int series)
{
  const struct scene_want *w = o->want;
  const struct quantities *all = &r->scene->quantities;
  struct table *t = &o->table;
  struct order_fit fit = order_estimate(o->errors + (size_t)series * SCENE_TIMES, (int)o->times);
  enum order_verdict verdict = order_judge(&fit, w->expect, w->tolerance);
  for (int i = 0; i < all->labels; i++)
    table_text(t, r->state->label[i] ? r->state->label[i] : "-");
  for (const char *const *name = crawler_parameters; *name; name++)
    if (strcmp(*name, "gait") == 0)
      table_text(t, r->state->at.crawler.gait->name);
    else if (strcmp(*name, "T") != 0)
      table_number(t, crawler_parameter(&r->state->at.crawler, *name));
  table_text(t, all->item[all->item[w->of[series]].of].name);
  table_rounded(t, fit.order, "%.4f");
  table_rounded(t, fit.lo, "%.4f");
  table_rounded(t, fit.hi, "%.4f");
  table_rounded(t, fit.used, "%.0f");
  table_text(t, fit_text(fit.state));
  table_number(t, w->has_expect ? w->expect : NAN);
  table_number(t, w->has_expect ? w->tolerance : NAN);
  table_text(t, w->has_expect ? order_verdict_text(verdict) : "none asked for");
  r->failed_checks += w->has_expect && verdict != ORDER_PASS;
  count_add(COUNT_ORDERS, 1);
  count_add(COUNT_ROWS, 1);
  o->rows++;
}

static void finish_orders(struct running *r, struct output *o)
{
  for (int i = 0; i < o->want->series; i++)
    write_order(r, o, i);
  o->times = 0;
}

/* ---- commands ---- */

static void find_leads(struct running *r, struct output *o)
{
  const struct scene *s = r->scene;
  for (int p = 0; p < s->products; p++)
    for (int g = 0; g < s->product[p].groups; g++)
      for (int v = 0; v < s->product[p].group[g].variables; v++) {
        const struct scene_variable *variable = &s->product[p].group[g].variable[v];
        int place = quantity_named((struct quantities *)&s->quantities, variable->name), i = 0;
        while (i < o->leads && strcmp(o->lead_name[i], variable->name) != 0)
          i++;
        if (i < o->leads || o->leads == LEADS || place < 0)
          continue;
        o->lead_quantity[o->leads] = place;
        o->lead_name[o->leads++] = variable->name;
      }
  if (o->leads > 0)
    table_lead(&o->table, o->lead_name, o->leads);
}

static bool takes(const struct command *command, const char *name)
{
  for (const char *const *a = command->accepts; *a; a++)
    if (strcmp(*a, name) == 0)
      return true;
  return false;
}

static enum exit_code run_command(struct running *r, struct output *o)
{
  const struct scene_want *w = o->want;
  const struct options *at = &r->state->at;
  char *arguments[MOST_ARGUMENTS + 1], names[CRAWLER_NUMBERS + 1][16], digits[40];
  double numbers[LEADS];
  const char *texts[LEADS];
  struct options options;
  int count = 0, code = EXIT_DONE;
  bool has_map = false;
  for (; count < w->argument_count; count++) {
    arguments[count] = w->arguments[count];
    has_map |= strcmp(w->arguments[count], "--map") == 0;
  }
  for (int i = 0; i <= CRAWLER_NUMBERS; i++) {
    const char *name = crawler_parameters[i], *text = i < CRAWLER_NUMBERS ? at->written[i]
                                                      : at->has_gait      ? at->crawler.gait->name
                                                                          : NULL;
    bool idle = w->command == &command_breakdown && !has_map && strcmp(name, "T") == 0;
    if (!text || idle || !takes(w->command, name))
      continue;
    snprintf(names[i], sizeof names[i], "--%s", name);
    arguments[count++] = names[i];
    arguments[count++] = (char *)text;
  }
  if (r->options->quiet && takes(w->command, "quiet"))
    arguments[count++] = "--quiet";
  if (r->options->digits > 0 && takes(w->command, "digits")) {
    snprintf(digits, sizeof digits, "--digits=%ld", r->options->digits);
    arguments[count++] = digits;
  }
  arguments[count] = NULL;
  for (int i = 0; i < o->leads; i++) {
    bool is_text = quantity_is_text(&r->scene->quantities.item[o->lead_quantity[i]]);
    texts[i] = is_text ? state_text(r->state, o->lead_quantity[i], 0) : NULL;
    numbers[i] = is_text ? NAN : state_number(r->state, o->lead_quantity[i]);
  }
  if (o->leads > 0)
    table_lead_values(&o->table, numbers, texts);
  if (options_read(&options, w->command, count, arguments, &code)) {
    options.into = o->is_open ? &o->table : NULL;
    options.output = o->file;
    options.format = o->options.format;
    code = (int)w->command->run(&options);
  }
  options_free(&options);
  count_add(COUNT_COMMANDS, 1);
  return (enum exit_code)code;
}

/* ---- points ---- */

static void at_point(struct running *r, bool last_of_times)
{
  struct scene_state *state = r->state;
  r->points++;
  for (int i = 0; i < r->scene->wants; i++) {
    struct output *o = &r->output[i];
    switch (o->want->kind) {
    case WANT_ROWS: write_columns(r, o); break;
    case WANT_TRAJECTORY: trace(r, o); break;
    case WANT_ORDERS:
      collect(r, o);
      if (last_of_times)
        finish_orders(r, o);
      break;
    case WANT_COMMAND: {
      enum exit_code code = run_command(r, o);
      r->code = code > r->code ? code : r->code;
    }
    }
  }
  if (state->why[0] == '\0')
    return;
  if (r->unsolved++ == 0)
    snprintf(r->why, sizeof r->why, "%s", state->why);
}

static bool failed(const struct running *r)
{
  for (int i = 0; i < r->scene->wants; i++)
    if (r->output[i].is_open && table_failed(&r->output[i].table))
      return true;
  return r->code == EXIT_USAGE || r->code == EXIT_FILE;
}

static void each_point(struct running *r, const struct scene_product *product)
{
  long index[SCENE_GROUPS] = { 0 };
  int g = 0;
  while (g >= 0 && !failed(r)) {
    int last = product->groups - 1;
    state_move(r->state, product, index);
    at_point(r, last >= 0 && index[last] == product->group[last].count - 1);
    for (g = last; g >= 0 && ++index[g] == product->group[g].count; g--)
      index[g] = 0;
  }
}

/* ---- the whole ---- */

static bool open_tables(struct running *r, const struct scene_outputs *outputs)
{
  for (int i = 0; i < r->scene->wants; i++) {
    struct output *o = &r->output[i];
    o->want = &r->scene->want[i];
    o->file = outputs->file[i];
    o->options = *r->options;
    o->options.crawler = r->scene->base.crawler;
    o->options.format = r->options->has_format ? r->options->format : o->want->format;
    o->options.digits = r->options->digits > 0 ? r->options->digits : o->want->digits;
    o->options.output = o->file;
    /* A command that runs once opens its table itself: a map then goes on where it was interrupted. */
    if (o->want->kind == WANT_COMMAND && scene_points(r->scene) == 1)
      continue;
    if (!table_open_at(&o->table, &o->options, o->file))
      return false;
    o->is_open = true;
    if (o->want->kind == WANT_COMMAND) {
      find_leads(r, o);
      continue;
    }
    begin_table(r, o);
    if (o->want->kind == WANT_ORDERS)
      begin_orders(r, o);
    else
      begin_columns(o);
    if (o->want->kind == WANT_ORDERS && !o->errors) {
      complain(r->options->command->name, "out of memory");
      return false;
    }
  }
  return true;
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
    else if (keep && o->file && !r->options->quiet)
      fprintf(stderr, "scallop %s: wrote %s\n", r->options->command->name, o->file);
    free(o->errors);
  }
  return code;
}

static enum exit_code draw_plots(const struct running *r, const struct scene_outputs *outputs)
{
  enum exit_code code = EXIT_DONE;
  for (int i = 0; i < r->scene->wants; i++) {
    const struct scene_plot *p = &r->output[i].want->plot;
    const struct plot plot = { .table = r->output[i].file,
                               .file = outputs->plot[i],
                               .script = p->script,
                               .title = r->scene->title,
                               .x = p->x,
                               .y = p->y,
                               .by = p->by,
                               .log_x = p->log_x,
                               .log_y = p->log_y };
    if (!plot.file)
      continue;
    if (plot_draw(&plot, r->options->command->name))
      count_add(COUNT_PLOTS, 1);
    else
      code = EXIT_FILE;
  }
  return code;
}

static void tell(const struct running *r)
{
  const char *command = r->options->command->name;
  if (r->unsolved > 0)
    complain(command, "%s: %ld of %ld points could not be solved, the first: %s", r->scene->name, r->unsolved, r->points,
             r->why);
  if (r->failed_checks > 0)
    complain(command, "%s: %ld orders are not what is expected: the column 'verdict' says how", r->scene->name,
             r->failed_checks);
}

enum exit_code scene_run(const struct scene *scene, const struct plan *plan, const struct scene_outputs *outputs,
                         const struct options *options)
{
  struct running r = { .scene = scene, .plan = plan, .options = options, .code = EXIT_DONE };
  r.state = malloc(sizeof *r.state);
  r.output = calloc((size_t)scene->wants, sizeof *r.output);
  bool opened = r.state && r.output;
  if (!opened)
    complain(options->command->name, "out of memory");
  else {
    state_init(r.state, scene, &plan->needs);
    opened = open_tables(&r, outputs);
    r.code = opened ? EXIT_DONE : EXIT_FILE;
    for (int i = 0; opened && i < scene->products; i++)
      each_point(&r, &scene->product[i]);
    bool keep = opened && r.code != EXIT_USAGE && r.code != EXIT_FILE;
    enum exit_code closed = close_tables(&r, keep);
    r.code = closed == EXIT_DONE ? r.code : closed;
    if (keep && closed == EXIT_DONE) {
      tell(&r);
      enum exit_code drawn = draw_plots(&r, outputs);
      r.code = drawn != EXIT_DONE                           ? drawn
               : r.unsolved > 0                             ? EXIT_UNSOLVED
               : r.failed_checks > 0 && r.code == EXIT_DONE ? EXIT_CHECK_FAILED
                                                            : r.code;
    }
    state_clear(r.state);
  }
  free(r.state);
  free(r.output);
  return opened || r.code != EXIT_DONE ? r.code : EXIT_UNSOLVED;
}
