/* Maps over two parameters of a crawler, the axes X and Y, which are what varies in the request: Y in the first
 * group, X in the last. A row for each point of a grid, or the boundaries between the regions of the same modes. */
#ifndef SCALLOP_COMPARE_MAPS_MAPS_H
#define SCALLOP_COMPARE_MAPS_MAPS_H

#include "compare/answers/rows.h"
#include "compare/breakdown/breakdown.h"

/* Plans the rows of the grid. NULL, or what is wrong; "": that has been said. */
const char *breakdown_map(const struct breakdown_options *options, struct rows *rows);
enum exit_code breakdown_boundaries(const struct breakdown_options *options);

/* What varies along x (0) and y (1) */
const struct sweep_variable *map_axis(const struct breakdown_options *options, int i);
/* '#' lines: the formula file, both axes, and the parameters that hold */
void map_head(struct table *table, const struct breakdown_options *options);

#endif
