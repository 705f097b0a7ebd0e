/* A scene that has been read: its points, variables and columns, and its end. */
#include <stdlib.h>

#include "compare/scenes/parts.h"

static void free_product(struct scene_product *product)
{
  for (int g = 0; g < product->groups; g++)
    for (int v = 0; v < product->group[g].variables; v++) {
      free(product->group[g].variable[v].numbers);
      free(product->group[g].variable[v].texts);
    }
}

void scene_free(struct scene *s)
{
  while (s->kept) {
    struct kept *first = s->kept;
    s->kept = first->next;
    free(first);
  }
  for (int p = 0; p < s->products; p++)
    free_product(&s->product[p]);
  for (int w = 0; w < s->wants; w++)
    free(s->want[w].arguments), free(s->want[w].column);
  free(s->product);
  free(s->name);
  if (s->file)
    config_destroy(s->file);
  free(s->file);
  *s = (struct scene){ .products = 0 };
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

const char *scene_variable_sets(const struct scene_variable *v)
{
  switch (v->target) {
  case TARGET_F1_OVER_F2: return "F1";
  case TARGET_M1_OVER_M2: return "m1";
  case TARGET_FROUDE: return "T";
  default: return v->name;
  }
}

const struct scene_variable *scene_variable(const struct scene *s, int i)
{
  for (int p = 0; p < s->products; p++)
    for (int g = 0; g < s->product[p].groups; g++) {
      const struct scene_group *group = &s->product[p].group[g];
      if (i < group->variables)
        return &group->variable[i];
      i -= group->variables;
    }
  return NULL;
}

long scene_product_points(const struct scene_product *product)
{
  long points = 1;
  for (int g = 0; g < product->groups; g++)
    points *= product->group[g].count;
  return points;
}

long scene_points(const struct scene *s)
{
  long points = 0;
  for (int p = 0; p < s->products; p++)
    points += scene_product_points(&s->product[p]);
  return points;
}
