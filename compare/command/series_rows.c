/* Series at points: a row for each point; for each series the order along T; or, at one point, a row for each published
 * formula. */
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "asymptotics/observed/order.h"
#include "compare/formulas/formula_file.h"
#include "compare/command/series_options.h"
#include "compare/points/counts.h"

enum { MAX_SERIES = 96, SERIES_NAME = 2 * QUANTITY_NAME, MAX_TIMES = 4096 };
struct series_names {
  int count;
  char name[MAX_SERIES][SERIES_NAME];
};

bool series_are_rows(const struct series_options *o)
{
  return o->rows || o->orders || (has_many_points(&o->request) && !o->symbolic && !o->bound);
}

/* Returns true for formulas of the scene: of the steady state, or, for a scene about a phase, of this phase and its
 * start, except formulas that take t1 and the like as given. */
static bool is_of_scene(const struct request *r, const struct scallop_formula *f, bool of_contraction)
{
  if (!r->scene->is_about_phase || f->setting == SCALLOP_STEADY)
    return !r->scene->is_about_phase && f->setting == SCALLOP_STEADY;
  bool rests = !r->required->from_steady && r->point.v0 == 0 && is_constant(r, "v0");
  return of_contraction == (r->point.phase == SCALLOP_CONTRACTION) && (f->setting == SCALLOP_AT_REST_START) == rests
         && !formula_takes_given(f);
}

/* Adds a formula; one of a phase from rest is for both phases. */
static void add_formula(struct series_names *list, const struct series_options *o, const struct scallop_formula *f)
{
  const struct request *r = &o->request;
  int phases = f->setting == SCALLOP_AT_REST_START ? 2 : 1;
  for (int i = 0; i < phases && list->count < MAX_SERIES; i++)
    if (!r->scene || is_of_scene(r, f, i == 1 || f->setting == SCALLOP_MOVING_CONTRACTION))
      snprintf(list->name[list->count++], SERIES_NAME, "%s%s", f->name, i == 1 ? ":contraction" : "");
}

static void add_derived(struct series_names *list, const struct series_options *o)
{
  bool of_phase = o->request.scene ? o->request.scene->is_about_phase : o->request.point.has_v0;
  enum quantity_of of = of_phase ? OF_PHASE : OF_STEADY;
  const char *kind = is_from(o, "derived") ? wrong_text("derived_%ld.", o->order.value) : "limit.";
  for (int q = quantity_first(of); q < (int)quantity_end(of); q++)
    if (quantity_rows[q].has_series)
      snprintf(list->name[list->count++], SERIES_NAME, "%s%s", kind, quantity_rows[q].name);
}

static bool has_name(const struct series_names *list, const char *name)
{
  bool has = false;
  for (int i = 0; i < list->count; i++)
    has |= strcmp(list->name[i], name) == 0;
  return has;
}

/* Adds all series, or the series of --only: in a scene in the given order, else formulas of the list first. */
static void add_names(struct series_names *list, const struct series_options *o)
{
  const char *rest = o->only;
  const struct scallop_formula *f;
  bool in_given_order = o->only && o->request.scene;
  if (!is_from(o, "published"))
    add_derived(list, o);
  else
    for (int i = 0; !in_given_order && (f = listed_formula(i)); i++)
      if (!o->only || formula_is_listed(o->only, f->name))
        add_formula(list, o, f);
  while (list->count < MAX_SERIES && next_item(list->name[list->count], SERIES_NAME, &rest)) {
    f = in_given_order ? NULL : formula_named(list->name[list->count]);
    list->count += !f || !has_name(list, f->name);
  }
}

/* Returns NULL, or an error: rows of points take any series, the table of one point formulas only. */
static const char *no_series(const struct series_options *o, const char *name)
{
  struct quantities *all = &o->request.required->quantities;
  int place = quantity_named(all, name);
  if (!series_are_rows(o) && (place < 0 || all->item[place].kind != QUANTITY_PUBLISHED))
    return wrong_text("--only: there is no formula '%s' here%s", name, formula_hint(name));
  if (place < 0)
    return unknown_quantity_error(o->request.required, name);
  return quantity_is_series(&all->item[place])
             ? NULL
             : wrong_text("%s is no series: a formula of the paper, derived_8.displacement or limit.displacement is "
                          "meant",
                          name);
}

/* Reads the parts of each series in a row; the default is its value, with --only the exact value and the relative error
 * too. Returns NULL, or an error. */
static const char *read_parts(bool has[4], const struct series_options *o)
{
  static const char *const parts[] = { "value", "exact", "error", "relative", NULL };
  char item[SERIES_NAME];
  const char *rest = o->parts ? o->parts : o->only ? "value,exact,relative" : "value";
  while (next_item(item, sizeof item, &rest)) {
    int part = word_place(item, parts);
    if (part < 0)
      return not_allowed(item, "parts of a series: value, exact, error and relative");
    has[part] = true;
  }
  return NULL;
}

static const char *plan_points(const struct series_options *o, struct rows *rows, const struct series_names *list)
{
  static const char *const prefixes[] = { "", "exact.", "error.", "relative." };
  bool has[4] = { false };
  const char *wrong = read_parts(has, o);
  rows->has_parameters = true;
  rows->extra[0] = !o->request.scene || o->request.scene->is_about_phase ? "v0" : NULL;
  for (int i = 0; !wrong && i < list->count; i++)
    for (int k = 0; k < 4 && !wrong; k++)
      wrong = has[k] ? rows_own(rows, "%s%s", prefixes[k], list->name[i]) : NULL;
  return wrong ? wrong : rows_own(rows, "status");
}

/* State of tables with a row for each series: the quantity that compares it with its exact value */
struct compared {
  int count, quantity[MAX_SERIES];
  int steady;                         /* v_start: without its value, no row is written */
  long times;                         /* count of T so far */
  struct scallop_order_point point[]; /* of orders, MAX_TIMES for each series: its errors */
};

static const char *begin_compared(struct rows *rows, const struct series_names *list, const char *kind, size_t times)
{
  struct quantities *all = &rows->sheet.required->quantities;
  struct compared *c = rows->context = calloc(1, sizeof *c + (size_t)list->count * times * sizeof *c->point);
  if (!c)
    return rows_no_memory;
  for (; c->count < list->count; c->count++)
    c->quantity[c->count] = quantity_named(all, wrong_text("%s.%s", kind, list->name[c->count]));
  c->steady = quantity_named(all, "v_start");
  return NULL;
}

/* Orders of errors in T, the variable that varies fastest */

/* Returns the rounding error of a difference of doubles, some ulp of them. */
static double noise(const struct at *at, int error)
{
  const struct series_error *c = &at->comparison[at->required->quantities.item[error].of];
  return at->certified_errors ? 0 : 8 * DBL_EPSILON * fmax(fabs(c->exact), fabs(c->exact + c->error));
}

static void write_order(struct rows *rows, struct at *at, int series)
{
  struct compared *all = rows->context;
  const struct series_options *o = (const void *)rows->request;
  const struct quantity *item = at->required->quantities.item;
  const struct scallop_order_wanted wanted = { .order = o->expect.given ? o->expect.value : NAN,
                                               .tolerance = o->tolerance.value };
  struct table *t = &rows->table;
  struct scallop_order_result result;
  int count = (int)all->times;
  scallop_order(all->point + (size_t)series * MAX_TIMES, &count, &wanted, &result);
  /* an error that this accuracy cannot distinguish from 0 is 0 */
  if (result.verdict <= SCALLOP_ORDER_MEASURED && isnan(result.order))
    result.verdict = SCALLOP_ORDER_FLOOR_LIMITED;
  sheet_row(&rows->sheet, t, at);
  table_text(t, item[item[all->quantity[series]].of].name);
  table_rounded(t, result.order, "%.4f");
  table_rounded(t, result.low, "%.4f");
  table_rounded(t, result.high, "%.4f");
  table_text(t, scallop_order_interval_text(result.interval));
  table_rounded(t, result.used, "%.0f");
  table_number(t, wanted.order);
  table_number(t, o->expect.given ? wanted.tolerance : NAN);
  table_text(t, scallop_order_verdict_text(result.verdict));
  table_text(t, result.reason);
  rows->failed_checks += o->expect.given && result.verdict != SCALLOP_ORDER_PASS;
  count_add(COUNT_ORDERS, 1);
}

/* Keeps the errors of a point; writes the rows after the last T. */
static void visit_orders(struct rows *rows, struct at *at)
{
  struct compared *all = rows->context;
  for (int i = 0; i < all->count; i++)
    all->point[(long)i * MAX_TIMES + all->times] = (struct scallop_order_point){ .h = at->place.point.crawler.T,
                                                                                 .err = at_number(at, all->quantity[i]),
                                                                                 .noise = noise(at, all->quantity[i]) };
  all->times++;
  if (!at->place.ends_group)
    return;
  for (int i = 0; i < all->count; i++)
    write_order(rows, at, i);
  all->times = 0;
}

/* Returns true if T varies, alone, in the last group of each product. */
static bool T_varies(const struct sweep *s)
{
  bool fine = s->products > 0;
  for (int p = 0; p < s->products && fine; p++) {
    const struct sweep_product *product = &s->product[p];
    const struct sweep_group *last = product->groups > 0 ? &product->group[product->groups - 1] : NULL;
    fine = last && last->variables == 1 && last->variable[0].target == TARGET_NUMBER && last->variable[0].name[0] == 'T'
           && last->count >= 3 && last->count <= MAX_TIMES;
  }
  return fine;
}

static const char *plan_orders(const struct series_options *o, struct rows *rows, const struct series_names *list)
{
  static const char *const columns[] = { "series", "order",     "order_low", "order_high", "interval", "points",
                                         "expect", "tolerance", "verdict",   "reason",     NULL };
  if (!T_varies(&o->request.sweep))
    return wrong_text("orders need T to vary, alone, in the last group of what varies, with 3 to %d values", MAX_TIMES);
  const char *wrong = begin_compared(rows, list, "error", MAX_TIMES);
  rows->has_errors = true;
  rows->visit = visit_orders;
  rows->behind = columns;
  for (int i = 0; crawler_parameters[i] && !wrong; i++)
    wrong = strcmp(crawler_parameters[i], "T") == 0 ? NULL : rows_own(rows, "%s", crawler_parameters[i]);
  return wrong;
}

/* One point: a row for each formula */

static void head(struct rows *rows)
{
  static const char no_ends[] = "l'' = 0 where a phase of this gait begins or ends: formulas that divide by it are nan";
  const struct point *point = &rows->request->point;
  char v0[80] = "the exact steady velocity at the start of each phase";
  if (point->has_v0)
    number_text(v0, point->v0, 0);
  table_note(&rows->table, "v0: %s", v0);
  if (gait_has_ends(point->crawler.gait))
    return;
  table_note(&rows->table, "%s", no_ends);
  if (!rows->request->style.quiet)
    complain("series", "%s", no_ends);
}

static void write_formula(struct table *table, const struct quantity *series, double published, double exact)
{
  static const char *const phases[] = { "extension", "contraction" };
  const struct scallop_formula *f = series->formula;
  enum scallop_phase_kind kind = series->phase > 0 ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION;
  const int n = f->remainder;
  table_text(table, f->name);
  table_text(table, f->equation);
  table_text(table, f->setting == SCALLOP_STEADY ? "period" : phases[kind]);
  table_text(table, formula_quantity_text(f, kind));
  table_text(table, n <= 0 ? "-" : n == 1 ? "O(T)" : wrong_text("O(T^%d)", n));
  table_number(table, published);
  table_number(table, exact);
  table_number(table, published - exact);
}

static void visit_formulas(struct rows *rows, struct at *at)
{
  const struct compared *all = rows->context;
  const struct quantity *item = at->required->quantities.item;
  at_number(at, all->steady);
  if (at->why[0] != '\0' || !rows_open(rows))
    return;
  for (int i = 0; i < all->count; i++) {
    int exact = all->quantity[i], series = item[exact].of;
    write_formula(&rows->table, &item[series], at_number(at, series), at_number(at, exact));
  }
  at_begin_row(at); /* a formula without a value is no failure of the point */
}

static const char *plan_formulas(const struct series_options *o, struct rows *rows, const struct series_names *list)
{
  static const char *const columns[] = { "formula",   "equation", "phase", "quantity", "remainder",
                                         "published", "exact",    "error", NULL };
  if (o->request.style.digits > DIGITS_OF_DOUBLE)
    return "--digits: a double has 17; with --source derived or limit there are up to 10000";
  rows->of = "published";
  rows->opens_late = true;
  rows->notes_parameters = true;
  rows->head = head;
  rows->behind = columns;
  rows->visit = visit_formulas;
  return begin_compared(rows, list, "exact", 0);
}

const char *series_plan(const void *options, struct rows *rows)
{
  const struct series_options *o = options;
  struct requirements *required = rows->sheet.required;
  struct series_names list = { .count = 0 };
  const char *wrong = NULL;
  if (!o->request.scene) {
    required->from_steady = required->v0_only_if_given = !o->request.point.has_v0;
    required->accuracy = 0;
  }
  add_names(&list, o);
  for (int i = 0; i < list.count && !wrong; i++)
    wrong = no_series(o, list.name[i]);
  return wrong ? wrong : (o->orders ? plan_orders : series_are_rows(o) ? plan_points : plan_formulas)(o, rows, &list);
}
