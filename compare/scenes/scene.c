#include "compare/scenes/scene.h"

int scene_want_quantities(const struct scene_want *w, int places[WANT_QUANTITIES])
{
  int count = 0;
  for (int i = 0; i < w->columns; i++) {
    const struct scene_column *c = &w->column[i];
    if (c->quantity >= 0)
      places[count++] = c->quantity;
    else
      count += formula_places(&c->formula, places + count);
  }
  if (w->until.is_formula && count <= WANT_QUANTITIES - FORMULA_STEPS)
    count += formula_places(&w->until.formula, places + count);
  for (int i = 0; i < w->series && count < WANT_QUANTITIES; i++)
    places[count++] = w->of[i];
  return count;
}
