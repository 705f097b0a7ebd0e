/* Quantities of a crawler along T: reach of series, verdicts on formulas, transitions. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/points/point_flint.h"
#include "compare/summary/summary.h"

enum { MIN_ORDER = 8 };

struct at_study { /* of one crawler */
  struct study study;
  struct claim_table claims;    /* the rows requested so far */
  double reach[MAX_QUANTITIES]; /* does not depend on T, and is kept while only T varies; 0: not yet computed */
};

static void clear(struct at_study *s)
{
  study_clear(&s->study);
  claim_table_free(&s->claims);
  memset(s->reach, 0, sizeof s->reach);
}

static void end(struct at_study *s)
{
  clear(s);
  free(s);
}

static long max_order(const struct quantities *all)
{
  long order = MIN_ORDER;
  for (int i = 0; i < all->count; i++)
    order = all->item[i].order > order ? all->item[i].order : order;
  return order;
}

struct study *study_of(struct at *at)
{
  struct at_study *s = at->study = at->study ? at->study : calloc(1, sizeof *s);
  struct motion motion = motion_of(&at->place.point, OF_STEADY);
  motion.crawler.T = 1; /* not used */
  if (!s)
    return at_fail(at, "out of memory"), NULL;
  if (s->study.places && same_crawler(&s->study.motion.crawler, &motion.crawler))
    return &s->study;
  clear(s);
  const char *why = study_begin(&s->study, &motion, max_order(&at->required->quantities));
  return why ? at_fail(at, why), NULL : &s->study;
}

const struct claim_row *claim_of(struct at *at, const struct scallop_formula *formula)
{
  if (!study_of(at))
    return NULL;
  struct claim_table *l = &at->study->claims;
  for (int i = 0; i < l->count; i++)
    if (strcmp(l->rows[i].claim, formula->name) == 0)
      return &l->rows[i];
  SCOPED(scallop_rational, exact);
  rational_point(&exact, NULL, &at->place.point);
  claim_table_add_formula(l, &exact, true, formula);
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

/* Compares the series of the quantity with the exact motion; nan without a series. */
static double compare_series(struct at *at, const struct quantity *q)
{
  const struct quantity *series = &at->required->quantities.item[q->of];
  const struct scallop_formula *f = series->formula;
  const struct study *s = study_of(at);
  const double T = at->place.point.crawler.T;
  struct comparison c = { .study = s, .tolerance = q->tolerance };
  c.item = f ? series_of_formula(f, quantity_of_formula(f, SCALLOP_EXTENSION))
             : (struct series_item){ series->kind == QUANTITY_DERIVED ? FROM_DERIVED : FROM_LIMIT,
                                     (enum quantity_id)series->which, NULL, series->order };
  if (!s || !(f ? series_is_about(f, &s->motion, c.item.quantity) : s->derived.value[series->which] != NULL))
    return NAN;
  return q->which == STUDIED_REACH       ? comparison_reach(&c)
         : q->which == STUDIED_VALUE     ? value_of(&c, T)
         : q->which == STUDIED_DEVIATION ? comparison_error(&c, T)
                                         : comparison_limit(&c);
}

static double reach(struct at *at, const struct quantity *q)
{
  if (!study_of(at))
    return NAN;
  double *kept = &at->study->reach[q - at->required->quantities.item];
  *kept = *kept == 0 ? compare_series(at, q) : *kept;
  return *kept;
}

/* Returns the order of the best truncation of the displacement, or its error. */
static double best(struct at *at, bool is_order)
{
  struct study *s = study_of(at);
  const struct best_order best = s ? study_best_order(s, Q_DISPLACEMENT, at->place.point.crawler.T)
                                   : (struct best_order){ .error = INFINITY };
  return isinf(best.error) ? NAN : is_order ? (double)best.order : best.error;
}

static double number(struct at *at, const struct quantity *q)
{
  struct study *s = study_of(at);
  switch ((enum studied)q->which) {
  case STUDIED_REACH: return reach(at, q);
  case STUDIED_VALUE:
  case STUDIED_DEVIATION:
  case STUDIED_ERROR_LIMIT: return compare_series(at, q);
  case STUDIED_ORDER: return order_of(claim_of(at, at->required->quantities.item[q->of].formula));
  case STUDIED_TRANSITION_T: return s && study_transitions(s)->count > 0 ? s->transitions.transition[0].T : NAN;
  default: return best(at, q->which == STUDIED_BEST_ORDER);
  }
}

static const char *reversals_text(char text[MOTION_WORDS], const struct transitions *e)
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
  struct study *s = study_of(at);
  if (!s)
    return "-";
  if (q->which == STUDIED_VERDICT)
    return claim_verdict_text(claim_of(at, at->required->quantities.item[q->of].formula)->verdict);
  const struct transitions *e = study_transitions(s);
  return q->which == STUDIED_REVERSALS ? reversals_text(at->text, e) : e->count > 0 ? e->transition[0].causes : "-";
}

static const struct at_study_functions functions = { end, number, text };

/* Registers the functions on loading, or before main in a program that is linked with this file. */
static void __attribute__((constructor)) offer(void) { at_study = &functions; }
