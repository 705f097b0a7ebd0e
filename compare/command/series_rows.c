/* scallop series with a row for each point, or for each row of points along T. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/observed/order.h"
#include "compare/book/book.h"
#include "compare/command/series_options.h"
#include "compare/points/counts.h"

/* Each formula that is asked for, once for each motion that it is about. Returns how many. */
int series_uses(struct series_use uses[MOST_SERIES], const struct series_options *o)
{
  int n = 0;
  const struct scallop_formula *f;
  for (int i = 0; (f = listed_formula(i)) && n <= MOST_SERIES - 2; i++) {
    if (o->only && !formula_is_listed(o->only, f->name))
      continue;
    if (f->setting == SCALLOP_STEADY)
      uses[n++] = (struct series_use){ f, PERIOD };
    if (f->setting == SCALLOP_AT_REST_START || f->setting == SCALLOP_MOVING_EXTENSION)
      uses[n++] = (struct series_use){ f, SCALLOP_EXTENSION };
    if (f->setting == SCALLOP_AT_REST_START || f->setting == SCALLOP_MOVING_CONTRACTION)
      uses[n++] = (struct series_use){ f, SCALLOP_CONTRACTION };
  }
  return n;
}

const char *series_use_name(char name[QUANTITY_NAME], const struct series_use *use)
{
  bool is_other = use->of == SCALLOP_CONTRACTION && use->formula->setting == SCALLOP_AT_REST_START;
  snprintf(name, QUANTITY_NAME, "%s%s", use->formula->name, is_other ? ":contraction" : "");
  return name;
}

/* Of a scene that says nothing of a phase the formulas of the steady state, else those of its phase and its start that
 * take nothing as given */
static bool is_of_scene(const struct series_options *o, const struct series_use *use)
{
  const struct request *r = &o->request;
  enum scallop_setting setting = use->formula->setting;
  if (!r->scene->is_about_phase || setting == SCALLOP_STEADY)
    return !r->scene->is_about_phase && setting == SCALLOP_STEADY;
  bool rests = !r->asked->from_steady && r->point.v0 == 0 && is_held(r, "v0");
  return use->of == (int)r->point.phase && (setting == SCALLOP_AT_REST_START) == rests
         && !formula_takes_given(use->formula);
}

enum { SERIES_NAME = 2 * QUANTITY_NAME };
struct names_of_series {
  int count;
  char name[MOST_SERIES][SERIES_NAME];
};

/* The names of the series in rows */
static void usual_names(struct names_of_series *list, const struct series_options *o)
{
  struct series_use uses[MOST_SERIES];
  bool published = is_from(o, "published");
  char kind[32] = "limit.";
  if (is_from(o, "derived"))
    snprintf(kind, sizeof kind, "derived_%ld.", o->order.value);
  int count = published ? series_uses(uses, o) : 0;
  for (int i = 0; i < count; i++)
    if (!o->request.scene || is_of_scene(o, &uses[i]))
      series_use_name(list->name[list->count++], &uses[i]);
  bool of_phase = o->request.scene ? o->request.scene->is_about_phase : o->request.point.has_v0;
  enum quantity_of of = of_phase ? OF_PHASE : OF_STEADY;
  for (int q = quantity_first(of); q < (int)quantity_end(of) && !published; q++)
    if (quantity_rows[q].has_series)
      snprintf(list->name[list->count++], SERIES_NAME, "%s%s", kind, quantity_rows[q].name);
}

/* Those of --only: in a scene as they stand; else the formulas as they are listed, those of a phase from rest for both
 * phases, and then the others */
static void named(struct names_of_series *list, const struct series_options *o)
{
  struct series_use uses[MOST_SERIES];
  int count = o->request.scene ? 0 : series_uses(uses, o);
  for (int i = 0; i < count; i++)
    series_use_name(list->name[list->count++], &uses[i]);
  const char *rest = o->only;
  while (list->count < MOST_SERIES && next_item(list->name[list->count], SERIES_NAME, &rest))
    list->count += o->request.scene || !formula_named(list->name[list->count]);
}

/* NULL, or what is wrong */
static const char *no_series(const struct series_options *o, const char *name)
{
  static char message[320];
  struct quantities *all = &o->request.asked->quantities;
  int place = quantity_named(all, name);
  if (place < 0)
    return sheet_no_quantity(o->request.asked, name);
  snprintf(message, sizeof message,
           "%s is no series: a formula of the paper, derived_8.displacement or limit.displacement is meant", name);
  return quantity_is_series(&all->item[place]) ? NULL : message;
}

static const char *read_names(struct names_of_series *list, const struct series_options *o)
{
  const char *wrong = NULL;
  list->count = 0;
  (o->only ? named : usual_names)(list, o);
  for (int i = 0; i < list->count && !wrong; i++)
    wrong = no_series(o, list->name[i]);
  return wrong;
}

/* Which parts a row has of each series: its value alone, or of those of --only what they should be, too. NULL, or
 * what is wrong. */
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

/* The orders in T at which the errors fall, T being what varies fastest */

enum { MOST_TIMES = 4096 };

struct orders {                   /* the errors of each series at the T so far */
  int series, error[MOST_SERIES]; /* as quantities */
  long times;
  struct scallop_order_point point[]; /* MOST_TIMES of each series */
};

/* Doubles are wrong by some ulp of what they are the difference of. */
static double noise(const struct at *at, int error)
{
  const struct series_error *c = &at->comparison[at->asked->quantities.item[error].of];
  return at->certified_errors ? 0 : 8 * DBL_EPSILON * fmax(fabs(c->exact), fabs(c->exact + c->error));
}

static const char *const order_columns[] = { "series", "order",     "order_lo", "order_hi", "interval", "points",
                                             "expect", "tolerance", "verdict",  "reason",   NULL };

static void write_order(struct rows *rows, struct at *at, int series)
{
  struct orders *all = rows->context;
  const struct series_options *o = (const void *)rows->request;
  const struct quantity *item = at->asked->quantities.item;
  const struct scallop_order_wanted wanted = { .order = o->expect.given ? o->expect.value : NAN,
                                               .tolerance = o->tolerance.value };
  struct table *t = &rows->table;
  struct scallop_order_result result;
  int count = (int)all->times;
  scallop_order(all->point + (size_t)series * MOST_TIMES, &count, &wanted, &result);
  /* an error that is not told from 0 with this accuracy stands as 0 */
  if (result.verdict <= SCALLOP_ORDER_MEASURED && isnan(result.order))
    result.verdict = SCALLOP_ORDER_FLOOR_LIMITED;
  sheet_row(&rows->sheet, t, at);
  table_text(t, item[item[all->error[series]].of].name);
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

/* Keeps the errors of a point; after the last T come the rows. */
static void collect(struct rows *rows, struct at *at)
{
  struct orders *all = rows->context;
  for (int i = 0; i < all->series; i++) {
    double error = at_number(at, all->error[i]);
    all->point[(long)i * MOST_TIMES + all->times] =
        (struct scallop_order_point){ .h = at->place.point.crawler.T, .err = error, .noise = noise(at, all->error[i]) };
  }
  all->times++;
  if (!at->place.ends_group)
    return;
  for (int i = 0; i < all->series; i++)
    write_order(rows, at, i);
  all->times = 0;
}

/* T varies, alone, in the last group of each product: an order is one of a row of such points. */
static bool T_varies(const struct sweep *s)
{
  bool fine = s->products > 0;
  for (int p = 0; p < s->products && fine; p++) {
    const struct sweep_product *product = &s->product[p];
    const struct sweep_group *last = product->groups > 0 ? &product->group[product->groups - 1] : NULL;
    fine = last && last->variables == 1 && last->variable[0].target == TARGET_NUMBER && last->variable[0].name[0] == 'T'
           && last->count >= 3 && last->count <= MOST_TIMES;
  }
  return fine;
}

/* The errors of the series, as quantities */
static const char *begin_orders(struct rows *rows, const struct names_of_series *list)
{
  char error[SERIES_NAME + 8];
  struct orders *all = rows->context = calloc(1, sizeof *all + (size_t)list->count * MOST_TIMES * sizeof *all->point);
  if (!all)
    return rows_no_memory;
  for (; all->series < list->count; all->series++) {
    snprintf(error, sizeof error, "error.%s", list->name[all->series]);
    all->error[all->series] = quantity_named(&rows->sheet.asked->quantities, error);
  }
  return NULL;
}

static const char *plan_orders(const struct series_options *o, struct rows *rows)
{
  static char T_needed[120];
  struct names_of_series list;
  snprintf(T_needed, sizeof T_needed,
           "orders need T to vary, alone, in the last group of what varies, with 3 to %d values", MOST_TIMES);
  const char *wrong = T_varies(&o->request.sweep) ? read_names(&list, o) : T_needed;
  wrong = wrong ? wrong : begin_orders(rows, &list);
  rows->has_errors = true;
  rows->visit = collect;
  rows->behind = order_columns;
  for (int i = 0; crawler_parameters[i] && !wrong; i++)
    wrong = strcmp(crawler_parameters[i], "T") == 0 ? NULL : rows_own(rows, "%s", crawler_parameters[i]);
  return wrong;
}

/* A row for each point */
const char *series_plan(const void *options, struct rows *rows)
{
  static const char *const prefixes[] = { "", "exact.", "error.", "relative." };
  const struct series_options *o = options;
  const struct scene_head *scene = o->request.scene;
  struct names_of_series list;
  bool has[4] = { false };
  if (!scene) {
    rows->sheet.asked->from_steady = rows->sheet.asked->tells_no_start = !o->request.point.has_v0;
    rows->sheet.asked->accuracy = 0;
  }
  if (o->orders)
    return plan_orders(o, rows);
  rows->has_parameters = true;
  rows->extra[0] = !scene || scene->is_about_phase ? "v0" : NULL;
  const char *wrong = read_parts(has, o);
  wrong = wrong ? wrong : read_names(&list, o);
  for (int i = 0; !wrong && i < list.count; i++)
    for (int k = 0; k < 4 && !wrong; k++)
      wrong = has[k] ? rows_own(rows, "%s%s", prefixes[k], list.name[i]) : NULL;
  return wrong ? wrong : rows_own(rows, "status");
}
