/* What the wants of a scene need at a point: from their quantities, each looked at once. */
#include <math.h>
#include <string.h>

#include "compare/scenes/plan_parts.h"

static const struct quantity *quantity_at(const struct planning *p, int place) { return &p->scene->quantities.item[place]; }

static void need(bool *what, const char **for_what, const char *name)
{
  *what = true;
  if (for_what && !*for_what)
    *for_what = name;
}

bool every_product_sets(const struct scene *s, enum scene_target target)
{
  for (int i = 0; i < s->products; i++) {
    bool has = false;
    for (int g = 0; g < s->product[i].groups; g++)
      for (int v = 0; v < s->product[i].group[g].variables; v++)
        has |= s->product[i].group[g].variable[v].target == target;
    if (!has)
      return false;
  }
  return true;
}

static void need_v0(struct planning *p, const char *name)
{
  if (p->scene->start == START_STEADY && !every_product_sets(p->scene, TARGET_V0))
    need(&p->n.steady, &p->n.for_steady, name);
}

static void need_phase(struct planning *p, const char *name)
{
  need(&p->n.phase, &p->n.for_phase, name);
  need_v0(p, name);
}

static void need_solution(struct planning *p, bool of_phase, const char *name)
{
  if (of_phase)
    need_phase(p, name);
  else
    need(&p->n.steady, &p->n.for_steady, name);
}

static void need_certified(struct planning *p, bool of_phase, const char *name)
{
  need(of_phase ? &p->n.certified_phase : &p->n.certified_steady, &p->n.for_certified, name);
  if (of_phase)
    need_v0(p, name);
}

/* The formula of the paper with what it takes as given, in double or certified */
static void need_formula(struct planning *p, const struct quantity *q, bool certified)
{
  const struct scallop_formula *f = q->formula;
  p->n.formulas++;
  if (f->setting == SCALLOP_STEADY)
    return;
  need_v0(p, q->name);
  if (!formula_takes_given(f))
    return;
  if (certified)
    need_certified(p, true, q->name);
  else {
    need_phase(p, q->name);
    p->n.turnings |= strstr(f->text, "x_switch") != NULL;
  }
}

static void need_derived(struct planning *p, const struct quantity *q)
{
  bool of_phase = q->which >= STEADY_VALUES;
  long order = q->kind == QUANTITY_DERIVED ? q->order : of_phase ? 8 : 1; /* some begin with T^3 */
  long *most = of_phase ? &p->plan->needs.phase_order : &p->plan->needs.steady_order;
  *most = order > *most ? order : *most;
  *(of_phase ? &p->n.phase_series : &p->n.steady_series) = true;
  p->n.sums++;
  if (of_phase)
    need_v0(p, q->name);
}

static void need_quantity(struct planning *p, int place);

/* What a series should be, and what it is beside that; once, whoever asks. */
static void need_comparison(struct planning *p, int series_place)
{
  const struct quantity *series = quantity_at(p, series_place);
  bool of_phase = quantity_is_of_phase(&p->scene->quantities, series);
  if (p->n.compared[series_place])
    return;
  p->n.compared[series_place] = true;
  if (p->plan->needs.certified_errors) {
    need_certified(p, of_phase, series->name);
    if (series->kind == QUANTITY_PUBLISHED)
      need_formula(p, series, true);
    else
      need_derived(p, series);
    return;
  }
  need_solution(p, of_phase, series->name);
  if (series->kind == QUANTITY_PUBLISHED)
    p->n.turnings |= series->formula->quantity == SCALLOP_REAR_AT_FIRST || series->formula->quantity == SCALLOP_REAR_AT_LAST;
  need_quantity(p, series_place);
}

/* The value of a series. */
static void need_series(struct planning *p, int place)
{
  const struct quantity *q = quantity_at(p, place);
  if (p->plan->needs.certified_errors && quantity_is_compared(&p->scene->quantities, q))
    need_comparison(p, place);
  else if (q->kind == QUANTITY_PUBLISHED)
    need_formula(p, q, false);
  else
    need_derived(p, q);
}

static void need_quantity(struct planning *p, int place)
{
  const struct quantity *q = quantity_at(p, place);
  if (p->n.used[place])
    return;
  p->n.used[place] = true;
  switch (q->kind) {
  case QUANTITY_V0: need_v0(p, q->name); break;
  case QUANTITY_ONSET: p->n.onset = true; break;
  case QUANTITY_STEADY: need(&p->n.steady, &p->n.for_steady, q->name); break;
  case QUANTITY_PHASE: need_phase(p, q->name); break;
  case QUANTITY_PUBLISHED:
  case QUANTITY_DERIVED:
  case QUANTITY_LIMIT: need_series(p, place); break;
  case QUANTITY_CERTIFIED: need_certified(p, q->which >= STEADY_VALUES, q->name); break;
  case QUANTITY_EXACT:
  case QUANTITY_ERROR:
  case QUANTITY_RELATIVE: need_comparison(p, q->of); break;
  default: break; /* a parameter, a label, a sample, status */
  }
}

/* Applies visit to each quantity of the columns and orders of a want. */
static void each_quantity(const struct scene_want *w, void visit(struct planning *, int), struct planning *p)
{
  for (int i = 0; i < w->columns; i++) {
    int places[FORMULA_STEPS], count = scene_column_quantities(&w->column[i], places);
    for (int k = 0; k < count; k++)
      visit(p, places[k]);
  }
  if (w->kind == WANT_TRAJECTORY && w->until.is_formula) {
    int places[FORMULA_STEPS], count = formula_places(&w->until.formula, places);
    for (int k = 0; k < count; k++)
      visit(p, places[k]);
  }
  for (int i = 0; i < w->series; i++)
    visit(p, w->of[i]);
}

/* A change of velocity in doubles is a small difference of large numbers, which has not the digits that are promised. */
static void note_error(struct planning *p, int place)
{
  const struct quantity *q = quantity_at(p, place), *series = q->of >= 0 ? quantity_at(p, q->of) : NULL;
  p->n.errors |= series != NULL;
  if (series && series->formula && series->formula->quantity == SCALLOP_VELOCITY_CHANGE)
    p->plan->needs.certified_errors = true;
}

/* To how many digits certified values are wanted, and errors against what. */
static void find_accuracy(struct planning *p)
{
  static const double of_doubles = 1e-10;
  struct scene_needs *needs = &p->plan->needs;
  needs->accuracy = of_doubles;
  for (int i = 0; i < p->scene->wants; i++) {
    const struct scene_want *w = &p->scene->want[i];
    bool before = p->n.errors;
    p->n.errors = false;
    each_quantity(w, note_error, p);
    if (p->n.errors) {
      needs->certified_errors |= w->is_certified || w->accuracy < of_doubles;
      needs->accuracy = fmin(needs->accuracy, w->accuracy);
    }
    p->n.errors |= before;
    if (w->kind == WANT_ROWS)
      needs->digits = w->digits > needs->digits ? w->digits : needs->digits;
  }
  if (needs->digits == 0)
    needs->digits = 17;
}

void plan_needs(struct planning *p)
{
  find_accuracy(p);
  for (int i = 0; i < p->scene->wants; i++) {
    each_quantity(&p->scene->want[i], need_quantity, p);
    if (p->scene->want[i].kind == WANT_TRAJECTORY)
      need_v0(p, "where a trajectory starts");
  }
}
