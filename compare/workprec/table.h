/* `scallop workprec`: error against run time of every method for the steady state. Needs FLINT. */
#ifndef SCALLOP_WORKPREC_TABLE_H
#define SCALLOP_WORKPREC_TABLE_H

#include "compare/text/message.h"

struct options;
enum exit_code workprec_table(const struct options *options);

#endif
