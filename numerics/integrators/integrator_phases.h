/* The common part of all integrators: a period is an extension and then a contraction. An integrator brings one phase:
 * it takes c, the velocity of the centre of mass, and x, the way of the centre of mass or of body 1, from its start to
 * its end. Units: L, and the duration of the phase. Private to the integrators. */
#ifndef SCALLOP_NUMERICS_INTEGRATORS_INTEGRATOR_PHASES_H
#define SCALLOP_NUMERICS_INTEGRATORS_INTEGRATOR_PHASES_H

#include "numerics/integrators/integrator.h"

enum { INTEGRATOR_MAX_STEPS = 1000000 }; /* in a period; past it an integrator gives up */

struct integrator_phases {
  /* Takes c and x from the start of a phase of this shape to its end; SCALLOP_OK, or why it could not. */
  enum scallop_status (*phase)(struct integrator_phases *phases, const struct scallop_shape *shape);
  const struct scallop_patience *patience;
  double mu[2], f[2];  /* of body 1 and body 2; sums are 1                          */
  double f_difference; /* f[0] - f[1]                                              */
  double fraction;     /* of the period that this phase takes                      */
  double eps;          /* tau^2 (F1 + F2)/(M L), tau the duration of the phase      */
  double c, x;
  long steps, evaluations, events;
};

/* One period from v0; the caller has set phase and patience, and all else is set here. Statuses and *period as struct
 * scallop_integrator requires. */
enum scallop_status integrator_period(struct integrator_phases *phases, const struct scallop_crawler *crawler,
                                      double v0, struct scallop_integrator_period *period);

static inline bool integrator_patience_lasts(const struct scallop_patience *patience)
{
  return !patience || patience->lasts(patience->context);
}

/* Time since the phase began, for an offset from the piece's anchor; and the other way round. */
static inline double integrator_flip(const struct scallop_piece *piece, double t)
{
  return piece->anchor == SCALLOP_FROM_START ? t : 1 - t;
}

#endif
