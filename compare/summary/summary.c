#include "compare/summary/summary.h"

#include <math.h>
#include <string.h>

#include "compare/points/point_flint.h"

const double summary_levels[SUMMARY_LEVELS] = { 0.01, 0.05 };

static const enum quantity_id quantities[] = { Q_V_START, Q_DISPLACEMENT };
enum { SUMMARY_QUANTITIES = sizeof quantities / sizeof *quantities };

static bool is_of_a_page(const void *context, const struct scallop_formula *f)
{
  bool shown = false;
  (void)context;
  for (int q = 0; q < SUMMARY_QUANTITIES; q++)
    shown = shown || (f->setting == SCALLOP_STEADY && quantity_of_formula(f, SCALLOP_EXTENSION) == quantities[q]);
  return shown;
}

bool summary_serves(const struct request *request)
{
  return book_serves(request->style.command, request->book, is_of_a_page, NULL, "the steady v_start or displacement");
}

int summary_formulas(const struct scallop_formula *formulas[SUMMARY_FORMULAS])
{
  const struct scallop_formula *f;
  int count = 0;
  for (int q = 0; q < SUMMARY_QUANTITIES; q++)
    for (int i = 0; (f = listed_formula(i)) && count < SUMMARY_FORMULAS; i++)
      if (f->setting == SCALLOP_STEADY && quantity_of_formula(f, SCALLOP_EXTENSION) == quantities[q])
        formulas[count++] = f;
  return count;
}

static struct summary_series examine(const struct summary *s, const struct series_item *item)
{
  struct summary_series made = { .item = *item };
  struct comparison c = { &s->study.expansions, *item, s->study.cache, .tolerance = 0 };
  double T = s->motion.crawler.T;
  SCOPED(arb, value);
  series_item_value(value, item, &s->study.expansions, T, BREAKDOWN_BITS);
  made.value = arb_is_finite(value) ? arf_get_d(arb_midref(value), ARF_RND_NEAR) : NAN;
  made.error = comparison_error(&c, T);
  for (int i = 0; i < SUMMARY_LEVELS; i++) {
    c.tolerance = summary_levels[i];
    made.reach[i] = comparison_reach(&c);
  }
  made.limit = comparison_limit(&c);
  return made;
}

/* The row of the ledger for the formula, this gait and these parameters */
static void decide_formula(struct summary_series *made, const struct point *point)
{
  struct ledger ledger = { .rows = NULL };
  struct scallop_rational_crawler exact;
  scallop_rational_init(&exact);
  rational_point(&exact, NULL, point);
  ledger_add_formula(&ledger, &exact, true, made->item.formula);
  if (ledger.count > 0)
    made->claim = ledger.rows[0];
  ledger_free(&ledger);
  scallop_rational_clear(&exact);
}

static void examine_series(struct summary *s, const struct point *point, bool verdicts)
{
  for (int q = 0; q < SUMMARY_QUANTITIES; q++) {
    struct series_item items[MOST_ITEMS];
    int count = series_items(items, &s->study.expansions, quantities[q], SUMMARY_ORDER);
    for (int i = 0; i < count; i++) {
      if (items[i].source == FROM_DERIVED)
        s->derived[s->series++] = examine(s, &items[i]);
      if (!items[i].formula || s->formulas == SUMMARY_FORMULAS)
        continue;
      struct summary_series *made = &s->formula[s->formulas++];
      *made = examine(s, &items[i]);
      if (verdicts)
        decide_formula(made, point);
    }
  }
}

static void find_best(struct summary *s)
{
  enum { DIGITS = 200 };
  struct ball_answer exact;
  ball_answer_init(&exact);
  answer_of_doubles(&exact, &s->motion, DIGITS);
  for (int i = 0; i < s->series; i++) {
    enum quantity_id q = s->derived[i].item.quantity;
    if (!study_best_order(&s->study, q, s->motion.crawler.T, exact.value[q], &s->best_order[i], &s->best_error[i]))
      s->best_order[i] = 0;
  }
  ball_answer_clear(&exact);
}

const char *summary_make(struct summary *s, const struct point *point, bool verdicts)
{
  *s = (struct summary){ .motion = motion_of(point, OF_STEADY) };
  const char *why = study_begin(&s->study, point, OF_STEADY, SUMMARY_ORDER, STUDY_MANY);
  if (!why && !answer_in_double(&s->answer, &s->motion))
    why = scallop_status_text(s->answer.status);
  if (why)
    return why;
  study_events(&s->study);
  examine_series(s, point, verdicts);
  find_best(s);
  return NULL;
}

void summary_clear(struct summary *s) { study_clear(&s->study); }
