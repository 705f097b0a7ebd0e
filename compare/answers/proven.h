/* Rows of `phase` and `steady` whose every digit is proven, and the table of derived series. These need FLINT. */
#ifndef SCALLOP_PROVEN_H
#define SCALLOP_PROVEN_H

#include "compare/text/message.h"

struct options;
struct table;

/* NULL, or why there is no answer. */
const char *certified_phase_row(struct table *table, const struct options *point);
const char *certified_steady_row(struct table *table, const struct options *point);

/* series --source derived|limit and series --bound */
enum exit_code series_derived(const struct options *options);

#endif
