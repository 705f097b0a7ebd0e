#include "compare/answers/sweep.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text/table.h"
#include "compare/text/values.h"

/* Variables beside the crawler's numbers */
static const struct {
  const char *name, *sets;
  enum sweep_target target;
} others[] = { { "gait", "gait", TARGET_GAIT },
               { "v0", "v0", TARGET_V0 },
               { "F1_over_F2", "F1", TARGET_F1_OVER_F2 },
               { "m1_over_m2", "m1", TARGET_M1_OVER_M2 },
               { "froude", "T", TARGET_FROUDE } };

bool sweep_variable_of_name(struct sweep_variable *v, const char *name)
{
  *v = (struct sweep_variable){ .name = name, .sets = name, .place = crawler_place(name) };
  if (v->place < CRAWLER_NUMBERS)
    return true; /* TARGET_NUMBER is 0 */
  for (size_t i = 0; i < sizeof others / sizeof *others; i++)
    if (strcmp(name, others[i].name) == 0) {
      v->sets = others[i].sets;
      v->target = others[i].target;
      return true;
    }
  return false;
}

const char *sweep_wrong(const struct sweep_variable *v, const struct point *point, const char *text)
{
  struct point probe = *point;
  double x;
  if (v->target == TARGET_NUMBER || v->target == TARGET_V0 || v->target == TARGET_GAIT)
    return point_set(&probe, v->name, text);
  return v->target == TARGET_LABEL || (read_number(text, &x) && x > 0) ? NULL : no_number(text, "a finite number > 0");
}

const struct sweep_variable *sweep_set_twice(const struct sweep_product *product)
{
  const struct sweep_variable *all[SWEEP_GROUPS * SWEEP_VARIABLES];
  int count = 0;
  for (int g = 0; g < product->groups; g++)
    for (int i = 0; i < product->group[g].variables; i++) {
      const struct sweep_variable *v = &product->group[g].variable[i];
      for (int k = 0; k < count; k++)
        if (strcmp(all[k]->sets, v->sets) == 0)
          return v;
      all[count++] = v;
    }
  return NULL;
}

const struct sweep_variable *sweep_variable(const struct sweep *s, int i)
{
  for (int p = 0; p < s->products; p++)
    for (int g = 0; g < s->product[p].groups; g++) {
      const struct sweep_group *group = &s->product[p].group[g];
      if (i < group->variables)
        return &group->variable[i];
      i -= group->variables;
    }
  return NULL;
}

long sweep_product_points(const struct sweep_product *product)
{
  long points = 1;
  for (int g = 0; g < product->groups; g++)
    points *= product->group[g].count;
  return points;
}

long sweep_points(const struct sweep *s)
{
  long points = 0;
  for (int p = 0; p < s->products; p++)
    points += sweep_product_points(&s->product[p]);
  return points;
}

void sweep_free(struct sweep *s)
{
  const struct sweep_variable *v;
  for (int i = 0; (v = sweep_variable(s, i)); i++) {
    free(v->texts);
  }
  free(s->product);
  *s = (struct sweep){ .products = 0 };
}

/* A move that is going on */
struct move {
  struct swept *swept;
  struct point *point;
  sweep_formula *value;
  void *context;
};

/* Sets a parameter, m1 to alpha or v0; text: as it was written, or NULL. */
static void set(const struct move *m, const char *parameter, double x, const char *text, const char *name)
{
  struct swept *s = m->swept;
  char *written = s->written[crawler_place(parameter)];
  if (!text)
    number_text(written, x, 0);
  const char *wrong = point_set(m->point, parameter, text ? text : written);
  if (wrong && s->why[0] == '\0')
    snprintf(s->why, sizeof s->why, "%s: %s", name, wrong);
}

static double rounded(double x, long digits)
{
  char text[DIGITS_TEXT];
  number_text(text, x, digits);
  read_number(text, &x);
  return x;
}

static double end_value(const struct move *m, const struct sweep_end *end)
{
  return end->is_formula ? m->value(m->context, &end->formula) : end->number;
}

static double range_value(const struct move *m, const struct sweep_variable *v, long i)
{
  double from = end_value(m, &v->from), to = end_value(m, &v->to);
  long steps = v->count - 1;
  if (i == 0)
    return from;
  if (i == steps)
    return to;
  /* decimal: 0.07 for a reader, and the same on every machine, whose logarithms may differ in the last digit */
  if (v->is_log)
    return rounded(exp(log(from) + (double)i * ((log(to) - log(from)) / (double)steps)), 12);
  double x = from + (double)i * ((to - from) / (double)steps);
  return v->from.is_formula || v->to.is_formula ? x : rounded(x, 15);
}

static void set_variable(const struct move *m, const struct sweep_variable *v, long i)
{
  long place = v->count == 1 ? 0 : i;
  const char *text = v->texts ? v->texts[place] : NULL;
  double x = 0;
  if (!text)
    x = range_value(m, v, place);
  else if (v->target != TARGET_GAIT && v->target != TARGET_LABEL)
    read_number(text, &x);
  switch (v->target) {
  case TARGET_NUMBER:
  case TARGET_V0: set(m, v->name, x, text, v->name); break;
  case TARGET_GAIT: point_set(m->point, "gait", text); break; /* it was made when the sweep was read */
  case TARGET_LABEL: m->swept->label[v->place] = text; break;
  case TARGET_F1_OVER_F2: m->swept->F1_over_F2 = x; break;
  case TARGET_M1_OVER_M2: m->swept->m1_over_m2 = x; break;
  case TARGET_FROUDE: m->swept->froude = x; break;
  }
}

/* What follows from other parameters follows from them as they are now, and the Froude number is last. */
static void settle(const struct move *m)
{
  const struct swept *s = m->swept;
  const struct scallop_crawler *c = &m->point->crawler;
  point_complete(m->point);
  if (!isnan(s->F1_over_F2))
    set(m, "F1", s->F1_over_F2 * c->F2, NULL, "F1_over_F2");
  if (!isnan(s->m1_over_m2))
    set(m, "m1", s->m1_over_m2 * c->m2, NULL, "m1_over_m2");
  if (!isnan(s->froude))
    set(m, "T", sqrt((c->m1 + c->m2) / (c->F1 + c->F2) * c->L / s->froude), NULL, "froude");
}

void sweep_move(struct swept *swept, struct point *point, const struct sweep_product *product, const long *index,
                sweep_formula *value, void *context)
{
  const struct move m = { swept, point, value, context };
  memset(swept->label, 0, sizeof swept->label);
  swept->F1_over_F2 = swept->m1_over_m2 = swept->froude = NAN;
  swept->why[0] = '\0';
  for (int g = 0; g < product->groups; g++) {
    for (int v = 0; v < product->group[g].variables; v++)
      set_variable(&m, &product->group[g].variable[v], index[g]);
    bool was_outside = swept->why[0] != '\0';
    settle(&m);
    if (!was_outside && g < product->groups - 1) /* what is set further in may bring it back */
      swept->why[0] = '\0';
  }
}

bool sweep_next(const struct sweep_product *product, long index[SWEEP_GROUPS])
{
  int g = product->groups - 1;
  while (g >= 0 && ++index[g] == product->group[g].count)
    index[g--] = 0;
  return g >= 0;
}
