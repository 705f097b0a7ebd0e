#include "compare/answers/vary.h"

#include <stdlib.h>
#include <string.h>

#include "compare/answers/rows.h"

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

/* Returns true if the end is a formula that names what the variable sets. */
static bool end_names(const struct request *r, const struct sweep_end *end, const struct sweep_variable *v)
{
  int places[FORMULA_STEPS];
  bool found = false;
  for (int i = end->is_formula ? formula_places(&end->formula, places) : 0; i-- > 0;) {
    const char *name = r->required->quantities.item[places[i]].name;
    found = found || strcmp(name, v->sets) == 0 || strcmp(name, v->name) == 0;
  }
  return found;
}

/* Returns the name of an earlier, slower variable in the product whose range has an end that depends on v, or NULL. */
static const char *used_too_early(const struct request *r, const struct sweep_variable *v)
{
  const struct sweep_product *p = last_product(r);
  for (int g = 0; g < p->groups - 1 && v->target != TARGET_LABEL; g++)
    for (int i = 0; i < p->group[g].variables; i++) {
      const struct sweep_variable *slower = &p->group[g].variable[i];
      if (slower->target != TARGET_LABEL && (end_names(r, &slower->from, v) || end_names(r, &slower->to, v)))
        return slower->name;
    }
  return NULL;
}

/* Adds a variable with valid values. */
static const char *add(struct request *r, const struct sweep_variable *v)
{
  struct sweep_product *product = last_product(r);
  struct sweep_group *g = &product->group[product->groups - 1];
  double points = 1;
  if (g->variables == SWEEP_VARIABLES)
    return wrong_text("more than %d variables in one group", SWEEP_VARIABLES);
  if (v->count > 1 && g->count > 1 && v->count != g->count)
    return wrong_text("%ld values, but the variables before it in this group have %ld: they advance together", v->count,
                      g->count);
  g->count = v->count > g->count ? v->count : g->count;
  for (int i = 0; i < product->groups; i++)
    points *= (double)product->group[i].count;
  if (points > SWEEP_POINTS)
    return wrong_text("%g points: more than %g", points, SWEEP_POINTS);
  const char *early = used_too_early(r, v);
  if (early)
    return wrong_text("the range of %s has an end that depends on %s: give %s first", early, v->sets, v->name);
  g->variable[g->variables++] = *v;
  return NULL;
}

/* Copies the list and its texts to one block of memory. Returns NULL: out of memory. */
static const char **copied(const char *const *texts, long count)
{
  size_t size = (size_t)count * sizeof *texts;
  for (long i = 0; i < count; i++)
    size += strlen(texts[i]) + 1;
  const char **copy = malloc(size);
  char *next = (char *)(copy + count);
  for (long i = 0; i < count && copy; i++) {
    copy[i] = memcpy(next, texts[i], strlen(texts[i]) + 1);
    next += strlen(next) + 1;
  }
  return copy;
}

const char *vary_list(struct request *r, struct sweep_variable v, const char *const *texts, long count)
{
  const char *wrong = NULL;
  for (long i = 0; i < count && !wrong; i++)
    wrong = sweep_wrong(&v, &r->point, texts[i]);
  if (wrong)
    return wrong;
  v.count = count;
  v.texts = copied(texts, count);
  wrong = v.texts ? add(r, &v) : no_memory;
  if (wrong)
    free(v.texts);
  return wrong;
}

/* Returns true if the quantity is known before a motion is solved. */
static bool is_of_parameters(const struct quantity *q)
{
  return (q->kind == QUANTITY_NUMBER && q->which != PLACE_OF_V0) || q->kind == QUANTITY_RATIO
         || q->kind == QUANTITY_ONSET;
}

const char *vary_end(const struct request *r, const char *text, struct sweep_end *end)
{
  int places[FORMULA_STEPS];
  if (read_number(text, &end->number))
    return NULL;
  const char *wrong = r->required ? sheet_formula(r->required, &end->formula, text) : "a finite number";
  if (wrong)
    return wrong_text("'%.100s' is neither a number nor a formula: %s", text, wrong);
  end->is_formula = true;
  for (int i = formula_places(&end->formula, places); i-- > 0;)
    if (!is_of_parameters(&r->required->quantities.item[places[i]]))
      return wrong_text("'%.100s': a formula of m1 m2 F1 F2 L T alpha F1_over_F2 m1_over_m2 froude and sticking_onset, "
                        "not of %s",
                        text, r->required->quantities.item[places[i]].name);
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
  struct quantities *all = r->required ? &r->required->quantities : NULL;
  int place = 0;
  if (!all)
    return "labels need a table with a row for each point";
  while (place < all->labels && strcmp(all->label[place], name) != 0)
    place++;
  if (place == all->labels) { /* a new label */
    if (strlen(name) >= QUANTITY_NAME || place == QUANTITY_LABELS)
      return wrong_text("at most %d labels have a name, of fewer than %d characters", QUANTITY_LABELS, QUANTITY_NAME);
    if (quantity_named(all, name) >= 0)
      return wrong_text("a label cannot be called %s, which is a quantity", name);
    if (!(all->label[place] = strdup(name)))
      return no_memory;
    all->labels++;
  }
  name = all->label[place];
  *label = (struct sweep_variable){ .target = TARGET_LABEL, .place = place, .name = name, .sets = name };
  return NULL;
}

/* Returns the end of the first value of text: a comma, or the end of text. Gaits contain commas: there only a comma
 * before the name of a family ends a value. */
static const char *end_of_value(const struct sweep_variable *v, const char *text)
{
  const char *comma = strchr(text, ',');
  while (comma && v->target == TARGET_GAIT && !gait_family_begins(comma + 1))
    comma = strchr(comma + 1, ',');
  return comma ? comma : text + strlen(text);
}

/* Adds a list of values between commas; modifies text. */
static const char *list_of_text(struct request *r, const struct sweep_variable *v, char *text)
{
  const char **texts = calloc(strlen(text) + 1, sizeof *texts);
  long count = 0;
  for (bool more = texts != NULL; more;) {
    char *end = text + (end_of_value(v, text) - text);
    more = *end != '\0';
    *end = '\0';
    texts[count++] = text;
    text = end + 1;
  }
  const char *wrong = texts ? vary_list(r, *v, texts, count) : no_memory;
  free(texts);
  return wrong;
}

/* Adds the range FROM:TO:COUNT or FROM:TO:COUNT:SPACING; modifies copy, a copy of text. */
static const char *range_of_text(struct request *r, const struct sweep_variable *v, const char *text, char *copy)
{
  static const char *const spacings[] = { "linear", "log", NULL };
  char *part[4] = { copy };
  int parts = 1;
  long count;
  for (char *colon; parts < 4 && (colon = strchr(part[parts - 1], ':')); part[parts++] = colon + 1)
    *colon = '\0';
  int spacing = word_place(parts == 4 ? part[3] : "linear", spacings);
  if (parts == 2 || (parts == 3 && word_place(part[2], spacings) >= 0)) {
    struct sweep_variable sampled = *v;
    sampled.is_sampled = true;
    return vary_range(r, sampled, copy, part[1], 1, parts == 3 && word_place(part[2], spacings) == 1);
  }
  if (parts >= 3 && spacing >= 0 && read_count(part[2], strcmp(copy, part[1]) == 0 ? 1 : 2, SWEEP_RANGE, &count))
    return vary_range(r, *v, copy, part[1], count, spacing == 1);
  return wrong_text(
      "'%.80s' is not a range: FROM:TO:COUNT, or FROM:TO:COUNT:log with equal ratios; COUNT is from 2 to %d, "
      "or 1 where FROM = TO; both ends belong to it; with --sample also FROM:TO or FROM:TO:log",
      text, SWEEP_RANGE);
}

/* Removes the values of the parameter from the last product. */
static void remove_values(struct request *r, const char *name)
{
  struct sweep_product *product = last_product(r);
  int g = 0;
  while (product && g < product->groups && strcmp(product->group[g].variable[0].name, name) != 0)
    g++;
  if (!product || g == product->groups)
    return;
  free(product->group[g].variable[0].texts);
  product->groups--;
  memmove(&product->group[g], &product->group[g + 1], (size_t)(product->groups - g) * sizeof *product->group);
}

/* Reads the name of a label from "panel=A,B"; *values becomes its texts. */
static const char *label_of_text(struct request *r, struct sweep_variable *label, char **values)
{
  char *name = *values, *equals = strchr(name, '=');
  if (!equals || equals == name)
    return not_allowed(name, "NAME=TEXT or NAME=TEXT,TEXT");
  *equals = '\0';
  *values = equals + 1;
  return vary_label(r, name, label);
}

/* Adds a group with the parameter, or with a label if parameter is NULL; modifies copy, a copy of text. */
static const char *add_values(struct request *r, const struct sweep_variable *parameter, const char *text, char *copy)
{
  struct sweep_variable v = parameter ? *parameter : (struct sweep_variable){ .name = "" };
  const char *wrong = parameter ? NULL : label_of_text(r, &v, &copy);
  if (wrong)
    return wrong;
  remove_values(r, v.name);
  wrong = vary_group(r);
  if (wrong)
    return wrong;
  bool is_range = v.target <= TARGET_FROUDE && strchr(copy, ':');
  wrong = is_range ? range_of_text(r, &v, text, copy) : list_of_text(r, &v, copy);
  last_product(r)->groups -= wrong != NULL;
  r->point.has_v0 |= v.target == TARGET_V0 && !wrong; /* for blocks of rows in which v0 is constant */
  return wrong;
}

/* Moves the sampled variables of all later groups to `into`, and samples this group. Returns NULL or the error. */
static const char *gather(const struct samples *s, struct sweep_product *p, struct sweep_group *into)
{
  double points = (double)s->count;
  into->count = s->count;
  into->sampling = s->sampling;
  into->seed = s->seed;
  for (struct sweep_group *g = into + 1; g < p->group + p->groups;) {
    if (!g->variable[0].is_sampled) {
      g++;
      continue;
    }
    if (into->variables == SWEEP_VARIABLES)
      return wrong_text("more than %d ranges are sampled together", SWEEP_VARIABLES);
    into->variable[into->variables++] = g->variable[0];
    memmove(g, g + 1, (size_t)(p->group + --p->groups - g) * sizeof *g);
  }
  for (struct sweep_group *g = p->group; g < p->group + p->groups; g++)
    points *= g == into ? 1 : (double)g->count;
  return points > SWEEP_POINTS ? wrong_text("%g points: more than %g", points, SWEEP_POINTS) : NULL;
}

const char *vary_sample(struct request *r)
{
  const char *wrong = NULL;
  bool is_sampled = false;
  for (struct sweep_product *p = r->sweep.product; p < r->sweep.product + r->sweep.products; p++)
    for (int g = 0; g < p->groups && !wrong; g++) {
      const struct sweep_variable *v = &p->group[g].variable[0];
      if (!v->is_sampled || p->group[g].sampling != SAMPLING_NONE)
        continue;
      is_sampled = true;
      wrong = r->samples.sampling != SAMPLING_NONE
                  ? gather(&r->samples, p, &p->group[g])
                  : wrong_text("--%s: a range without a COUNT needs --sample", v->name);
    }
  return wrong || is_sampled || r->samples.sampling == SAMPLING_NONE
             ? wrong
             : "--sample: no parameter has a range FROM:TO or FROM:TO:log";
}

const char *vary_text(struct request *r, const char *name, const char *text)
{
  struct sweep_variable v;
  bool has = sweep_variable_of_name(&v, name), is_number = has && v.target <= TARGET_FROUDE;
  bool is_ratio = is_number && v.target >= TARGET_M1_OVER_M2; /* the point has no such number */
  bool is_many = has ? is_ratio || *end_of_value(&v, text) || (is_number && strchr(text, ':'))
                     : strcmp(name, "label") == 0;
  if (!is_many) {
    remove_values(r, name);
    return point_set(&r->point, name, text);
  }
  char *copy = strdup(text);
  const char *wrong = copy ? add_values(r, has ? &v : NULL, text, copy) : no_memory;
  free(copy);
  return wrong;
}
