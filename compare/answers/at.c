#include "compare/answers/at.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/points/counts.h"
#include "compare/points/gaits.h"
#include "compare/answers/stretches.h"
#include "compare/book/book.h"
#include "compare/columns/columns.h"
#include "compare/text/values.h"

struct asked asked_nothing(void)
{
  return (struct asked){ .accuracy = ACCURACY_OF_DOUBLES, .digits = DIGITS_OF_DOUBLE };
}

/* Are errors those against certified values? A change of velocity in doubles is a small difference of large numbers,
 * and has not the digits that errors are told to. */
static bool certifies_errors(const struct asked *asked)
{
  const struct quantities *all = &asked->quantities;
  bool certifies = false, has = false;
  for (int i = 0; i < all->count; i++) {
    const struct scallop_formula *f = all->item[i].of >= 0 ? all->item[all->item[i].of].formula : NULL;
    has = has || all->item[i].of >= 0;
    certifies = certifies || (f && f->quantity == SCALLOP_VELOCITY_CHANGE);
  }
  return certifies || (has && asked->certified_errors);
}

bool asked_needs_flint(const struct asked *asked)
{
  bool needs = certifies_errors(asked);
  for (int i = 0; i < asked->quantities.count; i++) {
    enum quantity_kind kind = asked->quantities.item[i].kind;
    needs = needs || kind == QUANTITY_CERTIFIED || kind == QUANTITY_DERIVED || kind == QUANTITY_LIMIT;
  }
  return needs;
}

bool at_init(struct at *s, const struct asked *asked)
{
  bool needs_flint = asked_needs_flint(asked);
  *s = (struct at){ .asked = asked, .onset = 1, .certified_errors = certifies_errors(asked) };
  if (needs_flint)
    s->flint = at_flint.create(asked);
  return !needs_flint || s->flint;
}

void at_clear(struct at *s)
{
  if (s->flint)
    at_flint.free(s->flint);
}

double at_fail(struct at *s, const char *why)
{
  s->failures++;
  if (s->why[0] == '\0')
    snprintf(s->why, sizeof s->why, "%s", why);
  return NAN;
}

/* Is the cell asked for the first time at this point? Then that is counted. */
static bool is_to_solve(struct at *s, enum cell cell, enum count stage)
{
  bool is_first = !s->has_cell[cell];
  s->has_cell[cell] = true;
  count_add(stage, is_first);
  return is_first;
}

static double check(struct at *s, enum scallop_status status, double value)
{
  return status < 0 ? at_fail(s, scallop_status_text(status)) : value;
}

/* Parameters may have changed since the last formula. */
static double formula_so_far(void *at, const struct formula *formula)
{
  struct at *s = at;
  memset(s->has, 0, (size_t)s->asked->quantities.count * sizeof *s->has);
  return at_formula(s, formula);
}

static void leave(struct at *s)
{
  const size_t count = (size_t)s->asked->quantities.count;
  memset(s->has_cell, 0, sizeof s->has_cell);
  memset(s->has, 0, count * sizeof *s->has);
  memset(s->comparison, 0, count * sizeof *s->comparison);
  s->is_outside = s->is_unread = s->tells_steady = false;
  s->why[0] = '\0';
}

static void arrive(struct at *s, const char *refused)
{
  memset(s->has, 0, (size_t)s->asked->quantities.count * sizeof *s->has); /* what a range was found with */
  s->why[0] = '\0';
  if (refused)
    at_fail(s, refused);
  s->is_outside = refused != NULL;
  if (s->flint && !refused)
    at_flint.move(s);
  count_add(COUNT_POINTS, 1);
}

void at_move(struct at *s, const struct point *point, const char *refused)
{
  leave(s);
  s->point = *point;
  s->point.has_v0 |= !s->asked->from_steady;
  s->swept.F1_over_F2 = s->swept.m1_over_m2 = s->swept.froude = NAN;
  arrive(s, refused);
  s->is_unread = refused != NULL;
}

void at_sweep(struct at *s, const struct point *base, const struct sweep_product *product, const long *index)
{
  leave(s);
  s->point = *base;
  s->point.has_v0 |= !s->asked->from_steady;
  sweep_move(&s->swept, &s->point, product, index, formula_so_far, s);
  arrive(s, s->swept.why[0] != '\0' ? s->swept.why : NULL);
}

void at_begin_row(struct at *s)
{
  s->tells_steady = false;
  if (!s->is_outside)
    s->why[0] = '\0';
}

/* The answer in double; NULL: there is none, and visit.why says why. */
static const struct answer *solved(struct at *s, enum quantity_of of)
{
  struct answer *a = &s->answer[of];
  double v0 = of == OF_PHASE ? at_v0(s) : 0;
  if (isnan(v0))
    return NULL;
  if (is_to_solve(s, IN_DOUBLE + of, of == OF_PHASE ? COUNT_PHASES : COUNT_STEADY)) {
    s->motion[of] = (struct motion){ of, s->point.crawler, s->point.phase, v0 };
    if (answer_in_double(a, &s->motion[of]))
      count_work(&a->work);
  }
  return check(s, a->status, 0) == 0 ? a : NULL;
}

double at_v0(struct at *s)
{
  if (s->point.has_v0)
    return s->point.v0;
  const struct answer *a = solved(s, OF_STEADY);
  return a ? a->value[s->point.phase == SCALLOP_EXTENSION ? Q_V_START : Q_V_MID].high : NAN;
}

/* The answer, with those of its numbers that take another walk, which is only done where one of them is asked for */
static const struct answer *solved_with(struct at *s, enum quantity_of of, int quantity)
{
  const struct answer *a = solved(s, of);
  if (!a)
    return NULL;
  if (quantity == Q_AT_FIRST || quantity == Q_AT_LAST) {
    if (is_to_solve(s, TURNINGS, COUNT_PHASES))
      answer_turnings(&s->answer[OF_PHASE], &s->motion[OF_PHASE]);
  } else if (quantity == Q_FRICTION_WORK || quantity == Q_COST_OF_TRANSPORT) {
    if (!s->has_cell[FRICTION])
      s->friction = answer_friction(&s->answer[OF_STEADY], &s->motion[OF_STEADY]);
    s->has_cell[FRICTION] = true;
    check(s, s->friction, 0);
  }
  return a;
}

static double estimate(struct at *s, const struct quantity *q)
{
  static const double rounded_up = 1.005; /* with three digits */
  enum quantity_of of = quantity_rows[q->which].of;
  struct answer again;
  if (!solved(s, of))
    return NAN;
  if (!s->has_cell[WITH_ERRORS + of])
    check(s, answer_with_errors(&again, &s->motion[of], s->estimate[of]) ? SCALLOP_OK : again.status, 0);
  s->has_cell[WITH_ERRORS + of] = true;
  return rounded_up * s->estimate[of][q->which];
}

/* Makes ready for what certified answers and series give at the point. False: a phase that has no start velocity. */
static bool has_start(struct at *s, enum quantity_of of)
{
  s->v0 = of == OF_PHASE ? at_v0(s) : 0;
  return !isnan(s->v0);
}

static bool certify(struct at *s, enum quantity_of of)
{
  bool has = has_start(s, of);
  if (has && is_to_solve(s, IN_BALLS + of, COUNT_CERTIFIED))
    at_flint.certify(s, of);
  return has;
}

static enum quantity_of motion_of_quantity(const struct at *s, const struct quantity *q)
{
  return quantity_is_of_phase(&s->asked->quantities, q) ? OF_PHASE : OF_STEADY;
}

/* The sum of a derived series */
static bool expand(struct at *s, const struct quantity *series)
{
  enum quantity_of of = motion_of_quantity(s, series);
  bool has = has_start(s, of);
  count_add(COUNT_SUMS, has);
  return has;
}

/* The longest period at which an extension from rest does not stick; no body need ever stick. It is kept until a
 * parameter but T changes. */
static double onset_of_sticking(struct at *s)
{
  struct scallop_crawler c = s->point.crawler;
  c.T = 1;
  if (!same_crawler(&s->onset_of, &c)) {
    count_add(COUNT_ONSETS, 1);
    s->onset_of = c;
    s->onset = sticking_onset(&c);
  }
  return s->onset;
}

static double published(struct at *s, const struct scallop_formula *f)
{
  const struct scallop_crawler *c = &s->point.crawler;
  const bool steady = f->setting == SCALLOP_STEADY, is_given = formula_takes_given(f);
  const bool is_of_start = f->setting != SCALLOP_AT_REST_START || (s->point.has_v0 && s->point.v0 == 0);
  const bool is_of_phase = (f->setting != SCALLOP_MOVING_EXTENSION || s->point.phase == SCALLOP_EXTENSION)
                           && (f->setting != SCALLOP_MOVING_CONTRACTION || s->point.phase == SCALLOP_CONTRACTION);
  if (!is_of_start || !is_of_phase)
    return NAN;
  const struct motion m = { steady ? OF_STEADY : OF_PHASE, *c, s->point.phase, steady ? NAN : at_v0(s) };
  const struct answer *given =
      is_given ? solved_with(s, OF_PHASE, formula_takes(f, SCALLOP_SYMBOL_x_switch) ? Q_AT_LAST : Q_DT) : NULL;
  if (is_given && !given)
    return NAN;
  double value = published_value(f, &m, given);
  count_add(COUNT_FORMULAS, 1);
  if (!isfinite(value) && !gait_has_ends(c->gait))
    return at_fail(s, gait_no_ends);
  return isfinite(value) ? value : NAN;
}

/* A series beside what it should be, in balls or by the double solver */
static void compare(struct at *s, struct comparison *c, const struct quantity *series, int place)
{
  bool is_published = series->kind == QUANTITY_PUBLISHED;
  int quantity = is_published ? (int)quantity_of_formula(series->formula, s->point.phase) : series->which;
  enum quantity_of of = motion_of_quantity(s, series);
  *c = (struct comparison){ .error = NAN, .value = NAN, .exact = NAN };
  if (!s->certified_errors) {
    const struct answer *a = solved_with(s, of, quantity);
    c->exact = a ? a->value[quantity].high : NAN;
    c->value = at_number(s, place);
    c->error = c->value - c->exact;
    if (fabs(c->error) < s->asked->accuracy * fabs(c->exact))
      c->error = 0;
    return;
  }
  bool ready = certify(s, of);
  if (!is_published)
    ready &= expand(s, series);
  else {
    count_add(COUNT_FORMULAS, 1);
    if (formula_takes_given(series->formula))
      ready &= certify(s, OF_PHASE);
  }
  if (ready)
    *c = at_flint.compare(s, series, quantity);
}

static const struct comparison *compared(struct at *s, int place)
{
  struct comparison *c = &s->comparison[place];
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
  if (!isnan(s->swept.froude))
    return s->swept.froude;
  return check(s, scallop_scale(&s->point.crawler, &scaled), 0) == 0 ? 1 / scaled.eps : NAN;
}

static double compute(struct at *s, const struct quantity *q)
{
  const struct scallop_crawler *c = &s->point.crawler;
  const struct quantities *all = &s->asked->quantities;
  static const struct comparison none;
  const struct answer *a;
  double numbers[CRAWLER_NUMBERS];
  if (s->is_unread || (s->is_outside && q->kind != QUANTITY_NUMBER && q->kind != QUANTITY_V0))
    return NAN; /* the point has no such thing */
  if (s->certified_errors && quantity_is_series(q) && quantity_is_compared(all, q))
    return compared(s, (int)(q - all->item))->value; /* rounded from the one that the error is of */
  const struct comparison *series = q->of >= 0 ? compared(s, q->of) : &none;
  switch (q->kind) {
  case QUANTITY_NUMBER: crawler_numbers(c, numbers); return numbers[q->which];
  case QUANTITY_V0: return at_v0(s);
  case QUANTITY_FROUDE: return froude(s);
  case QUANTITY_F1_OVER_F2: return isnan(s->swept.F1_over_F2) ? c->F1 / c->F2 : s->swept.F1_over_F2;
  case QUANTITY_M1_OVER_M2: return isnan(s->swept.m1_over_m2) ? c->m1 / c->m2 : s->swept.m1_over_m2;
  case QUANTITY_ONSET: return onset_of_sticking(s);
  case QUANTITY_ANSWER:
    a = solved_with(s, quantity_rows[q->which].of, q->which);
    return a ? a->value[q->which].high : NAN;
  case QUANTITY_ESTIMATE: return estimate(s, q);
  case QUANTITY_PUBLISHED: return published(s, q->formula);
  case QUANTITY_DERIVED:
  case QUANTITY_LIMIT: return expand(s, q) ? at_flint.sum(s, q) : NAN;
  case QUANTITY_EXACT: return series->exact;
  case QUANTITY_ERROR: return series->error;
  case QUANTITY_RELATIVE: return series->error / fabs(series->exact);
  default: return NAN; /* texts, and what only a trajectory has */
  }
}

/* What is asked for, of which the row then tells something */
static const struct quantity *ask(struct at *s, int quantity)
{
  const struct quantity *q = &s->asked->quantities.item[quantity];
  bool answered = q->kind == QUANTITY_ANSWER || q->kind == QUANTITY_REGIME || q->kind == QUANTITY_MODES;
  s->tells_steady |= (answered || q->of >= 0) && motion_of_quantity(s, q) == OF_STEADY;
  return q;
}

double at_number(struct at *s, int quantity)
{
  const struct quantity *q = ask(s, quantity);
  if (!s->has[quantity]) {
    long before = s->failures;
    s->value[quantity] = quantity_is_text(q) ? text_number(at_text(s, quantity, 0)) : compute(s, q);
    s->has[quantity] = s->failures == before; /* a failure is told in each row; solutions are kept */
  }
  return s->value[quantity];
}

static const char *status_text(struct at *s)
{
  if (s->why[0] != '\0')
    return s->why;
  if (s->asked->as_written)
    return "certified";
  return s->tells_steady && s->has_cell[IN_DOUBLE + OF_STEADY] ? answer_status_text(s->text, &s->answer[OF_STEADY])
                                                               : "ok";
}

/* The regime or the modes, in double or proven */
static const char *how(struct at *s, const struct quantity *q)
{
  enum quantity_of of = (enum quantity_of)q->which;
  struct answer proven;
  const struct answer *a = &proven;
  if (s->is_outside)
    return "-";
  if (!s->asked->as_written)
    a = solved(s, of);
  else if (!certify(s, of) || !at_flint.modes(s, of, &proven.regime, proven.modes))
    a = NULL;
  return !a                           ? "-"
         : q->kind == QUANTITY_REGIME ? scallop_regime_text(a->regime)
                                      : motion_modes_text(s->text, of, a->modes);
}

/* In double, whatever else is certified; "-" is no failure */
static const char *in_words(struct at *s, enum quantity_of of)
{
  enum { SHOWN = 6 };
  long failures = s->failures;
  bool had_why = s->why[0] != '\0';
  const struct answer *a = s->is_outside || had_why ? NULL : solved(s, of);
  if (!had_why && s->asked->as_written) {
    s->why[0] = '\0';
    s->failures = failures;
  }
  return a ? motion_in_words(s->text, &s->motion[of], a, SHOWN) : "-";
}

const char *at_text(struct at *s, int quantity, long digits)
{
  const struct quantity *q = ask(s, quantity);
  switch (q->kind) {
  case QUANTITY_GAIT: return s->is_unread ? "-" : s->point.crawler.gait->name;
  case QUANTITY_LABEL: return s->swept.label[q->which] ? s->swept.label[q->which] : "-";
  case QUANTITY_CARRIED: return s->carried[q->which];
  case QUANTITY_PHASE_NAME:
    return s->is_unread ? "-" : s->point.phase == SCALLOP_EXTENSION ? "extension" : "contraction";
  case QUANTITY_REGIME:
  case QUANTITY_MODES: return how(s, q);
  case QUANTITY_WORDS: return in_words(s, (enum quantity_of)q->which);
  case QUANTITY_CERTIFIED:
    return !s->is_outside && certify(s, quantity_rows[q->which].of)
               ? at_flint.text(s, q, digits > 0 ? digits : DIGITS_OF_DOUBLE)
               : "nan";
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
