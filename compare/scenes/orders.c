/* Orders of the errors of series, as T falls. */
#include <float.h>
#include <math.h>

#include "compare/scenes/parts.h"

/* Doubles are wrong by some ulp of what they are the difference of. */
static double noise(const struct running *r, const struct quantity *error)
{
  const struct comparison *c = &r->at->comparison[error->of];
  return r->at->certified_errors ? 0 : 8 * DBL_EPSILON * fmax(fabs(c->exact), fabs(c->exact + c->error));
}

void orders_collect(const struct running *r, struct output *o)
{
  for (int i = 0; i < o->want->series; i++) {
    double error = at_number(r->at, o->want->of[i]);
    o->errors[i * SCENE_TIMES + o->times] = (struct scallop_order_point){
      .h = r->at->point.crawler.T, .err = error, .noise = noise(r, &r->scene->asked.quantities.item[o->want->of[i]])
    };
  }
  o->times++;
}

static void write_order(struct running *r, struct output *o, int series)
{
  const struct scene_want *w = o->want;
  const struct quantities *all = &r->scene->asked.quantities;
  struct table *t = &o->table;
  const struct scallop_order_wanted wanted = { .order = w->has_expect ? w->expect : NAN, .tolerance = w->tolerance };
  struct scallop_order_result result;
  int count = (int)o->times;
  scallop_order(o->errors + (size_t)series * SCENE_TIMES, &count, &wanted, &result);
  /* an error that is not told from 0 with this accuracy stands as 0 */
  if (result.verdict <= SCALLOP_ORDER_MEASURED && isnan(result.order))
    result.verdict = SCALLOP_ORDER_FLOOR_LIMITED;
  sheet_row(&o->want->sheet, t, r->at);
  table_text(t, all->item[all->item[w->of[series]].of].name);
  table_rounded(t, result.order, "%.4f");
  table_rounded(t, result.low, "%.4f");
  table_rounded(t, result.high, "%.4f");
  table_text(t, scallop_order_interval_text(result.interval));
  table_rounded(t, result.used, "%.0f");
  table_number(t, wanted.order);
  table_number(t, w->has_expect ? w->tolerance : NAN);
  table_text(t, scallop_order_verdict_text(result.verdict));
  table_text(t, result.reason);
  r->failed_checks += w->has_expect && result.verdict != SCALLOP_ORDER_PASS;
  count_add(COUNT_ORDERS, 1);
}

void orders_finish(struct running *r, struct output *o)
{
  for (int i = 0; i < o->want->series; i++)
    write_order(r, o, i);
  o->times = 0;
}
