/* The tables of `stress --stiff`. */
#include <assert.h>
#include <math.h>
#include <stddef.h>

#include "compare/stress/stiff_measure.h"
#include "compare/stress/stress.h"
#include "compare/text/progress.h"

static const char *const names[] = { "scene", "gait", "regime", "stepper", NULL };

static void put_status(struct table *t, const struct table_column *c, const void *row)
{
  table_text(t, (const char *)row + c->at);
}

#define AT(member) offsetof(struct stiff_run, member)
static const struct table_column of_run[] = {
  { TABLE_COLUMN("delta", column_rounded, AT(delta)), .format = "%.3g" },
  { TABLE_COLUMN("tolerance", column_rounded, AT(tolerance)), .format = "%.3g" },
  { TABLE_COLUMN("v_end_error", column_rounded, AT(error[STIFF_V_END])), .format = "%.3g" },
  { TABLE_COLUMN("displacement_error", column_rounded, AT(error[STIFF_DISPLACEMENT])), .format = "%.3g" },
  { TABLE_COLUMN("v_end_own_error", column_rounded, AT(own[STIFF_V_END])), .format = "%.2g" },
  { TABLE_COLUMN("displacement_own_error", column_rounded, AT(own[STIFF_DISPLACEMENT])), .format = "%.2g" },
  { TABLE_COLUMN("steps", column_rounded, AT(steps)), .format = "%.0f" },
  { TABLE_COLUMN("evaluations", column_rounded, AT(evaluations)), .format = "%.0f" },
  { TABLE_COLUMN("creep", column_rounded, AT(error[STIFF_CREEP])), .format = "%.4g" },
  { TABLE_COLUMN("creep_over_delta", column_rounded, AT(creep_over_delta)), .format = "%.4g" },
  { TABLE_COLUMN("predicted_creep_over_delta", column_rounded, AT(predicted_creep)), .format = "%.4g" },
  { TABLE_COLUMN("creep_velocity", column_rounded, AT(velocity)), .format = "%.4g" },
  { TABLE_COLUMN("predicted_creep_velocity", column_rounded, AT(predicted_velocity)), .format = "%.4g" },
  { TABLE_COLUMN("last_velocity", column_rounded, AT(last)), .format = "%.4g" },
  { TABLE_COLUMN("status", put_status, offsetof(struct stiff_run, status)) },
  { .name = NULL },
};
#undef AT
#define AT(member) offsetof(struct stiff_trend, member)
static const struct table_column of_trend[] = {
  { TABLE_COLUMN("quantity", column_text, AT(quantity)) },
  { TABLE_COLUMN("order", column_rounded, AT(fit.order)), .format = "%.4f" },
  { TABLE_COLUMN("order_low", column_rounded, AT(fit.low)), .format = "%.4f" },
  { TABLE_COLUMN("order_high", column_rounded, AT(fit.high)), .format = "%.4f" },
  { TABLE_COLUMN("points", column_count, AT(fit.used)) },
  { TABLE_COLUMN("verdict", column_text, AT(verdict)) },
  { TABLE_COLUMN("good_to", column_rounded, AT(best.delta)), .format = "%.3g" },
  { TABLE_COLUMN("error_there", column_rounded, AT(error_there)), .format = "%.3g" },
  { TABLE_COLUMN("steps_there", column_number, AT(best.steps)) },
  { TABLE_COLUMN("evaluations_there", column_number, AT(best.evaluations)) },
  { TABLE_COLUMN("worst_beyond", column_rounded, AT(worst_beyond)), .format = "%.3g" },
  { TABLE_COLUMN("gives_up_at", column_rounded, AT(gives_up_at)), .format = "%.3g" },
  { TABLE_COLUMN("status", put_status, AT(last.status)) },
  { .name = NULL },
};
#undef AT

static const double deltas[] = { 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12 };
enum { DELTAS = sizeof deltas / sizeof *deltas, QUICK_DELTAS = 5, MOST_STEPS = 100000, QUICK_STEPS = 10000 };

static const struct {
  const char *name;
  double F1, T;
} made[] = {
  { "sliding", 4, 1 },
  { "stick-slip", 4, 4 }, /* released by a jump of l'' in the quadratic gait, gradually in the sinusoidal one */
  { "stiff", 1.01, 100 }, /* eps = 1005                                                                  */
};
enum { MOST_SCENES = 6 };

/* All are solved before anything is written: the crawler that is given or those made, with the gait that is given or
 * those of the paper. Returns how many there are; 0: the message is on stderr. */
static int make_scenes(struct stiff_scene scenes[MOST_SCENES], const struct point *p)
{
  int count = 0;
  bool given = false;
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    given |= p->written[i] != NULL;
  for (size_t i = 0; i < (given ? 1 : sizeof made / sizeof *made); i++)
    for (int g = 0; p->has_gait ? g == 0 : scallop_gait_name(g) != NULL; g++) {
      struct scallop_crawler c = given ? p->crawler : scallop_crawler_default();
      c.gait = p->has_gait ? p->crawler.gait : scallop_gait_named(scallop_gait_name(g));
      c.F1 = given ? c.F1 : made[i].F1;
      c.T = given ? c.T : made[i].T;
      assert(count < MOST_SCENES);
      const char *why = stiff_scene_init(&scenes[count++], given ? "given" : made[i].name, &c);
      if (why) {
        complain("stress", "no certified period to compare with for the %s gait, T = %.17g: %s", c.gait->name, c.T,
                 why);
        return 0;
      }
    }
  return count;
}

static void note_scene(struct table *t, const struct stiff_scene *scene)
{
  const struct scallop_crawler *c = &scene->crawler;
  const struct stiff_held *held = &scene->held;
  table_note(t, "%s, %s: m1=%.17g m2=%.17g F1=%.17g F2=%.17g L=%.17g T=%.17g alpha=%.17g; eps = %.4g; %s",
             scene->names[0], c->gait->name, c->m1, c->m2, c->F1, c->F2, c->L, c->T, c->alpha, scene->scaled.eps,
             scene->modes);
  if (held->body != 0)
    table_note(t, "  body %d is stuck from t = %.4g to %.4g of the %s; half-way, by a force of %.4g of its friction",
               held->body, held->begin, held->end, held->phase == SCALLOP_EXTENSION ? "extension" : "contraction",
               held->force);
}

static void note_meaning(struct table *t, bool summary, long most)
{
  table_note(t, "friction F tanh(v/v_delta), v_delta = delta L/T; one period from the certified steady start velocity");
  table_note(t, "errors: answer - that of binary128, of v_end over L/T, of displacement over L; rejected steps count");
  table_note(t,
             "tolerance: 1e-9 delta, 1e-15 at least; own error: of the stepper, what ten times the tolerance changes");
  table_note(t, "a period of more than %ld accepted steps is cut off, and a series ends where the stepper gives up",
             most);
  table_note(t, "creep: how far a smoothed body goes, over L, while the exact one is stuck; predicted: at v_delta "
                "artanh(force/friction)");
  if (!summary)
    return table_note(t, "velocities: of that body over v_delta, in the middle of the time and, the last, at its end");
  table_note(t, "good_to: down to which delta the error at least halves with every tenth of delta, and is ten times "
                "the own error;");
  table_note(t,
             "order in delta: over those; worst_beyond: the largest |error| below, of an answer that the stepper was "
             "content with");
}

static void write_row(struct table *t, const struct stiff_scene *scene, const struct table_column *columns,
                      const void *row)
{
  for (int i = 0; names[i]; i++)
    table_text(t, scene->names[i]);
  table_row(t, columns, row, true);
}

/* As delta -> 0, until the stepper gives up */
static void run_series(struct table *t, const struct stiff_scene *scene, const struct stress_options *o)
{
  struct stiff_run runs[STIFF_MOST_RUNS];
  int count = 0;
  do {
    double delta = deltas[count];
    progress_show("%s, %s: delta = %g", scene->names[0], scene->names[1], delta);
    stiff_solve(scene, delta, stiff_tolerance(delta), o->quick ? QUICK_STEPS : MOST_STEPS, &runs[count]);
  } while (runs[count++].solved && count < (o->quick ? QUICK_DELTAS : DELTAS));
  for (int i = 0; i < count && !o->summary; i++)
    write_row(t, scene, of_run, &runs[i]);
  for (int quantity = 0; quantity < STIFF_QUANTITIES && o->summary; quantity++) {
    const struct stiff_trend trend = stiff_trend(runs, count, quantity);
    if (quantity != STIFF_CREEP || scene->held.body != 0)
      write_row(t, scene, of_trend, &trend);
  }
}

enum exit_code stress_stiff(const struct stress_options *o)
{
  struct stiff_scene scenes[MOST_SCENES];
  struct table t;
  int count = make_scenes(scenes, &o->request.point);
  if (count == 0)
    return EXIT_UNSOLVED;
  if (!table_head(&t, &o->request.style, "stress --stiff%s%s", o->quick ? " --quick" : "",
                  o->summary ? " --summary" : ""))
    return EXIT_FILE;
  t.of = o->summary ? "stiff orders" : "stiff";
  for (int i = 0; i < count; i++)
    note_scene(&t, &scenes[i]);
  note_meaning(&t, o->summary, o->quick ? QUICK_STEPS : MOST_STEPS);
  table_columns(&t, names);
  table_add(&t, o->summary ? of_trend : of_run);
  table_begin_rows(&t);
  for (int i = 0; i < count && !table_failed(&t); i++)
    run_series(&t, &scenes[i], o);
  progress_end();
  return table_close(&t) ? EXIT_DONE : EXIT_FILE;
}
