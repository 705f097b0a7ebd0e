/* Quantities of a crawler along T: how far series reach, what is claimed and proven of formulas, and what ends the
 * expansion. */
#define _GNU_SOURCE /* tdestroy */
#include <math.h>
#include <search.h>
#include <stdlib.h>
#include <string.h>

#include "compare/points/point_flint.h"
#include "compare/summary/summary.h"

enum { LEAST_ORDER = 8, MOST_KEPT = 1 << 20 };

/* How far a series reaches does not depend on T: it is kept, whatever varies fastest. */
struct kept_reach {
  double crawler[CRAWLER_NUMBERS]; /* of T = 1 */
  const struct scallop_gait *gait;
  const struct quantity *of;
  double T;
};

struct at_study {
  struct study study;   /* of the crawler with T = 1 */
  struct ledger ledger; /* of this crawler: rows as they are asked for */
  void *reaches;        /* a tree (tsearch) of struct kept_reach */
  long kept;
};

static struct at_study *create(void) { return calloc(1, sizeof(struct at_study)); }

static void end(struct at_study *s)
{
  study_clear(&s->study);
  ledger_free(&s->ledger);
  tdestroy(s->reaches, free);
  free(s);
}

static long most_order(const struct quantities *all)
{
  long order = LEAST_ORDER;
  for (int i = 0; i < all->count; i++)
    order = all->item[i].order > order ? all->item[i].order : order;
  return order;
}

struct study *study_of(struct at *at)
{
  struct at_study *s = at->study = at->study ? at->study : create();
  struct motion motion = motion_of(&at->place.point, OF_STEADY);
  motion.crawler.T = 1;
  if (!s)
    return at_fail(at, "out of memory"), NULL;
  if (s->study.cache && same_crawler(&s->study.motion.crawler, &motion.crawler))
    return &s->study;
  ledger_free(&s->ledger);
  const char *why = study_begin(&s->study, &motion, most_order(&at->asked->quantities));
  return why ? at_fail(at, why), NULL : &s->study;
}

/* The series that the quantity is about, beside the exact motion. False: there is none. */
static bool compares(struct comparison *c, struct at *at, const struct quantity *q)
{
  const struct quantity *series = &at->asked->quantities.item[q->of];
  const struct scallop_formula *f = series->formula;
  const struct study *s = study_of(at);
  *c = (struct comparison){ .study = s, .tolerance = q->tolerance };
  c->item = f ? series_of_formula(f, quantity_of_formula(f, SCALLOP_EXTENSION))
              : (struct series_item){ series->kind == QUANTITY_DERIVED ? FROM_DERIVED : FROM_LIMIT,
                                      (enum quantity_id)series->which, NULL, series->order };
  return s && (f ? series_is_about(f, &s->motion, c->item.quantity) : s->derived.value[series->which] != NULL);
}

static int by_crawler(const void *a, const void *b) { return memcmp(a, b, offsetof(struct kept_reach, T)); }

static void keep(struct at_study *s, const struct kept_reach *reach)
{
  struct kept_reach *copy = s->kept < MOST_KEPT ? malloc(sizeof *copy) : NULL;
  if (!copy)
    return;
  *copy = *reach;
  if (tsearch(copy, &s->reaches, by_crawler))
    s->kept++;
  else
    free(copy);
}

static double reach(struct at *at, const struct quantity *q)
{
  struct kept_reach wanted;
  struct scallop_crawler crawler = at->place.point.crawler;
  struct comparison c;
  crawler.T = 1;
  crawler_numbers(&crawler, wanted.crawler);
  wanted.gait = crawler.gait;
  wanted.of = q;
  struct kept_reach *const *found = at->study ? tfind(&wanted, &at->study->reaches, by_crawler) : NULL;
  if (found)
    return (*found)->T;
  wanted.T = compares(&c, at, q) ? comparison_reach(&c) : NAN;
  if (c.study)
    keep(at->study, &wanted);
  return wanted.T;
}

const struct claim_row *claim_of(struct at *at, const struct scallop_formula *formula)
{
  if (!study_of(at))
    return NULL;
  struct ledger *l = &at->study->ledger;
  for (int i = 0; i < l->count; i++)
    if (strcmp(l->rows[i].claim, formula->name) == 0)
      return &l->rows[i];
  SCOPED(scallop_rational, exact);
  rational_point(&exact, NULL, &at->place.point);
  ledger_add_formula(l, &exact, true, formula);
  return &l->rows[l->count - 1];
}

static double order_of(const struct claim_row *c)
{
  return !c || !c->proven ? NAN : c->exact ? INFINITY : (double)c->derived_order;
}

static double value_of(const struct comparison *c, double T)
{
  SCOPED(arb, value);
  series_item_value(value, &c->item, c->study, T);
  return arb_is_finite(value) ? arf_get_d(arb_midref(value), ARF_RND_NEAR) : NAN;
}

/* Of the displacement: the order of the best truncation, or its error */
static double best(struct at *at, bool is_order)
{
  struct study *s = study_of(at);
  const struct best_order best = s ? study_best_order(s, Q_DISPLACEMENT, at->place.point.crawler.T)
                                   : (struct best_order){ .error = INFINITY };
  return isinf(best.error) ? NAN : is_order ? (double)best.order : best.error;
}

static double first_event(struct at *at)
{
  struct study *s = study_of(at);
  return s && study_events(s)->count > 0 ? s->events.event[0].T : NAN;
}

static double number(struct at *at, const struct quantity *q)
{
  double T = at->place.point.crawler.T;
  struct comparison c;
  switch ((enum studied)q->which) {
  case STUDIED_REACH: return reach(at, q);
  case STUDIED_VALUE: return compares(&c, at, q) ? value_of(&c, T) : NAN;
  case STUDIED_DEVIATION: return compares(&c, at, q) ? comparison_error(&c, T) : NAN;
  case STUDIED_ERROR_LIMIT: return compares(&c, at, q) ? comparison_limit(&c) : NAN;
  case STUDIED_ORDER: return order_of(claim_of(at, at->asked->quantities.item[q->of].formula));
  case STUDIED_EVENT_T: return first_event(at);
  default: return best(at, q->which == STUDIED_BEST_ORDER);
  }
}

static const char *reversals_text(char text[MOTION_WORDS], const struct events *e)
{
  size_t used = (size_t)snprintf(text, MOTION_WORDS, "%s", e->reversals == 0 ? "-" : "");
  for (long i = 0; i < e->reversals && used < MOTION_WORDS - NUMBER_TEXT; i++) {
    char number[NUMBER_TEXT];
    number_text(number, e->reversal[i].T, 0);
    used += (size_t)snprintf(text + used, MOTION_WORDS - used, "%s%s", i > 0 ? " " : "", number);
  }
  return text;
}

static const char *text(struct at *at, const struct quantity *q)
{
  if (q->which == STUDIED_VERDICT) {
    const struct claim_row *c = claim_of(at, at->asked->quantities.item[q->of].formula);
    return c ? claim_verdict_text(c->verdict) : "-";
  }
  struct study *study = study_of(at);
  if (!study)
    return "-";
  const struct events *e = study_events(study);
  if (q->which == STUDIED_REVERSALS)
    return reversals_text(at->text, e);
  return e->count > 0 ? e->event[0].what : "-";
}

static const struct at_study_functions functions = { end, number, text };

/* When it is loaded, or, where a program is linked with it, before main */
static void __attribute__((constructor)) offer(void) { at_study = &functions; }
