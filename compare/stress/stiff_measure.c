#include "compare/stress/stiff_measure.h"

#include <float.h>
#include <math.h>

#include <gsl/gsl_integration.h>

#include "compare/stress/periods.h"

/* Digits that the reference is proven to: errors down to the last bit of a double need twice as many */
enum { REFERENCE_DIGITS = 40 };

/* How many times the tolerance is taken to see what a stepper's own error is */
static const double LOOSER = 10;

const char *const stiff_quantities[] = { "v_end", "displacement", "creep", NULL };

struct stretch {
  struct scallop_scaled scaled;
  struct stiff_held now, *longest;
};

/* The friction that holds the body still over the most that there is, at a time in units of the phase, along the body's
 * own axis: it accelerates the centre of mass, which moves with +-l' times a share of the masses, together with that of
 * the body that moves. */
static double force_over_friction(const struct stretch *s, double time)
{
  const struct scallop_scaled *a = &s->scaled;
  double l2, eps = a->eps * a->fraction[s->now.phase] * a->fraction[s->now.phase];
  scallop_gait_at(a->gait, s->now.phase, time, NULL, NULL, &l2);
  double sign = s->now.phase == SCALLOP_EXTENSION ? 1 : -1;
  return s->now.body == 1 ? -(a->mu2 * l2 / eps + a->f2 * sign) / a->f1 : (a->mu1 * l2 / eps + a->f1 * sign) / a->f2;
}

/* The velocity at which smoothed friction is that force, over v_delta; kept finite where rounding takes the force to
 * the limit. */
static double creep_velocity(double time, void *context)
{
  const double most = 1 - DBL_EPSILON / 2;
  return atanh(fmax(-most, fmin(most, force_over_friction(context, time))));
}

static double integral(struct stretch *s, double begin, double end)
{
  enum { PARTS = 200 };
  gsl_integration_workspace *space = gsl_integration_workspace_alloc(PARTS);
  gsl_function velocity = { creep_velocity, s };
  double value = NAN, error;
  if (space && gsl_integration_qags(&velocity, begin, end, 0, 1e-9, PARTS, space, &value, &error) != 0)
    value = NAN;
  gsl_integration_workspace_free(space);
  return value;
}

static double period_share(const struct stretch *s, const struct stiff_held *held)
{
  return s->scaled.fraction[held->phase] * (held->end - held->begin);
}

/* Grows the stretch by an interval of the exact motion, or ends it. Times are in units of the phase, distances in delta
 * L. */
static void visit(void *context, const struct scallop_interval *interval)
{
  struct stretch *s = context;
  struct stiff_held *now = &s->now;
  bool from_start = interval->piece->anchor == SCALLOP_FROM_START;
  double begin = from_start ? interval->u_begin : 1 - interval->u_begin;
  double end = from_start ? interval->u_end : 1 - interval->u_end;
  int body = interval->mode.s1 == 0 ? 1 : interval->mode.s2 == 0 ? 2 : 0;
  if (body != now->body)
    *now = (struct stiff_held){ .body = body, .phase = now->phase, .v0 = now->v0, .begin = begin };
  if (body == 0)
    return;
  now->end = end;
  now->creep += s->scaled.fraction[now->phase] * integral(s, begin, end);
  if (period_share(s, now) > period_share(s, s->longest))
    *s->longest = *now;
}

static void find_held(struct stiff_scene *scene, double v_mid)
{
  struct stretch s = { .longest = &scene->held };
  const double v0[2] = { scene->v_start, v_mid };
  double duration[2] = { 0, 0 };
  scene->held = (struct stiff_held){ .body = 0 };
  scallop_scale(&scene->crawler, &s.scaled);
  for (int phase = SCALLOP_EXTENSION; phase <= SCALLOP_CONTRACTION; phase++) {
    s.now = (struct stiff_held){ .phase = (enum scallop_phase_kind)phase, .v0 = v0[phase] };
    scallop_phase_intervals(&scene->crawler, s.now.phase, s.now.v0, visit, &s);
    duration[phase] = scallop_phase_duration(&scene->crawler, s.now.phase);
  }
  if (scene->held.body == 0)
    return;
  s.now = scene->held;
  double middle = (s.now.begin + s.now.end) / 2;
  scene->held.force = fabs(force_over_friction(&s, middle));
  scene->held.velocity = creep_velocity(middle, &s);
  scene->held.begin *= duration[s.now.phase];
  scene->held.end *= duration[s.now.phase];
}

/* The certified steady start velocity, rounded, and the period from it: its own certified values, not those of the
 * steady state. */
static bool certify(struct stiff_scene *scene, const char **why)
{
  const struct motion steady = { .of = OF_STEADY, .crawler = scene->crawler };
  struct scallop_rational_crawler exact;
  struct ball_answer proven;
  struct ball_period period;
  fmpq_t v;
  fmpq_init(v);
  scallop_rational_init(&exact);
  ball_answer_init(&proven);
  ball_period_init(&period);
  scallop_rational_of(&exact, &scene->crawler);
  bool solved = answer_of_doubles(&proven, &steady, REFERENCE_DIGITS);
  *why = proven.why ? proven.why : scallop_status_text(proven.status);
  if (solved) {
    scene->v_start = ball_middle(proven.value[Q_V_START]).high;
    scene->regime = proven.regime;
    scallop_rational_set_double(v, scene->v_start);
    solved = ball_period_solve(&period, &exact, v, REFERENCE_DIGITS, why);
  }
  if (solved) {
    scene->v_end = ball_middle(period.v_end);
    scene->displacement = ball_middle(period.displacement);
    motion_modes_text(scene->modes, OF_STEADY, period.modes);
    find_held(scene, fmpq_get_d(period.v_mid));
  }
  ball_period_clear(&period);
  ball_answer_clear(&proven);
  scallop_rational_clear(&exact);
  fmpq_clear(v);
  return solved;
}

const char *stiff_scene_init(struct stiff_scene *scene, const char *name, const struct scallop_crawler *crawler)
{
  struct scallop_scaled scaled;
  const char *why = NULL;
  enum scallop_status status = scallop_scale(crawler, &scaled);
  *scene = (struct stiff_scene){ .name = name, .crawler = *crawler };
  if (status != SCALLOP_OK)
    return scallop_status_text(status);
  scene->eps = scaled.eps;
  return certify(scene, &why) ? NULL : why;
}

struct ration {
  long most, taken;
};

static bool ration_lasts(void *context)
{
  struct ration *r = context;
  return r->taken++ < r->most;
}

static double difference(double answer, const struct scallop_wide *value)
{
  return (answer - value->high) - value->low;
}

/* Samples at the beginning, in the middle and at the end of the stretch. */
static bool keep(void *context, const struct scallop_sample *sample)
{
  struct scallop_sample **next = context;
  *(*next)++ = *sample;
  return true;
}

static enum scallop_status look_inside(const struct stiff_scene *scene, struct scallop_rival *rival,
                                       const struct scallop_patience *patience, struct stiff_run *run)
{
  const struct stiff_held *held = &scene->held;
  const struct scallop_crawler *c = &scene->crawler;
  const double times[] = { held->begin, (held->begin + held->end) / 2, held->end }, unit = run->delta * c->L / c->T;
  struct scallop_sample sample[3] = { { 0 } }, *next = sample;
  enum scallop_status status = scallop_smoothed_phase(rival, c, held->phase, held->v0, patience, times, 3, keep, &next);
  if (status != SCALLOP_OK)
    return status;
  bool first = held->body == 1;
  run->error[STIFF_CREEP] = ((first ? sample[2].x1 : sample[2].x2) - (first ? sample[0].x1 : sample[0].x2)) / c->L;
  run->creep_over_delta = run->error[STIFF_CREEP] / run->delta;
  run->velocity = (first ? sample[1].v1 : sample[1].v2) / unit;
  run->last = (first ? sample[2].v1 : sample[2].v2) / unit;
  return SCALLOP_OK;
}

static enum scallop_status solve_period_smoothed(const struct stiff_scene *scene, struct scallop_rival *rival,
                                                 const struct scallop_patience *patience, struct stiff_run *run)
{
  const struct scallop_crawler *c = &scene->crawler;
  struct scallop_rival_period period;
  enum scallop_status status = rival->period(rival, c, scene->v_start, patience, &period);
  if (status != SCALLOP_OK)
    return status;
  run->error[STIFF_V_END] = difference(period.v_end, &scene->v_end) * c->T / c->L;
  run->error[STIFF_DISPLACEMENT] = difference(period.displacement, &scene->displacement) / c->L;
  run->steps = (double)period.steps;
  run->evaluations = (double)period.evaluations;
  return SCALLOP_OK;
}

static void describe(struct stiff_run *run, enum scallop_status status, const struct ration *ration)
{
  run->solved = status == SCALLOP_OK;
  if (run->solved)
    snprintf(run->status, sizeof run->status, "ok");
  else if (status == SCALLOP_ESTOPPED)
    snprintf(run->status, sizeof run->status, "cut off after %ld accepted steps", ration->most);
  else
    snprintf(run->status, sizeof run->status, "%s, after %ld accepted steps", scallop_status_text(status),
             ration->taken);
}

double stiff_tolerance(double delta)
{
  const double least = 1e-15;
  return fmax(least, 1e-9 * delta);
}

static void solve_once(const struct stiff_scene *scene, double delta, double tolerance, long most,
                       struct stiff_run *run)
{
  static const struct stiff_run unknown = {
    NAN, NAN, { NAN, NAN, NAN }, { NAN, NAN, NAN }, NAN, NAN, NAN, NAN, NAN, NAN, NAN, false, ""
  };
  bool held = scene->held.body != 0;
  *run = unknown;
  run->delta = delta;
  run->tolerance = tolerance;
  run->predicted_creep = held ? scene->held.creep : NAN;
  run->predicted_velocity = held ? scene->held.velocity : NAN;
  struct scallop_rival *rival = scallop_smoothed_rival(delta, tolerance);
  if (!rival) {
    snprintf(run->status, sizeof run->status, "out of memory");
    return;
  }
  struct ration ration = { .most = most };
  const struct scallop_patience patience = { ration_lasts, &ration };
  enum scallop_status status = solve_period_smoothed(scene, rival, &patience, run);
  if (status == SCALLOP_OK && held) {
    ration.taken = 0;
    status = look_inside(scene, rival, &patience, run);
  }
  describe(run, status, &ration);
  scallop_rival_destroy(rival);
}

void stiff_solve(const struct stiff_scene *scene, double delta, double tolerance, long most, struct stiff_run *run)
{
  struct stiff_run looser;
  solve_once(scene, delta, tolerance, most, run);
  if (!run->solved)
    return;
  solve_once(scene, delta, LOOSER * tolerance, most, &looser);
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
  struct scallop_order_point points[STIFF_MOST_RUNS];
  struct stiff_trend trend = { .worst_beyond = NAN };
  for (; trend.good < count && is_good(runs, trend.good, quantity); trend.good++)
    points[trend.good] = (struct scallop_order_point){ .h = runs[trend.good].delta,
                                                       .err = runs[trend.good].error[quantity] };
  for (int i = trend.good; i < count; i++)
    if (runs[i].solved)
      trend.worst_beyond = fmax(trend.worst_beyond, fabs(runs[i].error[quantity]));
  struct scallop_order_wanted wanted = { .order = 1, .tolerance = 0.1 };
  int good = trend.good;
  scallop_order(points, &good, &wanted, &trend.fit);
  return trend;
}
