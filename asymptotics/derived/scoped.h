/* Series and expansions, for SCOPED of model/exact/scoped.h */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_SCOPED_H
#define SCALLOP_ASYMPTOTICS_DERIVED_SCOPED_H

#include "asymptotics/derived/derived.h"
#include "asymptotics/derived/evaluate.h"
#include "model/exact/scoped.h"

SCOPED_KIND(scallop_symbols, struct scallop_symbols)

#endif
