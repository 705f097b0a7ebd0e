#include "compare/answers/at.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/answers/flint.h"
#include "compare/book/book.h"
#include "compare/columns/columns.h"
#include "compare/points/counts.h"
#include "compare/points/gaits.h"

const struct at_flint_functions *at_flint;
const struct at_study_functions *at_study;

struct at *at_new(const struct asked *asked)
{
  const char *needs_flint = asked_needs_flint(asked);
  if (needs_flint && !flint_for(asked->command, needs_flint))
    return NULL;
  struct at *s = malloc(sizeof *s);
  if (!s)
    return complain(asked->command, "out of memory"), NULL;
  memset(s, 0, offsetof(struct at, has)); /* the rest, which is large, when a point is moved to */
  s->asked = asked;
  s->onset = 1;
  s->certified_errors = asked_certifies_errors(asked);
  return s;
}

void at_free(struct at *s)
{
  if (s && s->flint)
    at_flint->free(s->flint);
  if (s && s->study)
    at_study->free(s->study);
  free(s);
}

double at_fail(struct at *s, const char *why)
{
  s->failures++;
  if (s->why[0] == '\0')
    snprintf(s->why, sizeof s->why, "%s", why);
  return NAN;
}

static double check(struct at *s, enum scallop_status status, double value)
{
  return status < 0 ? at_fail(s, scallop_status_text(status)) : value;
}

/* Is this done for the first time at this point? Then it is counted. */
static bool is_first(bool *done, enum count stage)
{
  bool first = !*done;
  *done = true;
  count_add(stage, first);
  return first;
}

static void forget(struct at *s)
{
  const size_t count = (size_t)s->asked->quantities.count;
  for (int m = 0; m < POINT_MOTIONS; m++) {
    struct solved *a = &s->solved[m];
    a->in_double = a->with_errors = a->with_second_walk = false;
  }
  memset(s->has, 0, count * sizeof *s->has);
  memset(s->comparison, 0, count * sizeof *s->comparison);
  s->is_outside = s->tells_steady = false;
  s->why[0] = '\0';
}

void at_move(struct at *s)
{
  const char *wrong = s->place.why[0] != '\0' ? s->place.why : NULL;
  forget(s);
  s->place.point.has_v0 |= !s->asked->from_steady;
  if (wrong)
    at_fail(s, wrong);
  s->is_outside = wrong != NULL;
  s->moves++;
  count_add(COUNT_POINTS, 1);
}

double at_formula_so_far(void *at, const struct sweep_place *place, const struct formula *formula)
{
  struct at *s = at;
  sweep_place_copy(&s->place, place);
  forget(s);
  return at_formula(s, formula);
}

void at_begin_row(struct at *s)
{
  s->tells_steady = false;
  if (!s->is_outside)
    s->why[0] = '\0';
}

/* The phase of a kind from the start of the point, or from rest */
static enum motion_of_point motion_from(const struct at *s, enum scallop_phase_kind phase, bool from_rest)
{
  const struct point *p = &s->place.point;
  bool rests = from_rest || (p->has_v0 && p->v0 == 0);
  return (enum motion_of_point)((int)(rests ? FROM_REST : FROM_START) + (int)phase);
}

/* The motion that a quantity is of: a formula of a phase from rest is of that, wherever the point's phase begins. */
static enum motion_of_point motion_of_quantity(const struct at *s, const struct quantity *q)
{
  if (q->motion == OF_STEADY)
    return STEADY_STATE;
  return motion_from(s, q->phase >= 0 ? (enum scallop_phase_kind)q->phase : s->place.point.phase, q->from_rest);
}

static const struct answer *solve(struct at *s, enum motion_of_point m);

/* The start velocity of a motion; of the steady state 0, and nan where that has to be known and is not */
static double start_of(struct at *s, enum motion_of_point m)
{
  if (m == STEADY_STATE || m >= FROM_REST)
    return 0;
  if (s->place.point.has_v0)
    return s->place.point.v0;
  const struct answer *a = solve(s, STEADY_STATE);
  return a ? a->value[phase_kind(m) == SCALLOP_EXTENSION ? Q_V_START : Q_V_MID].high : NAN;
}

/* The answer in double; NULL: there is none, and s->why says why. */
static const struct answer *solve(struct at *s, enum motion_of_point m)
{
  struct solved *a = &s->solved[m];
  double v0 = a->in_double ? a->motion.v0 : start_of(s, m);
  if (isnan(v0))
    return NULL;
  if (is_first(&a->in_double, m == STEADY_STATE ? COUNT_STEADY : COUNT_PHASES)) {
    a->motion = (struct motion){ m == STEADY_STATE ? OF_STEADY : OF_PHASE, s->place.point.crawler, phase_kind(m), v0 };
    if (answer_in_double(&a->answer, &a->motion))
      count_work(&a->answer.work);
  }
  return check(s, a->answer.status, 0) == 0 ? &a->answer : NULL;
}

static bool has_start(struct at *s, enum motion_of_point m) { return !isnan(start_of(s, m)); }

double at_v0(struct at *s) { return start_of(s, motion_from(s, s->place.point.phase, false)); }

/* The answer, with those of its numbers that take another walk, which is only done where one of them is asked for */
static const struct answer *solve_for(struct at *s, enum motion_of_point m, int quantity)
{
  struct solved *a = &s->solved[m];
  if (!solve(s, m))
    return NULL;
  bool by_second_walk = quantity >= Q_FRICTION_WORK && quantity <= Q_AT_LAST;
  if (by_second_walk && !a->with_second_walk) {
    count_add(COUNT_PHASES, m != STEADY_STATE);
    a->second_walk = answer_by_second_walk(&a->answer, &a->motion);
    a->with_second_walk = true;
  }
  if (by_second_walk)
    check(s, a->second_walk, 0);
  return &a->answer;
}

static double estimate(struct at *s, const struct quantity *q)
{
  static const double rounded_up = 1.005; /* with three digits */
  enum motion_of_point m = motion_of_quantity(s, q);
  struct solved *a = &s->solved[m];
  struct answer again;
  if (!solve(s, m))
    return NAN;
  if (!a->with_errors)
    check(s, answer_with_errors(&again, &a->motion, a->estimate) ? SCALLOP_OK : again.status, 0);
  a->with_errors = true;
  return rounded_up * a->estimate[q->which];
}

/* The longest period at which an extension from rest does not stick; no body need ever stick. It is kept until a
 * parameter but T changes. */
static double onset_of_sticking(struct at *s)
{
  struct scallop_crawler c = s->place.point.crawler;
  c.T = 1;
  if (!same_crawler(&s->onset_of, &c)) {
    count_add(COUNT_ONSETS, 1);
    s->onset_of = c;
    s->onset = sticking_onset(&c);
  }
  return s->onset;
}

static double published(struct at *s, const struct quantity *q)
{
  const struct scallop_formula *f = q->formula;
  const struct scallop_crawler *c = &s->place.point.crawler;
  enum motion_of_point m = motion_of_quantity(s, q);
  const struct motion motion = { q->motion, *c, phase_kind(m), start_of(s, m) };
  const struct answer *given = NULL;
  if (formula_takes_given(f)) {
    given = solve_for(s, m, formula_takes(f, SCALLOP_SYMBOL_x_switch) ? Q_AT_LAST : Q_DT);
    if (!given)
      return NAN;
  }
  double value = published_value(f, &motion, given);
  count_add(COUNT_FORMULAS, 1);
  if (!isfinite(value) && !gait_has_ends(c->gait))
    return at_fail(s, gait_no_ends);
  return isfinite(value) ? value : NAN;
}

/* A series beside what it should be, in balls or by the double solver */
static void compare(struct at *s, struct series_error *c, const struct quantity *series, int place)
{
  bool is_published = series->kind == QUANTITY_PUBLISHED;
  enum motion_of_point m = motion_of_quantity(s, series);
  int quantity = is_published ? (int)quantity_of_formula(series->formula, phase_kind(m)) : series->which;
  *c = (struct series_error){ .error = NAN, .value = NAN, .exact = NAN };
  if (!s->certified_errors) {
    const struct answer *a = solve_for(s, m, quantity);
    c->exact = a ? a->value[quantity].high : NAN;
    c->value = at_number(s, place);
    c->error = c->value - c->exact;
    if (fabs(c->error) < s->asked->accuracy * fabs(c->exact))
      c->error = 0;
    return;
  }
  if (has_start(s, m))
    *c = at_flint->compare(s, series, quantity, m);
}

static const struct series_error *compared(struct at *s, int place)
{
  struct series_error *c = &s->comparison[place];
  long before = s->failures;
  if (!c->done)
    compare(s, c, &s->asked->quantities.item[place], place);
  c->done = s->failures == before;
  return c;
}

/* What it was set to, or to the bit what the solver says */
static double froude(struct at *s)
{
  struct scallop_scaled scaled;
  if (s->place.point.ratio[FROUDE] > 0)
    return s->place.point.ratio[FROUDE];
  return check(s, scallop_scale(&s->place.point.crawler, &scaled), 0) == 0 ? 1 / scaled.eps : NAN;
}

static double ratio(const struct point *p, enum ratio_place which)
{
  const struct scallop_crawler *c = &p->crawler;
  return p->ratio[which] > 0 ? p->ratio[which] : which == F1_OVER_F2 ? c->F1 / c->F2 : c->m1 / c->m2;
}

/* Can it be told although the parameters are no point? */
static bool is_known_outside(const struct at *s, const struct quantity *q)
{
  return q->kind == QUANTITY_NUMBER || q->kind == QUANTITY_V0
         || (q->kind == QUANTITY_RATIO && s->place.point.ratio[q->which] > 0);
}

static double compute(struct at *s, const struct quantity *q)
{
  static const struct series_error none = { .value = NAN, .exact = NAN, .error = NAN };
  enum motion_of_point m = motion_of_quantity(s, q);
  const struct answer *a;
  if (s->place.is_unread || (s->is_outside && !is_known_outside(s, q)))
    return NAN; /* the point has no such thing */
  if (s->certified_errors && q->is_compared)
    return compared(s, (int)(q - s->asked->quantities.item))->value; /* rounded from the one that the error is of */
  const struct series_error *series = quantity_is_comparison(q) ? compared(s, q->of) : &none;
  switch (q->kind) {
  case QUANTITY_NUMBER: return crawler_number(&s->place.point.crawler, q->which);
  case QUANTITY_V0: return s->asked->tells_no_start && !s->place.point.has_v0 ? NAN : at_v0(s);
  case QUANTITY_FROUDE: return froude(s);
  case QUANTITY_RATIO: return ratio(&s->place.point, (enum ratio_place)q->which);
  case QUANTITY_ONSET: return onset_of_sticking(s);
  case QUANTITY_ANSWER: a = solve_for(s, m, q->which); return a ? a->value[q->which].high : NAN;
  case QUANTITY_ESTIMATE: return estimate(s, q);
  case QUANTITY_PUBLISHED: return published(s, q);
  case QUANTITY_DERIVED:
  case QUANTITY_LIMIT: return has_start(s, m) ? at_flint->sum(s, q, m) : NAN;
  case QUANTITY_EXACT: return series->exact;
  case QUANTITY_ERROR: return series->error;
  case QUANTITY_RELATIVE: return series->error / fabs(series->exact);
  case QUANTITY_STUDIED: return at_study->number(s, q);
  case QUANTITY_FORMULA: return at_formula(s, q->own);
  default: return NAN; /* texts, and what only a trajectory has */
  }
}

/* What is asked for, of which the row then tells something */
static const struct quantity *ask(struct at *s, int quantity)
{
  const struct quantity *q = &s->asked->quantities.item[quantity];
  bool answered = q->kind == QUANTITY_ANSWER || q->kind == QUANTITY_REGIME || q->kind == QUANTITY_MODES;
  s->tells_steady |= (answered || quantity_is_comparison(q)) && q->motion == OF_STEADY;
  return q;
}

double at_number(struct at *s, int quantity)
{
  const struct quantity *q = ask(s, quantity);
  if (s->has[quantity])
    return s->value[quantity];
  long before = s->failures;
  double x = quantity_is_text(q) ? text_number(at_text(s, quantity, 0)) : compute(s, q);
  s->has[quantity] = s->failures == before; /* a failure is told in each row; solutions are kept */
  return s->value[quantity] = x;
}

static const char *status_text(struct at *s)
{
  const struct solved *steady = &s->solved[STEADY_STATE];
  if (s->why[0] != '\0')
    return s->why;
  if (s->as_written)
    return "certified";
  return s->tells_steady && steady->in_double ? answer_status_text(s->text, &steady->answer) : "ok";
}

/* The regime or the modes, in double or proven */
static const char *how(struct at *s, const struct quantity *q)
{
  enum motion_of_point m = motion_of_quantity(s, q);
  struct answer proven;
  const struct answer *a = &proven;
  if (s->is_outside)
    return "-";
  if (!s->as_written)
    a = solve(s, m);
  else if (!has_start(s, m) || !at_flint->modes(s, m, &proven.regime, proven.modes))
    a = NULL;
  return !a                           ? "-"
         : q->kind == QUANTITY_REGIME ? scallop_regime_text(a->regime)
                                      : motion_modes_text(s->text, q->motion, a->modes);
}

/* In double, whatever else is certified; "-" is no failure */
static const char *in_words(struct at *s, enum motion_of_point m)
{
  enum { SHOWN = 6 };
  long failures = s->failures;
  bool had_why = s->why[0] != '\0';
  const struct answer *a = s->is_outside || had_why ? NULL : solve(s, m);
  if (!had_why && s->as_written) {
    s->why[0] = '\0';
    s->failures = failures;
  }
  return a ? motion_in_words(s->text, &s->solved[m].motion, a, SHOWN) : "-";
}

const char *at_text(struct at *s, int quantity, long digits)
{
  const struct quantity *q = ask(s, quantity);
  const struct point *p = &s->place.point;
  enum motion_of_point m = motion_of_quantity(s, q);
  switch (q->kind) {
  case QUANTITY_GAIT: return s->place.is_unread ? "-" : p->crawler.gait->name;
  case QUANTITY_LABEL: return s->place.label[q->which] ? s->place.label[q->which] : "-";
  case QUANTITY_CARRIED: return s->place.carried[q->which];
  case QUANTITY_PHASE_NAME:
    return s->place.is_unread ? "-" : p->phase == SCALLOP_EXTENSION ? "extension" : "contraction";
  case QUANTITY_REGIME:
  case QUANTITY_MODES: return how(s, q);
  case QUANTITY_WORDS: return in_words(s, m);
  case QUANTITY_STUDIED_TEXT: return s->is_outside ? "-" : at_study->text(s, q);
  case QUANTITY_CERTIFIED:
    return !s->is_outside && has_start(s, m) ? at_flint->text(s, q, digits > 0 ? digits : DIGITS_OF_DOUBLE, m) : "nan";
  default: return status_text(s);
  }
}

double at_formula(struct at *s, const struct formula *formula)
{
  int places[FORMULA_STEPS], count = formula_places(formula, places);
  for (int i = 0; i < count; i++)
    at_number(s, places[i]);
  return formula_double(formula, s->value);
}
