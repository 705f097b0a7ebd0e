#include "compare/scenes/flint.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/evaluate.h"
#include "asymptotics/derived.h"
#include "numerics/certified.h"
#include "compare/answers/answer_flint.h"
#include "compare/answers/point_flint.h"
#include "compare/answers/gaits.h"

/* Series that do not depend on T are kept for so many crawlers: those used last. */
enum { KEPT = 64, SUM_DIGITS = 20, SPARE_DIGITS = 8, GUARD_BITS = 128, TEXT_DIGITS = 3 };

struct kept_series {
  bool used;
  enum quantity_of of;
  unsigned long last; /* when it was used last                                                         */
  struct scallop_rational_crawler crawler; /* but for its T                                                  */
  fmpq_t v0;
  struct series_answer answer;
};

struct scene_flint {
  struct kept_series kept[KEPT];
  unsigned long clock;
  bool has_point; /* the next three are those of this point                                        */
  struct scallop_rational_crawler crawler;
  fmpq_t v0;
  bool has_answer[2];
  struct ball_answer answer[2]; /* by enum quantity_of */
  char *text;
};

static struct scene_flint *flint_new(void)
{
  struct scene_flint *f = calloc(1, sizeof *f);
  if (!f)
    return NULL;
  scallop_rational_init(&f->crawler);
  fmpq_init(f->v0);
  ball_answer_init(&f->answer[OF_STEADY]);
  ball_answer_init(&f->answer[OF_PHASE]);
  return f;
}

static void clear_series(struct kept_series *k)
{
  if (!k->used)
    return;
  scallop_rational_clear(&k->crawler);
  fmpq_clear(k->v0);
  series_answer_clear(&k->answer);
  k->used = false;
}

static void scene_flint_free(struct scene_flint *f)
{
  for (int i = 0; i < KEPT; i++)
    clear_series(&f->kept[i]);
  scallop_rational_clear(&f->crawler);
  fmpq_clear(f->v0);
  ball_answer_clear(&f->answer[OF_STEADY]);
  ball_answer_clear(&f->answer[OF_PHASE]);
  flint_free(f->text);
  free(f);
}

static void scene_flint_forget(struct scene_flint *f)
{
  f->has_point = f->has_answer[OF_STEADY] = f->has_answer[OF_PHASE] = false;
}

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

static struct kept_series *find_series(struct scene_flint *f, enum quantity_of of)
{
  for (int i = 0; i < KEPT; i++) {
    struct kept_series *k = &f->kept[i];
    if (k->used && k->of == of && same_but_T(&k->crawler, &f->crawler) && (of == OF_STEADY || fmpq_equal(k->v0, f->v0)))
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
static struct kept_series *series_at(struct scene_state *s, struct scene_flint *f, enum quantity_of of)
{
  struct kept_series *k = find_series(f, of);
  if (!k) {
    long order = of == OF_STEADY ? s->needs.steady_order : s->needs.phase_order;
    slong precision = bits_of(digits_of(&s->needs), order);
    k = free_place(f);
    *k = (struct kept_series){ .used = true, .of = of };
    scallop_rational_init(&k->crawler);
    scallop_rational_copy(&k->crawler, &f->crawler);
    fmpq_init(k->v0);
    fmpq_set(k->v0, f->v0);
    series_answer_init(&k->answer);
    count_add(COUNT_EXPANSIONS, 1);
    answer_in_series(&k->answer, &k->crawler, of, s->scene->phase, k->v0, order, precision);
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
  enum quantity_of of = quantity_rows[q->which].of;
  if (of == OF_PHASE && !set_v0(s, f))
    return false;
  const struct series_answer *a = &series_at(s, f, of)->answer;
  if (a->status != SCALLOP_OK) {
    state_fail(s, a->why ? a->why : scallop_status_text(a->status));
    return false;
  }
  const struct series *series = a->value[q->which];
  if (!series)
    return false; /* there is no such time */
  fmpq_t T;
  arb_t time;
  fmpq_init(T);
  arb_init(time);
  if (of == OF_STEADY)
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

static double scene_flint_sum(struct scene_state *s, const struct quantity *q)
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

static long certified_digits(const struct scene_needs *needs)
{
  double of_errors = needs->certified_errors ? -log10(needs->accuracy) + SPARE_DIGITS : 0;
  return (long)fmax((double)(needs->digits + TEXT_DIGITS), ceil(of_errors));
}

/* The certified answer; NULL: there is none, and the state says why. */
static const struct ball_answer *certified(struct scene_state *s, struct scene_flint *f, enum quantity_of of)
{
  struct ball_answer *a = &f->answer[of];
  if (!f->has_answer[of]) {
    if (of == OF_PHASE && !set_v0(s, f))
      return NULL;
    count_add(COUNT_CERTIFIED, 1);
    count_add(COUNT_CERTIFIED_DIGITS, certified_digits(&s->needs));
    answer_in_balls(a, &f->crawler, of, s->scene->phase, f->v0, certified_digits(&s->needs));
    f->has_answer[of] = true;
  }
  if (a->status == SCALLOP_OK)
    return a;
  char text[POINT_STATUS];
  snprintf(text, sizeof text, "%s%s%s", scallop_status_text(a->status), a->why ? ": " : "", a->why ? a->why : "");
  state_fail(s, text);
  return NULL;
}

/* NULL: there is none. */
static const arb_struct *certified_value(struct scene_state *s, struct scene_flint *f, enum quantity_of of, int q)
{
  const struct ball_answer *a = certified(s, f, of);
  return a ? a->value[q] : NULL;
}

static const char *scene_flint_certified(struct scene_state *s, const struct quantity *q, long digits)
{
  struct scene_flint *f = at_point(s);
  const arb_struct *value = f ? certified_value(s, f, quantity_rows[q->which].of, q->which) : NULL;
  if (!value)
    return "nan";
  flint_free(f->text);
  f->text = decimal_text(value, digits);
  return f->text;
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
  const struct ball_answer *given = formula_takes_given(formula) ? certified(s, f, OF_PHASE) : NULL;
  if ((formula_takes_given(formula) && (!given || !given->phase.switches)) || (!steady && !set_v0(s, f)))
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
  if (given) {
    series_set_ball(&symbols.value[SYMBOL_t1], given->phase.t1);
    series_set_ball(&symbols.value[SYMBOL_dT], given->phase.dT);
    series_set_ball(&symbols.value[SYMBOL_x_switch], given->phase.at_last);
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

static double scene_flint_error(struct scene_state *s, const struct quantity *series, double *rounded, double *exact)
{
  struct scene_flint *f = at_point(s);
  double error = *rounded = *exact = NAN;
  if (!f)
    return NAN;
  slong precision = bits_of(certified_digits(&s->needs), series->order);
  bool published = series->kind == QUANTITY_PUBLISHED;
  int q = published ? (int)quantity_of_formula(series->formula, s->scene->phase) : series->which;
  enum quantity_of of = quantity_is_of_phase(&s->scene->quantities, series) ? OF_PHASE : OF_STEADY;
  const arb_struct *counterpart = certified_value(s, f, of, q);
  arb_t value;
  arb_init(value);
  if (counterpart)
    *exact = arf_get_d(arb_midref(counterpart), ARF_RND_NEAR);
  bool found = published ? formula_value(value, s, f, series->formula, precision)
                         : derived_value(value, s, f, series, precision);
  if (found)
    *rounded = arf_get_d(arb_midref(value), ARF_RND_NEAR);
  if (found && counterpart) {
    arb_sub(value, value, counterpart, precision);
    error = told(value, counterpart, s->needs.accuracy);
  }
  arb_clear(value);
  return error;
}

const struct scene_flint_functions scene_flint = { scene_flint_free, scene_flint_forget, scene_flint_sum, scene_flint_error,
                                                   scene_flint_certified };
