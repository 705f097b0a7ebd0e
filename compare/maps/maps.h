/* Maps over two parameters of a crawler, its axes: one row for each point of a grid, or the curves between the regions
 * of the same modes. */
#ifndef SCALLOP_COMPARE_MAPS_MAPS_H
#define SCALLOP_COMPARE_MAPS_MAPS_H

#include "compare/breakdown/breakdown.h"

enum exit_code breakdown_map(const struct breakdown_options *options);
enum exit_code breakdown_boundaries(const struct breakdown_options *options);

/* F1/F2 and m1/m2, also called F1_over_F2 and m1_over_m2 as in scenes, keep body 2 as it is; froude = M L/(T^2 (F1 +
 * F2)) sets T when all else is set. */
enum axis_kind { AXIS_F1_F2, AXIS_M1_M2, AXIS_ALPHA, AXIS_T, AXIS_FROUDE, AXIS_KINDS };

struct axis {
  enum axis_kind kind;
  const char *name, *sets; /* the parameter that it sets */
  double from, to;         /* from < to, or from = to where count = 1                                          */
  long count;              /* values                                                                           */
  bool log;                /* they are spaced evenly in the logarithm                                          */
};

/* The usual ranges */
#define AXIS_ALPHA_RANGE "0.01:0.99:41:linear"
#define AXIS_RANGE "0.01:100:41:log"

/* An axis from its name and FROM:TO:COUNT[:log|:linear] (NULL: the usual one). NULL, or what is wrong, until the next
 * call. */
const char *axis_read(struct axis *axis, const char *name, const char *range);
/* Both, for a crawler of which some parameters are written. False: the message is on stderr, exit with EXIT_USAGE. */
bool axes_read(struct axis axes[2], const char *const names[2], const char *const ranges[2], const struct point *point);

/* The '#' lines: version, command, axes, parameters. about: what else the command line says, or "". */
void axes_head(struct table *table, const struct breakdown_options *options, const struct axis axes[2],
               const char *about);

/* The value at u in [0, 1]: from at 0, to at 1; their mean at 1/2, the geometric one where the axis is logarithmic. */
double axis_value(const struct axis *axis, double u);
/* Value i of count. */
double axis_node(const struct axis *axis, long i);
/* How much of the value a step in u is: |d value/du| over the value on a logarithmic axis, over the larger end on a
 * linear one. */
double axis_scale(const struct axis *axis);

/* The crawler at these two values. Other parameters are those of base. */
struct scallop_crawler axes_crawler(const struct axis axes[2], const struct scallop_crawler *base, double x, double y);

#endif
