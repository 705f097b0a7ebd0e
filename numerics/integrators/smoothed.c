#include "numerics/integrators/integrator.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include "numerics/event/motion.h"
#include "numerics/integrators/integrator_phases.h"

enum { DIMENSION = 2 };

/* The first step tried in a period, and the longest. Between two layers of friction the velocity is a straight line.
 * These methods solve it exactly, and the step control would lengthen the step until it leaps over the next layer.
 * Powers of two: steps of a tenth leave an ulp of a phase. */
static const double first_step = 0x1p-10, longest_step = 0x1p-5;

struct smoothed {
  struct scallop_integrator integrator; /* first member: a pointer to it is one to the struct */
  gsl_odeiv2_driver *driver;            /* msbdf reads its tolerance; else only its parts are used */
  double delta;
};

/* The samples of a phase that are to come; empty for a period. */
struct watch {
  const struct scallop_crawler *crawler;
  enum scallop_phase_kind kind;
  double duration;
  struct scallop_sample *sample; /* t is set */
  int count;
};

struct smoothed_run {
  struct integrator_phases phases; /* first member: a pointer to it is one to the struct */
  const struct smoothed *tools;
  const struct scallop_piece *piece;
  double d; /* the velocity over which friction is smoothed */
  double h; /* what the step control suggests               */
  struct watch watch;
};

static int equation(double t, const double y[], double dydt[], void *params)
{
  struct smoothed_run *run = params;
  struct integrator_phases *r = &run->phases;
  double c = y[0], l1 = run->piece->curve->velocity(run->piece, integrator_flip(run->piece, t));
  dydt[0] = -r->eps * (r->f[0] * tanh((c - r->mu[1] * l1) / run->d) + r->f[1] * tanh((c + r->mu[0] * l1) / run->d));
  dydt[1] = c;
  r->evaluations++;
  return GSL_SUCCESS;
}

/* Returns d tanh(x)/dx. Not 1/cosh(x)^2: cosh overflows on the way to 0. */
static double tanh_slope(double x)
{
  double t = tanh(x);
  return (1 - t) * (1 + t);
}

static int jacobian(double t, const double y[], double *dfdy, double dfdt[], void *params)
{
  struct smoothed_run *run = params;
  struct integrator_phases *r = &run->phases;
  double c = y[0], l1, l2, steepness = r->eps / run->d;
  piece_rates(run->piece, integrator_flip(run->piece, t), &l1, &l2);
  double slope1 = r->f[0] * tanh_slope((c - r->mu[1] * l1) / run->d);
  double slope2 = r->f[1] * tanh_slope((c + r->mu[0] * l1) / run->d);
  dfdy[0] = -steepness * (slope1 + slope2);
  dfdy[1] = 0;
  dfdy[2] = 1;
  dfdy[3] = 0;
  dfdt[0] = steepness * ((r->mu[1] * slope1 - r->mu[0] * slope2) * l2);
  dfdt[1] = 0;
  r->evaluations++;
  return GSL_SUCCESS;
}

static long steps_of(const gsl_odeiv2_evolve *e) { return (long)(e->count + e->failed_steps); }

static enum scallop_status one_step(struct smoothed_run *run, double *t, double end, double y[])
{
  const gsl_odeiv2_driver *d = run->tools->driver;
  const gsl_odeiv2_system system = { equation, jacobian, DIMENSION, run };
  if (!integrator_patience_lasts(run->phases.patience))
    return SCALLOP_ESTOPPED;
  run->h = fmin(run->h, longest_step);
  if (gsl_odeiv2_evolve_apply(d->e, d->c, d->s, &system, t, end, &run->h, y) != GSL_SUCCESS || !isfinite(y[0]))
    return SCALLOP_ECONVERGE;
  return run->phases.steps + steps_of(d->e) > INTEGRATOR_MAX_STEPS ? SCALLOP_ECONVERGE : SCALLOP_OK;
}

static double next_time(const struct watch *w) { return w->count > 0 ? w->sample->t / w->duration : INFINITY; }

static struct scallop_sample sample_at(const struct smoothed_run *run, double t, const double y[])
{
  const struct watch *w = &run->watch;
  const struct integrator_phases *r = &run->phases;
  double length, start, L = w->crawler->L, unit = L / w->duration;
  double l1 = run->piece->curve->velocity(run->piece, integrator_flip(run->piece, t));
  scallop_gait_at(w->crawler->gait, w->kind, 0, &start, NULL, NULL);
  scallop_gait_at(w->crawler->gait, w->kind, t, &length, NULL, NULL);
  struct scallop_sample s = { .t = w->sample->t, .l = L * length };
  s.x1 = L * (y[1] - r->mu[1] * (length - start));
  s.x2 = s.x1 + s.l;
  s.xC = s.x1 + s.l / 2;
  s.v1 = unit * (y[0] - r->mu[1] * l1);
  s.v2 = unit * (y[0] + r->mu[0] * l1);
  return s;
}

/* Takes the samples that are due now, or so soon that a step to there would be too short. */
static enum scallop_status take_due(struct smoothed_run *run, double t, const double y[])
{
  struct watch *w = &run->watch;
  for (; next_time(w) <= t + 4 * DBL_EPSILON; w->sample++, w->count--) {
    struct scallop_sample s = sample_at(run, t, y);
    if (!isfinite(s.x1) || !isfinite(s.x2) || !isfinite(s.v1) || !isfinite(s.v2))
      return SCALLOP_ERANGE;
    *w->sample = s;
  }
  return SCALLOP_OK;
}

/* Integrates one piece from a restart, as l'' may jump at its start. */
static enum scallop_status run_piece(struct smoothed_run *run, const struct scallop_piece *piece)
{
  struct integrator_phases *r = &run->phases;
  const gsl_odeiv2_driver *d = run->tools->driver;
  double t = integrator_flip(piece, piece->begin), end = integrator_flip(piece, piece->end),
         y[DIMENSION] = { r->c, r->x };
  run->piece = piece;
  if (gsl_odeiv2_evolve_reset(d->e) != GSL_SUCCESS || gsl_odeiv2_step_reset(d->s) != GSL_SUCCESS)
    return SCALLOP_ECONVERGE; /* GCOVR_EXCL_LINE: GSL's steppers never refuse this */
  enum scallop_status status = take_due(run, t, y);
  while (t < end && status == SCALLOP_OK) {
    status = one_step(run, &t, fmin(end, next_time(&run->watch)), y);
    if (status == SCALLOP_OK)
      status = take_due(run, t, y);
  }
  r->steps += steps_of(d->e);
  r->c = y[0];
  r->x = y[1];
  return status;
}

static enum scallop_status run_phase(struct integrator_phases *phases, const struct scallop_shape *shape)
{
  struct smoothed_run *run = (struct smoothed_run *)phases;
  run->d = run->tools->delta * phases->fraction;
  if (!isnormal(run->d) || !isfinite(phases->eps / run->d))
    return SCALLOP_ERANGE;
  enum scallop_status status = SCALLOP_OK;
  for (int i = 0; i < shape->count && status == SCALLOP_OK; i++)
    status = run_piece(run, &shape->pieces[i]);
  return status;
}

static enum scallop_status smoothed_period(struct scallop_integrator *self, const struct scallop_crawler *crawler,
                                           double v0, const struct scallop_patience *patience,
                                           struct scallop_integrator_period *period)
{
  struct smoothed_run run = { .phases = { .phase = run_phase, .patience = patience },
                              .tools = (const struct smoothed *)self,
                              .h = first_step };
  return integrator_period(&run.phases, crawler, v0, period);
}

static bool are_times(const struct scallop_sample *samples, int count, double duration)
{
  for (int i = 0; i < count; i++)
    if (!(samples[i].t >= (i == 0 ? 0 : samples[i - 1].t) && samples[i].t <= duration))
      return false;
  return count >= 0;
}

enum scallop_status scallop_smoothed_phase(struct scallop_integrator *integrator, const struct scallop_crawler *crawler,
                                           enum scallop_phase_kind kind, double v0,
                                           const struct scallop_patience *patience, struct scallop_sample *samples,
                                           int count)
{
  struct scallop_scaled s;
  double c0;
  enum scallop_status status = start_scaled(crawler, v0, &s, &c0);
  if (status != SCALLOP_OK)
    return status;
  double duration = scallop_phase_duration(crawler, kind), fraction = s.fraction[kind];
  if (!are_times(samples, count, duration))
    return SCALLOP_EDOMAIN;
  struct smoothed_run run = { .phases = { .patience = patience,
                                          .mu = { s.mu1, s.mu2 },
                                          .f = { s.f1, s.f2 },
                                          .fraction = fraction,
                                          .eps = s.eps * (fraction * fraction),
                                          .c = c0 * fraction },
                              .tools = (const struct smoothed *)integrator,
                              .h = first_step,
                              .watch = { crawler, kind, duration, samples, count } };
  return run_phase(&run.phases, &s.gait->phase[kind]);
}

static void smoothed_destroy(struct scallop_integrator *self)
{
  struct smoothed *s = (struct smoothed *)self;
  gsl_odeiv2_driver_free(s->driver);
  free(s);
}

struct scallop_integrator *scallop_smoothed_integrator(double delta, double tolerance)
{
  static const gsl_odeiv2_system shape = { equation, jacobian, DIMENSION, NULL };
  bool good = delta > 0 && isfinite(delta) && tolerance >= DBL_EPSILON && tolerance <= 0.1;
  struct smoothed *s = good ? malloc(sizeof *s) : NULL;
  if (!s)
    return NULL;
  gsl_error_handler_t *handler = gsl_set_error_handler_off(); /* GSL aborts when memory is short */
  *s = (struct smoothed){ { smoothed_period, smoothed_destroy },
                          gsl_odeiv2_driver_alloc_y_new(&shape, gsl_odeiv2_step_msbdf, first_step, tolerance,
                                                        tolerance),
                          delta };
  gsl_set_error_handler(handler);
  if (s->driver)
    return &s->integrator;
  free(s);
  return NULL;
}
