/* The period map in units of L, T and F1 + F2. Not public. */
#ifndef SCALLOP_NUMERICS_EVENT_PERIOD_H
#define SCALLOP_NUMERICS_EVENT_PERIOD_H

#include "model/scaling.h"
#include "numerics/event/motion.h"

/* The mean of sgn l' over the period: 2 alpha - 1 for the usual gaits, correctly rounded */
SCALLOP_INLINE double period_driven(const struct scallop_gait *gait, double alpha)
{
  double e = gait->phase[SCALLOP_EXTENSION].net, c = gait->phase[SCALLOP_CONTRACTION].net;
  return alpha * (e - c) + c;
}

/* Whether so much of a displacement cancels in the sum of its parts that wider arithmetic has to tell it: rounding
 * leaves up to an ulp of size, and the displacement itself may be known to as little as an ulp of its own. Of ramps the
 * parts are products, and exact to a few ulp of their own. */
SCALLOP_INLINE int period_cancels(double travel, double size, int ramps)
{
  return (travel < 0 ? -travel : travel) < (ramps ? 0x1p-6 : 0x1p-3) * size;
}

/* Nearly equal phases that are mirror images undo each other's displacement but for about 2 alpha - 1 of it. */
SCALLOP_INLINE int period_undoes(double driven) { return (driven < 0 ? -driven : driven) < 0x1p-10; }

struct period {
  double base[2];               /* of the phases, in L/tau: what velocities are counted from (walk.h)  */
  double c_start, c_mid, c_end; /* in L/T, from base                                                 */
  double travel;                /* displacement, in L                                                */
  double size;                  /* sum of the magnitudes of the parts that it was summed from          */
  double balance;               /* (c_end - c_start)/eps, formed without that subtraction            */
  double noise;                 /* what rounding can do to balance                                   */
  double balance_slope;         /* d balance / d c_start <= 0, unless it forgets                         */
  bool forgets;                 /* a body was stuck: c_end does not depend on c_start */
  bool goes_on;                 /* phase[1] is the contraction from c_mid                              */
  struct motion phase[2];
};

/* The parts of period_solve, for who wants to see the intervals: c_start is set, then the extension, the
 * contraction, and the conclusion. */
void period_phase(const struct scallop_scaled *scaled, enum scallop_phase_kind kind, struct period *period,
                  scallop_visitor *visit, void *context);
/* Afterwards, where the displacement is wanted and not only the velocities: travel as well as it can be told in
 * double. */
void period_sum_up(const struct scallop_scaled *scaled, struct period *period);
void period_conclude(const struct scallop_scaled *scaled, struct period *period);

/* Before the first solve: velocities are counted from 0. */
void period_begin(struct period *period);
void period_solve(const struct scallop_scaled *scaled, double c_start, struct period *period);
/* Velocities in L/T, the displacement in L */
void period_result(const struct scallop_scaled *scaled, const struct period *period,
                   struct scallop_period_result *result);

#endif
