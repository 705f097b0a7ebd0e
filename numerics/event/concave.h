/* A phase with concave |l'|, from 0 to 0, in which a body turns and turns back and none is held: two roots, and nothing
 * to walk through. The same line and curves as in motion.c, with the argument of regular.h. Not public.
 *
 * What it saves, as in ramps.h (else motion.c would do): 4291 for 11681 for a period of the sinusoidal gait.
 */
#ifndef SCALLOP_NUMERICS_EVENT_CONCAVE_H
#define SCALLOP_NUMERICS_EVENT_CONCAVE_H

#include "numerics/event/motion.h"

/* For a shape that is concave. As motion_solve, without a visitor; the modes come as motion->trail. False: the motion
 * is of another kind, or too near to one; *motion is then of no use. */
bool concave_solve(const struct motion_input *input, double c0, struct motion *motion);

#endif
