#include "numerics/integrators/integrator_motion.h"

#include <math.h>
#include <stddef.h>

static void set_mode(struct integrator_motion *m, int s1, int s2)
{
  m->sign[0] = s1;
  m->sign[1] = s2;
  m->drag = m->phases.eps * (m->phases.f[0] * s1 + m->phases.f[1] * s2);
}

/* The direction of a body beside one at rest: the second moves with l', the first against it. */
static int other_direction(const struct integrator_motion *m, int resting)
{
  return resting == 0 ? m->piece->direction : -m->piece->direction;
}

/* Where a body at rest goes: the direction in which it would speed up against its own friction, or 0 if
 * friction can hold it. */
static int from_rest(const struct integrator_motion *m, int body, double t)
{
  double push = (body == 0 ? -m->phases.mu[1] : m->phases.mu[0]) * integrator_gait_acceleration(m, t);
  for (int s = -1; s <= 1; s += 2)
    if (s * (push - m->phases.eps * (m->phases.f[body] * s + m->phases.f[1 - body] * other_direction(m, body))) > 0)
      return s;
  return 0;
}

/* When the acceleration of a body vanishes in the present mode; nan if never in this piece. It does so
 * once at most, because l'' is monotone in a piece. */
static double turning_time(const struct integrator_motion *m, int body)
{
  double level = body == 0 ? -m->drag / m->phases.mu[1] : m->drag / m->phases.mu[0];
  return integrator_flip(m->piece, m->piece->curve->when(m->piece, level));
}

bool integrator_motion_goes_on(struct integrator_motion *m)
{
  if (m->status == SCALLOP_OK && m->phases.steps > INTEGRATOR_MAX_STEPS)
    m->status = SCALLOP_ECONVERGE;
  if (m->status == SCALLOP_OK && !integrator_patience_lasts(m->phases.patience))
    m->status = SCALLOP_ESTOPPED;
  return m->status == SCALLOP_OK;
}

/* The state at a time when a body is at rest. */
static void rest(struct integrator_motion *m, int body, double t)
{
  m->t = t;
  m->y[0] = body == 0 ? 0 : -integrator_gait_velocity(m, t);
}

/* No body is stuck: integrate to the next event or the end of the piece. */
static void slide(struct integrator_motion *m, double end)
{
  for (int body = 0; body < 2; body++)
    m->turn[body] = turning_time(m, body);
  int body = m->slide(m, end);
  if (body < 0 || m->status != SCALLOP_OK)
    return;
  rest(m, body, m->t);
  int direction = from_rest(m, body, m->t), other = other_direction(m, body);
  set_mode(m, body == 0 ? direction : other, body == 0 ? other : direction);
  m->phases.events++;
}

/* A body is stuck: go to its release or the end of the piece. The force that holds it is monotone in
 * l'', so it is released exactly if it could not be held at the end. */
static void stick(struct integrator_motion *m, double end)
{
  const struct scallop_piece *p = m->piece;
  int body = m->sign[0] == 0 ? 0 : 1, released = from_rest(m, body, end);
  double begin = m->t, t = end;
  if (released != 0) {
    set_mode(m, body == 0 ? released : m->sign[0], body == 0 ? m->sign[1] : released);
    t = fmax(begin, fmin(turning_time(m, body), end)); /* fmin ignores a nan */
    m->phases.events++;
  }
  rest(m, body, t);
  if (body == 1)
    m->y[1] -= p->curve->length(p, integrator_flip(p, t)) - p->curve->length(p, integrator_flip(p, begin));
}

/* The mode at the start of a piece: from the velocities, and for a body at rest from the forces. */
static void enter(struct integrator_motion *m, const struct scallop_piece *piece)
{
  bool anew = !m->piece || piece->jump || piece->direction != m->piece->direction;
  int sign[2];
  m->piece = piece;
  m->t = integrator_flip(piece, piece->begin);
  double l1 = integrator_gait_velocity(m, m->t);
  if (anew)
    m->y[0] = m->phases.c - m->phases.mu[1] * l1;
  for (int body = 0; body < 2; body++) {
    double v = body == 0 ? m->y[0] : m->y[0] + l1;
    bool resting = v == 0 || (!anew && m->sign[body] == 0);
    sign[body] = resting ? from_rest(m, body, m->t) : v > 0 ? 1 : -1;
  }
  if (sign[0] == 0) /* then l' moves the other, even while l' is 0 and friction could hold both */
    sign[1] = other_direction(m, 0);
  set_mode(m, sign[0], sign[1]);
}

static enum scallop_status run_phase(struct integrator_phases *phases, const struct scallop_shape *shape)
{
  struct integrator_motion *m = (struct integrator_motion *)phases;
  m->piece = NULL;
  m->status = SCALLOP_OK;
  m->y[1] = phases->x;
  for (int i = 0; i < shape->count && m->status == SCALLOP_OK; i++) {
    enter(m, &shape->pieces[i]);
    double end = integrator_flip(m->piece, m->piece->end);
    while (m->t < end && integrator_motion_goes_on(m)) {
      if (m->sign[0] == 0 || m->sign[1] == 0)
        stick(m, end);
      else
        slide(m, end);
    }
    phases->c = m->y[0] + phases->mu[1] * integrator_gait_velocity(m, end); /* continues over a jump of l' */
  }
  phases->x = m->y[1];
  return m->status;
}

enum scallop_status integrator_motion_period(struct integrator_motion *m, const struct scallop_crawler *crawler,
                                             double v0, const struct scallop_patience *patience,
                                             struct scallop_integrator_period *period)
{
  *m = (struct integrator_motion){ .phases = { .phase = run_phase, .patience = patience }, .slide = m->slide };
  return integrator_period(&m->phases, crawler, v0, period);
}
