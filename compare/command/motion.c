/* Commands steady and phase: the quantities of one motion, a row for each point; trajectory: the motion in time. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/answers/vary.h"
#include "compare/command/commands.h"
#include "compare/points/counts.h"
#include "compare/points/gaits.h"
#include "numerics/numerics.h"

struct motion_options {
  struct request request;
  bool certified, error;
  enum quantity_of of;
};
static const struct motion_options of_steady = { .of = OF_STEADY }, of_phase = { .of = OF_PHASE };

#define OPTIONS_OF_ROWS \
  OPTION_FLAG("certified", motion_options, certified), OPTION_FLAG("error", motion_options, error), OPTION_POINTS, \
      OPTION_FORMAT, OPTION_DIGITS(DIGITS_PROVEN("with --certified"), MAX_DIGITS), OPTIONS_VARY, OPTIONS_ERRORS, \
      OPTIONS_PLOT, OPTION_STATS, OPTIONS_LAST

static const struct option steady_options[] = { OPTIONS_CRAWLER, OPTIONS_OF_ROWS };
static const struct option phase_options[] = { OPTIONS_CRAWLER, OPTIONS_PHASE, OPTIONS_OF_ROWS };

static bool is_certified(const struct motion_options *o)
{
  return o->certified || (o->request.style.digits > DIGITS_OF_DOUBLE && !o->request.style.choice);
}

/* Returns true if modes in words are a column: of a single answer for people, and of any table with --columns. */
static bool has_words(const struct request *r)
{
  return r->style.choice || (!r->scene && !has_many_points(r) && table_is_aligned(&r->style));
}

static const char *plan(const void *options, struct rows *rows)
{
  static const char *const how[][3] = { [OF_STEADY] = { "regime", "modes", "motion" },
                                        [OF_PHASE] = { "regime = phase_regime", "modes = phase_modes",
                                                       "motion = phase_motion" } };
  static const char *const start[] = { "phase", "v0" };
  const struct motion_options *o = options;
  int first = (int)quantity_first(o->of), end = (int)quantity_end(o->of);
  bool certified = is_certified(o);
  const char *wrong = NULL;
  rows->has_parameters = true;
  rows->sheet.as_written = certified;
  if (o->of == OF_PHASE)
    memcpy(rows->extra, start, sizeof start);
  bool is_recorded = gait_file_of(o->request.point.crawler.gait) != NULL;
  for (int q = first; q < end && !wrong; q++) {
    wrong = rows_own(rows, certified ? "%s = certified.%s" : "%s", quantity_rows[q].name, quantity_rows[q].name);
    for (int i = 0; i < 2 && is_recorded && q != Q_FROUDE && !wrong; i++)
      wrong = rows_own(rows, i == 0 ? "low.%s" : "high.%s", quantity_rows[q].name);
  }
  for (int q = first; q < end && o->error && !wrong; q++)
    wrong = rows_own(rows, "%s_error", quantity_rows[q].name);
  for (int i = 0; i < 2 + has_words(&o->request) && !wrong; i++)
    wrong = rows_own(rows, "%s", how[o->of][i]);
  return wrong ? wrong : rows_own(rows, "status");
}

static const struct option_rule rules[] = {
  { "error", RULE_WITH, "certified", "has nothing to do with --certified: every digit is proven" },
  { NULL, RULE_WITH, NULL, NULL },
};

const struct command command_steady = {
  .name = "steady",
  .options = steady_options,
  .initial = &of_steady,
  .size = sizeof(struct motion_options),
  .rules = rules,
  .quantities = { Q_FROUDE, FIRST_OF_PHASE },
  .plan = plan,
};

const struct command command_phase = {
  .name = "phase",
  .options = phase_options,
  .initial = &of_phase,
  .size = sizeof(struct motion_options),
  .rules = rules,
  .quantities = { FIRST_OF_PHASE, QUANTITIES },
  .plan = plan,
};

/* trajectory */

struct trajectory_options {
  struct request request;
  struct optional_count periods, samples;
  const char *until;
};

static const char *read_start(void *options, const struct option *option, const char *text)
{
  struct trajectory_options *o = options;
  (void)option;
  o->request.required->from_steady = strcmp(text, "steady") == 0;
  o->request.point.has_v0 = false;
  o->request.point.v0 = 0;
  if (o->request.required->from_steady || strcmp(text, "rest") == 0)
    return NULL;
  return point_set(&o->request.point, "v0", text) ? no_number(text, "rest, steady or a velocity") : NULL;
}

enum { MAX_PERIODS = 1000000000 };

static const struct option options_of_trajectory[] = {
  OPTIONS_CRAWLER,
  OPTIONS_VARY,
  OPTION("start", read_start, ),
  OPTION_COUNT("periods", trajectory_options, periods, 1, MAX_PERIODS),
  OPTION_COUNT("samples", trajectory_options, samples, 1, MAX_PERIODS),
  OPTION_TEXT("until", trajectory_options, until, "a time"),
  OPTIONS_PLOT,
  OPTION_STATS,
  OPTIONS_OF_DOUBLES,
};
static const struct trajectory_options of_trajectory = { .periods = { 10, false }, .samples = { 40, false } };

struct trajectory {     /* state of the output */
  struct sweep_end end; /* the last time, of each point */
  struct rows *rows;
  struct at *at;
  double until;
};

static bool write_sample(void *context, const struct scallop_sample *s)
{
  struct trajectory *t = context;
  const struct quantities *all = &t->at->required->quantities;
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
  const struct trajectory_options *o = (const void *)rows->request;
  const struct trajectory *plan = rows->context;
  double v0 = at_v0(at);
  struct trajectory own = { .end = plan->end, .rows = rows, .at = at }, *t = &own;
  t->until = t->end.is_formula ? at_formula(at, &t->end.formula) : t->end.number;
  if (at->why[0] != '\0' || isnan(v0))
    return;
  enum scallop_status status = scallop_trajectory(&at->place.point.crawler, v0, o->periods.value, o->samples.value,
                                                  write_sample, t);
  count_add(COUNT_TRAJECTORIES, 1);
  if (status < 0) {
    at_fail(at, scallop_status_text(status));
    if (rows->is_open)
      table_note(&rows->table, "incomplete: %s", scallop_status_text(status));
  }
}

static void head(struct rows *rows)
{
  const struct trajectory_options *o = (const void *)rows->request;
  const struct point *p = &o->request.point;
  char v0[NUMBER_TEXT];
  number_text(v0, p->v0, 0);
  const char *start = o->request.required->from_steady ? "steady" : p->v0 == 0 ? "rest" : v0;
  if (!o->request.scene)
    table_note(&rows->table, "start: %s; periods: %ld; samples in a period: %ld", start, o->periods.value,
               o->samples.value);
}

/* Plans a row for each sample; the columns of varied parameters distinguish the curves. */
static const char *plan_trajectory(const void *options, struct rows *rows)
{
  const struct trajectory_options *o = options;
  const struct sweep_variable *v;
  struct trajectory *t = rows->context = calloc(1, sizeof *t);
  if (!t)
    return rows_no_memory;
  t->end.number = INFINITY;
  const char *wrong = o->until ? vary_end(&o->request, o->until, &t->end) : NULL;
  rows->opens_late = !o->request.scene && !has_many_points(&o->request);
  rows->sheet.of_samples = true;
  rows->notes_parameters = true;
  rows->head = head;
  rows->visit = trace;
  rows->any_order = true;
  for (int i = 0; (v = sweep_variable(&o->request.sweep, i)) && !wrong; i++)
    wrong = v->target == TARGET_LABEL ? NULL : rows_own(rows, "%s", v->name);
  for (const struct quantity_row *row = quantity_rows; row->name && !wrong; row++)
    wrong = row->kind == QUANTITY_SAMPLE ? rows_own(rows, "%s", row->name) : NULL;
  return wrong;
}

const struct command command_trajectory = {
  .name = "trajectory",
  .options = options_of_trajectory,
  .size = sizeof(struct trajectory_options),
  .initial = &of_trajectory,
  .plan = plan_trajectory,
};
