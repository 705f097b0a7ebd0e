/* What is certified, for SCOPED of model/exact/scoped.h */
#ifndef SCALLOP_NUMERICS_CERTIFIED_SCOPED_H
#define SCALLOP_NUMERICS_CERTIFIED_SCOPED_H

#include "model/exact/scoped.h"
#include "numerics/certified/certified.h"

SCOPED_KIND(scallop_certified_phase, struct scallop_certified_phase)
SCOPED_KIND(scallop_certified_steady, struct scallop_certified_steady)

#endif
