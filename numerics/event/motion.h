/* Phases and periods in double (period.h), and what pieces of a gait are to them. Not public. */
#ifndef SCALLOP_NUMERICS_EVENT_MOTION_H
#define SCALLOP_NUMERICS_EVENT_MOTION_H

#include <float.h>

#include "model/law.h"

typedef double real;
#define ROUNDING (DBL_EPSILON / 2)
#define SOLVE
#include "numerics/event/period.h"

/* l' and l'' at an offset of a piece */
static inline void piece_rates(const struct scallop_piece *p, double u, double *velocity, double *acceleration)
{
  if (p->curve->rates) {
    p->curve->rates(p, u, velocity, acceleration);
  } else {
    *velocity = p->curve->velocity(p, u);
    *acceleration = p->curve->acceleration(p, u);
  }
}

/* The mean of sgn l' over the period: 2 alpha - 1 for the usual gaits, correctly rounded */
SCALLOP_INLINE double period_driven(const struct scallop_gait *gait, double alpha)
{
  double e = gait->phase[SCALLOP_EXTENSION].net, c = gait->phase[SCALLOP_CONTRACTION].net;
  return alpha * (e - c) + c;
}

/* Nearly equal phases that are mirror images undo each other's displacement but for about 2 alpha - 1 of it. */
SCALLOP_INLINE int period_undoes(double driven) { return (driven < 0 ? -driven : driven) < 0x1p-10; }

/* fraction: of the period */
SCALLOP_INLINE struct phase_input phase_input_of(const struct scallop_scaled *s, const struct scallop_shape *shape,
                                                 double fraction)
{
  return (struct phase_input){ shape, s->mu1, s->mu2, s->f1, s->f2, s->delta, s->eps * (fraction * fraction), 0 };
}
struct walker walker_of(const struct scallop_scaled *scaled);

/* What friction has left of the velocity at the end, as a fraction, if that is so little that rounding of what is gone
 * shows in it; else 1, as for two ramps, whose short cut does not set furthest. */
double motion_left(const struct scallop_shape *shape, const struct motion *motion);

/* Velocities in L/T, the displacement in L */
void period_result(const struct walker *walker, const struct period *period, struct scallop_period_result *result);

#endif
