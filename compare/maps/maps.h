/* Maps over two parameters of a crawler: one row for each point of a grid, or the curves between the regions of the same modes. */
#ifndef SCALLOP_MAPS_H
#define SCALLOP_MAPS_H

#include "compare/text/message.h"

struct options;
enum exit_code breakdown_map(const struct options *options);
enum exit_code breakdown_boundaries(const struct options *options);

#endif
