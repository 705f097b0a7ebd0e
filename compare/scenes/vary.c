/* Reading of vary = ( { F1 = [2.0, 4.0]; }, { T = { from = 0.01; to = 1.0; count = 21; spacing = "log"; }; } ): every
 * combination of the groups, the first slowest; variables of a group advance together. A list of such lists is a sweep
 * of several products. */
#include <stdlib.h>
#include <string.h>

#include "compare/answers/vary.h"
#include "compare/scenes/scene.h"

/* Returns true if the command line sets the parameter, as a constant. */
static bool is_overridden(const struct scene *s, const struct sweep_variable *v)
{
  const struct point *given = s->head.given;
  int place = crawler_place(v->sets);
  return v->target != TARGET_LABEL
         && (place < CRAWLER_NUMBERS ? given->written[place] != NULL : v->target == TARGET_GAIT && given->has_gait);
}

static const char *read_list(struct scene *s, const config_setting_t *at, const struct sweep_variable *v)
{
  const int count = element_count(at);
  const char **texts = calloc((size_t)count + 1, sizeof *texts), *wrong = texts ? NULL : "out of memory";
  if (count == 0)
    wrong = "it has no values";
  for (int i = 0; i < count && !wrong; i++) {
    const char *text = text_of(&s->config, element_at(at, i));
    if (!text)
      wrong = "it takes values, or a range: { from = 0.1; to = 10.0; count = 21; spacing = \"log\"; }";
    else if (v->target == TARGET_LABEL && !is_ascii(text))
      wrong = "a label is of printable ASCII";
    texts[i] = text && v->target == TARGET_GAIT ? gait_beside(&s->config, text) : text;
  }
  wrong = wrong ? wrong : vary_list(&s->request, *v, texts, count);
  free(texts);
  return wrong;
}

/* Reads a range. Returns NULL or the error; "": it has been printed. */
static const char *read_range(struct scene *s, const config_setting_t *at, const struct sweep_variable *v)
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
  if (!read_members(&s->config, at, members, &values, "a range"))
    return "";
  if (v->target == TARGET_GAIT || v->target == TARGET_LABEL)
    return "it takes texts in quotes, no range";
  const config_setting_t *from = config_setting_get_member(at, "from"), *to = config_setting_get_member(at, "to");
  const char *ends[] = { from ? text_of(&s->config, from) : NULL, to ? text_of(&s->config, to) : NULL };
  if (!ends[0] || !ends[1] || values.count == 0)
    return "its range needs from, to and count; an end is a number, or a formula in quotes";
  return vary_range(&s->request, *v, ends[0], ends[1], values.count, values.spacing == 1);
}

static bool add_variable(struct scene *s, const config_setting_t *at, const struct sweep_variable *v)
{
  if (is_overridden(s, v))
    return true;
  s->head.is_about_phase |= v->target == TARGET_V0;
  const char *wrong = (config_setting_is_group(at) ? read_range : read_list)(s, at, v);
  return !wrong || (*wrong && refuse_at(&s->config, at, "%s: %s", v->name, wrong));
}

static bool add_labels(struct scene *s, const config_setting_t *at)
{
  struct sweep_variable label;
  if (!config_setting_is_group(at))
    return refuse_at(&s->config, at, "label is a group of texts: { panel = [\"A\", \"B\"]; }");
  for (int k = 0; k < config_setting_length(at); k++) {
    const config_setting_t *one = member_at(at, k);
    const char *wrong = vary_label(&s->request, config_setting_name(one), &label);
    if (wrong)
      return refuse_at(&s->config, one, "%s", wrong);
    if (!add_variable(s, one, &label))
      return false;
  }
  return true;
}

static bool read_group(struct scene *s, const config_setting_t *group)
{
  static const struct member members[] = { OTHER("m1"),     OTHER("m2"),         OTHER("F1"),         OTHER("F2"),
                                           OTHER("L"),      OTHER("T"),          OTHER("alpha"),      OTHER("gait"),
                                           OTHER("v0"),     OTHER("F1_over_F2"), OTHER("m1_over_m2"), OTHER("froude"),
                                           OTHER("mu1"),    OTHER("mu2"),        OTHER("g"),          OTHER("label"),
                                           { .name = NULL } };
  if (!config_setting_is_group(group))
    return refuse_at(&s->config, group, "vary is a list of groups: ( { F1 = [2.0, 4.0]; }, { T = [0.1, 1.0]; } )");
  if (!read_members(&s->config, group, members, s, "a group of what varies"))
    return false;
  const char *wrong = vary_group(&s->request);
  if (wrong)
    return refuse_at(&s->config, group, "%s", wrong);
  for (int i = 0; i < config_setting_length(group); i++) {
    const config_setting_t *at = member_at(group, i);
    struct sweep_variable v;
    bool is_label = !sweep_variable_of_name(&v, config_setting_name(at));
    if (!(is_label ? add_labels(s, at) : add_variable(s, at, &v)))
      return false;
  }
  struct sweep_product *product = &s->request.sweep.product[s->request.sweep.products - 1];
  product->groups -= product->group[product->groups - 1].variables == 0; /* the command line overrides all of it */
  return true;
}

static bool read_product(struct scene *s, const config_setting_t *at)
{
  const char *wrong = vary_product(&s->request);
  if (wrong)
    return refuse_at(&s->config, at, "%s", wrong);
  for (int i = 0; i < element_count(at); i++)
    if (!read_group(s, element_at(at, i)))
      return false;
  const struct sweep_variable *twice = sweep_set_twice(&s->request.sweep.product[s->request.sweep.products - 1]);
  return !twice || refuse_at(&s->config, at, "%s is set twice here", twice->name);
}

bool scene_read_vary(struct scene *s, const config_setting_t *vary)
{
  bool has_products = vary && element_count(vary) > 0 && config_setting_is_list(element_at(vary, 0));
  if (!has_products)
    return !vary || read_product(s, vary);
  for (int i = 0; i < element_count(vary); i++)
    if (!read_product(s, element_at(vary, i)))
      return false;
  return true;
}
