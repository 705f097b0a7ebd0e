/* The crawler on SUNDIALS CVODE: Adams's method of variable order and step, which meets the events by its own root
 * finder. What rival.h promises, and where odeiv.h says how its events are decided, the same holds here. CVODE starts
 * anew at each event and at each piece of the gait, and never steps over the end of one. */
#ifndef SCALLOP_NUMERICS_RIVALS_CVODE_H
#define SCALLOP_NUMERICS_RIVALS_CVODE_H

#include "numerics/rivals/rival.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Whether this program was built with SUNDIALS; without it there is no such rival. */
bool scallop_has_cvode(void);

/* DBL_EPSILON <= tolerance <= 0.1; the error that each step may make is tolerance * (1 + |y|) in the root mean square,
 * y being x1/L and x1' tau/L (tau the duration of the phase). Near DBL_EPSILON CVODE may refuse: SCALLOP_ECONVERGE from
 * its periods. Worst error seen in a velocity: 180 tolerance (L/(T min(alpha, 1 - alpha)) + |v|) at 1e-12, 15 at 1e-4,
 * and T times that in the displacement; tests/numerics/rivals/test_integrators.c holds both to a bound. NULL: a bad
 * tolerance, memory is short, or the program was built without SUNDIALS. */
struct scallop_rival *scallop_cvode_rival(double tolerance);

#ifdef __cplusplus
}
#endif

#endif
