/* Floors: where errors that fell no longer fall. A rough one is roundoff, or the tolerance of a solver: the points on
 * it and near it are left out. A smooth one far above roundoff is a plateau: the table converges to something else, and
 * that is its verdict. */
#ifndef SCALLOP_ASYMPTOTICS_OBSERVED_FLOOR_H
#define SCALLOP_ASYMPTOTICS_OBSERVED_FLOOR_H

#include "asymptotics/observed/reason.h"

/* Looks for a floor, unless the noise of the table is announced. False: it decides, and the verdict is set. */
bool floor_judge(struct judged *j, bool announced);
/* Leaves out what is near a floor or the roundoff of doubles, where there are enough others, and takes the rest in
 * again. False: there is nothing to leave out. */
bool floor_leave_out_near(struct judged *j);

#endif
