/* The crawler on SUNDIALS ARKODE: an explicit Runge-Kutta method of order 5 with step control (ERKStep), which meets
 * the events by its own root finder, in the interpolant of each step. What rival.h promises, and where odeiv.h says how
 * its events are decided, the same holds here. ARKODE starts anew at each event and at each piece of the gait, and
 * never steps over the end of one. */
#ifndef SCALLOP_NUMERICS_RIVALS_ARKODE_H
#define SCALLOP_NUMERICS_RIVALS_ARKODE_H

#include "numerics/rivals/rival.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Whether this program was built with SUNDIALS; without it there is no such rival. */
bool scallop_has_arkode(void);

/* DBL_EPSILON <= tolerance <= 0.1; the error that each step may make is as scallop_cvode_rival has it (cvode.h). Once
 * it has met an event, ARKODE looks at its interpolant again in every step, also after a new start (seen in 6.4.1):
 * evaluations of the first period are up to one a step fewer than they would be later. Its numbers are the same. Worst
 * error seen in a velocity: 3 tolerance (L/(T min(alpha, 1 - alpha)) + |v|) at 1e-4, 2 at 1e-12, and T times that in
 * the displacement; tests/numerics/rivals/test_integrators.c holds both to a bound. NULL: a bad tolerance, memory is
 * short, or the program was built without SUNDIALS. */
struct scallop_rival *scallop_arkode_rival(double tolerance);

#ifdef __cplusplus
}
#endif

#endif
