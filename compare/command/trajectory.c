#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/answers/vary.h"
#include "compare/command/commands.h"
#include "compare/points/counts.h"
#include "numerics/numerics.h"

struct trajectory_options {
  struct request request;
  struct given_count periods, samples;
  const char *until;
};

static const char *read_start(void *options, const struct option *option, const char *text)
{
  struct trajectory_options *o = options;
  (void)option;
  o->request.asked->from_steady = strcmp(text, "steady") == 0;
  o->request.point.has_v0 = false;
  o->request.point.v0 = 0;
  if (o->request.asked->from_steady || strcmp(text, "rest") == 0)
    return NULL;
  return point_set(&o->request.point, "v0", text) ? no_number(text, "rest, steady or a velocity") : NULL;
}

static const struct option_kind start_option = { read_start, NULL };
enum { MOST_PERIODS = 1000000000 };

static const struct option options_of_trajectory[] = {
  OPTIONS_CRAWLER(NULL, NULL),
  OPTIONS_VARY,
  OPTION("start", "WHAT", "rest, steady, or a velocity", "rest", .kind = &start_option),
  OPTION_COUNT("periods", "N", "number of periods", NULL, trajectory_options, periods, 1, MOST_PERIODS),
  OPTION_COUNT("samples", "N", "samples in a period", NULL, trajectory_options, samples, 1, MOST_PERIODS),
  OPTION_TEXT("until", "TIME", "the last time: a number, or a formula of parameters such as alpha*T", "no limit",
              trajectory_options, until, "a time"),
  OPTIONS_PLOT,
  OPTION_STATS,
  OPTIONS_OF_DOUBLES,
};
static const struct trajectory_options initial = { .periods = { 10, false }, .samples = { 40, false } };

struct trajectory {
  const struct trajectory_options *options;
  struct sweep_end end;
};
/* One of them that is being written */
struct tracing {
  struct rows *rows;
  struct at *at;
  double until;
};

static bool write_sample(void *context, const struct scallop_sample *s)
{
  struct tracing *t = context;
  const struct quantities *all = &t->at->asked->quantities;
  const double numbers[SAMPLE_VALUES] = { s->t, s->x1, s->x2, s->xC, s->v1, s->v2, s->l };
  count_add(COUNT_SAMPLES, 1);
  if (s->t > t->until)
    return false;
  for (int i = 0; i < all->count; i++)
    if (all->item[i].kind == QUANTITY_SAMPLE) {
      t->at->value[i] = numbers[all->item[i].which];
      t->at->has[i] = true;
    }
  if (!t->rows->is_open && !rows_open(t->rows))
    return false;
  sheet_row(&t->rows->sheet, &t->rows->table, t->at);
  return !table_failed(&t->rows->table);
}

static void trace(struct rows *rows, struct at *at)
{
  const struct trajectory *of = rows->context;
  double v0 = at_v0(at);
  struct tracing t = { rows, at, of->end.is_formula ? at_formula(at, &of->end.formula) : of->end.number };
  if (at->why[0] != '\0' || isnan(v0))
    return;
  enum scallop_status status = scallop_trajectory(&at->place.point.crawler, v0, of->options->periods.value,
                                                  of->options->samples.value, write_sample, &t);
  count_add(COUNT_TRAJECTORIES, 1);
  if (status < 0) {
    at_fail(at, scallop_status_text(status));
    if (rows->is_open)
      table_note(&rows->table, "incomplete: %s", scallop_status_text(status));
  }
}

static void head(struct rows *rows)
{
  const struct trajectory_options *o = ((const struct trajectory *)rows->context)->options;
  const struct point *p = &o->request.point;
  char v0[NUMBER_TEXT];
  number_text(v0, p->v0, 0);
  const char *start = o->request.asked->from_steady ? "steady" : p->v0 == 0 ? "rest" : v0;
  if (!o->request.scene)
    table_note(&rows->table, "start: %s; periods: %ld; samples in a period: %ld", start, o->periods.value,
               o->samples.value);
}

/* What varies tells the curves apart. */
static const char *plan(const void *options, struct rows *rows)
{
  const struct trajectory_options *o = options;
  const struct sweep_variable *v;
  struct trajectory *of = rows->context = calloc(1, sizeof *of);
  if (!of)
    return rows_no_memory;
  *of = (struct trajectory){ .options = o, .end.number = INFINITY };
  const char *wrong = o->until ? vary_end(&o->request, o->until, &of->end) : NULL;
  rows->opens_late = !o->request.scene && !has_many_points(&o->request);
  rows->sheet.of_samples = true;
  rows->notes_parameters = true;
  rows->head = head;
  rows->visit = trace;
  for (int i = 0; (v = sweep_variable(&o->request.sweep, i)) && !wrong; i++)
    wrong = v->target == TARGET_LABEL ? NULL : rows_own(rows, "%s", v->name);
  for (const struct quantity_row *row = quantity_rows; row->name && !wrong; row++)
    wrong = row->kind == QUANTITY_SAMPLE ? rows_own(rows, "%s", row->name) : NULL;
  return wrong;
}

const struct command command_trajectory = {
  .name = "trajectory",
  .summary = "positions and velocities in time, from rest, from the steady state or from a velocity",
  .example = "scallop trajectory --start rest --periods 20 --samples 50",
  .options = options_of_trajectory,
  .size = sizeof(struct trajectory_options),
  .initial = &initial,
  .plan = plan,
};
