/* Linked into scallop-flint alone. */
#include "compare/command/with_flint.h"

#include <flint/flint.h>

#include "compare/answers/answer.h"
#include "compare/breakdown/breakdown.h"
#include "compare/claims/claims.h"
#include "compare/command/series_flint.h"
#include "compare/maps/maps.h"
#include "compare/stress/table.h"
#include "compare/workprec/table.h"

const struct with_flint with_flint = { .answer_in_decimals = answer_in_decimals,
                                       .decimals_free = decimals_free,
                                       .series = series_derived,
                                       .claims = claims_table,
                                       .workprec = workprec_table,
                                       .stress = stress_table,
                                       .stress_point = stress_point,
                                       .stress_stiff = stress_stiff,
                                       .breakdown = breakdown_table,
                                       .map = breakdown_map,
                                       .boundaries = breakdown_boundaries };

/* At its end the memory that FLINT keeps for reuse is given back. A leak checker then sees what was forgotten, the limbs of big
 * integers too, which FLINT holds behind pointers that no checker can read. */
static void end_of_program(void) __attribute__((destructor));

static void end_of_program(void) { flint_cleanup(); }
