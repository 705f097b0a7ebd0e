#include "compare/answers/vary.h"

#include <stdlib.h>
#include <string.h>

#include "compare/answers/sheet.h"

static const char no_memory[] = "out of memory";

static struct sweep_product *last_product(const struct request *r)
{
  return r->sweep.products > 0 ? &r->sweep.product[r->sweep.products - 1] : NULL;
}

const char *vary_product(struct request *r)
{
  struct sweep *s = &r->sweep;
  if (s->products == SWEEP_PRODUCTS)
    return wrong_text("more than %d products", SWEEP_PRODUCTS);
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
  if (product->groups == SWEEP_GROUPS)
    return wrong_text("more than %d groups", SWEEP_GROUPS);
  product->group[product->groups++] = (struct sweep_group){ .count = 1 };
  return NULL;
}

/* Adds a variable whose values are known to be good. */
static const char *add(struct request *r, const struct sweep_variable *v)
{
  struct sweep_product *product = last_product(r);
  struct sweep_group *g = &product->group[product->groups - 1];
  double points = 1;
  if (g->variables == SWEEP_VARIABLES)
    return wrong_text("more than %d variables go together here", SWEEP_VARIABLES);
  if (v->count > 1 && g->count > 1 && v->count != g->count)
    return wrong_text("%ld values, but those before it in this group have %ld: they go on together", v->count,
                      g->count);
  g->count = v->count > g->count ? v->count : g->count;
  for (int i = 0; i < product->groups; i++)
    points *= (double)product->group[i].count;
  if (points > SWEEP_POINTS)
    return wrong_text("%g points: more than %g", points, SWEEP_POINTS);
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
  if (wrong)
    return wrong_text("'%.100s' is no number, nor a formula: %s", text, wrong);
  end->is_formula = true;
  for (int i = formula_places(&end->formula, places); i-- > 0;)
    if (!is_of_parameters(&r->asked->quantities.item[places[i]]))
      return wrong_text("'%.100s': a formula of m1 m2 F1 F2 L T alpha F1_over_F2 m1_over_m2 froude and sticking_onset, "
                        "not of %s",
                        text, r->asked->quantities.item[places[i]].name);
  return NULL;
}

static const char *range_end(struct request *r, const struct sweep_variable *v, const char *text, struct sweep_end *end)
{
  const char *wrong = vary_end(r, text, end);
  if (wrong || end->is_formula)
    return wrong;
  wrong = sweep_wrong(v, &r->point, text);
  return !wrong && v->is_log && !(end->number > 0) ? "an end of a range with log spacing is > 0" : wrong;
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
  if (strlen(name) >= QUANTITY_NAME || place == QUANTITY_LABELS)
    return wrong_text("at most %d labels have a name, of fewer than %d characters", QUANTITY_LABELS, QUANTITY_NAME);
  if (place == all->labels && quantity_named(all, name) >= 0)
    return wrong_text("a label cannot be called %s, which is a quantity", name);
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
  return v.target > TARGET_V0 || end_of_value(&v, text) || (has_ranges(&v) && strchr(text, ':'));
}

/* Splits the text at its commas. */
static const char *list_of_text(struct request *r, struct sweep_variable *v, char *text)
{
  const char **texts = calloc(strlen(text) + 1, sizeof *texts), *wrong = no_memory;
  long count = 0;
  for (char *value = text, *end; texts && value; value = end) {
    end = (char *)end_of_value(v, value);
    texts[count++] = value;
    if (end)
      *end++ = '\0';
  }
  if (texts)
    wrong = vary_list(r, *v, texts, count);
  free(texts);
  return wrong;
}

/* FROM:TO:COUNT or FROM:TO:COUNT:SPACING */
static const char *range_of_text(struct request *r, struct sweep_variable *v, char *text)
{
  enum { MOST = 4 };
  char *colon[MOST] = { NULL };
  int colons = 0;
  long count;
  for (char *c = strchr(text, ':'); c && colons < MOST; c = strchr(c + 1, ':'))
    colon[colons++] = c;
  const char *spacing = colons == 3 ? colon[2] + 1 : "linear";
  bool is_log = strcmp(spacing, "log") == 0;
  bool fits = (colons == 2 || colons == 3) && (is_log || strcmp(spacing, "linear") == 0);
  for (int i = 0; i < colons; i++)
    *colon[i] = '\0';
  if (fits && read_count(colon[1] + 1, strcmp(text, colon[0] + 1) == 0 ? 1 : 2, SWEEP_RANGE, &count))
    return vary_range(r, *v, text, colon[0] + 1, count, is_log);
  for (int i = 0; i < colons; i++)
    *colon[i] = ':';
  return wrong_text(
      "'%.80s' is no range: FROM:TO:COUNT, or FROM:TO:COUNT:log with equal ratios; COUNT is from 2 to %d, "
      "or 1 where FROM = TO; both ends belong to it",
      text, SWEEP_RANGE);
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
  wrong = (is_range ? range_of_text : list_of_text)(r, &v, values);
  struct sweep_product *product = last_product(r);
  if (wrong) {
    product->groups--;
    free(copy);
    return wrong;
  }
  product->group[product->groups - 1].variable[0].kept = copy;
  r->point.has_v0 |= v.target == TARGET_V0; /* the point keeps its values, for blocks of rows where these do not vary */
  return NULL;
}
