#include "compare/scenes/state.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/answers/counts.h"
#include "compare/answers/gaits.h"

void state_init(struct scene_state *s, const struct scene *scene)
{
  *s = (struct scene_state){ .scene = scene, .at = scene->base, .asked = { .scene = scene, .at = &s->at } };
}

void state_clear(struct scene_state *s)
{
  if (s->asked.flint)
    scene_flint.free(s->asked.flint);
}

double state_fail(struct scene_state *s, const char *why)
{
  s->failures++;
  if (s->why[0] == '\0')
    snprintf(s->why, sizeof s->why, "%s", why);
  return NAN;
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
  s->at = scene->base;
  s->at.has_v0 = scene->start != START_STEADY;
  s->why[0] = '\0';
  s->is_outside = false;
  s->has_answer[OF_STEADY] = s->has_answer[OF_PHASE] = s->has_turnings = s->has_friction = false;
  memset(s->has, 0, sizeof s->has);
  memset(s->comparison, 0, (size_t)scene->quantities.count * sizeof *s->comparison);
  if (s->asked.flint)
    scene_flint.forget(s->asked.flint);
  sweep_move(&s->swept, &s->at, product, index, formula_so_far, s);
  s->why[0] = '\0'; /* what a formula could not have */
  if (s->swept.why[0] != '\0')
    state_fail(s, s->swept.why);
  memset(s->has, 0, sizeof s->has); /* what a range was found with may have changed since */
  s->is_outside = s->why[0] != '\0';
  count_add(COUNT_POINTS, 1);
}

void state_begin_row(struct scene_state *s)
{
  s->tells_steady = false;
  if (!s->is_outside)
    s->why[0] = '\0';
}

/* The answer in double; NULL: there is none, and s->why says why. */
static const struct answer *solved(struct scene_state *s, enum quantity_of of)
{
  struct answer *a = &s->answer[of];
  double v0 = of == OF_PHASE ? state_v0(s) : 0;
  if (isnan(v0))
    return NULL;
  if (!s->has_answer[of]) {
    s->motion[of] = (struct motion){ of, s->at.crawler, s->scene->phase, v0 };
    s->has_answer[of] = true;
    count_add(of == OF_PHASE ? COUNT_PHASES : COUNT_STEADY, 1);
    if (answer_in_double(a, &s->motion[of]))
      count_work(&a->work);
  }
  return check(s, a->status, 0) == 0 ? a : NULL;
}

double state_v0(struct scene_state *s)
{
  if (s->at.has_v0)
    return s->at.v0;
  const struct answer *a = solved(s, OF_STEADY);
  return a ? a->value[s->scene->phase == SCALLOP_EXTENSION ? Q_V_START : Q_V_MID].high : NAN;
}

/* Makes ready for what needs FLINT. False: it is of the phase, which has no start velocity. */
static bool ask(struct scene_state *s, const struct quantity *q)
{
  s->asked.v0 = quantity_is_of_phase(&s->scene->quantities, q) ? state_v0(s) : 0;
  s->asked.why[0] = '\0';
  return !isnan(s->asked.v0);
}

/* Why the last thing asked for could not be had, if so. Returns x. */
static double note_failure(struct scene_state *s, double x)
{
  if (s->asked.why[0] != '\0')
    state_fail(s, s->asked.why);
  return x;
}

/* Where the rear body turns takes a second walk through the phase. */
static void find_turnings(struct scene_state *s)
{
  if (s->has_turnings)
    return;
  s->has_turnings = answer_turnings(&s->answer[OF_PHASE], &s->motion[OF_PHASE]);
  count_add(COUNT_PHASES, 1);
}

static void find_friction(struct scene_state *s)
{
  if (!s->has_friction)
    s->friction = answer_friction(&s->answer[OF_STEADY], &s->motion[OF_STEADY]);
  s->has_friction = true;
  check(s, s->friction, 0);
}

/* Those that are no columns unless they are asked for take another walk. */
static double number_of(struct scene_state *s, enum quantity_of of, int q)
{
  struct answer *a = &s->answer[of];
  if (q == Q_AT_FIRST || q == Q_AT_LAST)
    find_turnings(s);
  if (q == Q_FRICTION_WORK || q == Q_COST_OF_TRANSPORT)
    find_friction(s);
  return a->value[q].high;
}

/* The longest period at which an extension from rest does not stick; no body need ever stick. */
static double onset_of_sticking(struct scene_state *s)
{
  struct scallop_crawler c = s->at.crawler;
  c.T = 1; /* the onset is the same for each T */
  if (!s->has_onset || !same_crawler(&s->onset_of, &c)) {
    s->has_onset = true;
    s->onset_of = c;
    s->onset = sticking_onset(&c);
    count_add(COUNT_ONSETS, 1);
  }
  return s->onset;
}

static double published(struct scene_state *s, const struct scallop_formula *f)
{
  double value;
  if (f->setting == SCALLOP_STEADY) {
    count_add(COUNT_FORMULAS, 1);
    value = f->steady(&s->at.crawler);
  } else {
    const struct motion m = { OF_PHASE, s->at.crawler, s->scene->phase, state_v0(s) };
    const struct answer none = { .value = { [Q_T1] = { NAN, 0 }, [Q_DT] = { NAN, 0 }, [Q_AT_LAST] = { NAN, 0 } } };
    const struct answer *given = formula_takes_given(f) ? solved(s, OF_PHASE) : &none;
    if (!given)
      return NAN;
    if (strstr(f->text, "x_switch"))
      find_turnings(s);
    const struct scallop_phase_point point = scallop_phase_point(&m.crawler, m.phase, m.v0);
    count_add(COUNT_FORMULAS, 1);
    value = published_value(f, &point, &m, given);
  }
  if (!isfinite(value) && !gait_has_ends(s->at.crawler.gait))
    return state_fail(s, gait_no_ends);
  return isfinite(value) ? value : NAN;
}

/* What the series is said to be, by the double solver */
static double exact_in_double(struct scene_state *s, const struct quantity *series)
{
  enum quantity_of of = quantity_is_of_phase(&s->scene->quantities, series) ? OF_PHASE : OF_STEADY;
  int q = series->kind == QUANTITY_PUBLISHED ? (int)quantity_of_formula(series->formula, s->scene->phase) : series->which;
  return solved(s, of) ? number_of(s, of, q) : NAN;
}

/* A series beside what it should be. */
static const struct scene_comparison *compared(struct scene_state *s, int place)
{
  const struct quantity *series = &s->scene->quantities.item[place];
  struct scene_comparison *c = &s->comparison[place];
  long before = s->failures;
  if (!c->done && s->scene->plan.needs.certified_errors) {
    c->error = c->value = c->exact = NAN;
    if (ask(s, series))
      c->error = note_failure(s, scene_flint.error(&s->asked, series, &c->value, &c->exact));
  } else if (!c->done) {
    c->exact = exact_in_double(s, series);
    c->value = state_number(s, place);
    c->error = c->value - c->exact;
    if (fabs(c->error) < s->scene->plan.needs.accuracy * fabs(c->exact))
      c->error = 0;
  }
  c->done = s->failures == before;
  return c;
}

static double about_series(struct scene_state *s, const struct quantity *q)
{
  const struct scene_comparison *c = compared(s, q->of);
  return q->kind == QUANTITY_EXACT ? c->exact : q->kind == QUANTITY_ERROR ? c->error : c->error / fabs(c->exact);
}

/* What it was set to, or to the bit what the solver says */
static double froude(struct scene_state *s)
{
  struct scallop_scaled scaled;
  if (!isnan(s->swept.froude))
    return s->swept.froude;
  return check(s, scallop_scale(&s->at.crawler, &scaled), 0) == 0 ? 1 / scaled.eps : NAN;
}

static double compute(struct scene_state *s, const struct quantity *q)
{
  const struct scallop_crawler *c = &s->at.crawler;
  double numbers[CRAWLER_NUMBERS];
  if (s->is_outside && q->kind != QUANTITY_NUMBER && q->kind != QUANTITY_V0)
    return NAN; /* the point has no such thing */
  if (s->scene->plan.needs.certified_errors && quantity_is_series(q) && quantity_is_compared(&s->scene->quantities, q))
    return compared(s, quantity_find(&s->scene->quantities, q->name))->value; /* rounded from the one that the error is of */
  enum quantity_of of = q->kind == QUANTITY_ANSWER ? quantity_rows[q->which].of : OF_STEADY;
  switch (q->kind) {
  case QUANTITY_NUMBER: crawler_numbers(c, numbers); return numbers[q->which];
  case QUANTITY_V0: return state_v0(s);
  case QUANTITY_FROUDE: return froude(s);
  case QUANTITY_F1_OVER_F2: return isnan(s->swept.F1_over_F2) ? c->F1 / c->F2 : s->swept.F1_over_F2;
  case QUANTITY_M1_OVER_M2: return isnan(s->swept.m1_over_m2) ? c->m1 / c->m2 : s->swept.m1_over_m2;
  case QUANTITY_ONSET: return onset_of_sticking(s);
  case QUANTITY_ANSWER: return solved(s, of) ? number_of(s, of, q->which) : NAN;
  case QUANTITY_PUBLISHED: return published(s, q->formula);
  case QUANTITY_DERIVED:
  case QUANTITY_LIMIT: return ask(s, q) ? note_failure(s, scene_flint.sum(&s->asked, q)) : NAN;
  case QUANTITY_EXACT:
  case QUANTITY_ERROR:
  case QUANTITY_RELATIVE: return about_series(s, q);
  default: return NAN; /* texts, and what only a trajectory has */
  }
}

static bool is_of_steady(const struct scene_state *s, const struct quantity *q)
{
  bool answered = q->kind == QUANTITY_ANSWER || q->kind == QUANTITY_REGIME || q->kind == QUANTITY_MODES;
  return (answered || q->of >= 0) && !quantity_is_of_phase(&s->scene->quantities, q);
}

double state_number(struct scene_state *s, int quantity)
{
  const struct quantity *q = &s->scene->quantities.item[quantity];
  s->tells_steady |= is_of_steady(s, q);
  if (!s->has[quantity]) {
    long before = s->failures;
    s->value[quantity] = compute(s, q);
    s->has[quantity] = s->failures == before; /* a failure is told in each row that it is of; solutions are kept */
  }
  return s->value[quantity];
}

static const char *answer_text(struct scene_state *s, const struct quantity *q)
{
  enum quantity_of of = (enum quantity_of)q->which;
  const struct answer *a = s->is_outside ? NULL : solved(s, of);
  if (!a)
    return "-";
  return q->kind == QUANTITY_REGIME ? scallop_regime_text(a->regime) : motion_modes_text(s->text, of, a->modes);
}

static const char *certified_text(struct scene_state *s, const struct quantity *q, long digits)
{
  if (s->is_outside || !ask(s, q))
    return "nan";
  const char *text = scene_flint.certified(&s->asked, q, digits);
  note_failure(s, 0);
  return text;
}

static const char *status_text(struct scene_state *s)
{
  if (s->why[0] != '\0')
    return s->why;
  return s->tells_steady && s->has_answer[OF_STEADY] ? answer_status_text(s->text, &s->answer[OF_STEADY]) : "ok";
}

const char *state_text(struct scene_state *s, int quantity, long digits)
{
  const struct quantity *q = &s->scene->quantities.item[quantity];
  s->tells_steady |= is_of_steady(s, q);
  switch (q->kind) {
  case QUANTITY_GAIT: return s->at.crawler.gait->name;
  case QUANTITY_LABEL: return s->swept.label[q->which] ? s->swept.label[q->which] : "-";
  case QUANTITY_PHASE_NAME: return s->scene->phase == SCALLOP_EXTENSION ? "extension" : "contraction";
  case QUANTITY_REGIME:
  case QUANTITY_MODES: return answer_text(s, q);
  case QUANTITY_CERTIFIED: return certified_text(s, q, digits);
  default: return status_text(s);
  }
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
