/* The plan of a scene: the least work that gives what is wanted, stage by stage, and what is left out and why. */
#ifndef SCALLOP_PLAN_H
#define SCALLOP_PLAN_H

#include "compare/answers/counts.h"
#include "compare/scenes/scene.h"
#include "compare/scenes/state.h"

enum plan_known { PLAN_LEFT_OUT, PLAN_EXACTLY, PLAN_AT_MOST, PLAN_ABOUT, PLAN_AT_LEAST };
const char *plan_known_text(enum plan_known known);

enum { PLAN_WHY = 240 };

struct plan_stage {
  double work; /* as the counter of that name will say (counts.h)                            */
  enum plan_known known;
  double seconds; /* to a factor of some                                                        */
  char why[PLAN_WHY];
};

struct plan {
  struct scene_needs needs;
  bool needs_flint;
  struct plan_stage stage[COUNTS];
};

/* Works out the plan. Nothing is solved. */
void plan_make(struct plan *plan, const struct scene *scene);

#endif
