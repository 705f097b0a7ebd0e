#include "compare/scenes/parts.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/answers/counts.h"
#include "compare/book/book.h"
#include "compare/answers/gaits.h"

bool state_init(struct scene_state *s, const struct scene *scene, struct tally *tally)
{
  *s = (struct scene_state){ .scene = scene, .tally = tally, .onset = 1 };
  if (!tally && scene->plan.needs_flint)
    s->flint = scene_flint.create();
  return tally || !scene->plan.needs_flint || s->flint;
}

void state_clear(struct scene_state *s)
{
  if (s->flint)
    scene_flint.free(s->flint);
}

/* Counts what is done, or would be. */
static void spend(struct scene_state *s, enum count stage)
{
  if (!s->tally)
    count_add(stage, 1);
  else if (s->tally[stage].count++ == 0)
    s->tally[stage].reason = s->asking;
}

/* Is the cell to be solved: asked for the first time at this point, and not for the plan? */
static bool is_to_solve(struct scene_state *s, enum cell cell, enum count stage)
{
  bool is_first = !s->has_cell[cell];
  s->has_cell[cell] = true;
  if (is_first)
    spend(s, stage);
  return is_first && !s->tally;
}

static double check(struct scene_state *s, enum scallop_status status, double value)
{
  return status < 0 ? state_fail(s, scallop_status_text(status)) : value;
}

/* Parameters may have changed since the last formula. */
static double formula_so_far(void *state, const struct formula *formula)
{
  struct scene_state *s = state;
  memset(s->has, 0, sizeof s->has);
  return state_formula(s, formula);
}

void state_move(struct scene_state *s, const struct sweep_product *product, const long *index)
{
  const struct scene *scene = s->scene;
  s->point = scene->base;
  s->point.has_v0 = scene->start != START_STEADY;
  s->is_outside = false;
  memset(s->has_cell, 0, sizeof s->has_cell);
  memset(s->comparison, 0, (size_t)scene->quantities.count * sizeof *s->comparison);
  sweep_move(&s->swept, &s->point, product, index, formula_so_far, s);
  memset(s->has, 0, sizeof s->has); /* what a range was found with may have changed since */
  s->has_cell[ONSET] = false;
  if (s->tally)
    s->tally[COUNT_ONSETS].reason = "the ends of a range";
  s->why[0] = '\0'; /* what a formula could not have */
  if (s->swept.why[0] != '\0' && !s->tally)
    state_fail(s, s->swept.why);
  s->is_outside = s->why[0] != '\0';
  if (s->flint)
    scene_flint.move(s);
  spend(s, COUNT_POINTS);
}

void state_begin_row(struct scene_state *s)
{
  s->tells_steady = false;
  if (!s->is_outside)
    s->why[0] = '\0';
}

/* The answer in double; NULL: there is none, and visit.why says why. */
static const struct answer *solved(struct scene_state *s, enum quantity_of of)
{
  struct answer *a = &s->answer[of];
  double v0 = of == OF_PHASE ? state_v0(s) : 0;
  if (isnan(v0))
    return NULL;
  if (is_to_solve(s, IN_DOUBLE + of, of == OF_PHASE ? COUNT_PHASES : COUNT_STEADY)) {
    s->motion[of] = (struct motion){ of, s->point.crawler, s->scene->phase, v0 };
    if (answer_in_double(a, &s->motion[of]))
      count_work(&a->work);
  }
  return check(s, a->status, 0) == 0 ? a : NULL;
}

double state_v0(struct scene_state *s)
{
  if (s->point.has_v0)
    return s->point.v0;
  const struct answer *a = solved(s, OF_STEADY);
  return a ? a->value[s->scene->phase == SCALLOP_EXTENSION ? Q_V_START : Q_V_MID].high : NAN;
}

/* The answer, with those of its numbers that take another walk, which is only done where one of them is asked for */
static const struct answer *solved_with(struct scene_state *s, enum quantity_of of, int quantity)
{
  const struct answer *a = solved(s, of);
  if (!a)
    return NULL;
  if (quantity == Q_AT_FIRST || quantity == Q_AT_LAST) {
    if (is_to_solve(s, TURNINGS, COUNT_PHASES))
      answer_turnings(&s->answer[OF_PHASE], &s->motion[OF_PHASE]);
  } else if (quantity == Q_FRICTION_WORK || quantity == Q_COST_OF_TRANSPORT) {
    if (!s->has_cell[FRICTION] && !s->tally)
      s->friction = answer_friction(&s->answer[OF_STEADY], &s->motion[OF_STEADY]);
    s->has_cell[FRICTION] = true;
    check(s, s->friction, 0);
  }
  return a;
}

/* Makes ready for what certified answers and series give at the point. False: a phase that has no start velocity. */
static bool has_start(struct scene_state *s, enum quantity_of of)
{
  s->v0 = of == OF_PHASE ? state_v0(s) : 0;
  return !isnan(s->v0);
}

static bool certify(struct scene_state *s, enum quantity_of of)
{
  bool has = has_start(s, of);
  if (has && is_to_solve(s, IN_BALLS + of, COUNT_CERTIFIED))
    scene_flint.certify(s, of);
  return has && !s->tally;
}

static enum quantity_of motion_of_quantity(const struct scene_state *s, const struct quantity *q)
{
  return quantity_is_of_phase(&s->scene->quantities, q) ? OF_PHASE : OF_STEADY;
}

/* The sum of a derived series */
static bool expand(struct scene_state *s, const struct quantity *series)
{
  enum quantity_of of = motion_of_quantity(s, series);
  bool has = has_start(s, of);
  if (has && s->tally) /* of those that are done, flint.c knows which are new */
    is_to_solve(s, IN_SERIES + of, COUNT_EXPANSIONS);
  if (has)
    spend(s, COUNT_SUMS);
  return has && !s->tally;
}

/* The longest period at which an extension from rest does not stick; no body need ever stick. It is kept until a
 * parameter but T changes. */
static double onset_of_sticking(struct scene_state *s)
{
  struct scallop_crawler c = s->point.crawler;
  c.T = 1;
  if (s->tally)
    is_to_solve(s, ONSET, COUNT_ONSETS);
  else if (!same_crawler(&s->onset_of, &c)) {
    spend(s, COUNT_ONSETS);
    s->onset_of = c;
    s->onset = sticking_onset(&c);
  }
  return s->onset;
}

static double published(struct scene_state *s, const struct scallop_formula *f)
{
  const struct scallop_crawler *c = &s->point.crawler;
  const bool steady = f->setting == SCALLOP_STEADY, is_given = formula_takes_given(f);
  const struct motion m = { steady ? OF_STEADY : OF_PHASE, *c, s->scene->phase, steady ? NAN : state_v0(s) };
  const struct answer *given =
      is_given ? solved_with(s, OF_PHASE, formula_takes(f, SCALLOP_SYMBOL_x_switch) ? Q_AT_LAST : Q_DT) : NULL;
  if (is_given && !given)
    return NAN;
  double value = published_value(f, &m, given);
  spend(s, COUNT_FORMULAS);
  if (!isfinite(value) && !gait_has_ends(c->gait))
    return state_fail(s, gait_no_ends);
  return isfinite(value) ? value : NAN;
}

/* A series beside what it should be, in balls or by the double solver */
static void compare(struct scene_state *s, struct comparison *c, const struct quantity *series, int place)
{
  bool is_published = series->kind == QUANTITY_PUBLISHED;
  int quantity = is_published ? (int)quantity_of_formula(series->formula, s->scene->phase) : series->which;
  enum quantity_of of = motion_of_quantity(s, series);
  *c = (struct comparison){ .error = NAN, .value = NAN, .exact = NAN };
  if (!s->scene->plan.needs.certified_errors) {
    const struct answer *a = solved_with(s, of, quantity);
    c->exact = a ? a->value[quantity].high : NAN;
    c->value = state_number(s, place);
    c->error = c->value - c->exact;
    if (fabs(c->error) < s->scene->plan.needs.accuracy * fabs(c->exact))
      c->error = 0;
    return;
  }
  bool ready = certify(s, of);
  if (!is_published)
    ready &= expand(s, series);
  else {
    spend(s, COUNT_FORMULAS);
    if (formula_takes_given(series->formula))
      ready &= certify(s, OF_PHASE);
  }
  if (ready)
    *c = scene_flint.compare(s, series, quantity);
}

static const struct comparison *compared(struct scene_state *s, int place)
{
  struct comparison *c = &s->comparison[place];
  long before = s->failures;
  if (!c->done)
    compare(s, c, &s->scene->quantities.item[place], place);
  c->done = s->tally || s->failures == before;
  return c;
}

/* What it was set to, or to the bit what the solver says */
static double froude(struct scene_state *s)
{
  struct scallop_scaled scaled;
  if (!isnan(s->swept.froude))
    return s->swept.froude;
  return check(s, scallop_scale(&s->point.crawler, &scaled), 0) == 0 ? 1 / scaled.eps : NAN;
}

static double compute(struct scene_state *s, const struct quantity *q)
{
  const struct scallop_crawler *c = &s->point.crawler;
  const struct quantities *all = &s->scene->quantities;
  static const struct comparison none;
  const struct answer *a;
  double numbers[CRAWLER_NUMBERS];
  if (s->is_outside && q->kind != QUANTITY_NUMBER && q->kind != QUANTITY_V0)
    return NAN; /* the point has no such thing */
  if (s->scene->plan.needs.certified_errors && quantity_is_series(q) && quantity_is_compared(all, q))
    return compared(s, (int)(q - all->item))->value; /* rounded from the one that the error is of */
  const struct comparison *series = q->of >= 0 ? compared(s, q->of) : &none;
  switch (q->kind) {
  case QUANTITY_NUMBER: crawler_numbers(c, numbers); return numbers[q->which];
  case QUANTITY_V0: return state_v0(s);
  case QUANTITY_FROUDE: return froude(s);
  case QUANTITY_F1_OVER_F2: return isnan(s->swept.F1_over_F2) ? c->F1 / c->F2 : s->swept.F1_over_F2;
  case QUANTITY_M1_OVER_M2: return isnan(s->swept.m1_over_m2) ? c->m1 / c->m2 : s->swept.m1_over_m2;
  case QUANTITY_ONSET: return onset_of_sticking(s);
  case QUANTITY_ANSWER:
    a = solved_with(s, quantity_rows[q->which].of, q->which);
    return a ? a->value[q->which].high : NAN;
  case QUANTITY_PUBLISHED: return published(s, q->formula);
  case QUANTITY_DERIVED:
  case QUANTITY_LIMIT: return expand(s, q) ? scene_flint.sum(s, q) : NAN;
  case QUANTITY_EXACT: return series->exact;
  case QUANTITY_ERROR: return series->error;
  case QUANTITY_RELATIVE: return series->error / fabs(series->exact);
  default: return NAN; /* texts, and what only a trajectory has */
  }
}

/* What is asked for, of which the row then tells something */
static const struct quantity *ask(struct scene_state *s, int quantity)
{
  const struct quantity *q = &s->scene->quantities.item[quantity];
  bool answered = q->kind == QUANTITY_ANSWER || q->kind == QUANTITY_REGIME || q->kind == QUANTITY_MODES;
  s->tells_steady |= (answered || q->of >= 0) && motion_of_quantity(s, q) == OF_STEADY;
  s->asking = q->name;
  return q;
}

double state_number(struct scene_state *s, int quantity)
{
  const struct quantity *q = ask(s, quantity);
  if (!s->has[quantity]) {
    long before = s->failures;
    s->value[quantity] = compute(s, q);
    s->has[quantity] = s->tally || s->failures == before; /* a failure is told in each row; solutions are kept */
  }
  return s->value[quantity];
}

static const char *status_text(struct scene_state *s)
{
  if (s->why[0] != '\0')
    return s->why;
  return s->tells_steady && s->has_cell[IN_DOUBLE + OF_STEADY] ? answer_status_text(s->text, &s->answer[OF_STEADY])
                                                               : "ok";
}

const char *state_text(struct scene_state *s, int quantity, long digits)
{
  const struct quantity *q = ask(s, quantity);
  const struct answer *a;
  switch (q->kind) {
  case QUANTITY_GAIT: return s->point.crawler.gait->name;
  case QUANTITY_LABEL: return s->swept.label[q->which] ? s->swept.label[q->which] : "-";
  case QUANTITY_PHASE_NAME: return s->scene->phase == SCALLOP_EXTENSION ? "extension" : "contraction";
  case QUANTITY_REGIME:
  case QUANTITY_MODES:
    a = s->is_outside ? NULL : solved(s, (enum quantity_of)q->which);
    return !a                           ? "-"
           : q->kind == QUANTITY_REGIME ? scallop_regime_text(a->regime)
                                        : motion_modes_text(s->text, (enum quantity_of)q->which, a->modes);
  case QUANTITY_CERTIFIED:
    return !s->is_outside && certify(s, quantity_rows[q->which].of)
               ? scene_flint.text(s, q, digits > 0 ? digits : DIGITS_OF_DOUBLE)
               : "nan";
  default: return status_text(s);
  }
}

void state_find(struct scene_state *s, int quantity, long digits)
{
  if (quantity_is_text(&s->scene->quantities.item[quantity]))
    state_text(s, quantity, digits);
  else
    state_number(s, quantity);
}

double state_formula(struct scene_state *s, const struct formula *formula)
{
  int places[FORMULA_STEPS], count = formula_places(formula, places);
  for (int i = 0; i < count; i++)
    state_number(s, places[i]);
  return formula_double(formula, s->value);
}

double state_end(struct scene_state *s, const struct sweep_end *end)
{
  return end->is_formula ? state_formula(s, &end->formula) : end->number;
}
