/* breakdown --map X Y: a row for each point of a grid, with the crawler, its steady state, and the errors of the
 * series. */
#define _GNU_SOURCE /* asprintf */
#include "compare/maps/maps.h"

#include <math.h>
#include <string.h>

#include "compare/formulas/formula_file.h"
#include "compare/breakdown/motion.h"
#include "compare/points/defaults.h"

const struct sweep_variable *map_axis(const struct breakdown_options *o, int i)
{
  return &o->request.sweep.product[0].group[1 - i].variable[0];
}

void map_head(struct table *t, const struct breakdown_options *o)
{
  const struct sweep_variable *axes[] = { map_axis(o, 0), map_axis(o, 1) };
  if (o->request.formulas)
    table_note(t, "formulas: %s", o->request.formulas);
  for (int i = 0; i < 2; i++) {
    char from[NUMBER_TEXT], to[NUMBER_TEXT];
    number_text(from, axes[i]->from.number, 0);
    number_text(to, axes[i]->to.number, 0);
    table_note(t, "%c: %s from %s to %s, %ld values, %s", "xy"[i], o -> map[i], from, to, axes[i] -> count,
               axes[i] -> is_log ? "log" : "linear");
  }
  note_parameters(t, &o->request.point, (const char *const[]){ axes[0]->sets, axes[1]->sets, NULL }, false);
}

static void head(struct rows *rows)
{
  const struct breakdown_options *o = (const struct breakdown_options *)rows->request;
  map_head(&rows->table, o);
  table_note(&rows->table,
             "series: of the %s; error: series/exact - 1 at this T; T: the largest up to which its size is below that "
             "number",
             o->quantity.value);
}

struct grid {
  const struct breakdown_options *options;
  struct rows *rows;
  enum quantity_id quantity;
};

/* Returns true if the table has the series: if a picture draws named columns, and no columns are chosen, it has only
 * the series drawn. */
static bool is_drawn(const struct style *style, const char *name)
{
  return !style->plot.file || !style->plot.y || style->choice || formula_is_listed(style->plot.y, name);
}

/* Adds the error of a series, or with tolerances its reach for each: "error_published", "reach_1e-2_published". */
static const char *add_series(const struct grid *g, const char *called, const char *series, const double *tolerances)
{
  const char *wrong = NULL;
  char name[2 * QUANTITY_NAME];
  snprintf(name, sizeof name, "error_%s", called);
  if (!tolerances && is_drawn(&g->options->request.style, name))
    return rows_own(g->rows, "%s = deviation.%s", name, series);
  for (const double *of = tolerances; of && *of > 0 && !wrong; of++) {
    double power = log10(*of);
    bool is_power = power == rint(power);
    snprintf(name, sizeof name, is_power ? "reach_1e%.0f_%s" : "reach_%g_%s", is_power ? power : *of, called);
    if (is_drawn(&g->options->request.style, name))
      wrong = rows_own(g->rows, "%s = reach_%g.%s", name, *of, series);
  }
  return wrong;
}

static bool is_about_quantity(const void *context, const struct scallop_formula *f)
{
  const struct motion steady = { .of = OF_STEADY };
  return series_is_about(f, &steady, *(const enum quantity_id *)context);
}

/* Adds the columns of each formula of the formula files and of each other source; of the paper's formulas it takes the
 * last and simplest. */
static const char *add_all_series(const struct grid *g, const double *tolerances)
{
  const struct breakdown_options *o = g->options;
  const char *wrong = NULL, *quantity = quantity_rows[g->quantity].name, *published = NULL;
  const struct scallop_formula *f;
  for (int i = 0; (f = listed_formula(i)) && !wrong; i++)
    if (!user_formula(i) && is_about_quantity(&g->quantity, f))
      published = f->name;
    else if (user_formula(i) && breakdown_takes(o, FROM_USER) && is_about_quantity(&g->quantity, f))
      wrong = add_series(g, f->name, f->name, tolerances);
  if (!wrong && breakdown_takes(o, FROM_PUBLISHED) && published)
    wrong = add_series(g, "published", published, tolerances);
  const char *derived = wrong_text("derived_%ld", o->order.value);
  if (!wrong && breakdown_takes(o, FROM_DERIVED))
    wrong = add_series(g, derived, wrong_text("%s.%s", derived, quantity), tolerances);
  if (!wrong && breakdown_takes(o, FROM_LIMIT))
    wrong = add_series(g, "limit", wrong_text("limit.%s", quantity), tolerances);
  return wrong;
}

/* Adds the axes, the parameters they set, and the other parameters; F1/F2 as an axis is not F1. */
static const char *add_parameters(const struct grid *g)
{
  static const char *const parameters[] = { "m1", "m2", "F1", "F2", "T", "alpha", "froude", NULL };
  const struct breakdown_options *o = g->options;
  const char *wrong = NULL;
  for (int i = 0; i < 2 && !wrong; i++)
    wrong = rows_own(g->rows, strchr(o->map[i], '/') ? "%s = %s" : "%s", o->map[i], map_axis(o, i)->name);
  for (const char *const *p = parameters; *p && !wrong; p++)
    wrong = strcmp(*p, o->map[0]) == 0 || strcmp(*p, o->map[1]) == 0 ? NULL : rows_own(g->rows, "%s", *p);
  return wrong;
}

const char *breakdown_map(const struct breakdown_options *o, struct rows *rows)
{
  static const char *const states[] = { "modes", "regime", "v_start", "displacement", "mean_velocity", NULL };
  static const double usual[] = { BREAKDOWN_MAP_TOLERANCES, 0 };
  const double given[] = { o->tolerance.value, 0 };
  struct grid g = { o, rows, quantity_of_name(o->quantity.value) };
  const char *what = wrong_text("the %s of the steady state", quantity_rows[g.quantity].name);
  char *command;
  if (!formula_file_applies("breakdown", o->request.formulas, is_about_quantity, &g.quantity, what))
    return "";
  rows->of = "map";
  if (asprintf(&command, "breakdown --map %s %s", o->map[0], o->map[1]) < 0)
    return rows_no_memory;
  rows->command = rows->context = command;
  rows->head = head;
  const char *wrong = add_parameters(&g);
  for (const char *const *s = states; *s && !wrong; s++)
    wrong = rows_own(rows, "%s", *s);
  wrong = wrong ? wrong : add_all_series(&g, NULL);
  wrong = wrong ? wrong : add_all_series(&g, o->tolerance.given ? given : usual);
  return wrong ? wrong : rows_own(rows, "status");
}
