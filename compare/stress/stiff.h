/* `scallop stress --stiff`: the table of stiff runs (stiff_measure.h), or with --summary a row for each series of them. Needs FLINT. */
#ifndef SCALLOP_STRESS_STIFF_H
#define SCALLOP_STRESS_STIFF_H

#include "compare/text/message.h"

struct stress_options;
enum exit_code stress_stiff(const struct stress_options *options);

#endif
