#include "compare/scenes/flint.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/evaluate.h"
#include "asymptotics/derived.h"
#include "numerics/certified.h"
#include "compare/answers/rational.h"
#include "compare/text/decimal.h"
#include "compare/answers/gaits.h"

/* Series that do not depend on T are kept for so many crawlers: those used last. */
enum { KEPT = 64, SUM_DIGITS = 20, SPARE_DIGITS = 8, GUARD_BITS = 128, TEXT_DIGITS = 3 };

struct kept_series {
  bool used, steady;
  unsigned long last; /* when it was used last                                                         */
  struct scallop_rational_crawler crawler; /* but for its T                                                  */
  fmpq_t v0;
  struct scallop_steady_expansion of_steady;
  struct scallop_phase_expansion of_phase;
  enum scallop_status status;
  const char *why;
};

struct scene_flint {
  struct kept_series kept[KEPT];
  unsigned long clock;
  bool has_point; /* the next three are those of this point                                        */
  struct scallop_rational_crawler crawler;
  fmpq_t v0;
  bool has_steady, has_phase;
  enum scallop_status steady_status, phase_status;
  const char *steady_why, *phase_why;
  struct scallop_certified_steady steady;
  struct scallop_certified_phase phase;
  arb_t turning_velocity; /* of the body that turns: 0                                         */
  char *text;
};

static struct scene_flint *flint_new(void)
{
  struct scene_flint *f = calloc(1, sizeof *f);
  if (!f)
    return NULL;
  scallop_rational_init(&f->crawler);
  fmpq_init(f->v0);
  scallop_certified_steady_init(&f->steady);
  scallop_certified_phase_init(&f->phase);
  arb_init(f->turning_velocity);
  return f;
}

static void clear_series(struct kept_series *k)
{
  if (!k->used)
    return;
  scallop_rational_clear(&k->crawler);
  fmpq_clear(k->v0);
  scallop_steady_expansion_clear(&k->of_steady);
  scallop_phase_expansion_clear(&k->of_phase);
  k->used = false;
}

void scene_flint_free(struct scene_flint *f)
{
  if (!f)
    return;
  for (int i = 0; i < KEPT; i++)
    clear_series(&f->kept[i]);
  scallop_rational_clear(&f->crawler);
  fmpq_clear(f->v0);
  scallop_certified_steady_clear(&f->steady);
  scallop_certified_phase_clear(&f->phase);
  arb_clear(f->turning_velocity);
  flint_free(f->text);
  free(f);
}

void scene_flint_forget(struct scene_flint *f) { f->has_point = f->has_steady = f->has_phase = false; }

/* The point's parameters as they are written; a start velocity that is a steady one is the double that it is. NULL: no memory. */
static struct scene_flint *at_point(struct scene_state *s)
{
  if (!s->flint)
    s->flint = flint_new();
  struct scene_flint *f = s->flint;
  if (!f) {
    state_fail(s, "out of memory");
    return NULL;
  }
  if (f->has_point)
    return f;
  f->has_point = true;
  rational_point(&f->crawler, NULL, &s->at);
  fmpq_zero(f->v0);
  return f;
}

/* False: there is none. */
static bool set_v0(struct scene_state *s, struct scene_flint *f)
{
  double v0 = state_v0(s);
  if (isnan(v0))
    return false;
  if (s->at.has_v0 && s->at.written_v0 && v0 != 0)
    scallop_rational_parse(f->v0, s->at.written_v0);
  else
    scallop_rational_set_double(f->v0, v0);
  return true;
}

static bool same_but_T(const struct scallop_rational_crawler *a, const struct scallop_rational_crawler *b)
{
  return fmpq_equal(a->m1, b->m1) && fmpq_equal(a->m2, b->m2) && fmpq_equal(a->F1, b->F1) && fmpq_equal(a->F2, b->F2)
         && fmpq_equal(a->L, b->L) && fmpq_equal(a->alpha, b->alpha) && a->gait == b->gait;
}

static struct kept_series *find_series(struct scene_flint *f, bool steady)
{
  for (int i = 0; i < KEPT; i++) {
    struct kept_series *k = &f->kept[i];
    if (k->used && k->steady == steady && same_but_T(&k->crawler, &f->crawler) && (steady || fmpq_equal(k->v0, f->v0)))
      return k;
  }
  return NULL;
}

static struct kept_series *free_place(struct scene_flint *f)
{
  struct kept_series *oldest = &f->kept[0];
  for (int i = 0; i < KEPT; i++) {
    if (!f->kept[i].used)
      return &f->kept[i];
    if (f->kept[i].last < oldest->last)
      oldest = &f->kept[i];
  }
  clear_series(oldest);
  return oldest;
}

static long digits_of(const struct scene_needs *needs)
{
  double of_errors = needs->certified_errors ? -log10(needs->accuracy) + SPARE_DIGITS : 0;
  return (long)fmax(SUM_DIGITS, ceil(of_errors));
}

static slong bits_of(long digits, long order) { return (slong)(3.33 * (double)digits) + GUARD_BITS + order; }

/* The series of the steady state or of the phase at the point, derived if it is not kept. */
static struct kept_series *series_at(struct scene_state *s, struct scene_flint *f, bool steady)
{
  struct kept_series *k = find_series(f, steady);
  if (!k) {
    long order = steady ? s->needs.steady_order : s->needs.phase_order;
    slong precision = bits_of(digits_of(&s->needs), order);
    k = free_place(f);
    *k = (struct kept_series){ .used = true, .steady = steady };
    scallop_rational_init(&k->crawler);
    scallop_rational_copy(&k->crawler, &f->crawler);
    fmpq_init(k->v0);
    fmpq_set(k->v0, f->v0);
    scallop_steady_expansion_init(&k->of_steady);
    scallop_phase_expansion_init(&k->of_phase);
    count_add(COUNT_EXPANSIONS, 1);
    k->status = steady ? scallop_expand_steady(&k->crawler, order, precision, &k->of_steady, &k->why)
                       : scallop_expand_phase(&k->crawler, s->scene->phase, k->v0, order, precision, NULL, &k->of_phase,
                                              &k->why);
  }
  k->last = ++f->clock;
  return k;
}

static slong first_power(const struct series *series)
{
  slong k = series->first;
  while (k < series->known && k < series->first + SCALLOP_MOST_TERMS && series_coefficient_is_zero(series, k))
    k++;
  return k;
}

/* Its sum at the point, as a ball. False: there is none, and the state says why. */
static bool derived_value(arb_t value, struct scene_state *s, struct scene_flint *f, const struct quantity *q,
                          slong precision)
{
  bool steady = q->which < STEADY_VALUES;
  if (!steady && !set_v0(s, f))
    return false;
  struct kept_series *k = series_at(s, f, steady);
  if (k->status != SCALLOP_OK) {
    state_fail(s, k->why ? k->why : scallop_status_text(k->status));
    return false;
  }
  const struct series *const of_steady[] = { &k->of_steady.v_start, &k->of_steady.v_mid, &k->of_steady.displacement,
                                             &k->of_steady.mean_velocity };
  const struct series *const of_phase[] = { &k->of_phase.t1,  &k->of_phase.dT,  &k->of_phase.v_end,
                                            &k->of_phase.dx1, &k->of_phase.dx2, &k->of_phase.dxC };
  if (!steady && q->which - STEADY_VALUES <= PHASE_DT && !k->of_phase.switches)
    return false; /* there is no such time */
  const struct series *series = steady ? of_steady[q->which] : of_phase[q->which - STEADY_VALUES];
  fmpq_t T;
  arb_t time;
  fmpq_init(T);
  arb_init(time);
  if (steady)
    fmpq_set(T, f->crawler.T);
  else
    scallop_rational_duration(T, &f->crawler, s->scene->phase);
  arb_set_fmpq(time, T, precision);
  series_value(value, series, time, q->kind == QUANTITY_LIMIT ? first_power(series) + 1 : q->order, precision);
  count_add(COUNT_SUMS, 1);
  fmpq_clear(T);
  arb_clear(time);
  return true;
}

double scene_flint_sum(struct scene_state *s, const struct quantity *q)
{
  struct scene_flint *f = at_point(s);
  double sum = NAN;
  arb_t value;
  arb_init(value);
  if (f && derived_value(value, s, f, q, bits_of(SUM_DIGITS, q->order)))
    sum = arf_get_d(arb_midref(value), ARF_RND_NEAR);
  arb_clear(value);
  return sum;
}

static bool certified_done(struct scene_state *s, enum scallop_status status, const char *why)
{
  char text[POINT_STATUS];
  if (status == SCALLOP_OK)
    return true;
  snprintf(text, sizeof text, "%s%s%s", scallop_status_text(status), why ? ": " : "", why ? why : "");
  state_fail(s, text);
  return false;
}

static long certified_digits(const struct scene_needs *needs)
{
  double of_errors = needs->certified_errors ? -log10(needs->accuracy) + SPARE_DIGITS : 0;
  return (long)fmax((double)(needs->digits + TEXT_DIGITS), ceil(of_errors));
}

static void count_certified(const struct scene_state *s)
{
  count_add(COUNT_CERTIFIED, 1);
  count_add(COUNT_CERTIFIED_DIGITS, certified_digits(&s->needs));
}

static bool solve_steady(struct scene_state *s, struct scene_flint *f)
{
  if (!f->has_steady) {
    count_certified(s);
    f->steady_status = scallop_certified_steady(&f->crawler, certified_digits(&s->needs), &f->steady, &f->steady_why);
  }
  f->has_steady = true;
  return certified_done(s, f->steady_status, f->steady_why);
}

static bool solve_phase(struct scene_state *s, struct scene_flint *f)
{
  if (!f->has_phase && !set_v0(s, f))
    return false;
  if (!f->has_phase) {
    count_certified(s);
    f->phase_status = scallop_certified_phase(&f->crawler, s->scene->phase, f->v0, certified_digits(&s->needs), &f->phase,
                                              &f->phase_why);
  }
  f->has_phase = true;
  return certified_done(s, f->phase_status, f->phase_why);
}

/* NULL: there is none. */
static const arb_struct *certified_value(struct scene_state *s, struct scene_flint *f, int which)
{
  if (which < STEADY_VALUES) {
    const arb_struct *const all[] = { f->steady.v_start, f->steady.v_mid, f->steady.displacement, f->steady.mean_velocity,
                                      f->steady.multiplier };
    return solve_steady(s, f) ? all[which] : NULL;
  }
  const arb_struct *const all[] = { f->phase.t1, f->phase.dT, f->phase.v_end, f->phase.dx1, f->phase.dx2, f->phase.dxC };
  int place = which - STEADY_VALUES;
  return solve_phase(s, f) && (f->phase.switches || place > PHASE_DT) ? all[place] : NULL;
}

const char *scene_flint_certified(struct scene_state *s, const struct quantity *q, long digits)
{
  struct scene_flint *f = at_point(s);
  const arb_struct *value = f ? certified_value(s, f, q->which) : NULL;
  if (!value)
    return "nan";
  flint_free(f->text);
  f->text = decimal_text(value, digits);
  return f->text;
}

/* What a formula of a phase is about, certified. */
static const arb_struct *formula_counterpart(struct scene_state *s, struct scene_flint *f,
                                             const struct scallop_formula *formula)
{
  bool extension = s->scene->phase == SCALLOP_EXTENSION;
  if (formula->quantity == SCALLOP_STEADY_VELOCITY)
    return certified_value(s, f, STEADY_V_START);
  if (formula->quantity == SCALLOP_STEADY_DISPLACEMENT)
    return certified_value(s, f, STEADY_DISPLACEMENT);
  if (!solve_phase(s, f))
    return NULL;
  switch (formula->quantity) {
  case SCALLOP_LAG: return f->phase.switches ? f->phase.dT : NULL;
  case SCALLOP_FIRST_SWITCH: return f->phase.switches ? f->phase.t1 : NULL;
  case SCALLOP_REAR_AT_FIRST: return f->phase.switches ? f->phase.at_first : NULL;
  case SCALLOP_REAR_AT_LAST: return f->phase.switches ? f->phase.at_last : NULL;
  case SCALLOP_REAR_AT_END: return extension ? f->phase.dx1 : f->phase.dx2;
  case SCALLOP_FRONT_AT_END: return extension ? f->phase.dx2 : f->phase.dx1;
  case SCALLOP_CENTRE_AT_END: return f->phase.dxC;
  case SCALLOP_VELOCITY_AT_FIRST:
  case SCALLOP_VELOCITY_AT_LAST: return f->phase.switches ? f->turning_velocity : NULL;
  default: return f->phase.v_end;
  }
}

/* The value of a formula with all digits. */
static bool formula_value(arb_t value, struct scene_state *s, struct scene_flint *f, const struct scallop_formula *formula,
                          slong precision)
{
  const struct ring ring = { 1, precision };
  bool steady = formula->setting == SCALLOP_STEADY;
  struct scallop_symbols symbols;
  struct series sum;
  fmpq_t T;
  count_add(COUNT_FORMULAS, 1);
  if ((formula_takes_given(formula) && (!solve_phase(s, f) || !f->phase.switches)) || (!steady && !set_v0(s, f)))
    return false;
  scallop_symbols_init(&symbols);
  series_init(&sum);
  fmpq_init(T);
  scallop_symbols_set(&symbols, &f->crawler, steady ? SCALLOP_EXTENSION : s->scene->phase, steady ? NULL : f->v0, NULL,
                      &ring);
  if (steady)
    fmpq_set(T, f->crawler.T);
  else
    scallop_rational_duration(T, &f->crawler, s->scene->phase);
  series_set_rational(&symbols.value[SYMBOL_T], T);
  if (formula_takes_given(formula)) {
    series_set_ball(&symbols.value[SYMBOL_t1], f->phase.t1);
    series_set_ball(&symbols.value[SYMBOL_dT], f->phase.dT);
    series_set_ball(&symbols.value[SYMBOL_x_switch], f->phase.at_last);
  }
  bool found = scallop_formula_expand(&sum, formula, &symbols, steady ? SCALLOP_EXTENSION : s->scene->phase, &ring);
  if (!gait_has_ends(s->at.crawler.gait) && (!found || strstr(formula->text, "L_kin"))) {
    state_fail(s, no_ends); /* L_kin is 0 there, and nothing is said of it */
    found = false;
  }
  if (found)
    series_coefficient(value, &sum, 0, precision);
  fmpq_clear(T);
  series_clear(&sum);
  scallop_symbols_clear(&symbols);
  return found;
}

/* What is less than the accuracy is 0. */
static double told(const arb_t error, const arb_t exact, double accuracy)
{
  mag_t most, least;
  mag_init(most);
  mag_init(least);
  arb_get_mag(most, error);
  arb_get_mag_lower(least, exact);
  bool below = mag_get_d(most) <= accuracy * mag_get_d(least);
  mag_clear(most);
  mag_clear(least);
  return below ? 0 : arf_get_d(arb_midref(error), ARF_RND_NEAR);
}

static void subtract(arb_t x, const fmpq_t q, slong precision)
{
  arb_t ball;
  arb_init(ball);
  arb_set_fmpq(ball, q, precision);
  arb_sub(x, x, ball, precision);
  arb_clear(ball);
}

double scene_flint_error(struct scene_state *s, const struct quantity *series, double *rounded, double *exact)
{
  struct scene_flint *f = at_point(s);
  double error = *rounded = *exact = NAN;
  if (!f)
    return NAN;
  slong precision = bits_of(certified_digits(&s->needs), series->order);
  const arb_struct *counterpart = series->kind == QUANTITY_PUBLISHED ? formula_counterpart(s, f, series->formula)
                                                                     : certified_value(s, f, series->which);
  arb_t value, difference;
  arb_init(value);
  arb_init(difference);
  if (counterpart) {
    arb_set(difference, counterpart);
    if (series->kind == QUANTITY_PUBLISHED && series->formula->quantity == SCALLOP_VELOCITY_CHANGE)
      subtract(difference, f->v0, precision);
    *exact = arf_get_d(arb_midref(difference), ARF_RND_NEAR);
  }
  bool found = series->kind == QUANTITY_PUBLISHED ? formula_value(value, s, f, series->formula, precision)
                                                  : derived_value(value, s, f, series, precision);
  if (found)
    *rounded = arf_get_d(arb_midref(value), ARF_RND_NEAR);
  if (found && counterpart) {
    arb_sub(value, value, difference, precision);
    error = told(value, difference, s->needs.accuracy);
  }
  arb_clear(value);
  arb_clear(difference);
  return error;
}
