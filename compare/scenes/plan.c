/* The plan of a scene: what must be known before its first point, and the counts that follow from the kinds of its quantities. What a
 * point needs is found from its columns; the rest (state.c) is computed when it is first asked for, and once. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/scenes/parts.h"

/* What is computed once at a point, whatever needs it */
enum part { STEADY, PHASE, TURNINGS, ONSET, CERTIFIED_STEADY, CERTIFIED_PHASE, STEADY_SERIES, PHASE_SERIES, PARTS };

struct planning {
  const struct scene *scene;
  struct plan *plan;
  double points, runs; /* runs of points that differ in T alone */
  bool takes_steady;   /* some product does not set v0 */
  bool has[PARTS], used[MOST_QUANTITIES], compared[MOST_QUANTITIES];
};

static const struct quantity *quantity_at(const struct planning *p, int place) { return &p->scene->quantities.item[place]; }

/* reason: the first one stays. */
static void add(struct planning *p, enum count stage, double count, const char *reason)
{
  struct plan_stage *s = &p->plan->stage[stage];
  if (s->count == 0)
    snprintf(s->reason, sizeof s->reason, "%s", reason);
  s->count += count;
}

static void need(struct planning *p, enum part part, const char *name)
{
  static const enum count stages[PARTS] = { COUNT_STEADY,    COUNT_PHASES,    COUNT_PHASES,     COUNT_ONSETS,
                                            COUNT_CERTIFIED, COUNT_CERTIFIED, COUNT_EXPANSIONS, COUNT_EXPANSIONS };
  bool is_free_of_T = part == ONSET || part == STEADY_SERIES || part == PHASE_SERIES;
  if (!p->has[part])
    add(p, stages[part], is_free_of_T ? p->runs : p->points, name);
  p->has[part] = true;
}

/* A start in the steady state takes that state, but where the velocity varies. */
static void need_v0(struct planning *p, const char *name)
{
  if (p->scene->start == START_STEADY && p->takes_steady)
    need(p, STEADY, name);
}

static void need_phase(struct planning *p, bool certified, const char *name)
{
  need(p, certified ? CERTIFIED_PHASE : PHASE, name);
  need_v0(p, name);
}

static void need_solution(struct planning *p, bool of_phase, bool certified, const char *name)
{
  if (of_phase)
    need_phase(p, certified, name);
  else
    need(p, certified ? CERTIFIED_STEADY : STEADY, name);
}

/* The formula of the paper with what it takes as given, in double or certified */
static void need_formula(struct planning *p, const struct quantity *q, bool certified)
{
  const struct scallop_formula *f = q->formula;
  add(p, COUNT_FORMULAS, p->points, q->name);
  if (f->setting == SCALLOP_STEADY)
    return;
  need_v0(p, q->name);
  if (!formula_takes_given(f))
    return;
  need_phase(p, certified, q->name);
  if (!certified && strstr(f->text, "x_switch"))
    need(p, TURNINGS, q->name);
}

static void need_derived(struct planning *p, const struct quantity *q)
{
  bool of_phase = quantity_rows[q->which].of == OF_PHASE;
  long order = q->kind == QUANTITY_DERIVED ? q->order : of_phase ? 8 : 1; /* some begin with T^3 */
  long *most = of_phase ? &p->plan->needs.phase_order : &p->plan->needs.steady_order;
  *most = order > *most ? order : *most;
  need(p, of_phase ? PHASE_SERIES : STEADY_SERIES, q->name);
  add(p, COUNT_SUMS, p->points, q->name);
  if (of_phase)
    need_v0(p, q->name);
}

static void need_value(struct planning *p, const struct quantity *series, bool certified)
{
  if (series->kind == QUANTITY_PUBLISHED)
    need_formula(p, series, certified);
  else
    need_derived(p, series);
}

static void need_quantity(struct planning *p, int place);

/* What a series should be, and the series beside that */
static void need_comparison(struct planning *p, int place)
{
  const struct quantity *series = quantity_at(p, place);
  bool certified = p->plan->needs.certified_errors;
  if (p->compared[place])
    return;
  p->compared[place] = true;
  need_solution(p, quantity_is_of_phase(&p->scene->quantities, series), certified, series->name);
  if (certified) {
    need_value(p, series, true);
    return;
  }
  if (series->kind == QUANTITY_PUBLISHED
      && (series->formula->quantity == SCALLOP_REAR_AT_FIRST || series->formula->quantity == SCALLOP_REAR_AT_LAST))
    need(p, TURNINGS, series->name);
  need_quantity(p, place);
}

static void need_quantity(struct planning *p, int place)
{
  const struct quantity *q = quantity_at(p, place);
  if (p->used[place])
    return;
  p->used[place] = true;
  switch (q->kind) {
  case QUANTITY_V0: need_v0(p, q->name); break;
  case QUANTITY_ONSET: need(p, ONSET, q->name); break;
  case QUANTITY_ANSWER:
  case QUANTITY_REGIME:
  case QUANTITY_MODES: need_solution(p, quantity_is_of_phase(&p->scene->quantities, q), false, q->name); break;
  case QUANTITY_PUBLISHED:
  case QUANTITY_DERIVED:
  case QUANTITY_LIMIT:
    if (p->plan->needs.certified_errors && quantity_is_compared(&p->scene->quantities, q))
      need_comparison(p, place);
    else
      need_value(p, q, false);
    break;
  case QUANTITY_CERTIFIED: need_solution(p, quantity_rows[q->which].of == OF_PHASE, true, q->name); break;
  case QUANTITY_EXACT:
  case QUANTITY_ERROR:
  case QUANTITY_RELATIVE: need_comparison(p, q->of); break;
  default: break; /* a parameter, a label, a sample, status */
  }
}

/* To how many digits certified values are wanted, and errors against what. A change of velocity in doubles is a small difference of
 * large numbers, and has not the digits that errors are told to. */
static void find_accuracy(const struct scene *s, struct scene_needs *needs)
{
  static const double of_doubles = 1e-10;
  needs->accuracy = of_doubles;
  needs->digits = DIGITS_OF_DOUBLE;
  for (int i = 0; i < s->wants; i++) {
    const struct scene_want *w = &s->want[i];
    int places[WANT_QUANTITIES];
    bool has_errors = false;
    for (int k = scene_want_quantities(w, places); k-- > 0;) {
      const struct quantity *q = &s->quantities.item[places[k]];
      const struct scallop_formula *f = q->of >= 0 ? s->quantities.item[q->of].formula : NULL;
      has_errors |= q->of >= 0;
      needs->certified_errors |= f && f->quantity == SCALLOP_VELOCITY_CHANGE;
    }
    if (has_errors) {
      needs->certified_errors |= w->is_certified || w->accuracy < of_doubles;
      needs->accuracy = fmin(needs->accuracy, w->accuracy);
    }
    if (w->kind == WANT_ROWS && w->digits > needs->digits)
      needs->digits = w->digits;
  }
}

static void plan_want(struct planning *p, const struct scene_want *w)
{
  int places[WANT_QUANTITIES];
  double rows = w->kind == WANT_COMMAND ? 0 : p->points;
  for (int i = 0, count = scene_want_quantities(w, places); i < count; i++)
    need_quantity(p, places[i]);
  if (w->kind == WANT_TRAJECTORY) {
    rows *= (double)w->periods * (double)w->samples + 1;
    need_v0(p, "the start of a trajectory");
    add(p, COUNT_TRAJECTORIES, p->points, w->what);
    add(p, COUNT_SAMPLES, rows, "periods x samples + 1");
    p->plan->stage[COUNT_SAMPLES].is_at_most = p->plan->stage[COUNT_ROWS].is_at_most = true; /* it may end before */
  } else if (w->kind == WANT_ORDERS) {
    rows = 0;
    for (int k = 0; k < p->scene->sweep.products; k++) {
      const struct sweep_product *product = &p->scene->sweep.product[k];
      rows += (double)w->series * (double)sweep_product_points(product) / (double)product->group[product->groups - 1].count;
    }
    add(p, COUNT_ORDERS, rows, w->what);
  } else if (w->kind == WANT_COMMAND)
    add(p, COUNT_COMMANDS, 1, w->what);
  if (rows > 0)
    add(p, COUNT_ROWS, rows, w->what);
  if (w->has_plot)
    add(p, COUNT_PLOTS, 1, w->plot.file);
}

static bool is_free_of_T(const struct sweep_variable *v)
{
  return v->target == TARGET_FROUDE || v->target == TARGET_LABEL
         || (v->target == TARGET_NUMBER && strcmp(v->name, "T") == 0);
}

/* Looks at what varies in a product: "3 F1_over_F2 x 200 T"; the runs; and onsets that a range needs. */
static void plan_product(struct planning *p, const struct sweep_product *product, char *text, size_t size)
{
  size_t used = strlen(text);
  double runs = 1, points = 1;
  bool needs_onset = false, sets_v0 = false;
  for (int g = 0; g < product->groups; g++) {
    const struct sweep_group *group = &product->group[g];
    points *= (double)group->count;
    if (used < size)
      used += (size_t)snprintf(text + used, size - used, "%s%ld", g > 0 ? " x " : used > 0 ? " + " : "", group->count);
    for (int v = 0; v < group->variables; v++) {
      const struct sweep_variable *variable = &group->variable[v];
      if (used < size)
        used += (size_t)snprintf(text + used, size - used, "%s%s", v > 0 ? ", " : " ", variable->name);
      needs_onset |= variable->needs_onset;
      sets_v0 |= variable->target == TARGET_V0;
      if (!is_free_of_T(variable) && variable->count > 1)
        runs = points;
    }
  }
  p->runs += runs;
  p->takes_steady |= !sets_v0;
  if (needs_onset)
    add(p, COUNT_ONSETS, runs, "the ends of a range");
}

void make_plan(struct scene *scene)
{
  struct plan *plan = &scene->plan;
  struct planning p = { .scene = scene, .plan = plan, .points = (double)sweep_points(&scene->sweep) };
  char text[sizeof plan->stage->reason] = "";
  *plan = (struct plan){ .needs_flint = false };
  for (int i = 0; i < scene->sweep.products; i++)
    plan_product(&p, &scene->sweep.product[i], text, sizeof text);
  find_accuracy(scene, &plan->needs);
  for (int i = 0; i < scene->wants; i++)
    plan_want(&p, &scene->want[i]);
  add(&p, COUNT_POINTS, p.points, *text ? text : "nothing varies");
  plan->stage[COUNT_ONSETS].is_at_most = plan->stage[COUNT_EXPANSIONS].is_at_most = plan->stage[COUNT_PLOTS].is_at_most =
      true;
  plan->stage[COUNT_STEADY].is_at_most = scene->varies_v0;
  plan->needs_flint = plan->stage[COUNT_CERTIFIED].count > 0 || plan->stage[COUNT_EXPANSIONS].count > 0
                      || plan->stage[COUNT_COMMANDS].count > 0;
}
