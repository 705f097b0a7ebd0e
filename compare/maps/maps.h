/* Maps over two parameters of a crawler: rows for the points of a grid, or the boundaries between regions of equal
 * modes. The axes X and Y are the variables of the request: Y in the first group, X in the last. */
#ifndef SCALLOP_COMPARE_MAPS_MAPS_H
#define SCALLOP_COMPARE_MAPS_MAPS_H

#include "compare/answers/rows.h"
#include "compare/breakdown/breakdown.h"

/* Plans the rows of the grid. Returns NULL or the error; "": it has been printed. */
const char *breakdown_map(const struct breakdown_options *options, struct rows *rows);
enum exit_code breakdown_boundaries(const struct breakdown_options *options);

/* Returns the variable of the axis x (i = 0) or y (i = 1). */
const struct sweep_variable *map_axis(const struct breakdown_options *options, int i);
/* Writes '#' lines: the formula file, both axes, and the constant parameters. */
void map_head(struct table *table, const struct breakdown_options *options);

#endif
