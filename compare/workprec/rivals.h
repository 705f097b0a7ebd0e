/* The rivals of numerics/rival.h: GSL's solvers with events, CVODE, GSL's stiff solvers on smoothed friction, Moreau's time stepping.
 * Each is two methods: simulation from rest until the periods repeat, and the root of its period map. */
#ifndef SCALLOP_WORKPREC_RIVALS_H
#define SCALLOP_WORKPREC_RIVALS_H

#include "compare/workprec/setting.h"

/* quick: fewer settings. */
void rivals_add(struct settings *settings, const struct reference *reference, bool quick);

#endif
