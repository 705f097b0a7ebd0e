/* What the rivals that locate no events share: one period of the velocity c and the path X of the centre of mass,
 *
 *     c' = -eps (f1 sgn v1 + f2 sgn v2),   v1 = c - mu2 l',   v2 = c + mu1 l',   X' = c        (numerics.h)
 *
 * phase by phase. A rival brings one phase. Units: L, and the duration of the phase. Private to the rivals. */
#ifndef SCALLOP_RIVAL_CENTRE_H
#define SCALLOP_RIVAL_CENTRE_H

#include "numerics/rival.h"

struct rival_centre {
  /* Takes c and x from the start of a phase of this shape to its end; SCALLOP_OK, or why it could not. */
  enum scallop_status (*phase)(struct rival_centre *centre, const struct scallop_shape *shape);
  const struct scallop_patience *patience;
  double mu1, mu2, f1, f2;
  double f_difference; /* f1 - f2                                                  */
  double fraction;     /* of the period that this phase takes                      */
  double eps;          /* tau^2 (F1 + F2)/(M L), tau the duration of the phase      */
  double c, x;
  long steps, evaluations;
};

/* One period from v0; the caller has set phase and patience, and all else is set here. Statuses and *period as struct
 * scallop_rival promises. */
enum scallop_status rival_centre_period(struct rival_centre *centre, const struct scallop_crawler *crawler, double v0,
                                        struct scallop_rival_period *period);

#endif
