/* Quantities of a crawler along T: how far series reach, what is claimed and proven of formulas, and what ends the
 * expansion. */
#define _GNU_SOURCE /* tdestroy */
#include <math.h>
#include <search.h>
#include <stdlib.h>
#include <string.h>

#include "compare/points/point_flint.h"
#include "compare/summary/summary.h"

enum { LEAST_ORDER = 8, MOST_KEPT = 1 << 20, BEST_DIGITS = 200, MOST_CLAIMS = 64, REVERSALS_TEXT = 8 * NUMBER_TEXT };

/* How far a series reaches does not depend on T: it is kept, whatever varies fastest. */
struct kept_reach {
  double crawler[CRAWLER_NUMBERS]; /* of T = 1 */
  const struct scallop_gait *gait;
  const struct quantity *of;
  double T;
};

struct at_study {
  struct point point; /* that of the study, T = 1 */
  struct study study;
  int claims;
  struct claim {
    const struct scallop_formula *formula;
    struct claim_row row;
  } claim[MOST_CLAIMS];
  void *reaches; /* a tree (tsearch) of struct kept_reach */
  long kept;
  char text[REVERSALS_TEXT];
};

static struct at_study *create(void) { return calloc(1, sizeof(struct at_study)); }

static void end(struct at_study *s)
{
  study_clear(&s->study);
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
  struct point point = at->place.point;
  point.crawler.T = 1;
  if (!s)
    return at_fail(at, "out of memory"), NULL;
  if (s->study.cache && same_crawler(&s->point.crawler, &point.crawler))
    return &s->study;
  s->point = point;
  s->claims = 0;
  const char *why = study_begin(&s->study, &s->point, OF_STEADY, most_order(&at->asked->quantities));
  return why ? at_fail(at, why), NULL : &s->study;
}

/* The series of a quantity among those of the study. False: there is none. */
static bool find_item(struct series_item *item, const struct study *study, const struct quantity *series)
{
  struct series_item items[MOST_ITEMS];
  enum quantity_id of = series->formula ? quantity_of_formula(series->formula, SCALLOP_EXTENSION)
                                        : (enum quantity_id)series->which;
  int count = series_items(items, &study->expansions, of, series->order > 0 ? series->order : LEAST_ORDER);
  for (int i = 0; i < count; i++)
    if (series->formula                    ? items[i].formula == series->formula
        : series->kind == QUANTITY_DERIVED ? items[i].source == FROM_DERIVED
                                           : items[i].source == FROM_LIMIT) {
      *item = items[i];
      return true;
    }
  return false;
}

static int by_crawler(const void *a, const void *b)
{
  const struct kept_reach *x = a, *y = b;
  int order = (x->gait > y->gait) - (x->gait < y->gait);
  for (int i = 0; i < CRAWLER_NUMBERS && order == 0; i++)
    order = (x->crawler[i] > y->crawler[i]) - (x->crawler[i] < y->crawler[i]);
  return order != 0 ? order : (x->of > y->of) - (x->of < y->of);
}

static double reach(struct at *at, const struct quantity *q)
{
  struct at_study *s = at->study = at->study ? at->study : create();
  struct kept_reach *wanted = s ? calloc(1, sizeof *wanted) : NULL;
  if (!wanted)
    return at_fail(at, "out of memory");
  struct scallop_crawler crawler = at->place.point.crawler;
  crawler.T = 1;
  *wanted = (struct kept_reach){ .gait = crawler.gait, .of = q, .T = NAN };
  crawler_numbers(&crawler, wanted->crawler);
  struct kept_reach **found = tfind(wanted, &s->reaches, by_crawler);
  struct study *study = found ? NULL : study_of(at);
  struct comparison c = { .expansions = study ? &study->expansions : NULL, .tolerance = q->tolerance };
  if (study && find_item(&c.item, study, &at->asked->quantities.item[q->of])) {
    c.cache = study->cache;
    wanted->T = comparison_reach(&c);
  }
  double T = found ? (*found)->T : wanted->T;
  if (!study || s->kept >= MOST_KEPT || !tsearch(wanted, &s->reaches, by_crawler))
    free(wanted);
  else
    s->kept++;
  return T;
}

const struct claim_row *claim_of(struct at *at, const struct scallop_formula *formula)
{
  if (!study_of(at))
    return NULL;
  struct at_study *s = at->study;
  for (int i = 0; i < s->claims; i++)
    if (s->claim[i].formula == formula)
      return &s->claim[i].row;
  struct ledger ledger = { .rows = NULL };
  SCOPED(scallop_rational, exact);
  rational_point(&exact, NULL, &at->place.point);
  ledger_add_formula(&ledger, &exact, true, formula);
  struct claim *c = &s->claim[s->claims < MOST_CLAIMS ? s->claims++ : MOST_CLAIMS - 1];
  *c = (struct claim){ .formula = formula };
  if (ledger.count > 0)
    c->row = ledger.rows[0];
  ledger_free(&ledger);
  return &c->row;
}

static double order_of(const struct claim_row *c)
{
  return !c || !c->proven ? NAN : c->exact ? INFINITY : (double)c->derived_order;
}

struct best_order best_of(struct at *at, enum quantity_id quantity)
{
  struct study *study = study_of(at);
  double T = at->place.point.crawler.T;
  if (!study || !study_many(study, quantity))
    return (struct best_order){ .error = INFINITY };
  const struct motion motion = motion_at(&study->motion, T);
  SCOPED(ball_answer, exact);
  answer_of_doubles(&exact, &motion, BEST_DIGITS);
  return study_best_order(study, quantity, T, exact.value[quantity]);
}

static double number(struct at *at, const struct quantity *q)
{
  const struct quantity *series = q->of >= 0 ? &at->asked->quantities.item[q->of] : NULL;
  if (q->which == STUDIED_REACH)
    return reach(at, q);
  if (q->which == STUDIED_BEST_ORDER || q->which == STUDIED_BEST_ERROR) {
    const struct best_order best = best_of(at, Q_DISPLACEMENT);
    return isinf(best.error) ? NAN : q->which == STUDIED_BEST_ORDER ? (double)best.order : best.error;
  }
  if (q->which == STUDIED_EVENT_T || q->which == STUDIED_EVENT_FROUDE) {
    struct study *s = study_of(at);
    double T = s && study_events(s)->count > 0 ? s->events.event[0].T : NAN;
    return q->which == STUDIED_EVENT_T || isnan(T) ? T : motion_froude(&s->motion, T);
  }
  if (!series)
    return NAN;
  if (q->which == STUDIED_ORDER)
    return order_of(claim_of(at, series->formula));
  struct study *study = study_of(at);
  struct comparison c = { .expansions = study ? &study->expansions : NULL, .cache = study ? study->cache : NULL };
  if (!study || !find_item(&c.item, study, series))
    return NAN;
  if (q->which == STUDIED_VALUE) {
    SCOPED(arb, value);
    series_item_value(value, &c.item, &study->expansions, at->place.point.crawler.T, BREAKDOWN_BITS);
    return arb_is_finite(value) ? arf_get_d(arb_midref(value), ARF_RND_NEAR) : NAN;
  }
  return q->which == STUDIED_DEVIATION ? comparison_error(&c, at->place.point.crawler.T) : comparison_limit(&c);
}

static const char *reversals_text(char text[REVERSALS_TEXT], const struct events *e)
{
  size_t used = (size_t)snprintf(text, REVERSALS_TEXT, "%s", e->reversals == 0 ? "-" : "");
  for (long i = 0; i < e->reversals && used < REVERSALS_TEXT - NUMBER_TEXT; i++) {
    char number[NUMBER_TEXT];
    number_text(number, e->reversal[i].T, 0);
    used += (size_t)snprintf(text + used, REVERSALS_TEXT - used, "%s%s", i > 0 ? " " : "", number);
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
    return reversals_text(at->study->text, e);
  return e->count > 0 ? e->event[0].what : "-";
}

static const struct at_study_functions functions = { end, number, text };

/* When it is loaded, or, where a program is linked with it, before main */
static void __attribute__((constructor)) offer(void) { at_study = &functions; }
