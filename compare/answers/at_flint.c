#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/derived/derived.h"
#include "compare/answers/answer_flint.h"
#include "compare/answers/at.h"
#include "compare/formulas/formula_file.h"
#include "compare/points/counts.h"
#include "compare/points/gaits.h"
#include "compare/points/point_flint.h"
#include "model/exact/scoped.h"

enum { KEPT = 64, SUM_DIGITS = 20, SPARE_DIGITS = 8, GUARD_BITS = 128, TEXT_DIGITS = 3 };

/* Series do not depend on T: the last KEPT series are kept, each for a motion, crawler and start velocity. */
struct kept_series {
  enum motion_of_point motion;
  struct scallop_rational_crawler crawler;
  fmpq_t v0;
  struct series_answer answer;
};
#define KEPT_PARTS(of) of(scallop_rational, &s->crawler) of(fmpq, s->v0) of(series_answer, &s->answer)
SCOPED_PARTS(kept_series, struct kept_series, KEPT_PARTS)

struct at_flint {
  struct scallop_rational_crawler crawler;
  fmpq_t v0, start, T; /* v0 as written; start velocity of the current motion; its period or the phase's duration */
  long move;           /* at->moves of this point */
  bool is_certified[POINT_MOTIONS];
  struct ball_answer certified[POINT_MOTIONS];
  struct kept_series kept[KEPT];
  int series; /* number of series derived so far; a new one replaces the oldest */
  char *text;
};
#define POINT_PARTS(of) \
  of(scallop_rational, &s->crawler) of(fmpq, s->v0) of(fmpq, s->start) of(fmpq, s->T) \
      of(ball_answer, &s->certified[0]) of(ball_answer, &s->certified[1]) of(ball_answer, &s->certified[2]) \
          of(ball_answer, &s->certified[3]) of(ball_answer, &s->certified[4])
SCOPED_PARTS(at_flint, struct at_flint, POINT_PARTS)

static void flint_end(struct at_flint *f)
{
  for (int i = 0; i < KEPT && i < f->series; i++)
    kept_series_clear(&f->kept[i]);
  at_flint_clear(f);
  flint_free(f->text);
  flint_free(f);
}

static enum quantity_of kind_of(enum motion_of_point m) { return m == STEADY_STATE ? OF_STEADY : OF_PHASE; }

/* Sets the crawler and v0 to the numbers as written, and start and T to those of the motion. A start velocity that the
 * steady state determines is a double, taken as exact. */
static struct at_flint *set_motion(struct at *s, enum motion_of_point m)
{
  const struct scallop_wide *steady = s->solved[STEADY_STATE].answer.value;
  if (!s->flint) {
    s->flint = flint_calloc(1, sizeof *s->flint);
    at_flint_init(s->flint);
  }
  struct at_flint *f = s->flint;
  if (f->move != s->moves) {
    rational_point(&f->crawler, f->v0, &s->place.point);
    memset(f->is_certified, 0, sizeof f->is_certified);
    f->move = s->moves;
  }
  if (m == STEADY_STATE)
    fmpq_set(f->T, f->crawler.T);
  else
    scallop_rational_duration(f->T, &f->crawler, phase_kind(m));
  if (m >= FROM_REST || m == STEADY_STATE)
    fmpq_zero(f->start);
  else if (s->place.point.has_v0)
    fmpq_set(f->start, f->v0);
  else
    scallop_rational_set_double(f->start, steady[phase_kind(m) == SCALLOP_EXTENSION ? Q_V_START : Q_V_MID].high);
  return f;
}

static bool same_but_T(const struct scallop_rational_crawler *a, const struct scallop_rational_crawler *b)
{
  return fmpq_equal(a->m1, b->m1) && fmpq_equal(a->m2, b->m2) && fmpq_equal(a->F1, b->F1) && fmpq_equal(a->F2, b->F2)
         && fmpq_equal(a->L, b->L) && fmpq_equal(a->alpha, b->alpha) && a->gait == b->gait;
}

/* Returns the digits of certified answers, for texts and for certified errors. */
static long certified_digits(const struct at *s)
{
  long of_texts = s->required->digits + TEXT_DIGITS;
  long of_errors = s->certified_errors ? (long)ceil(-log10(s->required->accuracy) + SPARE_DIGITS) : 0;
  long most = of_texts > of_errors ? of_texts : of_errors;
  return most < SCALLOP_MOST_DIGITS ? most : SCALLOP_MOST_DIGITS;
}

/* Returns the precision of series: the bits of the digits, the guard bits, and one more bit for each term. */
static slong bits_of(const struct at *s, long order)
{
  long digits = certified_digits(s);
  return (slong)(3.33 * (double)(digits > SUM_DIGITS ? digits : SUM_DIGITS)) + GUARD_BITS + order;
}

/* Returns the highest requested order, for the limit at least 8 (phase) or 1 (steady state): above its first power. */
static long order_of_series(const struct quantities *all, enum quantity_of of)
{
  long most = 0;
  for (const struct quantity *q = all->item; q < all->item + all->count; q++) {
    long order = q->kind == QUANTITY_DERIVED ? q->order : q->kind != QUANTITY_LIMIT ? 0 : of == OF_PHASE ? 8 : 1;
    most = q->motion == of && order > most ? order : most;
  }
  return most;
}

/* Returns the series of a motion and derives them if they are not kept. */
static const struct series_answer *series_at(struct at *s, enum motion_of_point m)
{
  struct at_flint *f = set_motion(s, m);
  for (const struct kept_series *k = f->kept; k < f->kept + KEPT && k < f->kept + f->series; k++)
    if (k->motion == m && same_but_T(&k->crawler, &f->crawler) && fmpq_cmp(k->v0, f->start) == 0)
      return &k->answer;
  struct kept_series *k = &f->kept[f->series % KEPT];
  if (f->series++ < KEPT)
    kept_series_init(k);
  long order = order_of_series(&s->required->quantities, kind_of(m));
  k->motion = m;
  scallop_rational_copy(&k->crawler, &f->crawler);
  fmpq_set(k->v0, f->start);
  count_add(COUNT_EXPANSIONS, 1);
  answer_in_series(&k->answer, &f->crawler, kind_of(m), phase_kind(m), f->start, order, bits_of(s, order));
  return &k->answer;
}

/* Sums a derived series. Returns false if it does not exist, after setting s->why unless the motion has no such
 * quantity. */
static bool derived_value(arb_t value, struct at *s, const struct quantity *q, enum motion_of_point m, slong precision)
{
  const struct series_answer *a = series_at(s, m);
  const struct series *series = a->value[q->which];
  if (a->status != SCALLOP_OK)
    at_fail(s, a->why ? a->why : scallop_status_text(a->status));
  if (a->status != SCALLOP_OK || !series)
    return false;
  SCOPED(arb, time);
  arb_set_fmpq(time, s->flint->T, precision);
  series_value(value, series, time, q->kind == QUANTITY_LIMIT ? series_first_power(series) + 1 : q->order, precision);
  return true;
}

static double middle(const arb_t x) { return arf_get_d(arb_midref(x), ARF_RND_NEAR); }

static double sum(struct at *s, const struct quantity *series, enum motion_of_point m)
{
  SCOPED(arb, value);
  count_add(COUNT_SUMS, 1);
  return derived_value(value, s, series, m, bits_of(s, series->order)) ? middle(value) : NAN;
}

/* Returns the certified answer, or NULL after setting s->why. */
static const struct ball_answer *certified(struct at *s, enum motion_of_point m)
{
  struct at_flint *f = set_motion(s, m);
  struct ball_answer *a = &f->certified[m];
  char why[POINT_STATUS];
  if (!f->is_certified[m]) {
    long digits = certified_digits(s);
    count_add(COUNT_CERTIFIED, 1);
    count_add(COUNT_CERTIFIED_DIGITS, digits);
    answer_in_balls(a, &f->crawler, kind_of(m), phase_kind(m), f->start, digits);
    f->is_certified[m] = true;
  }
  if (a->status == SCALLOP_OK)
    return a;
  snprintf(why, sizeof why, "%s%s%s", scallop_status_text(a->status), a->why ? ": " : "", a->why ? a->why : "");
  at_fail(s, why);
  return NULL;
}

static const char *text(struct at *s, const struct quantity *q, long digits, enum motion_of_point m)
{
  const struct ball_answer *a = certified(s, m);
  if (q->kind != QUANTITY_CERTIFIED)
    return !a                          ? "-"
           : q->kind == QUANTITY_MODES ? motion_modes_text(s->text, q->motion, a->modes)
                                       : scallop_regime_text(a->regime);
  if (!a || !a->value[q->which])
    return "nan";
  flint_free(s->flint->text);
  s->flint->text = decimal_text(a->value[q->which], digits);
  return s->flint->text;
}

/* Evaluates a formula in balls. Returns false if it has no value. */
static bool formula_value(arb_t value, struct at *s, const struct scallop_formula *f, enum motion_of_point m,
                          slong precision)
{
  const struct ball_answer *given = formula_takes_given(f) ? certified(s, m) : NULL;
  if (formula_takes_given(f) && (!given || !given->phase.switches))
    return false;
  const struct at_flint *a = set_motion(s, m);
  bool found = published_in_balls(value, f, &a->crawler, phase_kind(m), a->start, a->T, given, precision);
  if (gait_has_ends(s->place.point.crawler.gait) || (found && !formula_takes(f, SCALLOP_SYMBOL_L_kin)))
    return found;
  at_fail(s, gait_no_ends); /* the formula divides by L_kin = 0 */
  return false;
}

/* Returns true if the upper bound of |error| is at most accuracy times the lower bound of |exact|. */
static bool is_below(const arb_t error, const arb_t exact, double accuracy)
{
  SCOPED(arf, most, least);
  arb_get_abs_ubound_arf(most, error, 30);
  arb_get_abs_lbound_arf(least, exact, 30);
  return arf_get_d(most, ARF_RND_UP) <= accuracy * arf_get_d(least, ARF_RND_DOWN);
}

static struct series_error compare(struct at *s, const struct quantity *series, int quantity, enum motion_of_point m)
{
  slong precision = bits_of(s, series->order);
  const struct ball_answer *answer = certified(s, m);
  const arb_struct *exact = answer ? answer->value[quantity] : NULL;
  SCOPED(arb, value);
  count_add(series->formula ? COUNT_FORMULAS : COUNT_SUMS, 1);
  bool found = series->formula ? formula_value(value, s, series->formula, m, precision)
                               : derived_value(value, s, series, m, precision);
  struct series_error c = { .value = found ? middle(value) : NAN, .exact = exact ? middle(exact) : NAN, .error = NAN };
  if (found && exact) {
    arb_sub(value, value, exact, precision);
    c.error = is_below(value, exact, s->required->accuracy) ? 0 : middle(value);
  }
  return c;
}

static const struct at_flint_functions functions = { flint_end, sum, compare, text, flint_cleanup };

/* Runs when the shared object is loaded, or before main in a program that is linked with it. */
static void __attribute__((constructor)) register_functions(void) { at_flint = &functions; }
