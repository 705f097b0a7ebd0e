/* Maps over two parameters of a crawler: one row for each point of a grid, or the curves between the regions of the same modes. */
#ifndef SCALLOP_MAPS_H
#define SCALLOP_MAPS_H

#include "compare/breakdown/breakdown.h"
#include "compare/text/message.h"

enum exit_code breakdown_map(const struct breakdown_options *options);
enum exit_code breakdown_boundaries(const struct breakdown_options *options);

#endif
