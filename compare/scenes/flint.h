/* What a scene's point needs FLINT for: series and certified values, kept until the next point, series until room is needed. Weak: `scallop`
 * is linked without these, and the plan hands such a scene over to the program that has them. */
#ifndef SCALLOP_SCENE_FLINT_H
#define SCALLOP_SCENE_FLINT_H

#include "compare/answers/points.h"
#include "compare/scenes/scene.h"

struct scene_asked { /* of which point, and what came of it */
  const struct scene *scene;
  const struct point *at;
  double v0;                 /* the start velocity, for a quantity of the phase; else 0 */
  char why[POINT_STATUS];    /* "", or why there is no value */
  struct scene_flint *flint; /* what is kept; NULL at first */
};

extern const struct scene_flint_functions {
  void (*free)(struct scene_flint *flint);
  /* The next point has other certified values. */
  void (*forget)(struct scene_flint *flint);
  /* The sum of a derived series, or of its first term, at the point. */
  double (*sum)(struct scene_asked *asked, const struct quantity *series);
  /* series - exact against certified values, and both; 0 where it is below the accuracy that the scene wants. */
  double (*error)(struct scene_asked *asked, const struct quantity *series, double *value, double *exact);
  /* A certified value with so many digits; it lives until the next call. */
  const char *(*certified)(struct scene_asked *asked, const struct quantity *q, long digits);
} scene_flint __attribute__((weak, visibility("hidden")));

#endif
