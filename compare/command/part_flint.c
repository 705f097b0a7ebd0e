/* Functions of the part that needs FLINT, loaded on demand. */
#include <flint/flint.h>
#include <gsl/gsl_errno.h>

#include "compare/breakdown/breakdown.h"
#include "compare/claims/claims.h"
#include "compare/answers/flint.h"
#include "compare/command/series_options.h"
#include "compare/maps/maps.h"
#include "compare/stress/stress.h"
#include "compare/summary/summary.h"
#include "compare/workprec/table.h"

const struct flint_part flint_part = { SCALLOP_VERSION, series_report, claims_table,         workprec_table,
                                       breakdown_table, breakdown_map, breakdown_boundaries, breakdown_page,
                                       summary_plan,    stress_table,  stress_point,         stress_stiff };

/* Makes an error in GSL's functions in this part a status. */
static void __attribute__((constructor)) begin(void) { gsl_set_error_handler_off(); }

/* Frees the memory that FLINT keeps for reuse. A leak checker then finds all leaks, also in the limbs of big integers,
 * since FLINT's pointers to them are encoded. */
static void __attribute__((destructor)) end(void) { flint_cleanup(); }
