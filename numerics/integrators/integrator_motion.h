/* The common part of the integrators that locate events: everything except the steps. The pieces of the gait, the mode,
 * the effect of the forces when a velocity reaches zero, and the motion of a stuck body (without integration: x1' = 0,
 * or x1' = -l'). An integrator brings the integration of
 *
 *     x1'' = -(m2/M) l'' - (F1 s1 + F2 s2)/M,   x2' = x1' + l'        (the paper, section 2)
 *
 * in (x1', x1) while both bodies move. Units throughout: L, and the duration of the phase. Private to the integrators.
 */
#ifndef SCALLOP_NUMERICS_INTEGRATORS_INTEGRATOR_MOTION_H
#define SCALLOP_NUMERICS_INTEGRATORS_INTEGRATOR_MOTION_H

#include "numerics/integrators/integrator_phases.h"

struct integrator_motion {
  struct integrator_phases phases; /* first member: a pointer to it is one to the struct                   */
  /* Integrates t and y to `end` within the piece, or to the first event: the velocity of a body, counted in its
   * direction in the mode, falls to zero. Returns that body, or -1. Sets status on failure. */
  int (*slide)(struct integrator_motion *motion, double end);
  const struct scallop_piece *piece;
  double t;       /* since the phase began                                                */
  double y[2];    /* velocity and position of body 1                                      */
  int sign[2];    /* the mode                                                             */
  double drag;    /* eps (f1 s1 + f2 s2)                                                  */
  double turn[2]; /* when the velocity of each body turns in this mode; nan if never      */
  enum scallop_status status;
};

/* One period from v0 by these steps. Statuses and *period as of struct scallop_integrator. */
enum scallop_status integrator_motion_period(struct integrator_motion *motion, const struct scallop_crawler *crawler,
                                             double v0, const struct scallop_patience *patience,
                                             struct scallop_integrator_period *period);

/* Returns whether the integration may take another step; if false, status has the reason. */
bool integrator_motion_goes_on(struct integrator_motion *motion);

static inline double integrator_gait_velocity(const struct integrator_motion *m, double t)
{
  return m->piece->curve->velocity(m->piece, integrator_flip(m->piece, t));
}

static inline double integrator_gait_acceleration(const struct integrator_motion *m, double t)
{
  const struct scallop_piece *p = m->piece;
  return p->linear ? p->acceleration : p->curve->acceleration(p, integrator_flip(p, t));
}

/* x1'' while both bodies move. */
static inline double integrator_acceleration(const struct integrator_motion *m, double t)
{
  return -m->phases.mu[1] * integrator_gait_acceleration(m, t) - m->drag;
}

/* Returns a body's velocity counted in the direction of the mode; an event is a fall of this to zero. */
static inline double integrator_ahead(const struct integrator_motion *m, double v1, double v2, int body)
{
  return m->sign[body] * (body == 0 ? v1 : v2);
}

/* Returns its rate of change. Not x1'' + l'': that cancels when body 2 is far lighter than body 1. */
static inline double integrator_ahead_rate(const struct integrator_motion *m, double t, int body)
{
  double a = integrator_gait_acceleration(m, t);
  return m->sign[body] * (body == 0 ? -m->phases.mu[1] * a - m->drag : m->phases.mu[0] * a - m->drag);
}

#endif
