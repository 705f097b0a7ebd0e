/* `stress --stiff`: scenes, single runs, and the table. */
#include "compare/stress/stiff.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>

#include <gsl/gsl_integration.h>

#include "compare/answers/answer_flint.h"
#include "compare/stress/stress.h"
#include "compare/text/progress.h"
#include "numerics/integrators/integrator.h"

enum { DIGITS = 40 }; /* errors down to the last bit of a double need twice as many as it has */

/* The friction that holds the body still over the most that there is, at a time since the phase began, along the body's
 * own axis: it accelerates the centre of mass, which moves with +-l' times a share of the masses, together with that of
 * the body that moves. */
static double force_over_friction(const struct stiff_scene *scene, double time)
{
  const struct scallop_scaled *a = &scene->scaled;
  const enum scallop_phase_kind phase = scene->held.phase;
  double l2, eps = a->eps * a->fraction[phase] * a->fraction[phase], sign = phase == SCALLOP_EXTENSION ? 1 : -1;
  scallop_gait_at(a->gait, phase, time / scallop_phase_duration(&scene->crawler, phase), NULL, NULL, &l2);
  return scene->held.body == 1 ? -(a->mu2 * l2 / eps + a->f2 * sign) / a->f1
                               : (a->mu1 * l2 / eps + a->f1 * sign) / a->f2;
}

/* The velocity at which smoothed friction is that force, over v_delta; kept finite where rounding takes the force to
 * the limit. */
static double creep_velocity(double time, void *scene)
{
  const double most = 1 - DBL_EPSILON / 2;
  return atanh(fmax(-most, fmin(most, force_over_friction(scene, time))));
}

static void predict(struct stiff_scene *scene)
{
  enum { PARTS = 200 };
  struct stiff_held *held = &scene->held;
  double middle = (held->begin + held->end) / 2, way = NAN, error;
  gsl_integration_workspace *space = gsl_integration_workspace_alloc(PARTS);
  gsl_function velocity = { creep_velocity, scene };
  bool done = space
              && gsl_integration_qags(&velocity, held->begin, held->end, 0, 1e-9, PARTS, space, &way, &error) == 0;
  gsl_integration_workspace_free(space);
  held->force = fabs(force_over_friction(scene, middle));
  held->velocity = creep_velocity(middle, scene);
  held->creep = done ? way / scene->crawler.T : NAN;
}

static void find_held(struct stiff_scene *scene, const struct scallop_wide_period *period)
{
  const struct motion steady = { .of = OF_STEADY, .crawler = scene->crawler };
  const struct answer starts = { .value = { [Q_V_START] = period->v_start, [Q_V_MID] = period->v_mid } };
  const double v0[] = { period->v_start.high, period->v_mid.high };
  const double since[] = { 0, scallop_phase_duration(&scene->crawler, SCALLOP_EXTENSION) };
  struct segment all[MAX_SEGMENTS];
  struct stiff_held now = { .body = 0 };
  int count = motion_segments(all, &steady, &starts);
  for (const struct segment *s = all; s < all + count && s < all + MAX_SEGMENTS; s++) {
    int body = s->mode.s1 == 0 ? 1 : s->mode.s2 == 0 ? 2 : 0;
    if (body != now.body || s->phase != now.phase)
      now = (struct stiff_held){ body, s->phase, v0[s->phase], .begin = s->from - since[s->phase] };
    now.end = s->until - since[s->phase];
    if (body != 0 && now.end - now.begin > scene->held.end - scene->held.begin)
      scene->held = now;
  }
  if (scene->held.body != 0)
    predict(scene);
}

/* The period has its own values, not those of the steady state, whose v_start is rounded. */
const char *stiff_scene_init(struct stiff_scene *scene, const char *name, const struct scallop_crawler *crawler)
{
  const struct motion motion = { .of = OF_STEADY, .crawler = *crawler };
  struct scallop_wide_period period;
  SCOPED(ball_answer, steady);
  *scene = (struct stiff_scene){ .names = { name, crawler->gait->name, NULL, "msbdf" },
                                 .crawler = *crawler,
                                 .held = { .velocity = NAN, .creep = NAN } };
  enum scallop_status status = scallop_scale(crawler, &scene->scaled);
  if (status == SCALLOP_OK && !answer_of_doubles(&steady, &motion, DIGITS))
    return steady.why ? steady.why : scallop_status_text(steady.status);
  if (status == SCALLOP_OK) {
    const arb_struct *v = steady.value[Q_V_START];
    scene->v_start = arb_contains_zero(v) ? 0 : arf_get_d(arb_midref(v), ARF_RND_NEAR);
    status = scallop_wide_period(SCALLOP_BINARY128, crawler, scene->v_start, &period);
  }
  if (status != SCALLOP_OK)
    return scallop_status_text(status);
  scene->names[2] = scallop_regime_text(steady.regime);
  scene->v_end = period.v_end;
  scene->displacement = period.displacement;
  motion_modes_text(scene->modes, OF_STEADY, period.modes);
  find_held(scene, &period);
  return NULL;
}

/* Runs */

/* Counts the steps down that are left. */
static bool lasts(void *left) { return --*(long *)left >= 0; }

/* Follows the stuck body from the beginning over the middle to the end of the stretch. */
static enum scallop_status look_inside(const struct stiff_scene *scene, struct scallop_integrator *integrator,
                                       const struct scallop_patience *patience, struct stiff_run *run)
{
  const struct stiff_held *held = &scene->held;
  const struct scallop_crawler *c = &scene->crawler;
  const double unit = run->delta * c->L / c->T;
  struct scallop_sample sample[] = { { .t = held->begin }, { .t = (held->begin + held->end) / 2 }, { .t = held->end } };
  enum scallop_status status = scallop_smoothed_phase(integrator, c, held->phase, held->v0, patience, sample, 3);
  if (status != SCALLOP_OK)
    return status;
  bool first = held->body == 1;
  run->error[STIFF_CREEP] = ((first ? sample[2].x1 : sample[2].x2) - (first ? sample[0].x1 : sample[0].x2)) / c->L;
  run->creep_over_delta = run->error[STIFF_CREEP] / run->delta;
  run->velocity = (first ? sample[1].v1 : sample[1].v2) / unit;
  run->last = (first ? sample[2].v1 : sample[2].v2) / unit;
  return SCALLOP_OK;
}

static double difference(double answer, struct scallop_wide value) { return (answer - value.high) - value.low; }

static void solve_with(struct scallop_integrator *integrator, const struct stiff_scene *scene, long most,
                       struct stiff_run *run)
{
  const struct scallop_crawler *c = &scene->crawler;
  long left = most;
  const struct scallop_patience patience = { lasts, &left };
  struct scallop_integrator_period period;
  enum scallop_status status = integrator->period(integrator, c, scene->v_start, &patience, &period);
  if (status == SCALLOP_OK) {
    run->error[STIFF_V_END] = difference(period.v_end, scene->v_end) * c->T / c->L;
    run->error[STIFF_DISPLACEMENT] = difference(period.displacement, scene->displacement) / c->L;
    run->steps = (double)period.steps;
    run->evaluations = (double)period.evaluations;
  }
  if (status == SCALLOP_OK && scene->held.body != 0) {
    left = most;
    status = look_inside(scene, integrator, &patience, run);
  }
  run->solved = status == SCALLOP_OK;
  if (run->solved)
    snprintf(run->status, STIFF_STATUS, "ok");
  else if (status == SCALLOP_ESTOPPED)
    snprintf(run->status, STIFF_STATUS, "cut off after %ld accepted steps", most);
  else
    snprintf(run->status, STIFF_STATUS, "%s, after %ld accepted steps", scallop_status_text(status), most - left);
}

double stiff_tolerance(double delta) { return fmax(1e-15, 1e-9 * delta); }

static struct stiff_run solve_once(const struct stiff_scene *scene, double delta, double tolerance, long most)
{
  struct scallop_integrator *integrator = scallop_smoothed_integrator(delta, tolerance);
  struct stiff_run run = { delta, tolerance, { NAN, NAN, NAN }, { NAN, NAN, NAN },    NAN,
                           NAN,   NAN,       scene->held.creep, scene->held.velocity, NAN,
                           NAN,   false,     "out of memory" };
  if (integrator)
    solve_with(integrator, scene, most, &run);
  scallop_integrator_destroy(integrator);
  return run;
}

void stiff_solve(const struct stiff_scene *scene, double delta, double tolerance, long most, struct stiff_run *run)
{
  *run = solve_once(scene, delta, tolerance, most);
  if (!run->solved)
    return;
  const struct stiff_run looser = solve_once(scene, delta, 10 * tolerance, most);
  for (int i = 0; i < STIFF_QUANTITIES; i++)
    run->own[i] = fabs(run->error[i] - looser.error[i]);
}

/* Tables */

static const char *const names[] = { "scene", "gait", "regime", "stepper", NULL };

static void put_status(struct table *t, const struct table_column *c, const void *row)
{
  table_text(t, (const char *)row + c->at);
}

#define AT(member) offsetof(struct stiff_run, member)
static const struct table_column columns[] = {
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
  { TABLE_COLUMN("status", put_status, AT(status)) },
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
  { "stiff", 1.01, 100 }, /* eps = 1005 */
};
enum { MADE = sizeof made / sizeof *made, MOST_SCENES = 2 * MADE };

/* All are solved before anything is written: the crawler that is given or those made, with the gait that is given or
 * those of the paper. Returns how many there are; 0: the message is on stderr. */
static int make_scenes(struct stiff_scene scenes[MOST_SCENES], const struct point *p)
{
  int count = 0;
  bool given = false;
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    given |= p->written[i] != NULL;
  for (int i = 0; i < (given ? 1 : MADE); i++)
    for (int g = 0; p->has_gait ? g == 0 : scallop_gait_name(g) != NULL; g++) {
      struct scallop_crawler c = given ? p->crawler : scallop_crawler_default();
      c.gait = p->has_gait ? p->crawler.gait : scallop_gait_named(scallop_gait_name(g));
      c.F1 = given ? c.F1 : made[i].F1;
      c.T = given ? c.T : made[i].T;
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

static void note_meaning(struct table *t, long most)
{
  table_note(t, "friction F tanh(v/v_delta), v_delta = delta L/T; one period from the certified steady start velocity");
  table_note(t, "errors: answer - that of binary128, of v_end over L/T, of displacement over L; rejected steps count");
  table_note(t,
             "tolerance: 1e-9 delta, 1e-15 at least; own error: of the stepper, what ten times the tolerance changes");
  table_note(t, "a period of more than %ld accepted steps is cut off, and a series ends where the stepper gives up",
             most);
  table_note(t, "creep: how far a smoothed body goes, over L, while the exact one is stuck; predicted: at v_delta "
                "artanh(force/friction)");
  table_note(t, "velocities: of that body over v_delta, in the middle of the time and, the last, at its end");
}

/* As delta -> 0, until the stepper gives up */
static void run_series(struct table *t, const struct stiff_scene *scene, bool quick)
{
  const int count = quick ? QUICK_DELTAS : DELTAS;
  struct stiff_run run = { .solved = true };
  for (const double *delta = deltas; delta < deltas + count && run.solved; delta++) {
    progress_show("%s, %s: delta = %g", scene->names[0], scene->names[1], *delta);
    stiff_solve(scene, *delta, stiff_tolerance(*delta), quick ? QUICK_STEPS : MOST_STEPS, &run);
    for (int i = 0; names[i]; i++)
      table_text(t, scene->names[i]);
    table_row(t, columns, &run, true);
  }
}

enum exit_code stress_stiff(const struct stress_options *o)
{
  struct stiff_scene scenes[MOST_SCENES];
  struct table t;
  int count = make_scenes(scenes, &o->request.point);
  if (count == 0)
    return EXIT_UNSOLVED;
  if (!table_head(&t, &o->request.style, "stress --stiff%s", o->quick ? " --quick" : ""))
    return EXIT_FILE;
  t.of = "stiff";
  for (int i = 0; i < count; i++)
    note_scene(&t, &scenes[i]);
  note_meaning(&t, o->quick ? QUICK_STEPS : MOST_STEPS);
  table_columns(&t, names);
  table_add(&t, columns);
  table_begin_rows(&t);
  for (int i = 0; i < count && !table_failed(&t); i++)
    run_series(&t, &scenes[i], o->quick);
  progress_end();
  return table_close(&t) ? EXIT_DONE : EXIT_FILE;
}
