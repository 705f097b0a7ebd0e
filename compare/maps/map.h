/* Maps over two parameters (`breakdown --map`): what the grid and the boundaries share, and how curves between regions are followed. */
#ifndef SCALLOP_MAP_H
#define SCALLOP_MAP_H

#include "compare/maps/axis.h"
#include "compare/command/compare.h"

/* The '#' lines: version, command, axes, parameters. about: what else the command line says, or "". */
void map_begin(struct table *table, const struct options *options, const struct axis axes[2], const char *about);

/* ---- curves between regions: map_curves.c ---- */

/* The region at (u, v), both within [0, 1]: a number >= 0 that stands for it, or MAP_NOWHERE. Called by several threads at once. */
enum { MAP_NOWHERE = -1 };
typedef int map_region(void *context, double u, double v);

enum map_end {
  MAP_GOES_ON,  /* a point in the middle                                                            */
  MAP_OPEN,     /* the curve leaves the square                                                      */
  MAP_CLOSED,   /* it comes back to where it began                                                  */
  MAP_JUNCTION, /* a third region meets the two, within MAP_NEAR of this point                        */
  MAP_STOPS     /* it could not be followed any further                                               */
};
struct map_point {
  double u, v;
  double nu, nv;    /* unit vector across the curve, towards the region on the left as the points go    */
  enum map_end end; /* of the first and of the last point of a curve                                  */
  int third;        /* the region that meets the two at a junction, or MAP_NOWHERE                     */
};
struct map_curve {
  int left, right; /* regions, as the points go with u to the right and v up                            */
  long count;
  struct map_point *points;
};
struct map_curves {
  long count, lost; /* curves; changes from which no curve could be followed                              */
  struct map_curve *curves;
};

/* How near the last point of a curve lies to a junction; and how near each point lies to the curve: where the regions of that
 * width exist, or of less. In u and v. */
#define MAP_NEAR 1e-11
#define MAP_THIN 1e-13

/* Every curve between two regions that the lines of a grid of columns x rows cells cross, or that begins where one of those ends.
 * Points follow each other at distances of at most step. False: out of memory. */
bool map_follow(map_region *region, void *context, int columns, int rows, double step, struct map_curves *curves);
void map_curves_clear(struct map_curves *curves);

/* `scallop breakdown --map`; with --boundaries */
enum exit_code breakdown_map(const struct options *options);
enum exit_code breakdown_boundaries(const struct options *options);

#endif
