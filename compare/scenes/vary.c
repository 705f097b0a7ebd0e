/* vary = ( { F1 = [2.0, 4.0]; }, { T = { from = 0.1; to = 1.0; count = 10; spacing = "log"; }; } ): every combination of the groups, the
 * first slowest; what stands in one group goes on together. A list of such lists: one after the other. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/scenes/parts.h"

static const struct {
  const char *name;
  enum scene_target target;
} others[] = { { "gait", TARGET_GAIT },
               { "v0", TARGET_V0 },
               { "F1_over_F2", TARGET_F1_OVER_F2 },
               { "m1_over_m2", TARGET_M1_OVER_M2 },
               { "froude", TARGET_FROUDE } };
enum { OTHERS = sizeof others / sizeof *others };

static const char *const group_keys[] = { "m1",   "m2", "F1",         "F2",         "L",      "T",     "alpha",
                                          "gait", "v0", "F1_over_F2", "m1_over_m2", "froude", "label", NULL };

/* ---- which variable ---- */

static bool target_of(struct scene_variable *v, const char *name)
{
  v->name = name;
  v->place = crawler_place(name);
  if (v->place < CRAWLER_NUMBERS)
    return true; /* TARGET_NUMBER is 0 */
  for (int i = 0; i < OTHERS; i++)
    if (strcmp(name, others[i].name) == 0) {
      v->target = others[i].target;
      return true;
    }
  return false;
}

/* The numbers of the crawler that a variable sets, as bits */
static unsigned sets(const struct scene_variable *v)
{
  switch (v->target) {
  case TARGET_GAIT: return 1U << CRAWLER_NUMBERS;
  case TARGET_V0: return 2U << CRAWLER_NUMBERS;
  case TARGET_LABEL: return 4U << (CRAWLER_NUMBERS + v->place);
  default: return 1U << crawler_place(scene_variable_sets(v));
  }
}

/* Given on the command line, which then holds throughout */
static bool is_overridden(const struct reading *r, const struct scene_variable *v)
{
  unsigned given = r->options->point.has_gait ? 1U << CRAWLER_NUMBERS : 0;
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    given |= r->options->point.written[i] ? 1U << i : 0;
  return (sets(v) & given) != 0;
}

/* ---- its values ---- */

/* NULL, or what is wrong with a number of that variable. text: as it was written, or NULL. */
static const char *check_number(const struct reading *r, const struct scene_variable *v, double x, const char *text)
{
  struct options probe = r->scene->base;
  char written[NUMBER_TEXT];
  if (v->target == TARGET_NUMBER) {
    number_text(written, x, 0);
    return point_set_number(&probe.point, v->place, text ? text : written);
  }
  if (!isfinite(x))
    return "a finite number is wanted";
  return v->target == TARGET_V0 || x > 0 ? NULL : "a number > 0 is wanted";
}

static bool is_ascii(const char *text)
{
  while (*text >= ' ' && *text < 0x7f)
    text++;
  return *text == '\0';
}

static bool read_list(const struct reading *r, const config_setting_t *at, struct scene_variable *v)
{
  bool several = is_sequence(at), is_words = v->target == TARGET_GAIT || v->target == TARGET_LABEL;
  v->count = several ? config_setting_length(at) : 1;
  if (v->count < 1)
    return refuse_at(r, at, "%s has no values", v->name);
  v->numbers = calloc((size_t)v->count, sizeof *v->numbers);
  v->texts = calloc((size_t)v->count, sizeof *v->texts);
  if (!v->numbers || !v->texts)
    return refuse_at(r, at, "out of memory");
  for (long i = 0; i < v->count; i++) {
    const config_setting_t *element = several ? config_setting_get_elem(at, (unsigned)i) : at;
    if (is_words) {
      v->texts[i] = config_setting_get_string(element);
      if (!v->texts[i])
        return refuse_at(r, element, "%s takes texts in quotes", v->name);
      if (v->target == TARGET_LABEL && !is_ascii(v->texts[i]))
        return refuse_at(r, element, "a label is of printable ASCII");
      if (v->target == TARGET_LABEL)
        continue;
      struct options probe = r->scene->base;
      v->texts[i] = gait_beside(r, v->texts[i]);
      const char *wrong = v->texts[i] ? point_set(&probe.point, "gait", v->texts[i]) : "out of memory";
      if (wrong)
        return refuse_at(r, element, "gait: %s", wrong);
      continue;
    }
    if (!is_number(element, &v->numbers[i], &v->texts[i]) && !(v->target == TARGET_NUMBER && v->texts[i]))
      return refuse_at(r, element, "%s takes numbers, or a range: { from = 0.1; to = 10.0; count = 21; spacing = \"log\"; }",
                       v->name);
    const char *wrong = check_number(r, v, v->numbers[i], v->texts[i]);
    if (wrong)
      return refuse_at(r, element, "%s: %s", v->name, wrong);
  }
  return true;
}

bool check_end(const struct reading *r, const config_setting_t *at, const struct scene_end *end, bool *onset)
{
  int places[ARITHMETIC_STEPS], count = end->is_formula ? arithmetic_places(&end->formula, places) : 0;
  for (int i = 0; i < count; i++) {
    const struct quantity *q = &r->scene->quantities.item[places[i]];
    *onset |= q->kind == QUANTITY_ONSET;
    if (q->kind != QUANTITY_NUMBER && q->kind != QUANTITY_ONSET && q->kind != QUANTITY_FROUDE
        && q->kind != QUANTITY_F1_OVER_F2 && q->kind != QUANTITY_M1_OVER_M2)
      return refuse_at(r, at,
                       "%s is a formula of m1 m2 F1 F2 L T alpha F1_over_F2 m1_over_m2 froude and sticking_onset, not of %s",
                       config_setting_name(at), q->name);
  }
  return true;
}

static bool read_range(const struct reading *r, const config_setting_t *at, struct scene_variable *v)
{
  static const char *const keys[] = { "from", "to", "count", "spacing", NULL };
  const config_setting_t *ends[] = { config_setting_get_member(at, "from"), config_setting_get_member(at, "to") };
  struct scene_end *const range[] = { &v->from, &v->to };
  const char *spacing = "linear";
  if (!keys_known(r, at, keys, "a range"))
    return false;
  if (v->target == TARGET_GAIT || v->target == TARGET_LABEL)
    return refuse_at(r, at, "%s takes texts in quotes, no range", v->name);
  if (!ends[0] || !ends[1] || !config_setting_get_member(at, "count"))
    return refuse_at(r, at, "the range of %s needs from, to and count", v->name);
  if (!read_member_count(r, at, "count", 1, SCENE_RAMP, &v->count) || !read_member_text(r, at, "spacing", &spacing))
    return false;
  v->is_log = strcmp(spacing, "log") == 0;
  if (!v->is_log && strcmp(spacing, "linear") != 0)
    return refuse_at(r, at, "spacing is \"linear\" or \"log\"");
  for (int i = 0; i < 2; i++) {
    if (!read_end(r, ends[i], range[i]) || !check_end(r, ends[i], range[i], &v->needs_onset))
      return false;
    const char *wrong = range[i]->is_formula ? NULL : check_number(r, v, range[i]->number, NULL);
    if (wrong)
      return refuse_at(r, ends[i], "%s: %s", v->name, wrong);
    if (v->is_log && !range[i]->is_formula && !(range[i]->number > 0))
      return refuse_at(r, ends[i], "%s: an end of a range with log spacing is > 0", v->name);
  }
  return true;
}

/* ---- a group ---- */

static bool add_variable(const struct reading *r, const config_setting_t *at, struct scene_group *g, struct scene_variable v)
{
  bool is_range = config_setting_is_group(at);
  if (is_overridden(r, &v))
    return true;
  if (g->variables == SCENE_VARIABLES)
    return refuse_at(r, at, "more than %d variables go together here", SCENE_VARIABLES);
  struct scene_variable *kept = &g->variable[g->variables++];
  *kept = v;
  if (!(is_range ? read_range(r, at, kept) : read_list(r, at, kept)))
    return false;
  if (kept->count > 1 && g->count > 1 && kept->count != g->count)
    return refuse_at(r, at, "%s has %ld values, but those before it in this group %ld: they go on together", v.name,
                     kept->count, g->count);
  if (kept->count > g->count)
    g->count = kept->count;
  r->scene->varies_v0 |= v.target == TARGET_V0;
  return true;
}

static bool add_label(const struct reading *r, const config_setting_t *at, struct scene_group *g)
{
  struct quantities *all = &r->scene->quantities;
  const char *name = config_setting_name(at);
  int place = 0;
  while (place < all->labels && strcmp(all->label[place], name) != 0)
    place++;
  if (strlen(name) >= QUANTITY_NAME)
    return refuse_at(r, at, "a label has a name of fewer than %d characters", QUANTITY_NAME);
  if (place == QUANTITY_LABELS)
    return refuse_at(r, at, "more than %d labels", QUANTITY_LABELS);
  if (place == all->labels && quantity_named(all, name) >= 0)
    return refuse_at(r, at, "a label cannot be called %s, which is a quantity", name);
  all->label[place] = name;
  all->labels += place == all->labels;
  return add_variable(r, at, g, (struct scene_variable){ .target = TARGET_LABEL, .place = place, .name = name });
}

static bool read_group(const struct reading *r, const config_setting_t *group, struct scene_group *g)
{
  g->count = 1;
  if (!config_setting_is_group(group))
    return refuse_at(r, group, "vary is a list of groups: ( { F1 = [2.0, 4.0]; }, { T = [0.1, 1.0]; } )");
  if (!keys_known(r, group, group_keys, "a group of what varies"))
    return false;
  for (int i = 0; i < config_setting_length(group); i++) {
    const config_setting_t *at = config_setting_get_elem(group, (unsigned)i);
    struct scene_variable v = { .target = TARGET_NUMBER };
    if (strcmp(config_setting_name(at), "label") == 0) {
      if (!config_setting_is_group(at))
        return refuse_at(r, at, "label is a group of texts: { panel = [\"A\", \"B\"]; }");
      for (int k = 0; k < config_setting_length(at); k++)
        if (!add_label(r, config_setting_get_elem(at, (unsigned)k), g))
          return false;
      continue;
    }
    if (!target_of(&v, config_setting_name(at)) || !add_variable(r, at, g, v))
      return false;
  }
  return true;
}

/* ---- products ---- */

static bool check_once(const struct reading *r, const config_setting_t *at, const struct scene_product *product)
{
  unsigned seen = 0;
  for (int g = 0; g < product->groups; g++)
    for (int v = 0; v < product->group[g].variables; v++) {
      unsigned bits = sets(&product->group[g].variable[v]);
      if (seen & bits)
        return refuse_at(r, at, "%s is set twice here", product->group[g].variable[v].name);
      seen |= bits;
    }
  return true;
}

/* The number of points fits a long with room to spare. */
static bool check_size(const struct reading *r, const config_setting_t *at, const struct scene_product *product)
{
  double points = 1;
  for (int g = 0; g < product->groups; g++)
    points *= (double)product->group[g].count;
  return points <= 1e15 || refuse_at(r, at, "%g points: more than 1e15", points);
}

static bool read_product(const struct reading *r, const config_setting_t *at)
{
  struct scene *s = r->scene;
  struct scene_product *product = &s->product[s->products++];
  int groups = config_setting_is_group(at) ? 1 : config_setting_length(at);
  if (groups > SCENE_GROUPS)
    return refuse_at(r, at, "%d groups: %d at most", groups, SCENE_GROUPS);
  for (int i = 0; i < groups; i++) {
    const config_setting_t *group = config_setting_is_group(at) ? at : config_setting_get_elem(at, (unsigned)i);
    if (!read_group(r, group, &product->group[product->groups++]))
      return false;
    if (product->group[product->groups - 1].variables == 0) /* all of it is given on the command line */
      product->groups--;
  }
  return check_once(r, at, product) && check_size(r, at, product);
}

bool read_vary(const struct reading *r, const config_setting_t *vary)
{
  bool one_after_the_other = vary && config_setting_is_list(vary) && config_setting_length(vary) > 0
                             && config_setting_is_list(config_setting_get_elem(vary, 0));
  int products = one_after_the_other ? config_setting_length(vary) : 1;
  if (products > SCENE_PRODUCTS)
    return refuse_at(r, vary, "%d products: %d at most", products, SCENE_PRODUCTS);
  r->scene->product = calloc((size_t)products, sizeof *r->scene->product);
  if (!r->scene->product)
    return refuse_at(r, vary, "out of memory");
  if (vary && !config_setting_is_group(vary) && !config_setting_is_list(vary))
    return refuse_at(r, vary, "vary is a list of groups: ( { F1 = [2.0, 4.0]; }, { T = [0.1, 1.0]; } )");
  if (!vary)
    r->scene->products = 1;
  for (int i = 0; vary && i < products; i++)
    if (!read_product(r, one_after_the_other ? config_setting_get_elem(vary, (unsigned)i) : vary))
      return false;
  return true;
}
