#include "compare/answers/at.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/answers/flint.h"
#include "compare/formulas/formula_file.h"
#include "compare/columns/columns.h"
#include "compare/points/counts.h"
#include "compare/points/gaits.h"

const struct at_flint_functions *at_flint;
const struct at_study_functions *at_study;

struct at *at_new(const struct requirements *required)
{
  const char *needs_flint = quantity_needing_flint(required);
  if (needs_flint && !load_flint(required->command, needs_flint))
    return NULL;
  struct at *s = malloc(sizeof *s);
  if (!s)
    return complain(required->command, "out of memory"), NULL;
  memset(s, 0, offsetof(struct at, has)); /* reset() clears the large rest for each point */
  s->required = required;
  s->certified_errors = errors_are_certified(required);
  return s;
}

void at_free(struct at *s)
{
  if (s && s->flint)
    at_flint->free(s->flint);
  if (s && s->study)
    at_study->free(s->study);
  if (s && s->data) {
    at_free(s->data->at);
    free(s->data);
  }
  free(s);
}

double at_fail(struct at *s, const char *why)
{
  s->failures++;
  if (s->why[0] == '\0')
    snprintf(s->why, sizeof s->why, "%s", why);
  return NAN;
}

static bool succeeds(struct at *s, enum scallop_status status)
{
  if (status < 0)
    at_fail(s, scallop_status_text(status));
  return status >= 0;
}

static void reset(struct at *s)
{
  const size_t count = (size_t)s->required->quantities.count;
  for (int m = 0; m < POINT_MOTIONS; m++)
    s->solved[m].in_double = s->solved[m].with_errors = s->solved[m].is_complete = false;
  memset(s->has, 0, count * sizeof *s->has);
  memset(s->comparison, 0, count * sizeof *s->comparison);
  s->is_outside = false;
  s->why[0] = '\0';
  if (s->data)
    s->data->done = false;
}

void at_begin_point(struct at *s)
{
  reset(s);
  s->is_outside = s->place.why[0] != '\0';
  if (s->is_outside)
    at_fail(s, s->place.why);
  s->place.point.has_v0 |= !s->required->from_steady;
  s->moves++;
  count_add(COUNT_POINTS, 1);
}

double at_formula_so_far(void *at, const struct sweep_place *place, const struct formula *formula)
{
  struct at *s = at;
  sweep_place_copy(&s->place, place);
  reset(s);
  return at_formula(s, formula);
}

void at_begin_row(struct at *s)
{
  if (!s->is_outside)
    s->why[0] = '\0';
}

static enum motion_of_point phase_from(const struct at *s, enum scallop_phase_kind phase, bool from_rest)
{
  const struct point *p = &s->place.point;
  bool rests = from_rest || (p->has_v0 && p->v0 == 0);
  return (enum motion_of_point)((int)(rests ? FROM_REST : FROM_START) + (int)phase);
}

/* Returns the motion of a quantity. A formula for a phase from rest has that motion, whatever v0 the point has. */
static enum motion_of_point motion_of_quantity(const struct at *s, const struct quantity *q)
{
  enum scallop_phase_kind phase = q->phase >= 0 ? (enum scallop_phase_kind)q->phase : s->place.point.phase;
  return q->motion == OF_STEADY ? STEADY_STATE : phase_from(s, phase, q->from_rest);
}

static const struct answer *solve(struct at *s, enum motion_of_point m);

/* Returns the start velocity of a motion: 0 for the steady state; nan if it follows from a steady state that has no
 * answer. */
static double start_of(struct at *s, enum motion_of_point m)
{
  if (m == STEADY_STATE || m >= FROM_REST)
    return 0;
  if (s->place.point.has_v0)
    return s->place.point.v0;
  const struct answer *a = solve(s, STEADY_STATE);
  return a ? a->value[phase_kind(m) == SCALLOP_EXTENSION ? Q_V_START : Q_V_MID].high : NAN;
}

static bool has_start(struct at *s, enum motion_of_point m) { return !isnan(start_of(s, m)); }

double at_v0(struct at *s) { return start_of(s, phase_from(s, s->place.point.phase, false)); }

/* Returns the answer in double, or NULL after setting s->why. */
static const struct answer *solve(struct at *s, enum motion_of_point m)
{
  struct solution *a = &s->solved[m];
  if (!a->in_double) {
    enum quantity_of of = m == STEADY_STATE ? OF_STEADY : OF_PHASE;
    a->motion = (struct motion){ of, s->place.point.crawler, phase_kind(m), start_of(s, m) };
    if (isnan(a->motion.v0))
      return NULL;
    a->in_double = true;
    count_add(m == STEADY_STATE ? COUNT_STEADY : COUNT_PHASES, 1);
    if (answer_in_double(&a->answer, &a->motion))
      count_work(&a->answer.work);
  }
  return succeeds(s, a->answer.status) ? &a->answer : NULL;
}

/* Returns a number of the answer. The first request for a number that takes a second walk does this walk. */
static double solve_for(struct at *s, enum motion_of_point m, int quantity)
{
  struct solution *a = &s->solved[m];
  if (!solve(s, m))
    return NAN;
  if (quantity >= Q_FRICTION_WORK && quantity <= Q_AT_LAST && !a->is_complete) {
    count_add(COUNT_PHASES, m != STEADY_STATE);
    a->is_complete = succeeds(s, answer_complete(&a->answer, &a->motion));
  }
  return a->answer.value[quantity].high;
}

static double estimate(struct at *s, const struct quantity *q)
{
  static const double rounded_up = 1.005; /* the error is printed with three digits */
  enum motion_of_point m = motion_of_quantity(s, q);
  struct solution *a = &s->solved[m];
  struct answer again;
  if (!solve(s, m))
    return NAN;
  if (!a->with_errors)
    a->with_errors = answer_with_errors(&again, &a->motion, a->estimate);
  return rounded_up * a->estimate[q->which];
}

/* Returns sticking_onset of the crawler and keeps it until a parameter other than T changes. */
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

static double published(struct at *s, const struct quantity *q, enum motion_of_point m)
{
  const struct scallop_crawler *c = &s->place.point.crawler;
  const struct motion motion = { q->motion, *c, phase_kind(m), start_of(s, m) };
  const struct answer *given = NULL;
  if (formula_takes_given(q->formula)) {
    solve_for(s, m, formula_takes(q->formula, SCALLOP_SYMBOL_x_switch) ? Q_AT_LAST : Q_DT);
    if (!(given = solve(s, m)))
      return NAN;
  }
  double value = published_value(q->formula, &motion, given);
  count_add(COUNT_FORMULAS, 1);
  if (!isfinite(value) && !gait_has_ends(c->gait))
    return at_fail(s, gait_no_ends);
  return isfinite(value) ? value : NAN;
}

/* Compares a series with the exact value, in balls or by the double solver. */
static const struct series_error *compared(struct at *s, int place)
{
  const struct quantity *series = &s->required->quantities.item[place];
  struct series_error *c = &s->comparison[place];
  enum motion_of_point m = motion_of_quantity(s, series);
  int quantity = series->formula ? (int)quantity_of_formula(series->formula, phase_kind(m)) : series->which;
  long before = s->failures;
  if (c->done)
    return c;
  *c = (struct series_error){ .error = NAN, .value = NAN, .exact = NAN };
  if (s->certified_errors && has_start(s, m))
    *c = at_flint->compare(s, series, quantity, m);
  else if (!s->certified_errors) {
    c->exact = solve_for(s, m, quantity);
    c->value = at_number(s, place);
    c->error = c->value - c->exact;
    if (fabs(c->error) < s->required->accuracy * fabs(c->exact))
      c->error = 0;
  }
  c->done = s->failures == before;
  return c;
}

/* Returns the ratio that was set, else the one of the parameters; the Froude number equals the solver's to the bit. */
static double ratio(struct at *s, enum ratio_place which)
{
  const struct scallop_crawler *c = &s->place.point.crawler;
  struct scallop_scaled scaled;
  if (s->place.point.ratio[which] > 0)
    return s->place.point.ratio[which];
  if (which == FROUDE)
    return succeeds(s, scallop_scale(c, &scaled)) ? 1 / scaled.eps : NAN;
  return which == F1_OVER_F2   ? c->F1 / c->F2
         : which == M1_OVER_M2 ? c->m1 / c->m2
         : which == MU1        ? c->F1 / (c->m1 * s->place.point.gravity)
                               : c->F2 / (c->m2 * s->place.point.gravity);
}

static double parameter(struct at *s, int place)
{
  if (place != PLACE_OF_V0)
    return crawler_number(&s->place.point.crawler, place);
  return s->required->v0_only_if_given && !s->place.point.has_v0 ? NAN : at_v0(s);
}

/* Begins with the same point and gait i of the recording's alternatives. Returns false if it does not exist. */
static bool begin_alternative(struct at *other, const struct at *s, int i)
{
  sweep_place_copy(&other->place, &s->place);
  reset(other);
  other->moves++;
  return gait_exchange(&other->place.point.crawler, i);
}

static bool has_data_bounds(const struct at *s, int place)
{
  for (int i = 0; i < s->required->quantities.count; i++)
    if (s->required->quantities.item[i].kind == QUANTITY_DATA && s->required->quantities.item[i].of == place)
      return true;
  return false;
}

/* Finds the uncertainty of all numbers from the recording, to solve each alternative gait once. Returns false if memory
 * is short. */
static bool find_data_errors(struct at *s)
{
  const int count = s->required->quantities.count;
  double(*others)[SCALLOP_MEASURED_OTHERS] = malloc((size_t)count * sizeof *others);
  if (!s->data)
    s->data = calloc(1, sizeof *s->data);
  if (s->data && !s->data->at)
    s->data->at = at_new(s->required);
  bool works = others && s->data && s->data->at;
  for (int i = 0; works && i < SCALLOP_MEASURED_OTHERS; i++) {
    bool moved = begin_alternative(s->data->at, s, i);
    for (int k = 0; k < count; k++)
      others[k][i] = moved && has_data_bounds(s, k) ? at_number(s->data->at, k) : NAN;
  }
  for (int k = 0; works && k < count; k++)
    s->data->error[k] = has_data_bounds(s, k) ? scallop_measured_error(at_number(s, k), others[k]) : NAN;
  if (works)
    s->data->done = true;
  free(others);
  return works;
}

/* Returns nan if the gait is not measured. */
static double data_error(struct at *s, int place)
{
  if (!gait_file_of(s->place.point.crawler.gait))
    return NAN;
  bool known = (s->data && s->data->done) || find_data_errors(s);
  return known ? s->data->error[place] : at_fail(s, "out of memory");
}

double at_data_error(struct at *s, int quantity)
{
  const struct quantity *q = &s->required->quantities.item[quantity];
  const int of = q->kind == QUANTITY_DATA ? q->of : quantity;
  return has_data_bounds(s, of) ? data_error(s, of) : NAN;
}

/* Returns true if the quantity is known although the parameters are invalid. */
static bool is_known_outside(const struct at *s, const struct quantity *q)
{
  return q->kind == QUANTITY_NUMBER || (q->kind == QUANTITY_RATIO && s->place.point.ratio[q->which] > 0);
}

static double compute(struct at *s, int place)
{
  const struct quantity *q = &s->required->quantities.item[place];
  enum motion_of_point m = motion_of_quantity(s, q);
  if (quantity_is_text(q))
    return text_number(at_text(s, place, 0));
  if (s->place.is_unread || (s->is_outside && !is_known_outside(s, q)))
    return NAN;
  if (s->certified_errors && q->is_compared)
    return compared(s, place)->value; /* consistent with the error */
  switch (q->kind) {
  case QUANTITY_ANSWER: return solve_for(s, m, q->which);
  case QUANTITY_NUMBER: return parameter(s, q->which);
  case QUANTITY_RATIO: return ratio(s, (enum ratio_place)q->which);
  case QUANTITY_ONSET: return onset_of_sticking(s);
  case QUANTITY_ESTIMATE: return estimate(s, q);
  case QUANTITY_PUBLISHED: return published(s, q, m);
  case QUANTITY_DERIVED:
  case QUANTITY_LIMIT: return has_start(s, m) ? at_flint->sum(s, q, m) : NAN;
  case QUANTITY_EXACT: return compared(s, q->of)->exact;
  case QUANTITY_ERROR: return compared(s, q->of)->error;
  case QUANTITY_RELATIVE: return compared(s, q->of)->error / fabs(compared(s, q->of)->exact);
  case QUANTITY_FORMULA: return at_formula(s, q->own);
  case QUANTITY_DATA: return at_number(s, q->of) + q->which * data_error(s, q->of);
  case QUANTITY_STUDIED: return at_study->number(s, q);
  default: return NAN; /* quantities of a trajectory */
  }
}

double at_number(struct at *s, int quantity)
{
  long before = s->failures;
  if (!s->has[quantity]) {
    s->value[quantity] = compute(s, quantity);
    s->has[quantity] = s->failures == before; /* after a failure each row repeats its reason */
  }
  return s->value[quantity];
}

static const char *status_text(struct at *s)
{
  const struct solution *steady = &s->solved[STEADY_STATE];
  if (s->why[0] != '\0')
    return s->why;
  return steady->in_double && !s->as_written ? answer_status_text(s->text, &steady->answer) : "ok";
}

/* Returns the regime, the modes, or the modes in words; proven if as_written. */
static const char *mode_text(struct at *s, const struct quantity *q, enum motion_of_point m)
{
  enum { SHOWN = 6 };
  if (s->as_written && q->kind != QUANTITY_WORDS)
    return has_start(s, m) ? at_flint->text(s, q, 0, m) : "-";
  const struct answer *a = q->kind == QUANTITY_WORDS && s->why[0] != '\0' ? NULL : solve(s, m);
  if (!a)
    return "-";
  if (q->kind == QUANTITY_REGIME)
    return scallop_regime_text(a->regime);
  return q->kind == QUANTITY_MODES ? motion_modes_text(s->text, q->motion, a->modes)
                                   : motion_in_words(s->text, &s->solved[m].motion, a, SHOWN);
}

const char *at_text(struct at *s, int quantity, long digits)
{
  const struct quantity *q = &s->required->quantities.item[quantity];
  const struct point *p = &s->place.point;
  const char *label = q->kind == QUANTITY_LABEL ? s->place.label[q->which] : NULL;
  enum motion_of_point m = motion_of_quantity(s, q);
  switch (q->kind) {
  case QUANTITY_GAIT: return s->place.is_unread ? "-" : p->crawler.gait->name;
  case QUANTITY_PHASE_NAME:
    return s->place.is_unread ? "-" : p->phase == SCALLOP_EXTENSION ? "extension" : "contraction";
  case QUANTITY_LABEL: return label ? label : "-";
  case QUANTITY_CARRIED: return s->place.carried[q->which];
  case QUANTITY_STATUS: return status_text(s);
  case QUANTITY_STUDIED_TEXT: return s->is_outside ? "-" : at_study->text(s, q);
  case QUANTITY_CERTIFIED:
    return !s->is_outside && has_start(s, m) ? at_flint->text(s, q, digits > 0 ? digits : DIGITS_OF_DOUBLE, m) : "nan";
  default: return s->is_outside ? "-" : mode_text(s, q, m);
  }
}

double at_formula(struct at *s, const struct formula *formula)
{
  int places[FORMULA_STEPS], count = formula_places(formula, places);
  for (int i = 0; i < count; i++)
    at_number(s, places[i]);
  return formula_double(formula, s->value);
}
