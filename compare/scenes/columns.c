/* Quantities and formulas in a scene, and the columns of a want: what is asked for, or what its kind has. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/book/book.h"
#include "compare/columns/columns.h"
#include "compare/scenes/parts.h"
#include "compare/text/values.h"

const char *const series_sources[] = { "published", "derived", "limit", NULL };
enum { PUBLISHED, DERIVED };
const char *const order_columns[] = { "series", "order",     "order_lo", "order_hi", "interval", "points",
                                      "expect", "tolerance", "verdict",  "reason",   NULL };

bool has_column(const struct scene_want *w, const char *name)
{
  return sheet_has(&w->sheet, name) || (w->kind == WANT_ORDERS && name_among(order_columns, name));
}

/* Is the quantity known before anything is solved at a point? */
static bool is_of_parameters(const struct quantity *q)
{
  return q->kind == QUANTITY_NUMBER || q->kind == QUANTITY_ONSET || q->kind == QUANTITY_FROUDE
         || q->kind == QUANTITY_F1_OVER_F2 || q->kind == QUANTITY_M1_OVER_M2;
}

bool read_end(const struct reading *r, const config_setting_t *at, struct sweep_end *end, bool *onset)
{
  const char *text = text_of(r->config, at), *name = config_setting_name(at);
  int places[FORMULA_STEPS];
  if (text && read_number(text, &end->number))
    return true;
  if (!text)
    return refuse_at(r->config, at, "%s is a number, or a formula in quotes", name);
  struct sheet sheet = { .asked = &r->scene->asked };
  const char *wrong = sheet_formula(&sheet, &end->formula, text);
  if (wrong)
    return refuse_at(r->config, at, "%s = \"%.100s\": %s", name, text, wrong);
  end->is_formula = true;
  for (int i = formula_places(&end->formula, places); i-- > 0;) {
    const struct quantity *q = &r->scene->asked.quantities.item[places[i]];
    *onset |= q->kind == QUANTITY_ONSET;
    if (!is_of_parameters(q))
      return refuse_at(
          r->config, at,
          "%s is a formula of m1 m2 F1 F2 L T alpha F1_over_F2 m1_over_m2 froude and sticking_onset, not of %s", name,
          q->name);
  }
  return true;
}

/* Which start a formula of the paper needs that the scene has not, or NULL */
static const char *other_start(const struct scene *s, enum scallop_setting setting)
{
  if (setting == SCALLOP_AT_REST_START && (s->start != START_REST || s->varies_v0))
    return "a phase from rest, and this scene does not start there: start = \"rest\"";
  if (setting == SCALLOP_MOVING_EXTENSION && s->phase != SCALLOP_EXTENSION)
    return "an extension: phase = \"extension\"";
  if (setting == SCALLOP_MOVING_CONTRACTION && s->phase != SCALLOP_CONTRACTION)
    return "a contraction: phase = \"contraction\"";
  return NULL;
}

const char *want_refuses(const struct sheet *sheet, const struct quantity *q)
{
  static char text[160];
  const struct scene_want *w = sheet->context;
  const struct scene *s = w->scene;
  const struct quantity *series = q->of >= 0 ? &s->asked.quantities.item[q->of] : q;
  const char *other = series->kind == QUANTITY_PUBLISHED ? other_start(s, series->formula->setting) : NULL;
  if (q->kind == QUANTITY_SAMPLE && w->kind != WANT_TRAJECTORY)
    return "is a quantity of a trajectory";
  if (w->kind == WANT_TRAJECTORY && q->kind == QUANTITY_STATUS)
    return "is nothing that a trajectory has: it ends where it cannot go on";
  snprintf(text, sizeof text, "is about %s", other ? other : "");
  if (other)
    return text;
  if ((series->kind == QUANTITY_DERIVED || series->kind == QUANTITY_LIMIT)
      && quantity_rows[series->which].of == OF_PHASE && s->start == START_STEADY && !s->varies_v0)
    return "is derived for a start that stays the same as T falls: start = \"rest\", or a velocity";
  return NULL;
}

/* Adds the column "NAME = FORMULA" or "FORMULA". */
static bool add_column(const struct reading *r, const config_setting_t *at, struct scene_want *w, const char *text)
{
  const char *wrong = w->sheet.count == SCENE_COLUMNS ? "there are more than 60 columns" : sheet_add(&w->sheet, text);
  return !wrong || refuse_at(r->config, at, "%s", wrong);
}

bool add_columns(const struct reading *r, const config_setting_t *at, struct scene_want *w, const char *const *texts)
{
  while (*texts)
    if (!add_column(r, at, w, *texts++))
      return false;
  return true;
}

/* Are formulas of the phase meant, where nothing is said? Where the scene says something about a phase. */
static bool is_about_phase(const struct reading *r)
{
  const config_setting_t *root = config_root(r->config);
  return config_setting_get_member(root, "phase") || config_setting_get_member(root, "start") || r->scene->varies_v0;
}

/* The formulas that the scene can evaluate without a solution, or the derived series of its motion */
static bool usual_series(const struct reading *r, struct scene_want *w)
{
  const struct scene *s = r->scene;
  const struct scallop_formula *f;
  bool of_phase = is_about_phase(r), moving = s->start != START_REST || s->varies_v0;
  if (w->source == PUBLISHED) {
    for (int i = 0; (f = listed_formula(i)) && w->series < SCENE_COLUMNS; i++)
      if ((f->setting != SCALLOP_STEADY) == of_phase && (!of_phase || moving || f->setting == SCALLOP_AT_REST_START)
          && !other_start(s, f->setting) && !(of_phase && formula_takes_given(f)))
        w->series_name[w->series++] = f->name;
    return true;
  }
  enum quantity_of of = of_phase ? OF_PHASE : OF_STEADY;
  for (int q = quantity_first(of); q < (int)quantity_end(of); q++) {
    const char *name = quantity_rows[q].name;
    if (!quantity_rows[q].has_series)
      continue;
    name = w->source == DERIVED ? keep(r->config, "derived_%ld.%s", w->order, name) : keep(r->config, "limit.%s", name);
    if (!name)
      return false;
    w->series_name[w->series++] = name;
  }
  return true;
}

bool find_series(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  const config_setting_t *of = config_setting_get_member(at, "of");
  for (int i = 0; i < w->series; i++) {
    int place = quantity_named(&r->scene->asked.quantities, w->series_name[i]);
    if (place < 0)
      return refuse_at(r->config, of, "%s", sheet_no_quantity(&w->sheet, w->series_name[i]));
    if (!quantity_is_series(&r->scene->asked.quantities.item[place]))
      return refuse_at(r->config, of,
                       "%s is no series: a formula of the paper, derived_8.displacement or limit.displacement is meant",
                       w->series_name[i]);
  }
  return of || usual_series(r, w);
}

/* The numbers of a motion, in doubles or certified */
static bool motion_columns(const struct reading *r, const config_setting_t *at, struct scene_want *w,
                           enum quantity_of of)
{
  static const char *const how[][3] = {
    [OF_STEADY] = { "regime", "modes", NULL }, [OF_PHASE] = { "regime = phase_regime", "modes = phase_modes", NULL }
  };
  bool doubles = w->digits <= DIGITS_OF_DOUBLE;
  for (int q = quantity_first(of); q < (int)quantity_end(of); q++) {
    char column[2 * QUANTITY_NAME];
    snprintf(column, sizeof column, doubles ? "%s" : "%s = certified.%s", quantity_rows[q].name, quantity_rows[q].name);
    if ((doubles || q != Q_FROUDE) && !add_column(r, at, w, column)) /* froude is known without a solution */
      return false;
  }
  return !doubles || add_columns(r, at, w, how[of]);
}

static bool series_columns(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  static const char *const prefixes[] = { "", "exact.", "error.", "relative." };
  const int each = strcmp(w->what, "error") == 0 ? 4 : 1;
  if (!find_series(r, at, w))
    return false;
  if (w->series * each > SCENE_COLUMNS - w->sheet.count - 1)
    return refuse_at(r->config, at, "%d series are more columns than a table has: name some of them, of = [ ... ]",
                     w->series);
  for (int i = 0; i < w->series * each; i++) {
    char column[2 * QUANTITY_NAME];
    snprintf(column, sizeof column, "%s%s", prefixes[i % each], w->series_name[i / each]);
    if (!add_column(r, at, w, column))
      return false;
  }
  w->series = 0; /* columns like others now */
  return true;
}

bool usual_columns(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  static const char *const start[] = { "phase", "v0", NULL }, *const status[] = { "status", NULL };
  bool is_steady = strcmp(w->what, "steady") == 0, is_phase = strcmp(w->what, "phase") == 0;
  const struct sweep_variable *v;
  for (int i = 0; i < r->scene->asked.quantities.labels; i++)
    if (!add_column(r, at, w, r->scene->asked.quantities.label[i]))
      return false;
  if (w->kind == WANT_TRAJECTORY) { /* what varies tells the curves apart */
    for (int k = 0; (v = sweep_variable(&r->scene->sweep, k)); k++)
      if (!has_column(w, v->name) && !add_column(r, at, w, v->name))
        return false;
    return add_columns(r, at, w, quantity_samples);
  }
  for (int i = 0; crawler_parameters[i]; i++)
    if ((w->kind != WANT_ORDERS || strcmp(crawler_parameters[i], "T") != 0)
        && !add_column(r, at, w, crawler_parameters[i]))
      return false;
  if (w->kind == WANT_ORDERS)
    return true;
  if (is_phase && !add_columns(r, at, w, start))
    return false;
  if (is_steady || is_phase)
    return motion_columns(r, at, w, is_steady ? OF_STEADY : OF_PHASE) && add_columns(r, at, w, status);
  return (!is_about_phase(r) || add_column(r, at, w, "v0")) && series_columns(r, at, w)
         && add_columns(r, at, w, status);
}

int want_quantities(const struct scene_want *w, int places[WANT_QUANTITIES])
{
  int count = 0;
  for (int i = 0; i < w->sheet.count; i++) {
    const struct sheet_column *c = &w->sheet.column[i];
    if (c->quantity >= 0)
      places[count++] = c->quantity;
    else
      count += formula_places(c->formula, places + count);
  }
  if (w->until.is_formula && count <= WANT_QUANTITIES - FORMULA_STEPS)
    count += formula_places(&w->until.formula, places + count);
  for (int i = 0; i < w->series && count < WANT_QUANTITIES; i++)
    places[count++] = w->of[i];
  return count;
}
