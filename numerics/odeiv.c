#include "numerics/odeiv.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

enum { DIMENSION = 2, MAX_STEPS = 1000000, MAX_TRIALS = 2200 /* doubles can be halved no longer */ };

struct scallop_odeiv {
  gsl_odeiv2_step *step;
  gsl_odeiv2_control *control;
  gsl_odeiv2_evolve *evolve;
};

/* One end of a step. Units throughout: L, and the duration of the phase. */
struct point {
  double t;            /* since the phase began                                                */
  double y[DIMENSION]; /* velocity and position of body 1                                      */
  double dydt[DIMENSION];
  double v2; /* velocity of body 2                                                   */
};

struct run {
  struct scallop_odeiv *tools;
  gsl_odeiv2_system system;
  const struct scallop_piece *piece;
  double mu[2], f[2];     /* of body 1 and body 2; sums are 1                                     */
  double eps;             /* tau^2 (F1 + F2)/(M L)                                                */
  double close;           /* a velocity that counts as zero when an event is located              */
  double t, y[DIMENSION]; /* where we are, as in struct point                                     */
  double c;               /* velocity of the centre of mass where l' may jump: c does not         */
  double h;               /* what the step control suggests                                       */
  int sign[2];            /* the mode                                                             */
  double drag;            /* eps (f1 s1 + f2 s2)                                                  */
  double turn[2];         /* when the velocity of each body turns in this mode; nan if never      */
  long steps, evaluations, events;
  bool failed;
};

/* ---- the equation of motion ---- */

/* Time since the phase began, for an offset from the piece's anchor; and the other way round. */
static double flip(const struct scallop_piece *p, double t) { return p->anchor == SCALLOP_FROM_START ? t : 1 - t; }

static double gait_velocity(const struct run *r, double t) { return r->piece->curve->velocity(r->piece, flip(r->piece, t)); }

static double gait_acceleration(const struct run *r, double t)
{
  const struct scallop_piece *p = r->piece;
  return p->linear ? p->acceleration : p->curve->acceleration(p, flip(p, t));
}

static int equation(double t, const double y[], double dydt[], void *params)
{
  struct run *r = params;
  r->evaluations++;
  dydt[0] = -r->mu[1] * gait_acceleration(r, t) - r->drag;
  dydt[1] = y[0];
  return GSL_SUCCESS;
}

/* ---- the mode ---- */

static void set_mode(struct run *r, int s1, int s2)
{
  r->sign[0] = s1;
  r->sign[1] = s2;
  r->drag = r->eps * (r->f[0] * s1 + r->f[1] * s2);
}

/* The direction of a body beside one at rest: the second moves with l', the first against it. */
static int other_direction(const struct run *r, int resting)
{
  return resting == 0 ? r->piece->direction : -r->piece->direction;
}

/* Where a body at rest goes: the direction in which it would speed up against its own friction, or 0 if
 * friction can hold it. */
static int from_rest(const struct run *r, int body, double t)
{
  double push = (body == 0 ? -r->mu[1] : r->mu[0]) * gait_acceleration(r, t);
  for (int s = -1; s <= 1; s += 2)
    if (s * (push - r->eps * (r->f[body] * s + r->f[1 - body] * other_direction(r, body))) > 0)
      return s;
  return 0;
}

/* When the acceleration of a body vanishes in the present mode; nan if never in this piece. It does so
 * once at most, because l'' is monotone in a piece. */
static double turning_time(const struct run *r, int body)
{
  double level = body == 0 ? -r->drag / r->mu[1] : r->drag / r->mu[0];
  return flip(r->piece, r->piece->curve->when(r->piece, level));
}

/* ---- events within a step ---- */

/* A body's velocity counted in the direction of the mode, so it is an event when this falls to zero. */
static double ahead(const struct run *r, const struct point *p, int body)
{
  return r->sign[body] * (body == 0 ? p->y[0] : p->v2);
}

/* Its rate of change. Not x1'' + l'': that cancels when body 2 is far lighter than body 1. */
static double ahead_rate(const struct run *r, const struct point *p, int body)
{
  return r->sign[body] * (body == 0 ? p->dydt[0] : r->mu[0] * gait_acceleration(r, p->t) - r->drag);
}

/* One step of the method from `from` to time t. */
static void step_to(struct run *r, const struct point *from, double t, struct point *to)
{
  double error[DIMENSION];
  to->t = t;
  to->y[0] = from->y[0];
  to->y[1] = from->y[1];
  int status = gsl_odeiv2_step_apply(r->tools->step, from->t, t - from->t, to->y, error, from->dydt, to->dydt, &r->system);
  r->failed |= status != GSL_SUCCESS;
  to->v2 = to->y[0] + gait_velocity(r, t);
  r->steps++;
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
  step_to(r, from, r->turn[body], &lowest);
  *at = (struct bracket){ from->t, lowest.t };
  return ahead(r, &lowest, body) <= 0;
}

/* Does a body's velocity fall to zero within the step, and between what times? A body that starts the
 * step at zero has just been let go by the forces, so its zero must come after a turning point; if
 * rounding hides that, a velocity behind zero by more than rounding is an event all the same. */
static bool crosses(struct run *r, const struct point *from, const struct point *to, int body, struct bracket *at)
{
  double g0 = ahead(r, from, body), g1 = ahead(r, to, body);
  bool turns = r->turn[body] > from->t && r->turn[body] < to->t;
  *at = (struct bracket){ from->t, to->t };
  if (g0 > 0)
    return g1 <= 0 || (turns && dips(r, from, to, body, at));
  if (g1 >= -r->close)
    return false;
  if (turns)
    at->lo = r->turn[body];
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
  r->failed = true;
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

/* ---- from event to event ---- */

/* The state at a time when a body is at rest. */
static void rest(struct run *r, int body, double t)
{
  r->t = t;
  r->y[0] = body == 0 ? 0 : -gait_velocity(r, t);
}

static void begin_slide(struct run *r, struct point *from)
{
  from->t = r->t;
  from->y[0] = r->y[0];
  from->y[1] = r->y[1];
  from->v2 = r->y[0] + gait_velocity(r, r->t);
  for (int body = 0; body < 2; body++)
    r->turn[body] = turning_time(r, body);
  r->failed |= gsl_odeiv2_evolve_reset(r->tools->evolve) != GSL_SUCCESS;
}

/* One accepted step, not past `end`. */
static void accepted_step(struct run *r, double end, struct point *from, struct point *to)
{
  const struct scallop_odeiv *tools = r->tools;
  const gsl_odeiv2_evolve *e = tools->evolve;
  to->t = from->t;
  to->y[0] = from->y[0];
  to->y[1] = from->y[1];
  int status = gsl_odeiv2_evolve_apply(tools->evolve, tools->control, tools->step, &r->system, &to->t, end, &r->h, to->y);
  r->failed |= status != GSL_SUCCESS || e->count + e->failed_steps > MAX_STEPS;
  from->dydt[0] = e->dydt_in[0];
  from->dydt[1] = e->dydt_in[1];
  to->dydt[0] = e->dydt_out[0];
  to->dydt[1] = e->dydt_out[1];
  to->v2 = to->y[0] + gait_velocity(r, to->t);
}

/* No body is stuck: integrate to the next event or the end of the piece. */
static void slide(struct run *r, double end)
{
  struct point from, to;
  int body = -1;
  begin_slide(r, &from);
  while (body < 0 && from.t < end && !r->failed) {
    accepted_step(r, end, &from, &to);
    body = first_event(r, &from, &to);
    from = to;
  }
  r->steps += (long)(r->tools->evolve->count + r->tools->evolve->failed_steps);
  r->t = from.t;
  r->y[0] = from.y[0];
  r->y[1] = from.y[1];
  if (body < 0)
    return;
  rest(r, body, from.t);
  int direction = from_rest(r, body, from.t), other = other_direction(r, body);
  set_mode(r, body == 0 ? direction : other, body == 0 ? other : direction);
  r->events++;
}

/* A body is stuck: go to its release or the end of the piece. The force that holds it is monotone in
 * l'', so it is released exactly if it could not be held at the end. */
static void stick(struct run *r, double end)
{
  const struct scallop_piece *p = r->piece;
  int body = r->sign[0] == 0 ? 0 : 1, released = from_rest(r, body, end);
  double begin = r->t, t = end;
  if (released != 0) {
    set_mode(r, body == 0 ? released : r->sign[0], body == 0 ? r->sign[1] : released);
    t = fmax(begin, fmin(turning_time(r, body), end)); /* fmin passes over a nan */
    r->events++;
  }
  rest(r, body, t);
  if (body == 1)
    r->y[1] -= p->curve->length(p, flip(p, t)) - p->curve->length(p, flip(p, begin));
}

/* The mode at the start of a piece: from the velocities, and for a body at rest from the forces. */
static void enter(struct run *r, const struct scallop_piece *piece)
{
  bool anew = !r->piece || piece->jump || piece->direction != r->piece->direction;
  int sign[2];
  r->piece = piece;
  r->t = flip(piece, piece->begin);
  double l1 = gait_velocity(r, r->t);
  if (anew)
    r->y[0] = r->c - r->mu[1] * l1;
  for (int body = 0; body < 2; body++) {
    double v = body == 0 ? r->y[0] : r->y[0] + l1;
    bool resting = v == 0 || (!anew && r->sign[body] == 0);
    sign[body] = resting ? from_rest(r, body, r->t) : v > 0 ? 1 : -1;
  }
  set_mode(r, sign[0], sign[1]);
}

/* ---- one phase, one period ---- */

static void run_phase(struct run *r, const struct scallop_shape *shape)
{
  r->piece = NULL;
  for (int i = 0; i < shape->count && !r->failed; i++) {
    enter(r, &shape->pieces[i]);
    double end = flip(r->piece, r->piece->end);
    while (r->t < end && !r->failed) {
      if (r->sign[0] == 0 || r->sign[1] == 0)
        stick(r, end);
      else
        slide(r, end);
      r->failed |= r->steps > MAX_STEPS;
    }
    r->c = r->y[0] + r->mu[1] * gait_velocity(r, end);
  }
}

/* Both phases from v0 in L/T; v[kind] is the velocity after each, in the same unit. */
static enum scallop_status run_period(struct run *r, const struct scallop_scaled *s, double v0, double v[2])
{
  for (int kind = 0; kind < 2; kind++) {
    r->eps = s->eps * (s->fraction[kind] * s->fraction[kind]);
    r->c = (kind == SCALLOP_EXTENSION ? v0 : v[SCALLOP_EXTENSION]) * s->fraction[kind];
    run_phase(r, &s->gait->phase[kind]);
    if (r->failed)
      return SCALLOP_ECONVERGE;
    v[kind] = r->c / s->fraction[kind];
  }
  return SCALLOP_OK;
}

/* SCALLOP_OK and the crawler in its own units, the start velocity in L/T. */
static enum scallop_status check(const struct scallop_crawler *crawler, double v0, double tolerance,
                                 struct scallop_scaled *scaled, double *c0)
{
  enum scallop_status status = scallop_scale(crawler, scaled);
  if (status != SCALLOP_OK)
    return status;
  if (!isfinite(v0) || !(tolerance >= DBL_EPSILON && tolerance <= 0.1))
    return SCALLOP_EDOMAIN;
  *c0 = v0 / (crawler->L / crawler->T);
  return isfinite(*c0) && (*c0 != 0 || v0 == 0) ? SCALLOP_OK : SCALLOP_ERANGE;
}

enum scallop_status scallop_odeiv_run(struct scallop_odeiv *odeiv, const struct scallop_crawler *crawler, double v0,
                                      double tolerance, struct scallop_odeiv_result *result)
{
  struct scallop_scaled s;
  double c0, v[2];
  enum scallop_status status = check(crawler, v0, tolerance, &s, &c0);
  if (status != SCALLOP_OK)
    return status;
  /* h: the whole piece is the first step tried, as the control cuts down faster than it grows */
  struct run r = {
    .tools = odeiv, .mu = { s.mu1, s.mu2 }, .f = { s.f1, s.f2 }, .h = 1, .close = fmax(0.1 * tolerance, 4 * DBL_EPSILON)
  };
  r.system = (gsl_odeiv2_system){ .function = equation, .dimension = DIMENSION, .params = &r };
  if (gsl_odeiv2_control_init(odeiv->control, tolerance, tolerance, 1, 0) != GSL_SUCCESS)
    return SCALLOP_ECONVERGE;
  status = run_period(&r, &s, c0, v);
  if (status != SCALLOP_OK)
    return status;
  double unit = crawler->L / crawler->T;
  struct scallop_odeiv_result answer = { .v_mid = v[0] * unit,
                                         .v_end = v[1] * unit,
                                         .displacement = r.y[1] * crawler->L, /* l is back where it was */
                                         .steps = r.steps,
                                         .evaluations = r.evaluations,
                                         .events = r.events };
  if (!isfinite(answer.v_mid) || !isfinite(answer.v_end) || !isfinite(answer.displacement))
    return SCALLOP_ERANGE;
  *result = answer;
  return SCALLOP_OK;
}

/* ---- memory ---- */

/* A multistep method (gsl_odeiv2_step_msadams) would need a driver, and a one-step method in step_to. */
static const gsl_odeiv2_step_type *type_of(enum scallop_odeiv_stepper stepper)
{
  switch (stepper) {
  case SCALLOP_ODEIV_RKF45: return gsl_odeiv2_step_rkf45;
  case SCALLOP_ODEIV_RK8PD: return gsl_odeiv2_step_rk8pd;
  }
  return NULL;
}

struct scallop_odeiv *scallop_odeiv_make(enum scallop_odeiv_stepper stepper)
{
  const gsl_odeiv2_step_type *type = type_of(stepper);
  struct scallop_odeiv *odeiv = type ? calloc(1, sizeof *odeiv) : NULL;
  if (!odeiv)
    return NULL;
  gsl_error_handler_t *handler = gsl_set_error_handler_off(); /* GSL aborts when memory is short */
  odeiv->step = gsl_odeiv2_step_alloc(type, DIMENSION);
  odeiv->control = gsl_odeiv2_control_y_new(1, 1);
  odeiv->evolve = gsl_odeiv2_evolve_alloc(DIMENSION);
  gsl_set_error_handler(handler);
  if (odeiv->step && odeiv->control && odeiv->evolve)
    return odeiv;
  scallop_odeiv_destroy(odeiv);
  return NULL;
}

void scallop_odeiv_destroy(struct scallop_odeiv *odeiv)
{
  if (!odeiv)
    return;
  gsl_odeiv2_evolve_free(odeiv->evolve); /* all three take NULL */
  gsl_odeiv2_control_free(odeiv->control);
  gsl_odeiv2_step_free(odeiv->step);
  free(odeiv);
}

enum scallop_status scallop_odeiv_period(const struct scallop_crawler *crawler, double v0,
                                         enum scallop_odeiv_stepper stepper, double tolerance,
                                         struct scallop_odeiv_result *result)
{
  if (!type_of(stepper))
    return SCALLOP_EDOMAIN;
  struct scallop_odeiv *odeiv = scallop_odeiv_make(stepper);
  if (!odeiv)
    return SCALLOP_ECONVERGE;
  enum scallop_status status = scallop_odeiv_run(odeiv, crawler, v0, tolerance, result);
  scallop_odeiv_destroy(odeiv);
  return status;
}
