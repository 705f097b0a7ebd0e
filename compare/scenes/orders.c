/* Orders of the errors of series, as T falls. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/scenes/parts.h"

const char *const order_columns[] = { "series", "order",  "order_lo",  "order_hi", "points",
                                      "state",  "expect", "tolerance", "verdict",  NULL };

bool orders_begin(const struct running *r, struct output *o)
{
  const struct quantities *all = &r->scene->quantities;
  for (int i = 0; i < all->labels; i++)
    table_columns(&o->table, (const char *const[]){ all->label[i], NULL });
  for (const char *const *name = crawler_parameters; *name; name++)
    if (strcmp(*name, "T") != 0)
      table_columns(&o->table, (const char *const[]){ *name, NULL });
  table_columns(&o->table, order_columns);
  table_begin_rows(&o->table);
  o->errors = calloc((size_t)o->want->series * SCENE_TIMES, sizeof *o->errors);
  return o->errors != NULL;
}

/* Doubles are wrong by some ulp of what they are the difference of. */
static double noise(const struct running *r, const struct quantity *error)
{
  const struct comparison *c = &r->state->comparison[error->of];
  return r->scene->plan.needs.certified_errors ? 0 : 8 * DBL_EPSILON * fmax(fabs(c->exact), fabs(c->exact + c->error));
}

void orders_collect(const struct running *r, struct output *o)
{
  for (int i = 0; i < o->want->series; i++) {
    double error = state_number(r->state, o->want->of[i]);
    o->errors[i * SCENE_TIMES + o->times] = (struct order_point){
      .h = r->state->visit.point.crawler.T, .err = error, .noise = noise(r, &r->scene->quantities.item[o->want->of[i]])
    };
  }
  o->times++;
}

static void write_order(struct running *r, struct output *o, int series)
{
  const struct scene_want *w = o->want;
  const struct quantities *all = &r->scene->quantities;
  struct table *t = &o->table;
  struct order_fit fit = order_estimate(o->errors + (size_t)series * SCENE_TIMES, (int)o->times);
  /* an error that is not told from 0 with this accuracy stands as 0 */
  enum order_verdict verdict = fit.state == ORDER_EXACT ? ORDER_VERDICT_FLOOR_LIMITED
                                                        : order_judge(&fit, w->expect, w->tolerance);
  for (int i = 0; i < all->labels; i++)
    table_text(t, r->state->swept.label[i] ? r->state->swept.label[i] : "-");
  for (const char *const *name = crawler_parameters; *name; name++)
    if (strcmp(*name, "gait") == 0)
      table_text(t, r->state->visit.point.crawler.gait->name);
    else if (strcmp(*name, "T") != 0)
      table_number(t, crawler_parameter(&r->state->visit.point.crawler, *name));
  table_text(t, all->item[all->item[w->of[series]].of].name);
  table_rounded(t, fit.order, "%.4f");
  table_rounded(t, fit.lo, "%.4f");
  table_rounded(t, fit.hi, "%.4f");
  table_rounded(t, fit.used, "%.0f");
  table_text(t, order_state_text(fit.state));
  table_number(t, w->has_expect ? w->expect : NAN);
  table_number(t, w->has_expect ? w->tolerance : NAN);
  table_text(t, w->has_expect ? order_verdict_text(verdict) : "none asked for");
  r->failed_checks += w->has_expect && verdict != ORDER_PASS;
  count_add(COUNT_ORDERS, 1);
  count_add(COUNT_ROWS, 1);
}

void orders_finish(struct running *r, struct output *o)
{
  for (int i = 0; i < o->want->series; i++)
    write_order(r, o, i);
  o->times = 0;
}
