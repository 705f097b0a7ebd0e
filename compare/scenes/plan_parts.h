/* What plan.c and plan_needs.c share. Not public. */
#ifndef SCALLOP_PLAN_PARTS_H
#define SCALLOP_PLAN_PARTS_H

#include "compare/scenes/plan.h"

/* What a point needs, gathered from all columns of all wants */
struct needed {
  bool used[MOST_QUANTITIES], compared[MOST_QUANTITIES];
  bool steady, phase, turnings, onset, v0;
  bool certified_steady, certified_phase, steady_series, phase_series;
  bool errors;
  double formulas, sums; /* evaluations at a point                                               */
  const char *for_steady, *for_phase, *for_certified; /* the first quantity that needs it              */
};

struct planning {
  const struct scene *scene;
  struct plan *plan;
  struct needed n;
};

/* plan_needs.c: what the wants need at a point, and how accurately. */
void plan_needs(struct planning *planning);

/* Does each product have a variable of that kind? Then the base's value is never used. */
bool every_product_sets(const struct scene *s, enum scene_target target);

#endif
