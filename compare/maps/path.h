/* Regions of a square along a path: where one ends and the next begins. */
#ifndef SCALLOP_COMPARE_MAPS_PATH_H
#define SCALLOP_COMPARE_MAPS_PATH_H

#include <stdbool.h>

/* The region at (u, v), both within [0, 1]: a number >= 0 that stands for it, or MAP_NOWHERE. Called by several threads
 * at once. */
enum { MAP_NOWHERE = -1 };
typedef int map_region(void *context, double u, double v);

/* How near the last point of a curve lies to a junction; and how near each point lies to the curve: where the regions
 * of that width exist, or of less. In u and v. */
#define MAP_NEAR 1e-11
#define MAP_THIN 1e-13

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

/* Adds the changes between s0 and s1, where the regions are before and after. A region in between that is thinner than
 * MAP_THIN is left out. */
void find_changes(const struct square *square, const struct path *path, double s0, int before, double s1, int after,
                  struct changes *changes);

#endif
