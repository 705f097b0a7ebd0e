/* The plan of a scene: what must be known before its first point, and what --stats will count. One point of each
 * product is visited without a solver (state.c): what it asks for is asked for at every point. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/scenes/parts.h"

struct planning {
  const struct scene *scene;
  struct plan *plan;
  const struct sweep_product *product;
  double points, runs; /* of the product; runs of points that differ in T alone */
  struct scene_state state;
};

/* reason: the first one stays. */
static void add(struct plan *plan, enum count stage, double count, const char *reason)
{
  struct plan_stage *s = &plan->stage[stage];
  if (s->count == 0)
    snprintf(s->reason, sizeof s->reason, "%s", reason);
  s->count += count;
}

/* To how many digits certified values are wanted, errors against what, and which terms. A change of velocity in doubles
 * is a small difference of large numbers, and has not the digits that errors are told to. */
static void find_needs(const struct scene *s, struct scene_needs *needs)
{
  static const double of_doubles = 1e-10;
  *needs = (struct scene_needs){ .accuracy = of_doubles, .digits = DIGITS_OF_DOUBLE };
  for (int i = 0; i < s->quantities.count; i++) {
    const struct quantity *q = &s->quantities.item[i];
    if (q->kind != QUANTITY_DERIVED && q->kind != QUANTITY_LIMIT)
      continue;
    enum quantity_of of = quantity_rows[q->which].of;
    long order = q->kind == QUANTITY_DERIVED ? q->order : of == OF_PHASE ? 8 : 1; /* some begin with T^3 */
    needs->order[of] = order > needs->order[of] ? order : needs->order[of];
  }
  for (int i = 0; i < s->wants; i++) {
    const struct scene_want *w = &s->want[i];
    int places[WANT_QUANTITIES];
    bool has_errors = false;
    for (int k = scene_want_quantities(w, places); k-- > 0;) {
      int of = s->quantities.item[places[k]].of;
      const struct scallop_formula *f = of >= 0 ? s->quantities.item[of].formula : NULL;
      has_errors |= of >= 0;
      needs->certified_errors |= f && f->quantity == SCALLOP_VELOCITY_CHANGE;
    }
    if (has_errors) {
      needs->certified_errors |= w->reference == REFERENCE_CERTIFIED || w->accuracy < of_doubles;
      needs->accuracy = fmin(needs->accuracy, w->accuracy);
    }
    if (w->kind == WANT_ROWS && w->digits > needs->digits)
      needs->digits = w->digits;
  }
}

static void plan_want(struct planning *p, const struct scene_want *w)
{
  int places[WANT_QUANTITIES];
  for (int i = 0, count = scene_want_quantities(w, places); i < count; i++)
    state_find(&p->state, places[i], 0);
  double rows = p->points;
  if (w->kind == WANT_TRAJECTORY) {
    rows *= (double)w->periods * (double)w->samples + 1;
    p->state.asking = "the start of a trajectory";
    state_v0(&p->state);
    add(p->plan, COUNT_TRAJECTORIES, p->points, w->what);
    add(p->plan, COUNT_SAMPLES, rows, "periods x samples + 1");
    p->plan->stage[COUNT_SAMPLES].is_at_most = p->plan->stage[COUNT_ROWS].is_at_most = true; /* it may end before */
  } else if (w->kind == WANT_ORDERS) {
    rows *= (double)w->series / (double)p->product->group[p->product->groups - 1].count;
    add(p->plan, COUNT_ORDERS, rows, w->what);
  }
  if (w->kind != WANT_COMMAND)
    add(p->plan, COUNT_ROWS, rows, w->what);
}

static bool is_free_of_T(const struct sweep_variable *v)
{
  return v->target == TARGET_FROUDE || v->target == TARGET_LABEL
         || (v->target == TARGET_NUMBER && strcmp(v->name, "T") == 0);
}

/* Looks at what varies: "3 F1_over_F2 x 200 T", and the runs. */
static void look(struct planning *p, char *text, size_t size)
{
  size_t used = strlen(text);
  p->points = p->runs = 1;
  for (int g = 0; g < p->product->groups; g++) {
    const struct sweep_group *group = &p->product->group[g];
    p->points *= (double)group->count;
    if (used < size)
      used += (size_t)snprintf(text + used, size - used, "%s%ld", g > 0 ? " x " : used > 0 ? " + " : "", group->count);
    for (int v = 0; v < group->variables; v++) {
      const struct sweep_variable *variable = &group->variable[v];
      if (used < size)
        used += (size_t)snprintf(text + used, size - used, "%s%s", v > 0 ? ", " : " ", variable->name);
      if (!is_free_of_T(variable) && variable->count > 1)
        p->runs = p->points;
    }
  }
}

static void plan_product(struct planning *p)
{
  static const long first[SWEEP_GROUPS] = { 0 };
  struct tally tally[COUNTS] = { { 0, NULL } };
  state_init(&p->state, p->scene, tally);
  state_move(&p->state, p->product, first);
  for (int i = 0; i < p->scene->wants; i++)
    plan_want(p, &p->scene->want[i]);
  for (int k = COUNT_POINTS + 1; k < COUNT_PLANNED; k++)
    if (tally[k].count > 0)
      add(p->plan, (enum count)k,
          (double)tally[k].count * (k == COUNT_ONSETS || k == COUNT_EXPANSIONS ? p->runs : p->points), tally[k].reason);
}

void make_plan(struct scene *scene)
{
  struct plan *plan = &scene->plan;
  struct planning p = { .scene = scene, .plan = plan };
  char text[sizeof plan->stage->reason] = "";
  *plan = (struct plan){ .needs_flint = false };
  find_needs(scene, &plan->needs);
  for (int i = 0; i < scene->sweep.products; i++) {
    p.product = &scene->sweep.product[i];
    look(&p, text, sizeof text);
    plan_product(&p);
  }
  add(plan, COUNT_POINTS, (double)sweep_points(&scene->sweep), *text ? text : "nothing varies");
  for (int i = 0; i < scene->wants; i++) {
    if (scene->want[i].kind == WANT_COMMAND)
      add(plan, COUNT_COMMANDS, 1, scene->want[i].what);
    if (scene->want[i].has_plot)
      add(plan, COUNT_PLOTS, 1, scene->want[i].plot.file);
  }
  plan->stage[COUNT_ONSETS].is_at_most = plan->stage[COUNT_EXPANSIONS].is_at_most =
      plan->stage[COUNT_PLOTS].is_at_most = true;
  plan->needs_flint = plan->stage[COUNT_CERTIFIED].count > 0 || plan->stage[COUNT_EXPANSIONS].count > 0
                      || plan->stage[COUNT_COMMANDS].count > 0;
}
