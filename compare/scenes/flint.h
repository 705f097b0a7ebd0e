/* What a scene's point needs FLINT for. In `scallop` these are not reached: the plan hands such a scene over (with_flint.h). */
#ifndef SCALLOP_SCENE_FLINT_H
#define SCALLOP_SCENE_FLINT_H

#include "compare/scenes/state.h"

void scene_flint_free(struct scene_flint *flint); /* takes NULL */
/* The next point has other certified values. */
void scene_flint_forget(struct scene_flint *flint);

/* The sum of a derived series, or of its first term, at the point. */
double scene_flint_sum(struct scene_state *state, const struct quantity *series);
/* series - exact against certified values, and both; 0 where it is below the accuracy that the scene wants. */
double scene_flint_error(struct scene_state *state, const struct quantity *series, double *value, double *exact);
/* A certified value with so many digits; it lives until the next call. */
const char *scene_flint_certified(struct scene_state *state, const struct quantity *q, long digits);

#endif
