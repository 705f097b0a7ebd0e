/* Values of a variable as text, where they are all of a product: options of the command line. Scenes
 * (compare/scenes/vary.c) have values of their own syntax, and take from here what is wrong with one. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/points/gaits.h"
#include "compare/points/sweep.h"
#include "compare/text/values.h"

enum { WRONG = 400 };
static char message[WRONG];

const char *sweep_wrong(const struct sweep_variable *v, const struct point *point, const char *text)
{
  struct point probe = *point;
  double x;
  if (v->target == TARGET_NUMBER || v->target == TARGET_V0 || v->target == TARGET_GAIT || v->target == TARGET_PHASE)
    return point_set(&probe, v->name, text);
  return v->target == TARGET_LABEL || (read_number(text, &x) && x > 0) ? NULL : no_number(text, "a finite number > 0");
}

const char *sweep_end_wrong(const struct sweep_variable *v, const struct point *point, const char *text)
{
  double x;
  const char *wrong = sweep_wrong(v, point, text);
  return !wrong && v->is_log && !(read_number(text, &x) && x > 0) ? "an end of a range with log spacing is > 0" : wrong;
}

static bool is_number_of(const struct sweep_variable *v)
{
  return v->target == TARGET_NUMBER || v->target == TARGET_V0;
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

bool sweep_is_many(const char *name, const char *text)
{
  struct sweep_variable v;
  return sweep_variable_of_name(&v, name) && (end_of_value(&v, text) || (is_number_of(&v) && strchr(text, ':')));
}

/* Keeps a copy of text, to be split. */
static char *keep(struct sweep_variable *v, const char *text) { return v->kept = strdup(text); }

/* "0.6,0.7" */
static const char *read_list(struct sweep_variable *v, struct point *point, const char *text)
{
  char *value = keep(v, text);
  v->count = 1;
  for (const char *comma = end_of_value(v, text); comma; comma = end_of_value(v, comma + 1))
    v->count++;
  v->texts = calloc((size_t)v->count, sizeof *v->texts);
  for (long i = 0; value && v->texts && i < v->count; i++) {
    char *end = (char *)end_of_value(v, value);
    if (end)
      *end = '\0';
    v->texts[i] = value;
    const char *wrong = sweep_wrong(v, point, value);
    if (wrong)
      return wrong;
    value = end ? end + 1 : value;
  }
  return value && v->texts ? point_set(point, v->name, v->texts[0]) : "out of memory";
}

static const char *no_range(const char *text)
{
  snprintf(message, WRONG,
           "'%.80s' is no range: FROM:TO:COUNT, or FROM:TO:COUNT:log with equal ratios; COUNT is from 2 to %d, and "
           "both ends "
           "belong to it",
           text, SWEEP_RANGE);
  return message;
}

/* "1:10:10", "1e-3:1:50:log" */
static const char *read_range(struct sweep_variable *v, struct point *point, const char *text)
{
  enum { FROM, TO, COUNT, SPACING, PARTS };
  char *part[PARTS + 1] = { NULL }, *rest = keep(v, text);
  int parts = 0;
  if (!rest)
    return "out of memory";
  for (; rest && parts <= PARTS; parts++) {
    part[parts] = rest;
    rest = strchr(rest, ':');
    if (rest)
      *rest++ = '\0';
  }
  bool spaced = parts == PARTS && (strcmp(part[SPACING], "log") == 0 || strcmp(part[SPACING], "linear") == 0);
  if (!(parts == SPACING || spaced) || !read_count(part[COUNT], 2, SWEEP_RANGE, &v->count))
    return no_range(text);
  v->is_log = spaced && strcmp(part[SPACING], "log") == 0;
  for (int i = FROM; i <= TO; i++) {
    const char *wrong = sweep_end_wrong(v, point, part[i]);
    if (wrong)
      return wrong;
    read_number(part[i], i == FROM ? &v->from.number : &v->to.number);
  }
  return point_set(point, v->name, part[FROM]);
}

/* The place of the group that sets the parameter, or that behind the last. */
static int group_of(const struct sweep_product *product, const char *name)
{
  int g = 0;
  while (g < product->groups && strcmp(product->group[g].variable[0].name, name) != 0)
    g++;
  return g;
}

void sweep_hold(struct sweep *sweep, const char *name)
{
  struct sweep_product *product = sweep->product;
  int g = product ? group_of(product, name) : 0;
  if (!product || g == product->groups)
    return;
  sweep_variable_free(&product->group[g].variable[0]);
  product->groups--;
  memmove(&product->group[g], &product->group[g + 1], (size_t)(product->groups - g) * sizeof *product->group);
}

const char *sweep_vary(struct sweep *sweep, struct point *point, const char *name, const char *text)
{
  if (!sweep->product && !(sweep->product = calloc(1, sizeof *sweep->product)))
    return "out of memory";
  sweep->products = 1;
  sweep_hold(sweep, name);
  struct sweep_product *product = sweep->product;
  struct sweep_group *group = &product->group[product->groups];
  struct sweep_variable *v = &group->variable[0];
  if (product->groups == SWEEP_GROUPS || !sweep_variable_of_name(v, name))
    return "this does not vary";
  const char *wrong = (is_number_of(v) && strchr(text, ':') ? read_range : read_list)(v, point, text);
  double points = wrong ? 0 : (double)v->count;
  for (int g = 0; g < product->groups; g++)
    points *= (double)product->group[g].count;
  if (points > SWEEP_POINTS) {
    snprintf(message, WRONG, "%g points: more than %g", points, SWEEP_POINTS);
    wrong = message;
  }
  if (wrong) {
    sweep_variable_free(v);
    return wrong;
  }
  group->variables = 1;
  group->count = v->count;
  product->groups++;
  return NULL;
}
