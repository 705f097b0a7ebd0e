/* Curves between regions of a square, of which nothing is known but which region a point belongs to. */
#ifndef SCALLOP_MAP_H
#define SCALLOP_MAP_H

#include <stdbool.h>

/* The region at (u, v), both within [0, 1]: a number >= 0 that stands for it, or MAP_NOWHERE. Called by several threads at once. */
enum { MAP_NOWHERE = -1 };
typedef int map_region(void *context, double u, double v);

/* How near the last point of a curve lies to a junction; and how near each point lies to the curve: where the regions of that
 * width exist, or of less. In u and v. */
#define MAP_NEAR 1e-11
#define MAP_THIN 1e-13

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

/* Every curve between two regions that the lines of a grid of columns x rows cells cross, or that begins where one of those ends.
 * Points follow each other at distances of at most step. False: out of memory. */
bool map_follow(map_region *region, void *context, int columns, int rows, double step, struct map_curves *curves);
/* The same curve from its other end. */
void map_curve_reverse(struct map_curve *curve);
void map_curves_clear(struct map_curves *curves);

/* What curves are made of (path.c): where one region ends and the next begins along a path. */
struct square {
  map_region *region;
  void *context;
};

struct path {
  bool arc;
  double u, v, a, b; /* line: (u + s a, v + s b); arc: (u, v) + a (cos s, sin s)                                */
};

struct change { /* along a path, from before to after */
  double at, u, v;
  int before, after;
};

enum { MOST_CHANGES = 32 };
struct changes {
  int count;
  struct change list[MOST_CHANGES];
};

/* MAP_NOWHERE outside of the square */
int region_on(const struct square *square, const struct path *path, double s);

/* Adds the changes between s0 and s1, where the regions are before and after. A region in between that is thinner than MAP_THIN is
 * left out. */
void find_changes(const struct square *square, const struct path *path, double s0, int before, double s1, int after,
                  struct changes *changes);

#endif
