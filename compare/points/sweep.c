#include "compare/points/sweep.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text/values.h"

bool sweep_variable_of_name(struct sweep_variable *v, const char *name)
{
  const struct parameter *p = parameter_named(name);
  if (p)
    *v = (struct sweep_variable){
      .name = p->name, .sets = p->sets, .target = p->target, .place = crawler_place(p->sets)
    };
  return p != NULL;
}

const char *sweep_wrong(const struct sweep_variable *v, const struct point *point, const char *text)
{
  struct point probe = *point;
  return v->target == TARGET_LABEL ? NULL : point_set(&probe, v->name, text);
}

const struct sweep_variable *sweep_set_twice(const struct sweep_product *product)
{
  const struct sweep all = { 1, (struct sweep_product *)product };
  const struct sweep_variable *v;
  for (int i = 0; (v = sweep_variable(&all, i)); i++)
    for (int k = 0; k < i; k++)
      if (strcmp(sweep_variable(&all, k)->sets, v->sets) == 0)
        return v;
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

static long points_of(const struct sweep_product *p)
{
  long points = 1;
  for (int g = 0; g < p->groups; g++)
    points *= p->group[g].count;
  return points;
}

long sweep_points(const struct sweep *s)
{
  long points = s->products == 0;
  for (int p = 0; p < s->products; p++)
    points += points_of(&s->product[p]);
  return points;
}

void sweep_free(struct sweep *s)
{
  const struct sweep_variable *v;
  for (int i = 0; (v = sweep_variable(s, i)); i++)
    free(v->texts);
  free(s->product);
  *s = (struct sweep){ .products = 0 };
}

void sweep_place_set(struct sweep_place *p, const struct point *point)
{
  memset(p->label, 0, sizeof p->label);
  p->point = *point;
  p->carried = NULL;
  p->why[0] = '\0';
  p->is_unread = false;
}

void sweep_place_copy(struct sweep_place *copy, const struct sweep_place *p)
{
  *copy = *p;
  for (int i = 0; i < POINT_NUMBERS; i++)
    if (p->point.written[i] == p->written[i])
      copy->point.written[i] = copy->written[i];
}

static void note(struct sweep_place *p, const char *name, const char *wrong)
{
  if (wrong && p->why[0] == '\0')
    snprintf(p->why, POINT_STATUS, "%s: %s", name, wrong);
}

struct sweep_sobol sweep_sobol;

/* Returns output n of splitmix64 (Steele, Lea and Flood 2014) for a seed, scaled to [0, 1). */
static double random_number(uint64_t seed, uint64_t n)
{
  uint64_t z = seed + (n + 1) * UINT64_C(0x9e3779b97f4a7c15);
  z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
  return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/* Draws sample i of a group. A Sobol sequence continues from the last sample, or restarts. */
static void draw(struct sweep_walk *w, const struct sweep_group *g, long i)
{
  const bool is_sobol = g->sampling == SAMPLING_SOBOL;
  if (w->sampled == g && w->drawn == i)
    return;
  for (int k = 0; k < g->variables && !is_sobol; k++)
    w->sample[k] = random_number(g->seed, (uint64_t)i * (uint64_t)g->variables + (uint64_t)k);
  if (is_sobol && (w->sampled != g || w->drawn > i)) {
    sweep_walk_end(w);
    w->generator = sweep_sobol.begin(g->variables);
    w->drawn = -1;
  }
  for (; is_sobol && w->generator && w->drawn < i; w->drawn++)
    sweep_sobol.next(w->generator, w->sample);
  w->sampled = g;
  w->drawn = i;
}

void sweep_walk_end(struct sweep_walk *w)
{
  if (w->generator)
    sweep_sobol.end(w->generator);
  w->generator = NULL;
}

/* Returns value i of a range with known ends. Inner values are rounded to decimals: 0.07 is readable, and equal on
 * machines with different last digits of logarithms. */
static double range_value(struct sweep_walk *w, const struct sweep_group *g, int variable, long i, double from,
                          double to)
{
  const struct sweep_variable *v = &g->variable[variable];
  if (v->is_sampled)
    draw(w, g, i);
  const double steps = v->is_sampled ? 1 : (double)(v->count - 1), k = v->is_sampled ? w->sample[variable] : (double)i;
  const bool is_end = k == 0 || k == steps, is_formula = v->from.is_formula || v->to.is_formula;
  char text[DIGITS_TEXT];
  double x = k == 0       ? from
             : k == steps ? to
             : v->is_log  ? exp(log(from) + k * ((log(to) - log(from)) / steps))
                          : from + k * ((to - from) / steps);
  if (is_end || (is_formula && !v->is_log))
    return x;
  number_text(text, x, v->is_log ? 12 : 15);
  (void)read_number(text, &x);
  return x;
}

double sweep_number(struct sweep_walk *w, const struct sweep_group *g, int variable, long i)
{
  const struct sweep_variable *v = &g->variable[variable];
  const long k = v->count == 1 && !v->is_sampled ? 0 : i;
  double x = NAN;
  if (!v->texts)
    return range_value(w, g, variable, k, v->from.number, v->to.number);
  (void)read_number(v->texts[k], &x);
  return x;
}

/* Sets the parameters that follow from ratios and the other parameters; T from the Froude number last. */
static void set_dependent(struct sweep_place *p)
{
  const struct scallop_crawler *c = &p->point.crawler;
  const double *ratio = p->point.ratio;
  point_complete(&p->point);
  for (int i = 0; i < RATIOS; i++) {
    if (ratio[i] == 0)
      continue;
    const struct parameter *of = &point_parameters[PLACE_OF_RATIOS + i];
    const int place = crawler_place(of->sets);
    double x = i == F1_OVER_F2   ? ratio[i] * c->F2
               : i == M1_OVER_M2 ? ratio[i] * c->m2
               : i == MU1        ? ratio[i] * c->m1 * p->point.gravity
               : i == MU2        ? ratio[i] * c->m2 * p->point.gravity
                                 : sqrt((c->m1 + c->m2) / (c->F1 + c->F2) * c->L / ratio[i]);
    number_text(p->written[place], x, i == MU1 || i == MU2 ? 15 : 0); /* 0.4 times 9.81 is 3.924 */
    note(p, of->name, point_set_number(&p->point, place, p->written[place]));
  }
}

void sweep_set(struct sweep_place *p, const struct sweep_variable *v, double value)
{
  number_text(p->written[v->place], value, 0);
  note(p, v->name, point_set(&p->point, v->name, p->written[v->place]));
  set_dependent(p);
}

/* Sets place[g + 1]: place[g] and value i of group g. */
static void step(struct sweep_walk *w, int g, long i, sweep_formula *value, void *context)
{
  struct sweep_place *p = &w->place[g + 1];
  const struct sweep_group *group = &w->product->group[g];
  const bool is_last = g == w->product->groups - 1;
  sweep_place_copy(p, &w->place[g]);
  for (const struct sweep_variable *v = group->variable; v < group->variable + group->variables; v++) {
    const long k = v->count == 1 && !v->is_sampled ? 0 : i;
    const char *text = v->texts ? v->texts[k] : p->written[v->place];
    if (!v->texts) {
      double from = v->from.is_formula ? value(context, p, &v->from.formula) : v->from.number;
      double to = v->to.is_formula ? value(context, p, &v->to.formula) : v->to.number;
      number_text(p->written[v->place], range_value(w, group, (int)(v - group->variable), k, from, to), 0);
    }
    /* a value of a list was checked at the base point, not at this one */
    if (v->target == TARGET_LABEL)
      p->label[v->place] = text;
    else
      note(p, v->name, point_set(&p->point, v->name, text));
  }
  bool was_outside = p->why[0] != '\0';
  set_dependent(p);
  if (!was_outside && !is_last) /* a faster group may make it valid */
    p->why[0] = '\0';
  p->ends_group = is_last && i == group->count - 1;
}

/* Finds the product of the point and sets place[0]. */
static void find_product(struct sweep_walk *w, const struct sweep *s, const struct point *about, long number)
{
  const struct sweep_product *p = s->product;
  long first = 0;
  for (long points; number - first >= (points = points_of(p)); p++)
    first += points;
  if (p == w->product)
    return;
  w->product = p;
  w->first = first;
  memset(w->value, -1, sizeof w->value);
  sweep_place_set(&w->place[0], about);
}

const struct sweep_place *sweep_point(struct sweep_walk *w, const struct sweep *s, const struct point *about,
                                      long number, sweep_formula *value, void *context)
{
  if (s->products == 0)
    return sweep_place_set(&w->place[0], about), &w->place[0];
  find_product(w, s, about, number);
  long of_group[SWEEP_GROUPS], rest = number - w->first;
  const int groups = w->product->groups;
  bool as_it_was = true;
  for (int g = groups; g-- > 0; rest /= w->product->group[g].count)
    of_group[g] = rest % w->product->group[g].count;
  for (int g = 0; g < groups; g++) {
    as_it_was = as_it_was && w->value[g] == of_group[g];
    if (as_it_was)
      continue;
    w->value[g] = of_group[g];
    step(w, g, of_group[g], value, context);
  }
  return &w->place[groups];
}
