#include "compare/stress/stiff_measure.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

#include <gsl/gsl_integration.h>

#include "compare/answers/answer_flint.h"

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

/* What smoothed friction makes of it */
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

static void find_held(struct stiff_scene *scene, const struct answer *starts)
{
  const struct motion steady = { .of = OF_STEADY, .crawler = scene->crawler };
  const double v0[] = { starts->value[Q_V_START].high, starts->value[Q_V_MID].high };
  const double since[] = { 0, scallop_phase_duration(&scene->crawler, SCALLOP_EXTENSION) };
  struct stretch all[MOST_STRETCHES];
  struct stiff_held now = { .body = 0 };
  int count = stretches_of(all, &steady, starts);
  for (const struct stretch *s = all; s < all + count && s < all + MOST_STRETCHES; s++) {
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

/* The certified steady start velocity, rounded, and the period from it: its own values, not those of the steady
 * state. */
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
  const struct answer starts = { .value = { [Q_V_START] = period.v_start, [Q_V_MID] = period.v_mid } };
  scene->names[2] = scallop_regime_text(steady.regime);
  scene->v_end = period.v_end;
  scene->displacement = period.displacement;
  motion_modes_text(scene->modes, OF_STEADY, period.modes);
  find_held(scene, &starts);
  return NULL;
}

/* Counts the steps down that are left. */
static bool lasts(void *left) { return --*(long *)left >= 0; }

/* Follows the stuck body from the beginning over the middle to the end of the stretch. */
static enum scallop_status look_inside(const struct stiff_scene *scene, struct scallop_rival *rival,
                                       const struct scallop_patience *patience, struct stiff_run *run)
{
  const struct stiff_held *held = &scene->held;
  const struct scallop_crawler *c = &scene->crawler;
  const double unit = run->delta * c->L / c->T;
  struct scallop_sample sample[] = { { .t = held->begin }, { .t = (held->begin + held->end) / 2 }, { .t = held->end } };
  enum scallop_status status = scallop_smoothed_phase(rival, c, held->phase, held->v0, patience, sample, 3);
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

static void solve_with(struct scallop_rival *rival, const struct stiff_scene *scene, long most, struct stiff_run *run)
{
  const struct scallop_crawler *c = &scene->crawler;
  long left = most;
  const struct scallop_patience patience = { lasts, &left };
  struct scallop_rival_period period;
  enum scallop_status status = rival->period(rival, c, scene->v_start, &patience, &period);
  if (status == SCALLOP_OK) {
    run->error[STIFF_V_END] = difference(period.v_end, scene->v_end) * c->T / c->L;
    run->error[STIFF_DISPLACEMENT] = difference(period.displacement, scene->displacement) / c->L;
    run->steps = (double)period.steps;
    run->evaluations = (double)period.evaluations;
  }
  if (status == SCALLOP_OK && scene->held.body != 0) {
    left = most;
    status = look_inside(scene, rival, &patience, run);
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

static const struct stiff_run unknown = {
  NAN, NAN, { NAN, NAN, NAN }, { NAN, NAN, NAN }, NAN, NAN, NAN, NAN, NAN, NAN, NAN, false, "out of memory"
};

static void solve_once(const struct stiff_scene *scene, double delta, double tolerance, long most,
                       struct stiff_run *run)
{
  struct scallop_rival *rival = scallop_smoothed_rival(delta, tolerance);
  *run = unknown;
  run->delta = delta;
  run->tolerance = tolerance;
  run->predicted_creep = scene->held.creep;
  run->predicted_velocity = scene->held.velocity;
  if (rival)
    solve_with(rival, scene, most, run);
  scallop_rival_destroy(rival);
}

void stiff_solve(const struct stiff_scene *scene, double delta, double tolerance, long most, struct stiff_run *run)
{
  struct stiff_run looser;
  solve_once(scene, delta, tolerance, most, run);
  if (!run->solved)
    return;
  solve_once(scene, delta, 10 * tolerance, most, &looser);
  for (int i = 0; i < STIFF_QUANTITIES; i++)
    run->own[i] = fabs(run->error[i] - looser.error[i]);
}

static bool is_good(const struct stiff_run *runs, int i, int quantity)
{
  double error = fabs(runs[i].error[quantity]);
  bool outweighs = runs[i].solved && runs[i].own[quantity] <= 0.1 * error;
  return outweighs && (i == 0 || error <= 0.5 * fabs(runs[i - 1].error[quantity]));
}

struct stiff_trend stiff_trend(const struct stiff_run *runs, int count, int quantity)
{
  static const char *const names[STIFF_QUANTITIES] = { "v_end", "displacement", "creep" };
  const struct scallop_order_wanted wanted = { .order = 1, .tolerance = 0.1 };
  struct scallop_order_point points[STIFF_MOST_RUNS];
  struct stiff_trend t = { .quantity = names[quantity],
                           .best = unknown,
                           .last = count > 0 ? runs[count - 1] : unknown,
                           .error_there = NAN,
                           .worst_beyond = NAN };
  for (; t.good < count && is_good(runs, t.good, quantity); t.good++) {
    t.best = runs[t.good];
    t.error_there = t.best.error[quantity];
    points[t.good] = (struct scallop_order_point){ .h = t.best.delta, .err = t.error_there };
  }
  for (int i = t.good; i < count; i++)
    if (runs[i].solved)
      t.worst_beyond = fmax(t.worst_beyond, fabs(runs[i].error[quantity]));
  t.gives_up_at = t.last.solved ? NAN : t.last.delta;
  int good = t.good;
  scallop_order(points, &good, &wanted, &t.fit);
  t.verdict = scallop_order_verdict_text(t.fit.verdict);
  return t;
}
