/* series --orders: at which order in T the errors of series fall, T being what varies fastest. */
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "asymptotics/observed/order.h"
#include "compare/command/series_options.h"
#include "compare/points/counts.h"

enum { MOST_TIMES = 4096 };

struct orders { /* the errors of each series at the T so far */
  const struct series_options *options;
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

static const char *const columns[] = { "series", "order",     "order_lo", "order_hi", "interval", "points",
                                       "expect", "tolerance", "verdict",  "reason",   NULL };

static void write_order(struct rows *rows, struct at *at, int series)
{
  struct orders *all = rows->context;
  const struct series_options *o = all->options;
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
    all->point[(long)i * MOST_TIMES + all->times] = (struct scallop_order_point){ .h = at->place.point.crawler.T,
                                                                                  .err = error,
                                                                                  .noise = noise(at, all->error[i]) };
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
    fine = last && last->variables == 1 && last->variable[0].target == TARGET_NUMBER
           && last->variable[0].name[0] == 'T' && last->count >= 3 && last->count <= MOST_TIMES;
  }
  return fine;
}

/* The errors of the series, as quantities */
static const char *begin(struct rows *rows, const struct series_options *o, const struct series_list *list)
{
  char error[2 * QUANTITY_NAME];
  struct orders *all = rows->context = calloc(1, sizeof *all + (size_t)list->count * MOST_TIMES * sizeof *all->point);
  if (!all)
    return rows_no_memory;
  all->options = o;
  for (; all->series < list->count; all->series++) {
    snprintf(error, sizeof error, "error.%s", list->name[all->series]);
    all->error[all->series] = quantity_named(&rows->sheet.asked->quantities, error);
  }
  return NULL;
}

const char *series_orders(const struct series_options *o, struct rows *rows)
{
  static char T_needed[120];
  struct series_list list = { .count = 0 };
  snprintf(T_needed, sizeof T_needed,
           "orders need T to vary, alone, in the last group of what varies, with 3 to %d values", MOST_TIMES);
  const char *wrong = T_varies(&o->request.sweep) ? series_names(&list, o) : T_needed;
  wrong = wrong ? wrong : begin(rows, o, &list);
  series_list_free(&list);
  rows->has_errors = true;
  rows->visit = collect;
  rows->behind = columns;
  for (int i = 0; crawler_parameters[i] && !wrong; i++)
    wrong = strcmp(crawler_parameters[i], "T") == 0 ? NULL : rows_own(rows, "%s", crawler_parameters[i]);
  return wrong;
}
