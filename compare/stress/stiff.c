/* The tables of `stress --stiff`. */
#include <assert.h>
#include <math.h>
#include <stddef.h>

#include "compare/stress/stiff_measure.h"
#include "compare/stress/table.h"
#include "compare/text/progress.h"

enum { MOST_SCENES = 6 };

static const char *const names[] = { "scene", "gait", "regime", "stepper", NULL }; /* of a series */
/* The numbers of a run; status is the last column. */
static const struct {
  const char *name, *format;
  size_t at; /* in struct stiff_run */
} run_columns[] = {
  { "delta", "%.3g", offsetof(struct stiff_run, delta) },
  { "tolerance", "%.3g", offsetof(struct stiff_run, tolerance) },
  { "v_end_error", "%.3g", offsetof(struct stiff_run, error[STIFF_V_END]) },
  { "displacement_error", "%.3g", offsetof(struct stiff_run, error[STIFF_DISPLACEMENT]) },
  { "v_end_own_error", "%.2g", offsetof(struct stiff_run, own[STIFF_V_END]) },
  { "displacement_own_error", "%.2g", offsetof(struct stiff_run, own[STIFF_DISPLACEMENT]) },
  { "steps", "%.0f", offsetof(struct stiff_run, steps) },
  { "evaluations", "%.0f", offsetof(struct stiff_run, evaluations) },
  { "creep", "%.4g", offsetof(struct stiff_run, error[STIFF_CREEP]) },
  { "creep_over_delta", "%.4g", offsetof(struct stiff_run, creep_over_delta) },
  { "predicted_creep_over_delta", "%.4g", offsetof(struct stiff_run, predicted_creep) },
  { "creep_velocity", "%.4g", offsetof(struct stiff_run, velocity) },
  { "predicted_creep_velocity", "%.4g", offsetof(struct stiff_run, predicted_velocity) },
  { "last_velocity", "%.4g", offsetof(struct stiff_run, last) },
};
enum { RUN_COLUMNS = sizeof run_columns / sizeof *run_columns };
static const char *const summary_columns[] = {
  "quantity",    "order",       "order_low",         "order_high",   "points",      "verdict", "good_to",
  "error_there", "steps_there", "evaluations_there", "worst_beyond", "gives_up_at", "status",  NULL
};

static const double deltas[] = { 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12 };
enum { DELTAS = sizeof deltas / sizeof *deltas, QUICK_DELTAS = 5 };

struct book {
  const struct stress_options *options;
  struct stiff_scene scenes[MOST_SCENES];
  int scene_count;
  int deltas; /* the first so many         */
  long most;  /* steps that a run may take */
  struct table table;
  struct progress progress;
};

static const struct {
  const char *name;
  double F1, T;
} made[] = {
  { "sliding", 4, 1 },
  { "stick-slip", 4, 4 }, /* released by a jump of l'' in the quadratic gait, gradually in the sinusoidal one */
  { "stiff", 1.01, 100 }, /* eps = 1005                                                                  */
};

static bool has_parameters(const struct stress_options *o)
{
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    if (o->request.point.written[i])
      return true;
  return false;
}

/* All are solved before anything is written. */
static bool make_scenes(struct book *b)
{
  const struct point *p = &b->options->request.point;
  bool given = has_parameters(b->options);
  int count = given ? 1 : (int)(sizeof made / sizeof *made);
  for (int i = 0; i < count; i++)
    for (int g = 0; p->has_gait ? g == 0 : scallop_gait_name(g) != NULL; g++) {
      struct scallop_crawler c = given ? p->crawler : scallop_crawler_default();
      c.gait = p->has_gait ? p->crawler.gait : scallop_gait_named(scallop_gait_name(g));
      c.F1 = given ? c.F1 : made[i].F1;
      c.T = given ? c.T : made[i].T;
      assert(b->scene_count < MOST_SCENES);
      const char *why = stiff_scene_init(&b->scenes[b->scene_count++], given ? "given" : made[i].name, &c);
      if (!why)
        continue;
      complain("stress", "no certified period to compare with for the %s gait, T = %.17g: %s", c.gait->name, c.T, why);
      return false;
    }
  return true;
}

static void note_scene(struct table *t, const struct stiff_scene *scene)
{
  const struct scallop_crawler *c = &scene->crawler;
  const struct stiff_held *held = &scene->held;
  table_note(t, "%s, %s: m1=%.17g m2=%.17g F1=%.17g F2=%.17g L=%.17g T=%.17g alpha=%.17g; eps = %.4g; %s", scene->name,
             c->gait->name, c->m1, c->m2, c->F1, c->F2, c->L, c->T, c->alpha, scene->eps, scene->modes);
  if (held->body != 0)
    table_note(t, "  body %d is stuck from t = %.4g to %.4g of the %s; half-way, by a force of %.4g of its friction",
               held->body, held->begin, held->end, held->phase == SCALLOP_EXTENSION ? "extension" : "contraction",
               held->force);
}

static void note_meaning(const struct book *b, struct table *t)
{
  table_note(t, "friction F tanh(v/v_delta), v_delta = delta L/T; one period from the certified steady start velocity");
  table_note(t, "errors: answer - certified, of v_end over L/T, of displacement over L; rejected steps count");
  table_note(t,
             "tolerance: 1e-9 delta, 1e-15 at least; own error: of the stepper, what ten times the tolerance changes");
  table_note(t, "a period of more than %ld accepted steps is cut off, and a series ends where the stepper gives up",
             b->most);
  table_note(t, "creep: how far a smoothed body goes, over L, while the exact one is stuck; predicted: at v_delta "
                "artanh(force/friction)");
  if (b->options->summary) {
    table_note(t, "good_to: down to which delta the error at least halves with every tenth of delta, and is ten times "
                  "the own error;");
    table_note(t,
               "order in delta: over those; worst_beyond: the largest |error| below, of an answer that the stepper was "
               "content with");
  } else
    table_note(t, "velocities: of that body over v_delta, in the middle of the time and, the last, at its end");
}

static bool begin(struct book *b)
{
  const struct stress_options *o = b->options;
  struct table *t = &b->table;
  if (!table_head(t, &o->request.style, "stress --stiff%s%s", o->quick ? " --quick" : "",
                  o->summary ? " --summary" : ""))
    return false;
  t->of = o->summary ? "stiff orders" : "stiff";
  for (int i = 0; i < b->scene_count; i++)
    note_scene(t, &b->scenes[i]);
  note_meaning(b, t);
  table_columns(t, names);
  for (int i = 0; i < RUN_COLUMNS && !o->summary; i++)
    table_columns(t, (const char *const[]){ run_columns[i].name, NULL });
  table_columns(t, o->summary ? summary_columns : (const char *const[]){ "status", NULL });
  table_begin_rows(t);
  return true;
}

static void write_names(struct table *t, const struct stiff_scene *scene)
{
  table_text(t, scene->name);
  table_text(t, scene->crawler.gait->name);
  table_text(t, scallop_regime_text(scene->regime));
  table_text(t, "msbdf");
}

static void write_run(struct table *t, const struct stiff_scene *scene, const struct stiff_run *run)
{
  write_names(t, scene);
  for (int i = 0; i < RUN_COLUMNS; i++) {
    const void *number = (const char *)run + run_columns[i].at;
    table_rounded(t, *(const double *)number, run_columns[i].format);
  }
  table_text(t, run->status);
}

static void write_trend(struct table *t, const struct stiff_scene *scene, const struct stiff_run *runs, int count,
                        int quantity)
{
  struct stiff_trend trend = stiff_trend(runs, count, quantity);
  const struct stiff_run *best = trend.good > 0 ? &runs[trend.good - 1] : NULL, *last = &runs[count - 1];
  write_names(t, scene);
  table_text(t, stiff_quantities[quantity]);
  table_rounded(t, trend.fit.order, "%.4f");
  table_rounded(t, trend.fit.low, "%.4f");
  table_rounded(t, trend.fit.high, "%.4f");
  table_number(t, trend.fit.used);
  table_text(t, scallop_order_verdict_text(trend.fit.verdict));
  table_rounded(t, best ? best->delta : NAN, "%.3g");
  table_rounded(t, best ? best->error[quantity] : NAN, "%.3g");
  table_number(t, best ? best->steps : NAN);
  table_number(t, best ? best->evaluations : NAN);
  table_rounded(t, trend.worst_beyond, "%.3g");
  table_rounded(t, last->solved ? NAN : last->delta, "%.3g");
  table_text(t, last->status);
}

static void write_series(struct book *b, const struct stiff_scene *scene, const struct stiff_run *runs, int count)
{
  if (!b->options->summary)
    for (int i = 0; i < count; i++)
      write_run(&b->table, scene, &runs[i]);
  else
    for (int quantity = 0; quantity < STIFF_QUANTITIES; quantity++)
      if (quantity != STIFF_CREEP || scene->held.body != 0)
        write_trend(&b->table, scene, runs, count, quantity);
}

/* As delta -> 0, until the stepper gives up. Returns how many runs were made. */
static int solve_series(const struct book *b, const struct stiff_scene *scene, struct stiff_run *runs)
{
  for (int i = 0; i < b->deltas; i++) {
    double delta = deltas[i];
    progress_show(&b->progress, "%s, %s: delta = %g", scene->name, scene->crawler.gait->name, delta);
    stiff_solve(scene, delta, stiff_tolerance(delta), b->most, &runs[i]);
    if (!runs[i].solved)
      return i + 1;
  }
  return b->deltas;
}

static void solve_all(struct book *b)
{
  struct stiff_run runs[STIFF_MOST_RUNS];
  for (int i = 0; i < b->scene_count && !table_failed(&b->table); i++) {
    int count = solve_series(b, &b->scenes[i], runs);
    write_series(b, &b->scenes[i], runs, count);
  }
  progress_end(&b->progress);
}

enum exit_code stress_stiff(const struct stress_options *options)
{
  struct book b = { .options = options,
                    .deltas = options->quick ? QUICK_DELTAS : DELTAS,
                    .most = options->quick ? 10000 : 100000,
                    .progress = progress_begin(options->request.style.quiet) };
  if (!make_scenes(&b))
    return EXIT_UNSOLVED;
  if (!begin(&b))
    return EXIT_FILE;
  solve_all(&b);
  return table_close(&b.table) ? EXIT_DONE : EXIT_FILE;
}
