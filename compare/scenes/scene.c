/* A scene that has been read: its points, variables and columns, and its end. */
#include <stdlib.h>

#include "compare/scenes/parts.h"

void scene_free(struct scene *s)
{
  while (s->kept) {
    struct kept *first = s->kept;
    s->kept = first->next;
    free(first);
  }
  sweep_free(&s->sweep);
  for (int w = 0; w < s->wants; w++)
    free(s->want[w].arguments), free(s->want[w].column);
  free(s->name);
  if (s->file)
    config_destroy(s->file);
  free(s->file);
  *s = (struct scene){ .name = NULL };
}

int scene_want_quantities(const struct scene_want *w, int places[WANT_QUANTITIES])
{
  int count = 0;
  for (int i = 0; i < w->columns; i++) {
    const struct scene_column *c = &w->column[i];
    if (c->quantity >= 0)
      places[count++] = c->quantity;
    else
      count += arithmetic_places(&c->formula, places + count);
  }
  if (w->until.is_formula && count <= WANT_QUANTITIES - ARITHMETIC_STEPS)
    count += arithmetic_places(&w->until.formula, places + count);
  for (int i = 0; i < w->series && count < WANT_QUANTITIES; i++)
    places[count++] = w->of[i];
  return count;
}
