/* vary = ( { F1 = [2.0, 4.0]; }, { T = { from = 0.1; to = 1.0; count = 10; spacing = "log"; }; } ): every combination
 * of the groups, the first slowest; what stands in one group goes on together. A list of such lists: one after the
 * other. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/scenes/parts.h"

/* Given on the command line, which then holds throughout */
static bool is_overridden(const struct reading *r, const struct sweep_variable *v)
{
  const struct point *given = &r->options->request.point;
  int place = crawler_place(v->sets);
  return v->target != TARGET_LABEL
         && (place < CRAWLER_NUMBERS ? given->written[place] != NULL : v->target == TARGET_GAIT && given->has_gait);
}

static bool read_list(const struct reading *r, const config_setting_t *at, struct sweep_variable *v)
{
  v->count = element_count(at);
  if (v->count < 1)
    return refuse_at(r->config, at, "%s has no values", v->name);
  v->texts = calloc((size_t)v->count, sizeof *v->texts);
  if (!v->texts)
    return refuse_at(r->config, at, "out of memory");
  for (int i = 0; i < v->count; i++) {
    const char *text = text_of(r->config, element_at(at, i));
    const char *wrong = "it takes values, or a range: { from = 0.1; to = 10.0; count = 21; spacing = \"log\"; }";
    if (text && v->target == TARGET_GAIT)
      text = gait_beside(r->config, text);
    if (text)
      wrong = v->target == TARGET_LABEL && !is_ascii(text) ? "a label is of printable ASCII"
                                                           : sweep_wrong(v, &r->scene->base, text);
    if (wrong)
      return refuse_at(r->config, element_at(at, i), "%s: %s", v->name, wrong);
    v->texts[i] = text;
  }
  return true;
}

static bool read_range(const struct reading *r, const config_setting_t *at, struct sweep_variable *v)
{
  static const char *const spacings[] = { "linear", "log", NULL };
  struct values {
    long count;
    int spacing;
  } values = { 0, 0 };
  static const struct member members[] = { OTHER("from"),
                                           OTHER("to"),
                                           MEMBER(COUNT, "count", values, count, .low = 1, .high = SWEEP_RANGE),
                                           MEMBER(WORD, "spacing", values, spacing, .words = spacings),
                                           { .name = NULL } };
  const config_setting_t *ends[] = { config_setting_get_member(at, "from"), config_setting_get_member(at, "to") };
  struct sweep_end *const range[] = { &v->from, &v->to };
  if (!read_members(r->config, at, members, &values, "a range", NULL))
    return false;
  if (v->target == TARGET_GAIT || v->target == TARGET_LABEL)
    return refuse_at(r->config, at, "%s takes texts in quotes, no range", v->name);
  if (!ends[0] || !ends[1] || values.count == 0)
    return refuse_at(r->config, at, "the range of %s needs from, to and count", v->name);
  v->count = values.count;
  v->is_log = values.spacing == 1;
  for (int i = 0; i < 2; i++) {
    if (!read_end(r, ends[i], range[i], &v->needs_onset))
      return false;
    const char *wrong = range[i]->is_formula ? NULL : sweep_end_wrong(v, &r->scene->base, text_of(r->config, ends[i]));
    if (wrong)
      return refuse_at(r->config, ends[i], "%s: %s", v->name, wrong);
  }
  return true;
}

static bool add_variable(const struct reading *r, const config_setting_t *at, struct sweep_group *g,
                         struct sweep_variable v)
{
  bool is_range = config_setting_is_group(at);
  if (is_overridden(r, &v))
    return true;
  if (g->variables == SWEEP_VARIABLES)
    return refuse_at(r->config, at, "more than %d variables go together here", SWEEP_VARIABLES);
  struct sweep_variable *kept = &g->variable[g->variables++];
  *kept = v;
  if (!(is_range ? read_range(r, at, kept) : read_list(r, at, kept)))
    return false;
  if (kept->count > 1 && g->count > 1 && kept->count != g->count)
    return refuse_at(r->config, at, "%s has %ld values, but those before it in this group %ld: they go on together",
                     v.name, kept->count, g->count);
  if (kept->count > g->count)
    g->count = kept->count;
  r->scene->varies_v0 |= v.target == TARGET_V0;
  return true;
}

static bool add_label(const struct reading *r, const config_setting_t *at, struct sweep_group *g)
{
  struct quantities *all = &r->scene->asked.quantities;
  const char *name = config_setting_name(at);
  int place = 0;
  while (place < all->labels && strcmp(all->label[place], name) != 0)
    place++;
  if (strlen(name) >= QUANTITY_NAME)
    return refuse_at(r->config, at, "a label has a name of fewer than %d characters", QUANTITY_NAME);
  if (place == QUANTITY_LABELS)
    return refuse_at(r->config, at, "more than %d labels", QUANTITY_LABELS);
  if (place == all->labels && quantity_named(all, name) >= 0)
    return refuse_at(r->config, at, "a label cannot be called %s, which is a quantity", name);
  all->label[place] = name;
  all->labels += place == all->labels;
  return add_variable(r, at, g,
                      (struct sweep_variable){ .target = TARGET_LABEL, .place = place, .name = name, .sets = name });
}

static bool add_labels_of(const struct reading *r, const config_setting_t *at, struct sweep_group *g)
{
  bool good = config_setting_is_group(at)
              || refuse_at(r->config, at, "label is a group of texts: { panel = [\"A\", \"B\"]; }");
  for (int k = 0; good && k < config_setting_length(at); k++)
    good = add_label(r, member_at(at, k), g);
  return good;
}

static const char meant[] = "vary is a list of groups: ( { F1 = [2.0, 4.0]; }, { T = [0.1, 1.0]; } )";

static bool read_group(const struct reading *r, const config_setting_t *group, struct sweep_group *g)
{
  static const struct member members[] = { OTHER("m1"),    OTHER("m2"),         OTHER("F1"),         OTHER("F2"),
                                           OTHER("L"),     OTHER("T"),          OTHER("alpha"),      OTHER("gait"),
                                           OTHER("v0"),    OTHER("F1_over_F2"), OTHER("m1_over_m2"), OTHER("froude"),
                                           OTHER("label"), { .name = NULL } };
  g->count = 1;
  if (!config_setting_is_group(group))
    return refuse_at(r->config, group, "%s", meant);
  if (!read_members(r->config, group, members, g, "a group of what varies", NULL))
    return false;
  for (int i = 0; i < config_setting_length(group); i++) {
    const config_setting_t *at = member_at(group, i);
    struct sweep_variable v;
    if (!(sweep_variable_of_name(&v, config_setting_name(at)) ? add_variable(r, at, g, v) : add_labels_of(r, at, g)))
      return false;
  }
  return true;
}

static bool read_product(const struct reading *r, const config_setting_t *at)
{
  struct sweep_product *product = &r->scene->sweep.product[r->scene->sweep.products++];
  int groups = element_count(at);
  double points = 1;
  if (groups > SWEEP_GROUPS)
    return refuse_at(r->config, at, "%d groups: %d at most", groups, SWEEP_GROUPS);
  for (int i = 0; i < groups; i++) {
    struct sweep_group *g = &product->group[product->groups++];
    if (!read_group(r, element_at(at, i), g))
      return false;
    points *= (double)g->count;
    product->groups -= g->variables == 0; /* all of it is given on the command line */
  }
  const struct sweep_variable *twice = sweep_set_twice(product);
  if (twice)
    return refuse_at(r->config, at, "%s is set twice here", twice->name);
  return points <= SWEEP_POINTS || refuse_at(r->config, at, "%g points: more than %g", points, SWEEP_POINTS);
}

bool read_vary(const struct reading *r, const config_setting_t *vary)
{
  struct sweep *sweep = &r->scene->sweep;
  bool one_after_the_other = vary && element_count(vary) > 0 && config_setting_is_list(element_at(vary, 0));
  int products = one_after_the_other ? element_count(vary) : 1;
  if (products > SWEEP_PRODUCTS)
    return refuse_at(r->config, vary, "%d products: %d at most", products, SWEEP_PRODUCTS);
  sweep->product = calloc((size_t)products, sizeof *sweep->product);
  if (!sweep->product)
    return refuse_at(r->config, vary, "out of memory");
  sweep->products = vary ? 0 : 1;
  while (sweep->products < products)
    if (!read_product(r, one_after_the_other ? element_at(vary, sweep->products) : vary))
      return false;
  return true;
}
