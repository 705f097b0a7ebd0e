/* Maps over two parameters of a crawler, the axes X and Y, which are what varies in the request: Y in the first
 * group, X in the last. A row for each point of a grid, or the boundaries between the regions of the same modes. */
#ifndef SCALLOP_COMPARE_MAPS_MAPS_H
#define SCALLOP_COMPARE_MAPS_MAPS_H

#include "compare/answers/rows.h"
#include "compare/breakdown/breakdown.h"

/* Plans the rows of the grid. NULL, or what is wrong; "": that has been said. */
const char *breakdown_map(const struct breakdown_options *options, struct rows *rows);
enum exit_code breakdown_boundaries(const struct breakdown_options *options);

/* Along x (0) and y (1) */
struct axis {
  const char *name; /* in the table */
  const struct sweep_variable *varies;
};
struct axis map_axis(const struct breakdown_options *options, int i);
/* '#' lines: the book, both axes, and the parameters that hold */
void map_head(struct table *table, const struct breakdown_options *options);

/* axis.c. The value at u in [0, 1]: an end at 0 and at 1; their mean at 1/2, the geometric one where the axis is
 * logarithmic. */
double axis_value(struct axis axis, double u);
/* How much of the value a step in u is: |d value/du| over the value on a logarithmic axis, over the larger end on a
 * linear one. */
double axis_scale(struct axis axis);
/* The crawler at these two values. Other parameters are those of base. */
struct scallop_crawler axes_crawler(const struct axis axes[2], const struct scallop_crawler *base, double x, double y);

#endif
