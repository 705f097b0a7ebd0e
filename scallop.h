/* The crawling-scallop library: two bodies on dry friction, joined by a mechanism that pushes them apart and pulls them
 * together; their exact motion, and the published series for it. `pkg-config --cflags --libs scallop-core` prints the
 * compiler's options.
 *
 *     struct scallop_crawler crawler = scallop_crawler_default();
 *     struct scallop_steady_result steady;
 *     crawler.F1 = 3;
 *     if (scallop_steady(&crawler, &steady) >= 0)
 *       printf("%.17g\n", steady.mean_velocity);
 *
 * Headers of libscallop-core (it needs C's library only) and of libscallop:
 *     model/model.h                    crawlers, gaits, phases; scallop_status, the result of every call that can fail
 *     model/gaits.h                    parametrised gaits, and splines through given points
 *     model/measured/measured.h        gaits from recordings, and the uncertainty of results with them
 *     model/families.h                 the families of gaits, by name
 *     numerics/numerics.h              exact phases, periods, steady states, one or many, and trajectories
 *     numerics/wide/wide.h             the same in wider arithmetic: an estimate of the error of each number
 *     asymptotics/asymptotics.h        the formulas of the paper as published, and users' formulas
 *     asymptotics/observed/order.h     the observed order of a table of h and err, with a verdict; for any method
 * Headers of libscallop alone, not included here:
 *     numerics/certified/certified.h   up to 100 000 proven digits (FLINT), with exact parameters
 *     asymptotics/derived/expansion.h  the derived series, term by term, and formulas in balls (FLINT)
 *     numerics/integrators/integrator.h  methods for comparison, on GSL and SUNDIALS
 *
 * No function prints, exits or has a state. Memory is allocated only by the integrators, the functions that
 * need FLINT, scallop_formula_read and scallop_measured_new. Functions are thread-safe unless their header states
 * otherwise. */
#ifndef SCALLOP_H
#define SCALLOP_H

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

#include "asymptotics/asymptotics.h"
#include "asymptotics/observed/order.h"
#include "model/families.h"
#include "model/gaits.h"
#include "model/measured/measured.h"
#include "model/model.h"
#include "model/version.h"
#include "numerics/numerics.h"
#include "numerics/wide/wide.h"

#ifdef __cplusplus
}
#endif

#endif
