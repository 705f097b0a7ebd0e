/* Series and expansions, for SCOPED of model/exact/scoped.h */
#ifndef SCALLOP_ASYMPTOTICS_DERIVED_SCOPED_H
#define SCALLOP_ASYMPTOTICS_DERIVED_SCOPED_H

#include "asymptotics/derived/derived.h"
#include "asymptotics/derived/evaluate.h"
#include "model/exact/scoped.h"

SCOPED_KIND(series, struct series)
SCOPED_KIND(scallop_symbols, struct scallop_symbols)
SCOPED_KIND(scallop_phase_expansion, struct scallop_phase_expansion)
SCOPED_KIND(scallop_steady_expansion, struct scallop_steady_expansion)

#endif
