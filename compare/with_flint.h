/* What the commands ask of the parts that need FLINT. A build without it has compare/without_flint.c instead, where
 * each of these says what is missing. */
#ifndef SCALLOP_WITH_FLINT_H
#define SCALLOP_WITH_FLINT_H

#include "compare/compare.h"

/* True; or false, and what is missing is on stderr. what: "steady --certified". */
bool has_flint(const char *command, const char *what);

/* The rows of `phase` and `steady` in ball arithmetic, every digit proven. As point_row (points.h). */
const char *certified_phase_row(struct table *table, const struct options *point, const char *refused);
const char *certified_steady_row(struct table *table, const struct options *point, const char *refused);

/* series --source derived|limit and series --bound */
enum exit_code series_derived(const struct options *options);

#endif
