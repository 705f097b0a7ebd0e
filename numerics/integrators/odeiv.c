#include "numerics/integrators/integrator.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include "numerics/integrators/integrator_motion.h"

enum { DIMENSION = 2, MAX_TRIALS = 2200 /* doubles can be halved no longer */ };

struct odeiv {
  struct scallop_integrator integrator; /* first member: a pointer to it is one to the struct */
  gsl_odeiv2_driver *driver;
  gsl_odeiv2_system system;
  double tolerance;
};

/* One end of a step. Units throughout: L, and the duration of the phase. */
struct odeiv_point {
  double t;            /* since the phase began                                                */
  double y[DIMENSION]; /* velocity and position of body 1                                      */
  double dydt[DIMENSION];
  double v2; /* velocity of body 2                                                   */
};

struct odeiv_run {
  struct integrator_motion motion; /* first member: a pointer to it is one to the struct */
  struct odeiv *tools;
  double close; /* a velocity that counts as zero when an event is located */
  double h;     /* what the step control suggests                          */
};

static int equation(double t, const double y[], double dydt[], void *params)
{
  struct integrator_motion *m = params;
  m->phases.evaluations++;
  dydt[0] = integrator_acceleration(m, t);
  dydt[1] = y[0];
  return GSL_SUCCESS;
}

static double ahead(const struct odeiv_run *r, const struct odeiv_point *p, int body)
{
  return integrator_ahead(&r->motion, p->y[0], p->v2, body);
}

static double ahead_rate(const struct odeiv_run *r, const struct odeiv_point *p, int body)
{
  const struct integrator_motion *m = &r->motion;
  return body == 0 ? m->sign[0] * p->dydt[0] : integrator_ahead_rate(m, p->t, body); /* dydt is at hand */
}

static void check(struct odeiv_run *r, int gsl_status)
{
  if (gsl_status != GSL_SUCCESS)
    r->motion.status = SCALLOP_ECONVERGE;
}

static long tried(const gsl_odeiv2_evolve *e) { return (long)(e->count + e->failed_steps); }

/* One step of the method from `from` to time t */
static void step_to(struct odeiv_run *r, const struct odeiv_point *from, double t, struct odeiv_point *to)
{
  const struct odeiv *tools = r->tools;
  double error[DIMENSION];
  *to = *from;
  to->t = t;
  r->motion.phases.steps++;
  check(r, gsl_odeiv2_step_apply(tools->driver->s, from->t, t - from->t, to->y, error, from->dydt, to->dydt,
                                 &tools->system));
  to->v2 = to->y[0] + integrator_gait_velocity(&r->motion, t);
}

struct bracket {
  double lo, hi;
};

/* Both ends of the step are ahead of zero, and the velocity turns between them: if it has a minimum
 * there, look at it. As l'' is monotone in a piece the velocity is convex, so it lies above its tangents; this nearly
 * always decides without a step. */
static bool dips(struct odeiv_run *r, const struct odeiv_point *from, const struct odeiv_point *to, int body,
                 struct bracket *at)
{
  double g0 = ahead(r, from, body), g1 = ahead(r, to, body), h = to->t - from->t;
  double d0 = ahead_rate(r, from, body), d1 = ahead_rate(r, to, body);
  if (d0 >= 0 || d1 <= 0 || g0 + d0 * ((g1 - g0 - d1 * h) / (d0 - d1)) > 0)
    return false;
  struct odeiv_point lowest;
  step_to(r, from, r->motion.turn[body], &lowest);
  *at = (struct bracket){ from->t, lowest.t };
  return ahead(r, &lowest, body) <= 0;
}

/* Returns whether a body's velocity falls to zero within the step; *at brackets the time. A body that starts the step
 * at zero, or behind it by the errors of the steps, has just been let go by the forces, so its zero must come after a
 * turning point: it is found behind zero, and being driven further. */
static bool crosses(struct odeiv_run *r, const struct odeiv_point *from, const struct odeiv_point *to, int body,
                    struct bracket *at)
{
  double g0 = ahead(r, from, body), g1 = ahead(r, to, body);
  bool turns = r->motion.turn[body] > from->t && r->motion.turn[body] < to->t;
  *at = (struct bracket){ from->t, to->t };
  if (g0 > 0)
    return g1 <= 0 || (turns && dips(r, from, to, body, at));
  if (g1 >= -r->close || ahead_rate(r, to, body) >= 0)
    return false;
  if (turns)
    at->lo = r->motion.turn[body];
  return true;
}

/* The zero of the cubic through velocities and rates at both ends: a first guess, inside the bracket. */
static double guess(const struct odeiv_run *r, const struct odeiv_point *from, const struct odeiv_point *to, int body,
                    struct bracket at)
{
  double h = to->t - from->t, g0 = ahead(r, from, body), d0 = h * ahead_rate(r, from, body);
  double g1 = ahead(r, to, body), d1 = h * ahead_rate(r, to, body);
  double a2 = 3 * (g1 - g0) - 2 * d0 - d1, a3 = 2 * (g0 - g1) + d0 + d1;
  double x = g0 > 0 && g1 <= 0 ? g0 / (g0 - g1) : (0.5 * (at.lo + at.hi) - from->t) / h;
  for (int i = 0; i < 4; i++)
    x -= (g0 + x * (d0 + x * (a2 + x * a3))) / (d0 + x * (2 * a2 + x * 3 * a3));
  double t = from->t + x * h;
  return t > at.lo && t < at.hi ? t : 0.5 * (at.lo + at.hi);
}

/* Repeats the step with its end at the zero of the velocity of body. */
static void locate(struct odeiv_run *r, const struct odeiv_point *from, struct odeiv_point *to, int body,
                   struct bracket at)
{
  double t = guess(r, from, to, body, at);
  for (int i = 0; i < MAX_TRIALS; i++) {
    step_to(r, from, t, to);
    double g = ahead(r, to, body);
    if (fabs(g) <= r->close)
      return;
    *(g > 0 ? &at.lo : &at.hi) = t;
    t -= g / ahead_rate(r, to, body);
    if (!(t > at.lo && t < at.hi))
      t = at.lo + 0.5 * (at.hi - at.lo);
    if (t == at.lo || t == at.hi) /* nothing lies between */
      return;
  }
  r->motion.status = SCALLOP_ECONVERGE; /* GCOVR_EXCL_LINE: halving ends before MAX_TRIALS */
}

/* Shortens the step to the first event in it; the body of that event, or -1. */
static int first_event(struct odeiv_run *r, const struct odeiv_point *from, struct odeiv_point *to)
{
  int first = -1;
  struct bracket at;
  for (int body = 0; body < 2; body++)
    if (crosses(r, from, to, body, &at)) {
      locate(r, from, to, body, at);
      first = body;
    }
  return first;
}

static void begin(struct odeiv_run *r, struct odeiv_point *from)
{
  const struct integrator_motion *m = &r->motion;
  from->t = m->t;
  from->y[0] = m->y[0];
  from->y[1] = m->y[1];
  from->v2 = m->y[0] + integrator_gait_velocity(m, m->t);
  check(r, gsl_odeiv2_driver_reset(r->tools->driver));
}

/* One accepted step, not past `end`. */
static void accepted_step(struct odeiv_run *r, double end, struct odeiv_point *from, struct odeiv_point *to)
{
  const gsl_odeiv2_driver *d = r->tools->driver;
  const gsl_odeiv2_evolve *e = d->e;
  long before = tried(e);
  *to = *from;
  check(r, gsl_odeiv2_evolve_apply(d->e, d->c, d->s, &r->tools->system, &to->t, end, &r->h, to->y));
  r->motion.phases.steps += tried(e) - before;
  from->dydt[0] = e->dydt_in[0];
  from->dydt[1] = e->dydt_in[1];
  to->dydt[0] = e->dydt_out[0];
  to->dydt[1] = e->dydt_out[1];
  to->v2 = to->y[0] + integrator_gait_velocity(&r->motion, to->t);
}

static int slide(struct integrator_motion *m, double end)
{
  struct odeiv_run *r = (struct odeiv_run *)m;
  struct odeiv_point from, to;
  int body = -1;
  begin(r, &from);
  while (body < 0 && from.t < end && integrator_motion_goes_on(m)) {
    accepted_step(r, end, &from, &to);
    body = first_event(r, &from, &to);
    from = to;
  }
  m->t = from.t;
  m->y[0] = from.y[0];
  m->y[1] = from.y[1];
  return body;
}

static enum scallop_status period(struct scallop_integrator *self, const struct scallop_crawler *crawler, double v0,
                                  const struct scallop_patience *patience, struct scallop_integrator_period *result)
{
  struct odeiv *tools = (struct odeiv *)self;
  /* h: the whole piece is the first step tried, as the control cuts down faster than it grows */
  struct odeiv_run r = {
    .motion = { .slide = slide }, .tools = tools, .close = fmax(0.1 * tools->tolerance, 4 * DBL_EPSILON), .h = 1
  };
  tools->system.params = &r.motion;
  return integrator_motion_period(&r.motion, crawler, v0, patience, result);
}

static void destroy(struct scallop_integrator *self)
{
  struct odeiv *r = (struct odeiv *)self;
  gsl_odeiv2_driver_free(r->driver);
  free(r);
}

struct scallop_integrator *scallop_odeiv_integrator(enum scallop_odeiv_stepper stepper, double tolerance)
{
  const gsl_odeiv2_step_type *type = stepper == SCALLOP_ODEIV_RKF45   ? gsl_odeiv2_step_rkf45
                                     : stepper == SCALLOP_ODEIV_RK8PD ? gsl_odeiv2_step_rk8pd
                                                                      : NULL;
  bool good = type && tolerance >= DBL_EPSILON && tolerance <= 0.1;
  struct odeiv *r = good ? malloc(sizeof *r) : NULL;
  if (!r)
    return NULL;
  *r = (struct odeiv){ .integrator = { period, destroy },
                       .system = { .function = equation, .dimension = DIMENSION },
                       .tolerance = tolerance };
  gsl_error_handler_t *handler = gsl_set_error_handler_off(); /* GSL aborts when memory is short */
  r->driver = gsl_odeiv2_driver_alloc_y_new(&r->system, type, 1, tolerance, tolerance);
  gsl_set_error_handler(handler);
  if (r->driver)
    return &r->integrator;
  free(r);
  return NULL;
}
