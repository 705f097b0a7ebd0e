#include "compare/points/sweep.h"

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
} others[] = {
  { "gait", "gait", TARGET_GAIT },           { "phase", "phase", TARGET_PHASE },        { "v0", "v0", TARGET_V0 },
  { "F1_over_F2", "F1", TARGET_F1_OVER_F2 }, { "m1_over_m2", "m1", TARGET_M1_OVER_M2 }, { "froude", "T", TARGET_FROUDE }
};

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
  if (v->target <= TARGET_V0)
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

static long product_points(const struct sweep_product *product)
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
    points += product_points(&s->product[p]);
  return points;
}

void sweep_variable_free(struct sweep_variable *v)
{
  free(v->texts);
  free(v->kept);
}

void sweep_free(struct sweep *s)
{
  for (int p = 0; p < s->products; p++)
    for (int g = 0; g < s->product[p].groups; g++)
      for (int i = 0; i < s->product[p].group[g].variables; i++)
        sweep_variable_free(&s->product[p].group[g].variable[i]);
  free(s->product);
  *s = (struct sweep){ .products = 0 };
}

void sweep_place_set(struct sweep_place *p, const struct point *point)
{
  memset(p->label, 0, sizeof p->label);
  p->point = *point;
  p->ratio[F1_OVER_F2] = p->ratio[M1_OVER_M2] = p->ratio[FROUDE] = NAN;
  p->carried = NULL;
  p->why[0] = '\0';
  p->is_unread = false;
}

void sweep_place_copy(struct sweep_place *copy, const struct sweep_place *p)
{
  *copy = *p;
  for (int i = 0; i <= CRAWLER_NUMBERS; i++) {
    const char **written = i < CRAWLER_NUMBERS ? &copy->point.written[i] : &copy->point.written_v0;
    if (*written == p->written[i])
      *written = copy->written[i];
  }
}

/* A move that is going on */
struct move {
  struct sweep_cursor *cursor;
  struct sweep_place *place;
  sweep_formula *value;
  void *context;
};

static void note(const struct move *m, const char *name, const char *wrong)
{
  if (wrong && m->place->why[0] == '\0')
    snprintf(m->place->why, POINT_STATUS, "%s: %s", name, wrong);
}

/* Sets a parameter, m1 to alpha or v0, to a double; is_written: what was written of it stays. */
static void set(const struct move *m, const char *parameter, double x, bool is_written, const char *name)
{
  int place = crawler_place(parameter);
  char *written = m->place->written[place];
  struct point *point = &m->place->point;
  if (!is_written)
    number_text(written, x, 0);
  bool reads_back = x == 0 || isnormal(x); /* else its text is refused, and it is */
  note(m, name, reads_back ? point_set_double(point, place, x, written) : point_set_number(point, place, written));
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

static bool has_formula(const struct sweep_variable *v) { return v->from.is_formula || v->to.is_formula; }

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
  return has_formula(v) ? x : rounded(x, 15);
}

static bool is_ratio(const struct sweep_variable *v)
{
  return v->target >= TARGET_F1_OVER_F2 && v->target <= TARGET_FROUDE;
}

/* Where a ratio or the Froude number is set */
static double *ratio_of(const struct move *m, const struct sweep_variable *v)
{
  return &m->place->ratio[v->target - TARGET_F1_OVER_F2];
}

static void set_number(const struct move *m, const struct sweep_variable *v, double x, bool is_written)
{
  if (is_ratio(v))
    *ratio_of(m, v) = x;
  else
    set(m, v->name, x, is_written, v->name);
}

/* Value i of a range in *known; stays: that is there already. */
static void set_range(const struct move *m, const struct sweep_variable *v, long i, double *known, bool stays)
{
  stays = stays && !has_formula(v);
  if (!stays)
    *known = range_value(m, v, i);
  set_number(m, v, *known, stays);
}

/* A value of a list, which was found good when the sweep was read, if not at this point */
static void set_text(const struct move *m, const struct sweep_variable *v, const char *text)
{
  if (v->target == TARGET_LABEL)
    m->place->label[v->place] = text;
  else if (is_ratio(v))
    read_number(text, ratio_of(m, v));
  else
    note(m, v->name, point_set(&m->place->point, v->name, text));
}

static void set_group(const struct move *m, const struct sweep_product *product, int g, long i)
{
  struct sweep_cursor *c = m->cursor;
  bool stays = c->product == product && c->index[g] == i;
  for (int k = 0; k < product->group[g].variables; k++) {
    const struct sweep_variable *v = &product->group[g].variable[k];
    long place = v->count == 1 ? 0 : i;
    if (v->texts)
      set_text(m, v, v->texts[place]);
    else
      set_range(m, v, place, &c->value[g][k], stays);
  }
  c->index[g] = i;
}

/* What follows from other parameters follows from them as they are now, and the Froude number is last. */
static void settle(const struct move *m)
{
  const struct sweep_place *p = m->place;
  const struct scallop_crawler *c = &p->point.crawler;
  point_complete(&m->place->point);
  if (!isnan(p->ratio[F1_OVER_F2]))
    set(m, "F1", p->ratio[F1_OVER_F2] * c->F2, false, "F1_over_F2");
  if (!isnan(p->ratio[M1_OVER_M2]))
    set(m, "m1", p->ratio[M1_OVER_M2] * c->m2, false, "m1_over_m2");
  if (!isnan(p->ratio[FROUDE]))
    set(m, "T", sqrt((c->m1 + c->m2) / (c->F1 + c->F2) * c->L / p->ratio[FROUDE]), false, "froude");
}

void sweep_set(struct sweep_place *place, const struct sweep_variable *v, double value)
{
  const struct move m = { .place = place };
  set_number(&m, v, value, false);
  settle(&m);
}

void sweep_move(struct sweep_cursor *cursor, struct sweep_place *place, const struct point *base,
                const struct sweep_product *product, const long *index, sweep_formula *value, void *context)
{
  const struct move m = { cursor, place, value, context };
  sweep_place_set(place, base);
  for (int g = 0; g < product->groups; g++) {
    set_group(&m, product, g, index[g]);
    bool was_outside = place->why[0] != '\0';
    settle(&m);
    if (!was_outside && g < product->groups - 1) /* what is set further in may bring it back */
      place->why[0] = '\0';
  }
  const int last = product->groups - 1;
  place->ends_group = last >= 0 && index[last] == product->group[last].count - 1;
  cursor->product = product;
}

bool sweep_next(const struct sweep_product *product, long index[SWEEP_GROUPS])
{
  int g = product->groups - 1;
  while (g >= 0 && ++index[g] == product->group[g].count)
    index[g--] = 0;
  return g >= 0;
}
