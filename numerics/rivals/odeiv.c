#include "numerics/rivals/odeiv.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include "numerics/rivals/rival_motion.h"

enum { DIMENSION = 2, MAX_TRIALS = 2200 /* doubles can be halved no longer */ };

struct scallop_odeiv {
  gsl_odeiv2_driver *driver; /* GSL's multistep methods will not do without one */
  gsl_odeiv2_system system;
  /* a one-step method that takes a step of a multistep method again; NULL where that needs no other */
  gsl_odeiv2_step *relay;
  gsl_odeiv2_evolve *relay_evolve;
};

/* One end of a step. Units throughout: L, and the duration of the phase. */
struct point {
  double t;            /* since the phase began                                                */
  double y[DIMENSION]; /* velocity and position of body 1                                      */
  double dydt[DIMENSION];
  double v2; /* velocity of body 2                                                   */
};

struct run {
  struct rival_motion motion; /* first, so that the one is the other */
  struct scallop_odeiv *tools;
  double close; /* a velocity that counts as zero when an event is located              */
  double start; /* the first step tried after an event, at most                         */
  double h;     /* what the step control suggests                                       */
};

static int equation(double t, const double y[], double dydt[], void *params)
{
  struct rival_motion *m = params;
  m->phases.evaluations++;
  dydt[0] = rival_acceleration(m, t);
  dydt[1] = y[0];
  return GSL_SUCCESS;
}

static double ahead(const struct run *r, const struct point *p, int body)
{
  return rival_ahead(&r->motion, p->y[0], p->v2, body);
}

static double ahead_rate(const struct run *r, const struct point *p, int body)
{
  const struct rival_motion *m = &r->motion;
  return body == 0 ? m->sign[0] * p->dydt[0] : rival_ahead_rate(m, p->t, body); /* dydt is at hand */
}

static void check(struct run *r, int gsl_status)
{
  if (gsl_status != GSL_SUCCESS)
    r->motion.status = SCALLOP_ECONVERGE;
}

static long tried(const gsl_odeiv2_evolve *e) { return (long)(e->count + e->failed_steps); }

/* As many steps of the one-step method as the step control asks for, which is nearly always one. */
static void relay_to(struct run *r, double from, struct point *to)
{
  const struct scallop_odeiv *tools = r->tools;
  gsl_odeiv2_evolve *e = tools->relay_evolve;
  double t = from, h = to->t - from;
  check(r, gsl_odeiv2_evolve_reset(e));
  do {
    check(r, gsl_odeiv2_evolve_apply(e, tools->driver->c, tools->relay, &tools->system, &t, to->t, &h, to->y));
  } while (t < to->t && rival_motion_goes_on(&r->motion));
  r->motion.phases.steps += tried(e);
  to->dydt[0] = e->dydt_out[0];
  to->dydt[1] = e->dydt_out[1];
}

/* One step of the method from `from` to time t. It is shorter than one that the step control has accepted; that says
 * nothing of another method, so there the step control is asked again. */
static void step_to(struct run *r, const struct point *from, double t, struct point *to)
{
  const struct scallop_odeiv *tools = r->tools;
  double error[DIMENSION];
  to->t = t;
  to->y[0] = from->y[0];
  to->y[1] = from->y[1];
  if (tools->relay) {
    relay_to(r, from->t, to);
  } else {
    r->motion.phases.steps++;
    check(r, gsl_odeiv2_step_apply(tools->driver->s, from->t, t - from->t, to->y, error, from->dydt, to->dydt,
                                   &tools->system));
  }
  to->v2 = to->y[0] + rival_gait_velocity(&r->motion, t);
}

struct bracket {
  double lo, hi;
};

/* Both ends of the step are ahead of zero, and the velocity turns between them: if it has a minimum
 * there, look at it. As l'' is monotone in a piece the velocity is convex, so it lies above its
 * tangents, which nearly always settles the matter without a step. */
static bool dips(struct run *r, const struct point *from, const struct point *to, int body, struct bracket *at)
{
  double g0 = ahead(r, from, body), g1 = ahead(r, to, body), h = to->t - from->t;
  double d0 = ahead_rate(r, from, body), d1 = ahead_rate(r, to, body);
  if (d0 >= 0 || d1 <= 0 || g0 + d0 * ((g1 - g0 - d1 * h) / (d0 - d1)) > 0)
    return false;
  struct point lowest;
  step_to(r, from, r->motion.turn[body], &lowest);
  *at = (struct bracket){ from->t, lowest.t };
  return ahead(r, &lowest, body) <= 0;
}

/* Does a body's velocity fall to zero within the step, and between what times? A body that starts the step at zero, or
 * behind it by the errors of the steps, has just been let go by the forces, so its zero must come after a turning
 * point: it is found behind zero, and being driven further. */
static bool crosses(struct run *r, const struct point *from, const struct point *to, int body, struct bracket *at)
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
static double guess(const struct run *r, const struct point *from, const struct point *to, int body, struct bracket at)
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

/* Takes the step again so that it ends where the velocity of body is zero. */
static void locate(struct run *r, const struct point *from, struct point *to, int body, struct bracket at)
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
static int first_event(struct run *r, const struct point *from, struct point *to)
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

static void begin(struct run *r, struct point *from)
{
  const struct rival_motion *m = &r->motion;
  from->t = m->t;
  from->y[0] = m->y[0];
  from->y[1] = m->y[1];
  from->v2 = m->y[0] + rival_gait_velocity(m, m->t);
  r->h = fmin(r->h, r->start);
  check(r, gsl_odeiv2_driver_reset(r->tools->driver));
}

/* One accepted step, not past `end`. */
static void accepted_step(struct run *r, double end, struct point *from, struct point *to)
{
  const gsl_odeiv2_driver *d = r->tools->driver;
  const gsl_odeiv2_evolve *e = d->e;
  long before = tried(e);
  to->t = from->t;
  to->y[0] = from->y[0];
  to->y[1] = from->y[1];
  check(r, gsl_odeiv2_evolve_apply(d->e, d->c, d->s, &r->tools->system, &to->t, end, &r->h, to->y));
  r->motion.phases.steps += tried(e) - before;
  from->dydt[0] = e->dydt_in[0];
  from->dydt[1] = e->dydt_in[1];
  to->dydt[0] = e->dydt_out[0];
  to->dydt[1] = e->dydt_out[1];
  to->v2 = to->y[0] + rival_gait_velocity(&r->motion, to->t);
}

static int slide(struct rival_motion *m, double end)
{
  struct run *r = (struct run *)m;
  struct point from, to;
  int body = -1;
  begin(r, &from);
  while (body < 0 && from.t < end && rival_motion_goes_on(m)) {
    accepted_step(r, end, &from, &to);
    body = first_event(r, &from, &to);
    from = to;
  }
  m->t = from.t;
  m->y[0] = from.y[0];
  m->y[1] = from.y[1];
  return body;
}

static enum scallop_status run(struct scallop_odeiv *odeiv, const struct scallop_crawler *crawler, double v0,
                               double tolerance, const struct scallop_patience *patience,
                               struct scallop_rival_period *period)
{
  /* h: the whole piece is the first step tried, as the control cuts down faster than it grows; but a multistep method
   * starts with Euler's */
  struct run r = { .motion = { .slide = slide },
                   .tools = odeiv,
                   .close = fmax(0.1 * tolerance, 4 * DBL_EPSILON),
                   .start = odeiv->relay ? sqrt(tolerance) : 1,
                   .h = 1 };
  odeiv->system.params = &r.motion;
  if (gsl_odeiv2_control_init(odeiv->driver->c, tolerance, tolerance, 1, 0) != GSL_SUCCESS)
    return SCALLOP_ECONVERGE; /* GCOVR_EXCL_LINE: GSL refuses negative tolerances only */
  return rival_motion_period(&r.motion, crawler, v0, patience, period);
}

static bool good_tolerance(double tolerance) { return tolerance >= DBL_EPSILON && tolerance <= 0.1; }

enum scallop_status scallop_odeiv_run(struct scallop_odeiv *odeiv, const struct scallop_crawler *crawler, double v0,
                                      double tolerance, struct scallop_rival_period *period)
{
  return good_tolerance(tolerance) ? run(odeiv, crawler, v0, tolerance, NULL, period) : SCALLOP_EDOMAIN;
}

static const gsl_odeiv2_step_type *type_of(enum scallop_odeiv_stepper stepper)
{
  switch (stepper) {
  case SCALLOP_ODEIV_RKF45: return gsl_odeiv2_step_rkf45;
  case SCALLOP_ODEIV_RK8PD: return gsl_odeiv2_step_rk8pd;
  case SCALLOP_ODEIV_MSADAMS: return gsl_odeiv2_step_msadams;
  }
  return NULL;
}

static bool allocate(struct scallop_odeiv *odeiv, const gsl_odeiv2_step_type *type)
{
  odeiv->system = (gsl_odeiv2_system){ .function = equation, .dimension = DIMENSION };
  odeiv->driver = gsl_odeiv2_driver_alloc_y_new(&odeiv->system, type, 1, 1, 1);
  if (type != gsl_odeiv2_step_msadams)
    return odeiv->driver;
  odeiv->relay = gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, DIMENSION);
  odeiv->relay_evolve = gsl_odeiv2_evolve_alloc(DIMENSION);
  return odeiv->driver && odeiv->relay && odeiv->relay_evolve;
}

struct scallop_odeiv *scallop_odeiv_make(enum scallop_odeiv_stepper stepper)
{
  const gsl_odeiv2_step_type *type = type_of(stepper);
  struct scallop_odeiv *odeiv = type ? calloc(1, sizeof *odeiv) : NULL;
  if (!odeiv)
    return NULL;
  gsl_error_handler_t *handler = gsl_set_error_handler_off(); /* GSL aborts when memory is short */
  bool made = allocate(odeiv, type);
  gsl_set_error_handler(handler);
  if (made)
    return odeiv;
  scallop_odeiv_destroy(odeiv);
  return NULL;
}

void scallop_odeiv_destroy(struct scallop_odeiv *odeiv)
{
  if (!odeiv)
    return;
  if (odeiv->driver)
    gsl_odeiv2_driver_free(odeiv->driver);
  if (odeiv->relay)
    gsl_odeiv2_step_free(odeiv->relay);
  if (odeiv->relay_evolve)
    gsl_odeiv2_evolve_free(odeiv->relay_evolve);
  free(odeiv);
}

enum scallop_status scallop_odeiv_period(const struct scallop_crawler *crawler, double v0,
                                         enum scallop_odeiv_stepper stepper, double tolerance,
                                         struct scallop_rival_period *period)
{
  if (!type_of(stepper))
    return SCALLOP_EDOMAIN;
  struct scallop_odeiv *odeiv = scallop_odeiv_make(stepper);
  if (!odeiv)
    return SCALLOP_ECONVERGE;
  enum scallop_status status = scallop_odeiv_run(odeiv, crawler, v0, tolerance, period);
  scallop_odeiv_destroy(odeiv);
  return status;
}

struct odeiv_rival {
  struct scallop_rival rival; /* first, so that the one is the other */
  struct scallop_odeiv *odeiv;
  double tolerance;
};

static enum scallop_status period_of_rival(struct scallop_rival *self, const struct scallop_crawler *crawler, double v0,
                                           const struct scallop_patience *patience, struct scallop_rival_period *period)
{
  const struct odeiv_rival *r = (struct odeiv_rival *)self;
  return run(r->odeiv, crawler, v0, r->tolerance, patience, period);
}

static void rival_destroy(struct scallop_rival *self)
{
  struct odeiv_rival *r = (struct odeiv_rival *)self;
  scallop_odeiv_destroy(r->odeiv);
  free(r);
}

struct scallop_rival *scallop_odeiv_rival(enum scallop_odeiv_stepper stepper, double tolerance)
{
  struct odeiv_rival *r = good_tolerance(tolerance) ? malloc(sizeof *r) : NULL;
  if (!r)
    return NULL;
  *r = (struct odeiv_rival){ { period_of_rival, rival_destroy }, scallop_odeiv_make(stepper), tolerance };
  if (r->odeiv)
    return &r->rival;
  free(r);
  return NULL;
}
