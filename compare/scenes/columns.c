/* Quantities and formulas in a scene, and the columns of a want: what is asked for, or what its kind has. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/scenes/parts.h"

enum { FORMULA_TEXT = 400 };

const char *const series_sources[] = { "published", "derived", "limit", NULL };
enum { PUBLISHED, DERIVED };

static int place_of(void *scene, const char *name) { return quantity_named(&((struct scene *)scene)->quantities, name); }
static const char *near_to(void *scene, const char *name)
{
  return quantity_near(&((struct scene *)scene)->quantities, name);
}

const char *read_formula(const struct reading *r, struct formula *formula, const char *text)
{
  static char message[FORMULA_MESSAGE];
  const struct formula_names names = { place_of, near_to, r->scene };
  return formula_read(formula, text, &names, message);
}

bool refuse_quantity(const struct reading *r, const config_setting_t *at, const char *name)
{
  const char *near = quantity_near(&r->scene->quantities, name);
  return refuse_at(r, at, "there is no quantity '%s'%s (docs/scenes.md lists them)", name, did_you_mean(near));
}

/* Is the quantity known before anything is solved at a point? */
static bool is_of_parameters(const struct quantity *q)
{
  return q->kind == QUANTITY_NUMBER || q->kind == QUANTITY_ONSET || q->kind == QUANTITY_FROUDE
         || q->kind == QUANTITY_F1_OVER_F2 || q->kind == QUANTITY_M1_OVER_M2;
}

bool read_end(const struct reading *r, const config_setting_t *at, struct sweep_end *end, bool *onset)
{
  const char *text, *name = config_setting_name(at);
  int places[FORMULA_STEPS];
  if (is_number(at, &end->number, &text))
    return isfinite(end->number) || refuse_at(r, at, "%s is a finite number", name);
  if (!text)
    return refuse_at(r, at, "%s is a number, or a formula in quotes", name);
  const char *wrong = read_formula(r, &end->formula, text);
  if (wrong)
    return refuse_at(r, at, "%s = \"%.100s\": %s", name, text, wrong);
  end->is_formula = true;
  for (int i = formula_places(&end->formula, places); i-- > 0;) {
    const struct quantity *q = &r->scene->quantities.item[places[i]];
    *onset |= q->kind == QUANTITY_ONSET;
    if (!is_of_parameters(q))
      return refuse_at(r, at,
                       "%s is a formula of m1 m2 F1 F2 L T alpha F1_over_F2 m1_over_m2 froude and sticking_onset, not of %s",
                       name, q->name);
  }
  return true;
}

/* Does a scene like this one have the quantity? */
bool check_quantity(const struct reading *r, const config_setting_t *at, const struct scene_want *w, int place)
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
  if ((series->kind == QUANTITY_DERIVED || series->kind == QUANTITY_LIMIT) && quantity_rows[series->which].of == OF_PHASE
      && s->start == START_STEADY && !s->varies_v0)
    return refuse_at(r, at, "%s is derived for a start that stays the same as T falls: start = \"rest\", or a velocity",
                     q->name);
  return true;
}

/* "NAME = FORMULA" or "FORMULA" */
bool read_column(const struct reading *r, const config_setting_t *at, struct scene_want *w, const char *text)
{
  struct scene_column *column = &w->column[w->columns];
  const char *equals = strchr(text, '='), *formula = equals ? equals + 1 : text;
  formula += strspn(formula, " ");
  size_t length = equals ? (size_t)(equals - text) : strlen(text);
  while (length > 0 && text[length - 1] == ' ')
    length--;
  bool is_plain = true;
  for (size_t i = 0; i < length; i++)
    is_plain &= text[i] > ' ' && text[i] < 0x7f && text[i] != '"' && text[i] != '\\' ? true : text[i] == ' ';
  if (!is_plain)
    return refuse_at(r, at, "'%.100s': the name of a column is of ASCII, without tabs, quotes and backslashes", text);
  if (length == 0 || *formula == '\0')
    return refuse_at(r, at, "'%.100s' is no column: it takes \"QUANTITY\" or \"NAME = FORMULA\"", text);
  column->name = keep_text(r, text, (int)length, "");
  column->quantity = quantity_named(&r->scene->quantities, formula);
  if (column->quantity == -2)
    return refuse_at(r, at, "more than %d quantities", MOST_QUANTITIES);
  if (column->quantity < 0) {
    const char *wrong = read_formula(r, &column->formula, formula);
    if (wrong && formula[strcspn(formula, "+-*/^() ")] == '\0')
      return refuse_quantity(r, at, formula);
    if (wrong)
      return refuse_at(r, at, "'%.100s': %s", text, wrong);
    int places[FORMULA_STEPS], count = formula_places(&column->formula, places);
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

bool add_columns(const struct reading *r, const config_setting_t *at, struct scene_want *w, const char *const *names)
{
  for (; *names; names++) {
    if (w->columns == SCENE_COLUMNS)
      return refuse_at(r, at, "more than %d columns", SCENE_COLUMNS);
    if (!read_column(r, at, w, *names))
      return false;
  }
  return true;
}

bool add_labels(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  for (int i = 0; i < r->scene->quantities.labels; i++)
    if (!read_column(r, at, w, r->scene->quantities.label[i]))
      return false;
  return true;
}

/* The numbers of a motion, in doubles or certified. */
bool motion_columns(const struct reading *r, const config_setting_t *at, struct scene_want *w, enum quantity_of of)
{
  static const char *const start[] = { "phase", "v0", NULL }, *const status[] = { "status", NULL };
  static const char *const how[][3] = {
    [OF_STEADY] = { "regime", "modes", NULL }, [OF_PHASE] = { "regime = phase_regime", "modes = phase_modes", NULL }
  };
  bool doubles = w->digits <= DIGITS_OF_DOUBLE;
  if (!add_columns(r, at, w, crawler_parameters) || (of == OF_PHASE && !add_columns(r, at, w, start)))
    return false;
  for (int q = quantity_first(of); q < (int)quantity_end(of); q++) {
    const char *name = quantity_rows[q].name;
    char column[FORMULA_TEXT];
    snprintf(column, sizeof column, doubles ? "%s" : "%s = certified.%s", name, name);
    if ((doubles || q != Q_FROUDE) && !read_column(r, at, w, column)) /* froude is known without a solution */
      return false;
  }
  return (!doubles || add_columns(r, at, w, how[of])) && add_columns(r, at, w, status);
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

static bool usual_series(const struct reading *r, struct series_names *names)
{
  enum quantity_of of = is_about_phase(r) ? OF_PHASE : OF_STEADY;
  if (names->source == PUBLISHED) {
    for (const struct scallop_formula *f = scallop_published; f->name && names->count < SCENE_COLUMNS; f++)
      if (is_at_hand(r, f))
        names->name[names->count++] = f->name;
    return true;
  }
  char head[40];
  int length = snprintf(head, sizeof head, names->source == DERIVED ? "derived_%ld." : "limit.", names->order);
  for (int q = quantity_first(of); q < (int)quantity_end(of); q++)
    if (quantity_rows[q].has_series && !(names->name[names->count++] = keep_text(r, head, length, quantity_rows[q].name)))
      return false;
  return true;
}

bool find_series(const struct reading *r, const config_setting_t *at, struct series_names *names)
{
  const config_setting_t *of = config_setting_get_member(at, "of");
  if (!of)
    return usual_series(r, names);
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

bool series_columns(const struct reading *r, const config_setting_t *at, struct scene_want *w, struct series_names *names,
                    bool with_errors)
{
  static const char *const prefixes[] = { "", "exact.", "error.", "relative." }, *const v0[] = { "v0", NULL },
                           *const status[] = { "status", NULL };
  const int each = with_errors ? 4 : 1;
  if (!find_series(r, at, names) || !add_columns(r, at, w, crawler_parameters)
      || (is_about_phase(r) && !add_columns(r, at, w, v0)))
    return false;
  if (names->count * each > SCENE_COLUMNS - w->columns - 1)
    return refuse_at(r, at, "%d series are more columns than a table has: name some of them, of = [ ... ]", names->count);
  for (int i = 0; i < names->count; i++)
    for (int k = 0; k < each; k++) {
      const char *column = keep_text(r, prefixes[k], (int)strlen(prefixes[k]), names->name[i]);
      if (!column || !read_column(r, at, w, column))
        return false;
    }
  return add_columns(r, at, w, status);
}

int scene_want_quantities(const struct scene_want *w, int places[WANT_QUANTITIES])
{
  int count = 0;
  for (int i = 0; i < w->columns; i++) {
    const struct scene_column *c = &w->column[i];
    if (c->quantity >= 0)
      places[count++] = c->quantity;
    else
      count += formula_places(&c->formula, places + count);
  }
  if (w->until.is_formula && count <= WANT_QUANTITIES - FORMULA_STEPS)
    count += formula_places(&w->until.formula, places + count);
  for (int i = 0; i < w->series && count < WANT_QUANTITIES; i++)
    places[count++] = w->of[i];
  return count;
}
