/* want = ( { what = "steady"; file = "steady.tsv"; }, ... ) */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/scene_parts.h"

enum { FORMULA_TEXT = 400, MOST_ARGUMENTS = 64, MOST_DIGITS = 10000, DOUBLE_DIGITS = 17, MOST_ORDER = 1000 };

static const char *const whats[] = { "trajectory", "phase",     "steady",    "series",         "error",  "orders", "terms",
                                     "bounds",     "breakdown", "stability", "work-precision", "claims", NULL };

/* ---- columns ---- */

static int name_of_quantity(void *context, const char *name)
{
  return quantity_named(&((struct scene *)context)->quantities, name);
}

static bool refuse_quantity(const struct reading *r, const config_setting_t *at, const char *name)
{
  const char *near = quantity_near(&r->scene->quantities, name);
  return refuse_at(r, at, "there is no quantity '%s'%s%s%s (docs/scenes.md lists them)", name,
                   near ? ": did you mean '" : "", near ? near : "", near ? "'?" : "");
}

/* Does a scene like this one have the quantity? */
static bool check_quantity(const struct reading *r, const config_setting_t *at, const struct scene_want *w, int place)
{
  const struct scene *s = r->scene;
  const struct quantity *q = &s->quantities.item[place];
  bool moving = s->start != START_REST || s->varies_v0;
  if (q->kind == QUANTITY_SAMPLE && w->kind != WANT_TRAJECTORY)
    return refuse_at(r, at, "%s is a quantity of a trajectory", q->name);
  if (w->kind == WANT_TRAJECTORY && q->kind == QUANTITY_STATUS)
    return refuse_at(r, at, "a trajectory has no status: it ends where it cannot go on");
  const struct quantity *series = q->of >= 0 ? &s->quantities.item[q->of] : q;
  if (series->kind == QUANTITY_PUBLISHED) {
    enum scallop_setting setting = series->formula->setting;
    if (setting == SCALLOP_AT_REST_START && moving)
      return refuse_at(r, at, "%s is about a phase from rest, and this scene does not start there: start = \"rest\"",
                       q->name);
    if ((setting == SCALLOP_MOVING_EXTENSION && s->phase != SCALLOP_EXTENSION)
        || (setting == SCALLOP_MOVING_CONTRACTION && s->phase != SCALLOP_CONTRACTION))
      return refuse_at(r, at, "%s is about %s: phase = \"%s\"", q->name,
                       setting == SCALLOP_MOVING_EXTENSION ? "an extension" : "a contraction",
                       setting == SCALLOP_MOVING_EXTENSION ? "extension" : "contraction");
  }
  if ((series->kind == QUANTITY_DERIVED || series->kind == QUANTITY_LIMIT) && series->which >= STEADY_VALUES
      && s->start == START_STEADY && !s->varies_v0)
    return refuse_at(r, at, "%s is derived for a start that stays the same as T falls: start = \"rest\", or a velocity",
                     q->name);
  return true;
}

/* "NAME = FORMULA" or "FORMULA" */
static bool read_column(const struct reading *r, const config_setting_t *at, struct scene_want *w, const char *text)
{
  struct scene_column *column = &w->column[w->columns];
  const char *equals = strchr(text, '='), *formula = equals ? equals + 1 : text;
  formula += strspn(formula, " ");
  size_t length = equals ? (size_t)(equals - text) : strlen(text);
  while (length > 0 && text[length - 1] == ' ')
    length--;
  if (length == 0 || *formula == '\0')
    return refuse_at(r, at, "'%.100s' is no column: it takes \"QUANTITY\" or \"NAME = FORMULA\"", text);
  column->name = keep_text(r, text, (int)length, "");
  column->quantity = quantity_named(&r->scene->quantities, formula);
  if (column->quantity == -2)
    return refuse_at(r, at, "more than %d quantities", MOST_QUANTITIES);
  if (column->quantity < 0) {
    const char *wrong = arithmetic_compile(&column->formula, formula, name_of_quantity, r->scene);
    if (wrong && formula[strcspn(formula, "+-*/^() ")] == '\0')
      return refuse_quantity(r, at, formula);
    if (wrong)
      return refuse_at(r, at, "'%.100s': %s", text, wrong);
    int places[ARITHMETIC_STEPS], count = arithmetic_places(&column->formula, places);
    for (int i = 0; i < count; i++) {
      int place = places[i];
      if (quantity_is_text(&r->scene->quantities.item[place]))
        return refuse_at(r, at, "'%.100s': %s is a text, which stands alone in a column", text,
                         r->scene->quantities.item[place].name);
      if (!check_quantity(r, at, w, place))
        return false;
    }
  } else if (!check_quantity(r, at, w, column->quantity))
    return false;
  for (int i = 0; i < w->columns; i++)
    if (strcmp(w->column[i].name, column->name) == 0)
      return refuse_at(r, at, "the column %s is there twice", column->name);
  w->columns++;
  return column->name != NULL;
}

static bool add_columns(const struct reading *r, const config_setting_t *at, struct scene_want *w, const char *const *names)
{
  for (; *names; names++) {
    if (w->columns == SCENE_COLUMNS)
      return refuse_at(r, at, "more than %d columns", SCENE_COLUMNS);
    if (!read_column(r, at, w, *names))
      return false;
  }
  return true;
}

static bool add_labels(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  for (int i = 0; i < r->scene->quantities.labels; i++)
    if (!read_column(r, at, w, r->scene->quantities.label[i]))
      return false;
  return true;
}

/* ---- rows: what columns they have where none are asked for ---- */

static bool certified_columns(const struct reading *r, const config_setting_t *at, struct scene_want *w,
                              const char *const *names, int count)
{
  for (int i = 0; i < count; i++) {
    char column[FORMULA_TEXT];
    snprintf(column, sizeof column, "%s = certified.%s", names[i], names[i]);
    if (!read_column(r, at, w, column))
      return false;
  }
  return true;
}

static bool steady_columns(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  static const char *const numbers[] = { "v_start", "v_mid", "displacement", "mean_velocity", "multiplier", NULL };
  static const char *const before[] = { "froude", NULL }, *const after[] = { "regime", "modes", "status", NULL };
  static const char *const status[] = { "status", NULL };
  bool doubles = w->digits <= DOUBLE_DIGITS;
  return add_columns(r, at, w, crawler_parameters)
         && (doubles ? add_columns(r, at, w, before) && add_columns(r, at, w, numbers) && add_columns(r, at, w, after)
                     : certified_columns(r, at, w, numbers, 5) && add_columns(r, at, w, status));
}

static bool phase_columns(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  static const char *const numbers[] = { "t1", "dT", "v_end", "dx1", "dx2", "dxC", NULL };
  static const char *const before[] = { "phase", "v0", NULL };
  static const char *const after[] = { "regime = phase_regime", "modes = phase_modes", "status", NULL }, *const status[] = {
    "status", NULL
  };
  bool doubles = w->digits <= DOUBLE_DIGITS;
  return add_columns(r, at, w, crawler_parameters) && add_columns(r, at, w, before)
         && (doubles ? add_columns(r, at, w, numbers) && add_columns(r, at, w, after)
                     : certified_columns(r, at, w, numbers, 6) && add_columns(r, at, w, status));
}

/* Are formulas of the phase meant, where nothing is said? Where the scene says something about a phase. */
static bool is_about_phase(const struct reading *r)
{
  const config_setting_t *root = config_root_setting(r->scene->file);
  return config_setting_get_member(root, "phase") || config_setting_get_member(root, "start") || r->scene->varies_v0;
}

/* The formulas that a scene like this one can evaluate without a solution. */
static bool is_at_hand(const struct reading *r, const struct scallop_formula *f)
{
  const struct scene *s = r->scene;
  bool moving = s->start != START_REST || s->varies_v0;
  if (f->setting == SCALLOP_STEADY)
    return !is_about_phase(r);
  if (!is_about_phase(r) || formula_takes_given(f))
    return false;
  return f->setting == SCALLOP_AT_REST_START ? !moving
         : !moving                           ? false
                                             : (f->setting == SCALLOP_MOVING_EXTENSION) == (s->phase == SCALLOP_EXTENSION);
}

/* The names of the series: those of `of`, or the usual ones of a source. */
struct series_names {
  int count;
  const char *name[SCENE_COLUMNS];
};

static bool usual_series(const struct reading *r, const char *source, long order, struct series_names *names)
{
  static const char *const of_steady[] = { "v_start", "v_mid", "displacement", "mean_velocity", NULL };
  static const char *const of_phase[] = { "t1", "dT", "v_end", "dx1", "dx2", "dxC", NULL };
  if (strcmp(source, "published") == 0) {
    for (const struct scallop_formula *f = scallop_published; f->name && names->count < SCENE_COLUMNS; f++)
      if (is_at_hand(r, f))
        names->name[names->count++] = f->name;
    return true;
  }
  for (const char *const *value = is_about_phase(r) ? of_phase : of_steady; *value; value++) {
    char head[40];
    int length = snprintf(head, sizeof head, *source == 'd' ? "derived_%ld." : "limit.", order);
    const char *name = keep_text(r, head, length, *value);
    if (!name)
      return false;
    names->name[names->count++] = name;
  }
  return true;
}

/* Reads of, source and order. */
static bool read_series(const struct reading *r, const config_setting_t *at, struct series_names *names)
{
  const char *source = "published";
  long order = 8;
  const config_setting_t *of = config_setting_get_member(at, "of");
  if (!read_member_text(r, at, "source", &source) || !read_member_count(r, at, "order", 1, MOST_ORDER, &order)
      || !read_member_texts(r, at, "of", names->name, SCENE_COLUMNS, &names->count))
    return false;
  if (strcmp(source, "published") != 0 && strcmp(source, "derived") != 0 && strcmp(source, "limit") != 0)
    return refuse_at(r, config_setting_get_member(at, "source"), "source is \"published\", \"derived\" or \"limit\"");
  if (!of)
    return usual_series(r, source, order, names);
  for (int i = 0; i < names->count; i++) {
    int place = quantity_named(&r->scene->quantities, names->name[i]);
    if (place < 0)
      return refuse_quantity(r, of, names->name[i]);
    if (!quantity_is_series(&r->scene->quantities.item[place]))
      return refuse_at(r, of,
                       "%s is no series: a formula of the paper, derived_8.displacement or limit.displacement is meant",
                       names->name[i]);
  }
  return true;
}

static bool about_series(const struct reading *r, const config_setting_t *at, struct scene_want *w, const char *prefix,
                         const char *name)
{
  const char *column = keep_text(r, prefix, (int)strlen(prefix), name);
  return column && read_column(r, at, w, column);
}

static bool series_columns(const struct reading *r, const config_setting_t *at, struct scene_want *w, bool with_errors)
{
  static const char *const v0[] = { "v0", NULL }, *const status[] = { "status", NULL };
  struct series_names names = { .count = 0 };
  if (!read_series(r, at, &names) || !add_columns(r, at, w, crawler_parameters)
      || (is_about_phase(r) && !add_columns(r, at, w, v0)))
    return false;
  if (names.count * (with_errors ? 4 : 1) > SCENE_COLUMNS - w->columns - 1)
    return refuse_at(r, at, "%d series are more columns than a table has: name some of them, of = [ ... ]", names.count);
  for (int i = 0; i < names.count; i++)
    if (!about_series(r, at, w, "", names.name[i])
        || (with_errors
            && (!about_series(r, at, w, "exact.", names.name[i]) || !about_series(r, at, w, "error.", names.name[i])
                || !about_series(r, at, w, "relative.", names.name[i]))))
      return false;
  return add_columns(r, at, w, status);
}

/* ---- the kinds of wants ---- */

/* Which reference errors are told against, and how well. */
static bool read_accuracy(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  static const double of_doubles = 1e-10;
  const char *reference = NULL;
  const config_setting_t *accuracy = config_setting_get_member(at, "accuracy");
  w->accuracy = of_doubles;
  if (!read_member_text(r, at, "reference", &reference) || !read_member_number(r, at, "accuracy", &w->accuracy))
    return false;
  if (!(w->accuracy > 0) || !(w->accuracy < 1) || w->accuracy < 1e-300)
    return refuse_at(r, accuracy, "accuracy is a part of the exact value, between 1e-300 and 1");
  if (!reference)
    return true;
  const config_setting_t *named = config_setting_get_member(at, "reference");
  if (strcmp(reference, "certified") == 0) {
    w->is_certified = true;
    return true;
  }
  if (strcmp(reference, "exact") != 0)
    return refuse_at(r, named, "reference is \"exact\" (the solver in doubles) or \"certified\"");
  return w->accuracy >= of_doubles
         || refuse_at(r, named,
                      "the exact solver works in doubles, whose errors are told down to 1e-10; accuracy = %g needs "
                      "reference = \"certified\"",
                      w->accuracy);
}

static bool read_rows(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  static const char *const keys[] = { "what",  "file", "format", "digits",   "columns",   "source",
                                      "order", "of",   "plot",   "accuracy", "reference", NULL };
  const char *asked[SCENE_COLUMNS + 1] = { NULL };
  int count = 0;
  bool is_series = strcmp(w->what, "series") == 0, is_error = strcmp(w->what, "error") == 0;
  if (!keys_known(r, at, keys, "this want") || !read_accuracy(r, at, w)
      || !read_member_texts(r, at, "columns", asked, SCENE_COLUMNS, &count))
    return false;
  const config_setting_t *idle = is_series || is_error                 ? NULL
                                 : config_setting_get_member(at, "of") ? config_setting_get_member(at, "of")
                                                                       : config_setting_get_member(at, "source");
  if (idle)
    return refuse_at(r, idle, "%s is for what = \"series\", \"error\" and \"orders\"", config_setting_name(idle));
  if (count > 0)
    return add_columns(r, config_setting_get_member(at, "columns"), w, asked);
  return add_labels(r, at, w)
         && (is_series || is_error            ? series_columns(r, at, w, is_error)
             : strcmp(w->what, "steady") == 0 ? steady_columns(r, at, w)
                                              : phase_columns(r, at, w));
}

static bool read_trajectory(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  static const char *const keys[] = { "what",    "file",    "format", "digits", "columns",
                                      "periods", "samples", "until",  "plot",   NULL };
  static const char *const usual[] = { "t", "x1", "x2", "xC", "v1", "v2", "l", NULL };
  const char *asked[SCENE_COLUMNS + 1] = { NULL };
  const config_setting_t *until = config_setting_get_member(at, "until");
  int count = 0;
  w->kind = WANT_TRAJECTORY;
  w->periods = 10;
  w->samples = 40;
  w->until = (struct scene_end){ .number = INFINITY };
  if (!keys_known(r, at, keys, "a trajectory") || !read_member_texts(r, at, "columns", asked, SCENE_COLUMNS, &count)
      || !read_member_count(r, at, "periods", 1, 1000000000, &w->periods)
      || !read_member_count(r, at, "samples", 1, 1000000000, &w->samples) || (until && !read_end(r, until, &w->until)))
    return false;
  if (count > 0)
    return add_columns(r, config_setting_get_member(at, "columns"), w, asked);
  if (!add_labels(r, at, w))
    return false;
  for (int p = 0; p < r->scene->products; p++) /* what varies tells the curves apart */
    for (int g = 0; g < r->scene->product[p].groups; g++)
      for (int v = 0; v < r->scene->product[p].group[g].variables; v++) {
        const struct scene_variable *variable = &r->scene->product[p].group[g].variable[v];
        const char *name = variable->target == TARGET_F1_OVER_F2   ? "F1_over_F2 = F1/F2"
                           : variable->target == TARGET_M1_OVER_M2 ? "m1_over_m2 = m1/m2"
                                                                   : variable->name;
        bool there = variable->target == TARGET_LABEL;
        for (int i = 0; i < w->columns; i++)
          there |= strncmp(w->column[i].name, name, strlen(w->column[i].name)) == 0;
        if (!there && !read_column(r, at, w, name))
          return false;
      }
  return add_columns(r, at, w, usual);
}

/* T varies, alone, in the last group of each product: an order is one of a row of such points. */
static bool check_times(const struct reading *r, const config_setting_t *at)
{
  const struct scene *s = r->scene;
  for (int p = 0; p < s->products; p++) {
    const struct scene_product *product = &s->product[p];
    const struct scene_group *last = product->groups > 0 ? &product->group[product->groups - 1] : NULL;
    bool is_T = last && last->variables == 1 && last->variable[0].target == TARGET_NUMBER
                && strcmp(last->variable[0].name, "T") == 0;
    if (!is_T || last->count < 3 || last->count > SCENE_TIMES)
      return refuse_at(r, at, "orders need T to vary, alone, in the last group of what varies, with 3 to %d values",
                       SCENE_TIMES);
  }
  return true;
}

static bool read_orders(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  static const char *const keys[] = { "what",     "file",      "format", "digits", "of",   "source", "order",
                                      "accuracy", "reference", "expect", "tol",    "plot", NULL };
  struct series_names names = { .count = 0 };
  w->kind = WANT_ORDERS;
  w->tolerance = 0.1;
  w->has_expect = config_setting_get_member(at, "expect") != NULL;
  if (!keys_known(r, at, keys, "orders") || !read_accuracy(r, at, w) || !read_series(r, at, &names)
      || !read_member_number(r, at, "expect", &w->expect) || !read_member_number(r, at, "tol", &w->tolerance)
      || !check_times(r, at))
    return false;
  if (!(w->tolerance > 0))
    return refuse_at(r, config_setting_get_member(at, "tol"), "tol is a number > 0");
  for (w->series = 0; w->series < names.count; w->series++) {
    const char *name = keep_text(r, "error.", 6, names.name[w->series]);
    int place = name ? quantity_named(&r->scene->quantities, name) : -1;
    if (place < 0)
      return name && refuse_quantity(r, at, names.name[w->series]);
    if (!check_quantity(r, at, w, place))
      return false;
    w->of[w->series] = place;
  }
  return true;
}

/* ---- a command at each point ---- */

static const struct {
  const char *what;
  const struct command *command;
  const char *first; /* an option that is always given, or NULL */
} commands_of[] = { { "terms", &command_series, "--source=derived" }, { "bounds", &command_series, "--bound" },
                    { "breakdown", &command_breakdown, NULL },        { "stability", &command_stress, NULL },
                    { "work-precision", &command_workprec, NULL },    { "claims", &command_claims, NULL } };
enum { COMMANDS_OF = sizeof commands_of / sizeof *commands_of };

/* A member of the want as "--name value" */
static bool add_arguments(const struct reading *r, const config_setting_t *at, struct scene_want *w, int *count)
{
  const char *name = config_setting_name(at), *texts[2] = { NULL };
  int type = config_setting_type(at), values = is_sequence(at) ? config_setting_length(at) : 1;
  char number[NUMBER_TEXT];
  if (*count + 4 > MOST_ARGUMENTS)
    return refuse_at(r, at, "too many options");
  if (type == CONFIG_TYPE_BOOL && !config_setting_get_bool(at))
    return true;
  w->arguments[*count] = (char *)keep_text(r, "--", 2, name);
  if (!w->arguments[(*count)++])
    return false;
  for (int i = 0; i < values && type != CONFIG_TYPE_BOOL; i++) {
    const config_setting_t *element = is_sequence(at) ? config_setting_get_elem(at, (unsigned)i) : at;
    double x;
    if (values > 2 || !(config_setting_get_string(element) || is_number(element, &x, &texts[0])))
      return refuse_at(r, at, "%s takes what it takes on the command line: a number, a text, or true", name);
    const char *text = config_setting_get_string(element);
    if (!text) {
      number_text(number, x, 0);
      text = keep_text(r, number, 0, number);
    }
    if (!text)
      return false;
    w->arguments[(*count)++] = (char *)text;
  }
  return true;
}

static bool accepts(const struct command *command, const char *name)
{
  for (const char *const *a = command->accepts; *a; a++)
    if (strcmp(*a, name) == 0)
      return true;
  return false;
}

/* Parameters that vary must be ones that the command takes. */
static bool check_varied(const struct reading *r, const config_setting_t *at, const struct scene_want *w)
{
  const struct scene *s = r->scene;
  bool no_T = w->command == &command_breakdown && !config_setting_get_member(at, "map");
  for (int p = 0; p < s->products; p++)
    for (int g = 0; g < s->product[p].groups; g++)
      for (int v = 0; v < s->product[p].group[g].variables; v++) {
        const struct scene_variable *variable = &s->product[p].group[g].variable[v];
        const char *name = variable->target == TARGET_F1_OVER_F2   ? "F1"
                           : variable->target == TARGET_M1_OVER_M2 ? "m1"
                           : variable->target == TARGET_FROUDE     ? "T"
                                                                   : variable->name;
        if (variable->target != TARGET_LABEL && (!accepts(w->command, name) || (no_T && strcmp(name, "T") == 0)))
          return refuse_at(r, at, "%s varies, and %s does not take it%s", variable->name, w->what,
                           no_T ? " without a map" : "");
      }
  return true;
}

static bool read_command(const struct reading *r, const config_setting_t *at, struct scene_want *w, int kind)
{
  static const char *const own[] = { "what", "file", "format", "plot", NULL };
  struct options trial;
  int count = 0, code = EXIT_DONE;
  w->kind = WANT_COMMAND;
  w->command = commands_of[kind].command;
  w->arguments = calloc(MOST_ARGUMENTS + 1, sizeof *w->arguments);
  if (!w->arguments)
    return refuse_at(r, at, "out of memory");
  w->arguments[count++] = "scallop";
  w->arguments[count++] = (char *)w->command->name;
  if (commands_of[kind].first && !config_setting_get_member(at, "source"))
    w->arguments[count++] = (char *)keep_text(r, commands_of[kind].first, (int)strlen(commands_of[kind].first), "");
  for (int i = 0; i < config_setting_length(at); i++) {
    const config_setting_t *member = config_setting_get_elem(at, (unsigned)i);
    int k = 0;
    while (own[k] && strcmp(config_setting_name(member), own[k]) != 0)
      k++;
    if (!own[k] && !add_arguments(r, member, w, &count))
      return false;
  }
  w->argument_count = count;
  bool read = options_read(&trial, w->command, count, w->arguments, &code);
  options_free(&trial);
  if (!read)
    return refuse_at(r, at, "so these options of `scallop %s` cannot be wanted", w->command->name);
  return check_varied(r, at, w);
}

/* ---- plots ---- */

static bool has_column(const struct scene_want *w, const char *name)
{
  for (int i = 0; i < w->columns; i++)
    if (strcmp(w->column[i].name, name) == 0)
      return true;
  return w->columns == 0; /* a command's own, or those of orders: it will show */
}

static bool read_plot(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  static const char *const keys[] = { "file", "script", "x", "y", "by", "log_x", "log_y", NULL };
  struct scene_plot *p = &w->plot;
  int count = 0;
  w->has_plot = true;
  if (!config_setting_is_group(at))
    return refuse_at(r, at, "plot is a group: { file = \"error.svg\"; x = \"T\"; y = \"error\"; }");
  if (!keys_known(r, at, keys, "a plot") || !read_member_text(r, at, "file", &p->file)
      || !read_member_text(r, at, "script", &p->script) || !read_member_text(r, at, "x", &p->x)
      || !read_member_text(r, at, "by", &p->by)
      || !read_member_texts(r, at, "y", p->y, (int)(sizeof p->y / sizeof *p->y) - 1, &count)
      || !read_member_flag(r, at, "log_x", &p->log_x) || !read_member_flag(r, at, "log_y", &p->log_y))
    return false;
  if (!p->file)
    return refuse_at(r, at, "a plot needs a file: one that ends in .svg, .png or .pdf");
  const char *dot = strrchr(p->file, '.');
  if (!dot || (strcmp(dot, ".svg") != 0 && strcmp(dot, ".png") != 0 && strcmp(dot, ".pdf") != 0))
    return refuse_at(r, at, "'%.200s': a plot's file ends in .svg, .png or .pdf", p->file);
  if (!w->file || w->format != FORMAT_TSV)
    return refuse_at(r, at, "a plot is made from a table in a file, format tsv: this want needs file = \"...\"");
  if (p->script) {
    p->script = path_beside(r, p->script);
    return p->script != NULL;
  }
  if (!p->x || count == 0)
    return refuse_at(r, at, "a plot without a script of its own needs x and y, columns of the table");
  const char *all[] = { p->x, p->by };
  for (int i = 0; i < 2; i++)
    if (all[i] && !has_column(w, all[i]))
      return refuse_at(r, at, "the table has no column %s", all[i]);
  for (int i = 0; i < count; i++)
    if (!has_column(w, p->y[i]))
      return refuse_at(r, at, "the table has no column %s", p->y[i]);
  return true;
}

/* ---- all of them ---- */

static bool read_output(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  const char *format = NULL;
  const config_setting_t *digits = config_setting_get_member(at, "digits");
  bool beyond = strcmp(w->what, "steady") == 0 || strcmp(w->what, "phase") == 0 || w->kind == WANT_COMMAND;
  if (!read_member_text(r, at, "file", &w->file) || !read_member_text(r, at, "format", &format)
      || !read_member_count(r, at, "digits", 1, beyond ? MOST_DIGITS : DOUBLE_DIGITS, &w->digits))
    return false;
  if (w->file && strcmp(w->file, "-") == 0)
    w->file = NULL;
  if (format && strcmp(format, "tsv") != 0 && strcmp(format, "json") != 0)
    return refuse_at(r, config_setting_get_member(at, "format"), "format is \"tsv\" or \"json\"");
  w->format = format && *format == 'j' ? FORMAT_JSON : FORMAT_TSV;
  (void)digits;
  return true;
}

static bool read_want(const struct reading *r, const config_setting_t *at)
{
  struct scene_want *w = &r->scene->want[r->scene->wants++];
  w->column = calloc(SCENE_COLUMNS, sizeof *w->column);
  if (!w->column)
    return refuse_at(r, at, "out of memory");
  if (!config_setting_is_group(at))
    return refuse_at(r, at, "want is a list of groups: ( { what = \"steady\"; file = \"steady.tsv\"; } )");
  if (!read_member_text(r, at, "what", &w->what))
    return false;
  if (!w->what)
    return refuse_at(r, at, "what is wanted? what = \"steady\", for one");
  int k = 0, command = 0;
  while (whats[k] && strcmp(w->what, whats[k]) != 0)
    k++;
  while (command < COMMANDS_OF && strcmp(w->what, commands_of[command].what) != 0)
    command++;
  if (!whats[k]) {
    const char *near = nearest(w->what, whats);
    return refuse_at(
        r, at,
        "'%.80s' cannot be wanted%s%s%s: one of trajectory, phase, steady, series, error, orders, terms, bounds, "
        "breakdown, stability, work-precision and claims can",
        w->what, near ? "; did you mean '" : "", near ? near : "", near ? "'?" : "");
  }
  w->kind = command < COMMANDS_OF ? WANT_COMMAND : WANT_ROWS;
  const config_setting_t *plot = config_setting_get_member(at, "plot");
  if (!read_output(r, at, w))
    return false;
  bool read = command < COMMANDS_OF                ? read_command(r, at, w, command)
              : strcmp(w->what, "trajectory") == 0 ? read_trajectory(r, at, w)
              : strcmp(w->what, "orders") == 0     ? read_orders(r, at, w)
                                                   : read_rows(r, at, w);
  return read && (!plot || read_plot(r, plot, w));
}

bool read_wants(const struct reading *r, const config_setting_t *want)
{
  int count = !want ? 0 : config_setting_is_list(want) ? config_setting_length(want) : 1;
  if (count == 0)
    return refuse_at(r, want, "nothing is wanted: want = ( { what = \"steady\"; } );");
  if (count > SCENE_WANTS)
    return refuse_at(r, want, "%d wants: %d at most", count, SCENE_WANTS);
  for (int i = 0; i < count; i++)
    if (!read_want(r, config_setting_is_list(want) ? config_setting_get_elem(want, (unsigned)i) : want))
      return false;
  return true;
}
