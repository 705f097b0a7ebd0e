/* Smoothed friction for `stress --stiff`: scenes, single solutions, and the table. */
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

enum { DIGITS = 40 }; /* errors down to the last bit of a double need twice its digits */

/* Returns the friction on the stuck body over its maximum, at a time since the start of the phase: together with the
 * friction on the other body it accelerates the centre of mass, which moves at +-l' times a share of the masses. */
static double force_over_friction(const struct stiff_scene *scene, double time)
{
  const struct scallop_scaled *a = &scene->scaled;
  const enum scallop_phase_kind phase = scene->stuck.phase;
  double l2, eps = a->eps * a->fraction[phase] * a->fraction[phase], sign = phase == SCALLOP_EXTENSION ? 1 : -1;
  scallop_gait_at(a->gait, phase, time / scallop_phase_duration(&scene->crawler, phase), NULL, NULL, &l2);
  return scene->stuck.body == 1 ? -(a->mu2 * l2 / eps + a->f2 * sign) / a->f1
                                : (a->mu1 * l2 / eps + a->f1 * sign) / a->f2;
}

/* Returns the velocity, over v_delta, at which smoothed friction is this force; finite if the force is rounded to the
 * maximum. */
static double creep_velocity(double time, void *scene)
{
  const double max = 1 - DBL_EPSILON / 2;
  return atanh(fmax(-max, fmin(max, force_over_friction(scene, time))));
}

static void predict(struct stiff_scene *scene)
{
  enum { PARTS = 200 };
  struct stiff_interval *stuck = &scene->stuck;
  double middle = (stuck->begin + stuck->end) / 2, way = NAN, error;
  gsl_integration_workspace *space = gsl_integration_workspace_alloc(PARTS);
  gsl_function velocity = { creep_velocity, scene };
  bool done = space
              && gsl_integration_qags(&velocity, stuck->begin, stuck->end, 0, 1e-9, PARTS, space, &way, &error) == 0;
  gsl_integration_workspace_free(space);
  stuck->force = fabs(force_over_friction(scene, middle));
  stuck->velocity = creep_velocity(middle, scene);
  stuck->creep = done ? way / scene->crawler.T : NAN;
}

static void find_stuck(struct stiff_scene *scene, const struct scallop_wide_period *period)
{
  const struct motion steady = { .of = OF_STEADY, .crawler = scene->crawler };
  const struct answer starts = { .value = { [Q_V_START] = period->v_start, [Q_V_MID] = period->v_mid } };
  const double v0[] = { period->v_start.high, period->v_mid.high };
  const double since[] = { 0, scallop_phase_duration(&scene->crawler, SCALLOP_EXTENSION) };
  struct mode_segment all[MAX_SEGMENTS];
  struct stiff_interval now = { .body = 0 };
  int count = motion_segments(all, &steady, &starts);
  for (const struct mode_segment *s = all; s < all + count && s < all + MAX_SEGMENTS; s++) {
    int body = s->mode.s1 == 0 ? 1 : s->mode.s2 == 0 ? 2 : 0;
    if (body != now.body || s->phase != now.phase)
      now = (struct stiff_interval){ body, s->phase, v0[s->phase], .begin = s->from - since[s->phase] };
    now.end = s->until - since[s->phase];
    if (body != 0 && now.end - now.begin > scene->stuck.end - scene->stuck.begin)
      scene->stuck = now;
  }
  if (scene->stuck.body != 0)
    predict(scene);
}

/* v_end and displacement are of the period from the rounded v_start, and differ from the steady ones. */
const char *stiff_scene_init(struct stiff_scene *scene, const char *name, const struct scallop_crawler *crawler)
{
  const struct motion motion = { .of = OF_STEADY, .crawler = *crawler };
  struct scallop_wide_period period;
  SCOPED(ball_answer, steady);
  *scene = (struct stiff_scene){ .names = { name, crawler->gait->name, NULL, "msbdf" },
                                 .crawler = *crawler,
                                 .stuck = { .velocity = NAN, .creep = NAN } };
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
  find_stuck(scene, &period);
  return NULL;
}

/* Solutions */

/* Counts down the steps that remain. */
static bool has_steps(void *left) { return --*(long *)left >= 0; }

/* Solves the phase of the stuck interval, and samples the stuck body at its beginning, middle and end. */
static enum scallop_status sample_creep(const struct stiff_scene *scene, struct scallop_integrator *integrator,
                                        const struct scallop_patience *patience, struct stiff_result *result)
{
  const struct stiff_interval *stuck = &scene->stuck;
  const struct scallop_crawler *c = &scene->crawler;
  const double unit = result->delta * c->L / c->T;
  struct scallop_sample sample[] = { { .t = stuck->begin },
                                     { .t = (stuck->begin + stuck->end) / 2 },
                                     { .t = stuck->end } };
  enum scallop_status status = scallop_smoothed_phase(integrator, c, stuck->phase, stuck->v0, patience, sample, 3);
  if (status != SCALLOP_OK)
    return status;
  bool first = stuck->body == 1;
  result->error[STIFF_CREEP] = ((first ? sample[2].x1 : sample[2].x2) - (first ? sample[0].x1 : sample[0].x2)) / c->L;
  result->creep_over_delta = result->error[STIFF_CREEP] / result->delta;
  result->velocity = (first ? sample[1].v1 : sample[1].v2) / unit;
  result->last = (first ? sample[2].v1 : sample[2].v2) / unit;
  return SCALLOP_OK;
}

static double difference(double answer, struct scallop_wide value) { return (answer - value.high) - value.low; }

static void solve_with(struct scallop_integrator *integrator, const struct stiff_scene *scene, long max_steps,
                       struct stiff_result *result)
{
  const struct scallop_crawler *c = &scene->crawler;
  long left = max_steps;
  const struct scallop_patience patience = { has_steps, &left };
  struct scallop_integrator_period period;
  enum scallop_status status = integrator->period(integrator, c, scene->v_start, &patience, &period);
  if (status == SCALLOP_OK) {
    result->error[STIFF_V_END] = difference(period.v_end, scene->v_end) * c->T / c->L;
    result->error[STIFF_DISPLACEMENT] = difference(period.displacement, scene->displacement) / c->L;
    result->steps = (double)period.steps;
    result->evaluations = (double)period.evaluations;
  }
  if (status == SCALLOP_OK && scene->stuck.body != 0) {
    left = max_steps;
    status = sample_creep(scene, integrator, &patience, result);
  }
  result->solved = status == SCALLOP_OK;
  if (result->solved)
    snprintf(result->status, STIFF_STATUS, "ok");
  else if (status == SCALLOP_ESTOPPED)
    snprintf(result->status, STIFF_STATUS, "cut off after %ld accepted steps", max_steps);
  else
    snprintf(result->status, STIFF_STATUS, "%s, after %ld accepted steps", scallop_status_text(status),
             max_steps - left);
}

double stiff_tolerance(double delta) { return fmax(1e-15, 1e-9 * delta); }

static struct stiff_result solve_once(const struct stiff_scene *scene, double delta, double tolerance, long max_steps)
{
  struct scallop_integrator *integrator = scallop_smoothed_integrator(delta, tolerance);
  struct stiff_result result = { delta, tolerance, { NAN, NAN, NAN },  { NAN, NAN, NAN },     NAN,
                                 NAN,   NAN,       scene->stuck.creep, scene->stuck.velocity, NAN,
                                 NAN,   false,     "out of memory" };
  if (integrator)
    solve_with(integrator, scene, max_steps, &result);
  scallop_integrator_destroy(integrator);
  return result;
}

void stiff_solve(const struct stiff_scene *scene, double delta, double tolerance, long max_steps,
                 struct stiff_result *result)
{
  *result = solve_once(scene, delta, tolerance, max_steps);
  if (!result->solved)
    return;
  const struct stiff_result looser = solve_once(scene, delta, 10 * tolerance, max_steps);
  for (int i = 0; i < STIFF_QUANTITIES; i++)
    result->own_error[i] = fabs(result->error[i] - looser.error[i]);
}

/* Tables */

static const char *const names[] = { "scene", "gait", "regime", "stepper", NULL };

static void put_status(struct table *t, const struct table_column *c, const void *row)
{
  table_text(t, (const char *)row + c->at);
}

#define AT(member) offsetof(struct stiff_result, member)
static const struct table_column columns[] = {
  { TABLE_COLUMN("delta", column_rounded, AT(delta)), .format = "%.3g" },
  { TABLE_COLUMN("tolerance", column_rounded, AT(tolerance)), .format = "%.3g" },
  { TABLE_COLUMN("v_end_error", column_rounded, AT(error[STIFF_V_END])), .format = "%.3g" },
  { TABLE_COLUMN("displacement_error", column_rounded, AT(error[STIFF_DISPLACEMENT])), .format = "%.3g" },
  { TABLE_COLUMN("v_end_own_error", column_rounded, AT(own_error[STIFF_V_END])), .format = "%.2g" },
  { TABLE_COLUMN("displacement_own_error", column_rounded, AT(own_error[STIFF_DISPLACEMENT])), .format = "%.2g" },
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
enum { DELTAS = sizeof deltas / sizeof *deltas, QUICK_DELTAS = 5, MAX_STEPS = 100000, QUICK_STEPS = 10000 };

static const struct {
  const char *name;
  double F1, T;
} made[] = {
  { "sliding", 4, 1 },
  { "stick-slip", 4, 4 }, /* released by a jump of l'' in the quadratic gait, gradually in the sinusoidal one */
  { "stiff", 1.01, 100 }, /* eps = 1005 */
};
enum { MADE = sizeof made / sizeof *made, MAX_SCENES = 2 * MADE };

/* Solves all scenes before anything is written: the given crawler or the three above, with the given gait or the
 * paper's. Returns their count; 0: failed, with a message on stderr. */
static int make_scenes(struct stiff_scene scenes[MAX_SCENES], const struct point *p)
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
  const struct stiff_interval *stuck = &scene->stuck;
  table_note(t, "%s, %s: m1=%.17g m2=%.17g F1=%.17g F2=%.17g L=%.17g T=%.17g alpha=%.17g; eps = %.4g; %s",
             scene->names[0], c->gait->name, c->m1, c->m2, c->F1, c->F2, c->L, c->T, c->alpha, scene->scaled.eps,
             scene->modes);
  if (stuck->body != 0)
    table_note(t, "  body %d is stuck from t = %.4g to %.4g of the %s; half-way, by a force of %.4g of its friction",
               stuck->body, stuck->begin, stuck->end, stuck->phase == SCALLOP_EXTENSION ? "extension" : "contraction",
               stuck->force);
}

static void note_meaning(struct table *t, long max_steps)
{
  table_note(t, "friction F tanh(v/v_delta), v_delta = delta L/T; one period from the certified steady start velocity");
  table_note(t, "errors: answer - that of binary128, of v_end over L/T, of displacement over L; rejected steps count");
  table_note(t,
             "tolerance: 1e-9 delta, 1e-15 at least; own error: of the stepper, what ten times the tolerance changes");
  table_note(t, "a period of more than %ld accepted steps is cut off, and a series ends where the stepper gives up",
             max_steps);
  table_note(t, "creep: how far a smoothed body goes, over L, while the exact one is stuck; predicted: at v_delta "
                "artanh(force/friction)");
  table_note(t, "velocities: of that body over v_delta, in the middle of the time and, the last, at its end");
}

/* Writes a row for each delta, until the stepper fails. */
static void write_series(struct table *t, const struct stiff_scene *scene, bool quick)
{
  const int count = quick ? QUICK_DELTAS : DELTAS;
  struct stiff_result result = { .solved = true };
  for (const double *delta = deltas; delta < deltas + count && result.solved; delta++) {
    progress_show("%s, %s: delta = %g", scene->names[0], scene->names[1], *delta);
    stiff_solve(scene, *delta, stiff_tolerance(*delta), quick ? QUICK_STEPS : MAX_STEPS, &result);
    for (int i = 0; names[i]; i++)
      table_text(t, scene->names[i]);
    table_row(t, columns, &result, true);
  }
}

enum exit_code stress_stiff(const struct stress_options *o)
{
  struct stiff_scene scenes[MAX_SCENES];
  struct table t;
  int count = make_scenes(scenes, &o->request.point);
  if (count == 0)
    return EXIT_UNSOLVED;
  if (!table_head(&t, &o->request.style, "stress --stiff%s", o->quick ? " --quick" : ""))
    return EXIT_FILE;
  t.of = "stiff";
  for (int i = 0; i < count; i++)
    note_scene(&t, &scenes[i]);
  note_meaning(&t, o->quick ? QUICK_STEPS : MAX_STEPS);
  table_columns(&t, names);
  table_add(&t, columns);
  table_begin_rows(&t);
  for (int i = 0; i < count && !table_failed(&t); i++)
    write_series(&t, &scenes[i], o->quick);
  progress_end();
  return table_close(&t) ? EXIT_DONE : EXIT_FILE;
}
