/* What a scene's point needs FLINT for: certified answers, and series, which are kept for the last crawlers. Weak: `scallop` is linked
 * without this table, and the plan hands such a scene over to the program that has it. */
#ifndef SCALLOP_SCENE_FLINT_H
#define SCALLOP_SCENE_FLINT_H

#include <math.h>
#include <stdio.h>

#include "compare/answers/points.h"
#include "compare/scenes/scene.h"

/* The point that is visited */
struct visit {
  const struct scene *scene;
  struct point point;
  double v0;              /* the start of the phase, for what is of it */
  char why[POINT_STATUS]; /* the first thing that could not be done, or "" */
  long failures;          /* so far */
};

/* Notes why something cannot be done, if it is the first. Returns nan. */
static inline double visit_fail(struct visit *v, const char *why)
{
  v->failures++;
  if (v->why[0] == '\0')
    snprintf(v->why, sizeof v->why, "%s", why);
  return NAN;
}

struct scene_flint;
extern const struct scene_flint_functions {
  struct scene_flint *(*create)(void); /* NULL: no memory */
  void (*free)(struct scene_flint *flint);
  /* Goes to a point; the start of its phase is taken from there with the first thing that is of the phase. */
  void (*move)(struct scene_flint *flint, const struct visit *visit);
  /* Solves the steady state or the phase of the point, for the functions below. */
  void (*certify)(struct scene_flint *flint, const struct visit *visit, enum quantity_of of);
  /* The sum of a derived series, or of its first term, at the point. */
  double (*sum)(struct scene_flint *flint, struct visit *visit, const struct quantity *series);
  /* series - exact in balls, and both, where exact is a quantity of the certified answer; 0 below the accuracy that the scene wants. */
  double (*error)(struct scene_flint *flint, struct visit *visit, const struct quantity *series, int quantity, double *value,
                  double *exact);
  /* A certified value with so many digits; it lives until the next call. */
  const char *(*text)(struct scene_flint *flint, struct visit *visit, const struct quantity *q, long digits);
} scene_flint __attribute__((weak, visibility("hidden")));

#endif
