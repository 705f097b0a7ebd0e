#include "compare/answers/vary.h"

#include <stdlib.h>
#include <string.h>

#include "compare/answers/sheet.h"

enum { WRONG = 400 };
static char message[WRONG];
static const char no_memory[] = "out of memory";

static struct sweep_product *last_product(const struct request *r)
{
  return r->sweep.products > 0 ? &r->sweep.product[r->sweep.products - 1] : NULL;
}

const char *vary_product(struct request *r)
{
  struct sweep *s = &r->sweep;
  if (s->products == SWEEP_PRODUCTS) {
    snprintf(message, WRONG, "more than %d products", SWEEP_PRODUCTS);
    return message;
  }
  struct sweep_product *grown = realloc(s->product, (size_t)(s->products + 1) * sizeof *grown);
  if (!grown)
    return no_memory;
  s->product = grown;
  memset(&grown[s->products++], 0, sizeof *grown);
  return NULL;
}

const char *vary_group(struct request *r)
{
  const char *wrong = r->sweep.products == 0 ? vary_product(r) : NULL;
  struct sweep_product *product = last_product(r);
  if (wrong)
    return wrong;
  if (product->groups == SWEEP_GROUPS) {
    snprintf(message, WRONG, "more than %d groups", SWEEP_GROUPS);
    return message;
  }
  product->group[product->groups++] = (struct sweep_group){ .count = 1 };
  return NULL;
}

/* Adds a variable whose values are known to be good. */
static const char *add(struct request *r, const struct sweep_variable *v)
{
  struct sweep_product *product = last_product(r);
  struct sweep_group *g = &product->group[product->groups - 1];
  double points = 1;
  if (g->variables == SWEEP_VARIABLES) {
    snprintf(message, WRONG, "more than %d variables go together here", SWEEP_VARIABLES);
    return message;
  }
  if (v->count > 1 && g->count > 1 && v->count != g->count) {
    snprintf(message, WRONG, "%ld values, but those before it in this group have %ld: they go on together", v->count,
             g->count);
    return message;
  }
  g->count = v->count > g->count ? v->count : g->count;
  for (int i = 0; i < product->groups; i++)
    points *= (double)product->group[i].count;
  if (points > SWEEP_POINTS) {
    snprintf(message, WRONG, "%g points: more than %g", points, SWEEP_POINTS);
    return message;
  }
  g->variable[g->variables++] = *v;
  return NULL;
}

const char *vary_list(struct request *r, struct sweep_variable v, const char *const *texts, long count)
{
  v.count = count;
  v.texts = calloc((size_t)count, sizeof *v.texts);
  const char *wrong = v.texts ? NULL : no_memory;
  for (long i = 0; i < count && !wrong; i++) {
    wrong = sweep_wrong(&v, &r->point, texts[i]);
    v.texts[i] = texts[i];
  }
  wrong = wrong ? wrong : add(r, &v);
  if (wrong)
    free(v.texts);
  return wrong;
}

/* Is the quantity known before anything is solved at a point? */
static bool is_of_parameters(const struct quantity *q)
{
  return q->kind == QUANTITY_NUMBER || q->kind == QUANTITY_ONSET || q->kind == QUANTITY_FROUDE
         || q->kind == QUANTITY_RATIO;
}

const char *vary_end(const struct request *r, const char *text, struct sweep_end *end)
{
  int places[FORMULA_STEPS];
  if (read_number(text, &end->number))
    return NULL;
  const char *wrong = r->asked ? sheet_formula(r->asked, &end->formula, text) : "a finite number";
  if (wrong) {
    snprintf(message, WRONG, "'%.100s' is no number, nor a formula: %s", text, wrong);
    return message;
  }
  end->is_formula = true;
  for (int i = formula_places(&end->formula, places); i-- > 0;)
    if (!is_of_parameters(&r->asked->quantities.item[places[i]])) {
      snprintf(
          message, WRONG,
          "'%.100s': a formula of m1 m2 F1 F2 L T alpha F1_over_F2 m1_over_m2 froude and sticking_onset, not of %s",
          text, r->asked->quantities.item[places[i]].name);
      return message;
    }
  return NULL;
}

static const char *range_end(struct request *r, const struct sweep_variable *v, const char *text, struct sweep_end *end)
{
  const char *wrong = vary_end(r, text, end);
  if (!wrong && !end->is_formula)
    wrong = sweep_wrong(v, &r->point, text);
  if (!wrong && !end->is_formula && v->is_log && !(end->number > 0))
    wrong = "an end of a range with log spacing is > 0";
  return wrong;
}

const char *vary_range(struct request *r, struct sweep_variable v, const char *from, const char *to, long count,
                       bool is_log)
{
  v.count = count;
  v.is_log = is_log;
  const char *wrong = range_end(r, &v, from, &v.from);
  wrong = wrong ? wrong : range_end(r, &v, to, &v.to);
  return wrong ? wrong : add(r, &v);
}

const char *vary_label(struct request *r, const char *name, struct sweep_variable *label)
{
  struct quantities *all = r->asked ? &r->asked->quantities : NULL;
  int place = 0;
  if (!all)
    return "labels are columns of rows of points";
  while (place < all->labels && strcmp(all->label[place], name) != 0)
    place++;
  if (strlen(name) >= QUANTITY_NAME || place == QUANTITY_LABELS) {
    snprintf(message, WRONG, "at most %d labels have a name, of fewer than %d characters", QUANTITY_LABELS,
             QUANTITY_NAME);
    return message;
  }
  if (place == all->labels && quantity_named(all, name) >= 0) {
    snprintf(message, WRONG, "a label cannot be called %s, which is a quantity", name);
    return message;
  }
  all->label[place] = name;
  all->labels += place == all->labels;
  *label = (struct sweep_variable){ .target = TARGET_LABEL, .place = place, .name = name, .sets = name };
  return NULL;
}

static bool has_ranges(const struct sweep_variable *v)
{
  return v->target != TARGET_GAIT && v->target != TARGET_PHASE && v->target != TARGET_LABEL;
}

/* Where the value that text begins with ends: at a comma. A gait has commas of its own, so that there only one counts
 * behind which the name of a family stands. NULL: text is one value. */
static const char *end_of_value(const struct sweep_variable *v, const char *text)
{
  const char *comma = strchr(text, ',');
  while (comma && v->target == TARGET_GAIT && !gait_family_begins(comma + 1))
    comma = strchr(comma + 1, ',');
  return comma;
}

bool vary_is_many(const char *name, const char *text)
{
  struct sweep_variable v;
  if (!sweep_variable_of_name(&v, name))
    return strcmp(name, "label") == 0;
  bool is_of_point = v.target == TARGET_NUMBER || v.target == TARGET_GAIT || v.target == TARGET_PHASE
                     || v.target == TARGET_V0;
  return !is_of_point || end_of_value(&v, text) || (has_ranges(&v) && strchr(text, ':'));
}

/* Splits the text at its commas. */
static const char *list_of_text(struct request *r, struct sweep_variable *v, char *text)
{
  long count = 1, n = 0;
  for (const char *comma = end_of_value(v, text); comma; comma = end_of_value(v, comma + 1))
    count++;
  const char **texts = calloc((size_t)count, sizeof *texts);
  for (char *value = text, *end; texts && value; value = end) {
    end = (char *)end_of_value(v, value);
    texts[n++] = value;
    if (end)
      *end++ = '\0';
  }
  const char *wrong = texts ? vary_list(r, *v, texts, count) : no_memory;
  free(texts);
  return wrong;
}

static const char *range_of_text(struct request *r, struct sweep_variable *v, char *text)
{
  enum { FROM, TO, COUNT, SPACING, PARTS };
  char *part[PARTS + 1] = { NULL };
  int parts = 0;
  long count;
  for (char *rest = text; rest && parts <= PARTS; parts++) {
    part[parts] = rest;
    rest = strchr(rest, ':');
    if (rest)
      *rest++ = '\0';
  }
  bool spaced = parts == PARTS && (strcmp(part[SPACING], "log") == 0 || strcmp(part[SPACING], "linear") == 0);
  if ((parts == SPACING || spaced)
      && read_count(part[COUNT], strcmp(part[FROM], part[TO]) == 0 ? 1 : 2, SWEEP_RANGE, &count))
    return vary_range(r, *v, part[FROM], part[TO], count, spaced && strcmp(part[SPACING], "log") == 0);
  for (int i = 1; i < parts && i <= PARTS; i++)
    part[i][-1] = ':';
  snprintf(message, WRONG,
           "'%.80s' is no range: FROM:TO:COUNT, or FROM:TO:COUNT:log with equal ratios; COUNT is from 2 to %d, or "
           "1 where FROM = TO; both ends belong to it",
           text, SWEEP_RANGE);
  return message;
}

/* The place of the group that sets the parameter, or that behind the last */
static int group_of(const struct sweep_product *product, const char *name)
{
  int g = 0;
  while (g < product->groups && strcmp(product->group[g].variable[0].name, name) != 0)
    g++;
  return g;
}

void vary_hold(struct request *r, const char *name)
{
  struct sweep_product *product = last_product(r);
  int g = product ? group_of(product, name) : 0;
  if (!product || g == product->groups)
    return;
  sweep_variable_free(&product->group[g].variable[0]);
  product->groups--;
  memmove(&product->group[g], &product->group[g + 1], (size_t)(product->groups - g) * sizeof *product->group);
}

/* "panel=A,B": the label, and its texts in the copy */
static const char *label_of_text(struct request *r, struct sweep_variable *v, char *copy, char **texts)
{
  char *equals = strchr(copy, '=');
  if (!equals || equals == copy)
    return not_allowed(copy, "NAME=TEXT or NAME=TEXT,TEXT");
  *equals = '\0';
  *texts = equals + 1;
  return vary_label(r, copy, v);
}

const char *vary_text(struct request *r, const char *name, const char *text)
{
  struct sweep_variable v;
  char *copy = strdup(text), *values = copy;
  const char *wrong = copy ? NULL : no_memory;
  if (!wrong && !sweep_variable_of_name(&v, name))
    wrong = label_of_text(r, &v, copy, &values);
  if (!wrong)
    vary_hold(r, v.name);
  wrong = wrong ? wrong : vary_group(r);
  if (wrong) {
    free(copy);
    return wrong;
  }
  bool is_range = has_ranges(&v) && strchr(values, ':');
  struct point first = r->point;
  wrong = (is_range ? range_of_text : list_of_text)(r, &v, values);
  struct sweep_product *product = last_product(r);
  struct sweep_group *group = &product->group[product->groups - 1];
  if (wrong) {
    product->groups--;
    free(copy);
    return wrong;
  }
  group->variable[0].kept = copy;
  if (v.target != TARGET_LABEL && strcmp(v.name, v.sets) == 0 && !group->variable[0].from.is_formula)
    point_set(&first, name, is_range ? values : group->variable[0].texts[0]);
  r->point = first;
  return NULL;
}
