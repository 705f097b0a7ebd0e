/* Curves between regions of a square, of which nothing is known but which region a point belongs to. */
#ifndef SCALLOP_COMPARE_MAPS_CURVES_H
#define SCALLOP_COMPARE_MAPS_CURVES_H

#include <stdbool.h>

#include "compare/maps/path.h"

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

/* Every curve between two regions that the lines of a grid of columns x rows cells cross, or that begins where one of
 * those ends. Points follow each other at distances of at most step. False: out of memory. */
bool map_follow(map_region *region, void *context, int columns, int rows, double step, struct map_curves *curves);
/* The same curve from its other end. */
void map_curve_reverse(struct map_curve *curve);
void map_curves_clear(struct map_curves *curves);

#endif
