/* The methods of the paper and of this tool: published and derived series, the limit, the exact and the certified solver. */
#ifndef SCALLOP_WORKPREC_METHODS_H
#define SCALLOP_WORKPREC_METHODS_H

#include "compare/workprec/setting.h"

/* quick: fewer settings. */
void methods_add(struct settings *settings, const struct reference *reference, bool quick);

#endif
