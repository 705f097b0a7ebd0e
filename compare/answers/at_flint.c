#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/answers/at.h"
#include "compare/points/counts.h"
#include "asymptotics/derived/derived.h"
#include "compare/answers/answer_flint.h"
#include "compare/book/book.h"
#include "compare/points/gaits.h"
#include "compare/points/point_flint.h"
#include "numerics/certified/certified.h"

/* Series that do not depend on T are kept for so many crawlers: those derived last. */
enum { KEPT = 64, SUM_DIGITS = 20, SPARE_DIGITS = 8, GUARD_BITS = 128, TEXT_DIGITS = 3 };

struct kept_series {
  bool used;
  enum quantity_of of;
  struct scallop_rational_crawler crawler; /* but for its T */
  fmpq_t v0;
  struct series_answer answer;
};

struct at_flint {
  struct kept_series kept[KEPT];
  int next; /* the series that makes room for a new one */
  struct scallop_rational_crawler crawler;
  fmpq_t v0, T[2]; /* T by enum quantity_of: the period, the duration of the phase */
  struct ball_answer answer[2];
  char *text;
  long order[2]; /* of series, by enum quantity_of: terms below T^order */
};

/* The most that is asked for; of the limit so many that they hold the first term, as some begin with T^3 */
static void find_orders(struct at_flint *f, const struct quantities *all)
{
  for (int i = 0; i < all->count; i++) {
    const struct quantity *q = &all->item[i];
    if (q->kind != QUANTITY_DERIVED && q->kind != QUANTITY_LIMIT)
      continue;
    enum quantity_of of = quantity_rows[q->which].of;
    long order = q->kind == QUANTITY_DERIVED ? q->order : of == OF_PHASE ? 8 : 1;
    f->order[of] = order > f->order[of] ? order : f->order[of];
  }
}

static struct at_flint *flint_new(const struct asked *asked)
{
  struct at_flint *f = calloc(1, sizeof *f);
  if (!f)
    return NULL;
  scallop_rational_init(&f->crawler);
  fmpq_init(f->v0);
  for (int of = 0; of < 2; of++) {
    fmpq_init(f->T[of]);
    ball_answer_init(&f->answer[of]);
  }
  find_orders(f, &asked->quantities);
  return f;
}

static void clear_series(struct kept_series *k)
{
  if (!k->used)
    return;
  scallop_rational_clear(&k->crawler);
  fmpq_clear(k->v0);
  series_answer_clear(&k->answer);
}

static void flint_end(struct at_flint *f)
{
  for (int i = 0; i < KEPT; i++)
    clear_series(&f->kept[i]);
  scallop_rational_clear(&f->crawler);
  fmpq_clear(f->v0);
  for (int of = 0; of < 2; of++) {
    fmpq_clear(f->T[of]);
    ball_answer_clear(&f->answer[of]);
  }
  flint_free(f->text);
  free(f);
}

/* Parameters as they are written */
static void move(const struct at *s)
{
  rational_point(&s->flint->crawler, s->flint->v0, &s->point);
  fmpq_set(s->flint->T[OF_STEADY], s->flint->crawler.T);
  scallop_rational_duration(s->flint->T[OF_PHASE], &s->flint->crawler, s->point.phase);
}

/* A start velocity that is a steady one is the double that it is. */
static void start_phase(const struct at *s)
{
  if (!s->point.has_v0)
    scallop_rational_set_double(s->flint->v0, s->v0);
}

static bool same_but_T(const struct scallop_rational_crawler *a, const struct scallop_rational_crawler *b)
{
  return fmpq_equal(a->m1, b->m1) && fmpq_equal(a->m2, b->m2) && fmpq_equal(a->F1, b->F1) && fmpq_equal(a->F2, b->F2)
         && fmpq_equal(a->L, b->L) && fmpq_equal(a->alpha, b->alpha) && a->gait == b->gait;
}

/* Digits that certified answers need: for texts, and for errors where these are certified */
static long certified_digits(const struct at *s)
{
  long of_texts = s->asked->digits + TEXT_DIGITS < SCALLOP_MOST_DIGITS ? s->asked->digits + TEXT_DIGITS
                                                                       : SCALLOP_MOST_DIGITS;
  long of_errors = s->certified_errors ? (long)ceil(-log10(s->asked->accuracy) + SPARE_DIGITS) : 0;
  return of_texts > of_errors ? of_texts : of_errors;
}

/* For series: beyond the digits as many bits as there are terms */
static slong bits_of(const struct at *s, long order)
{
  long digits = certified_digits(s);
  return (slong)(3.33 * (double)(digits > SUM_DIGITS ? digits : SUM_DIGITS)) + GUARD_BITS + order;
}

/* The series of the steady state or of the phase at the point, derived if it is not kept */
static const struct series_answer *series_at(const struct at *s, enum quantity_of of)
{
  for (int i = 0; i < KEPT; i++) {
    const struct kept_series *k = &s->flint->kept[i];
    if (k->used && k->of == of && same_but_T(&k->crawler, &s->flint->crawler)
        && (of == OF_STEADY || fmpq_equal(k->v0, s->flint->v0)))
      return &k->answer;
  }
  long order = s->flint->order[of];
  struct kept_series *k = &s->flint->kept[s->flint->next++ % KEPT];
  clear_series(k);
  *k = (struct kept_series){ .used = true, .of = of };
  scallop_rational_init(&k->crawler);
  scallop_rational_copy(&k->crawler, &s->flint->crawler);
  fmpq_init(k->v0);
  fmpq_set(k->v0, s->flint->v0);
  series_answer_init(&k->answer);
  count_add(COUNT_EXPANSIONS, 1);
  answer_in_series(&k->answer, &k->crawler, of, s->point.phase, k->v0, order, bits_of(s, order));
  return &k->answer;
}

/* The sum of a derived series at the point. False: there is none, and s->why says why, unless the motion has no such
 * quantity. */
static bool derived_value(arb_t value, struct at *s, const struct quantity *q, slong precision)
{
  enum quantity_of of = quantity_rows[q->which].of;
  if (of == OF_PHASE)
    start_phase(s);
  const struct series_answer *a = series_at(s, of);
  const struct series *series = a->value[q->which];
  if (a->status != SCALLOP_OK)
    at_fail(s, a->why ? a->why : scallop_status_text(a->status));
  if (a->status != SCALLOP_OK || !series)
    return false;
  arb_t time;
  arb_init(time);
  arb_set_fmpq(time, s->flint->T[of], precision);
  series_value(value, series, time, q->kind == QUANTITY_LIMIT ? series_first_power(series) + 1 : q->order, precision);
  arb_clear(time);
  return true;
}

static double middle(const arb_t x) { return arf_get_d(arb_midref(x), ARF_RND_NEAR); }

static double sum(struct at *s, const struct quantity *series)
{
  arb_t value;
  arb_init(value);
  double sum = derived_value(value, s, series, bits_of(s, series->order)) ? middle(value) : NAN;
  arb_clear(value);
  return sum;
}

static void certify(const struct at *s, enum quantity_of of)
{
  long digits = certified_digits(s);
  if (of == OF_PHASE)
    start_phase(s);
  count_add(COUNT_CERTIFIED_DIGITS, digits);
  answer_in_balls(&s->flint->answer[of], &s->flint->crawler, of, s->point.phase, s->flint->v0, digits);
}

/* The certified answer; NULL: there is none, and s->why says why. */
static const struct ball_answer *certified(struct at *s, enum quantity_of of)
{
  const struct ball_answer *a = &s->flint->answer[of];
  char text[POINT_STATUS];
  if (a->status == SCALLOP_OK)
    return a;
  snprintf(text, sizeof text, "%s%s%s", scallop_status_text(a->status), a->why ? ": " : "", a->why ? a->why : "");
  at_fail(s, text);
  return NULL;
}

static const char *text(struct at *s, const struct quantity *q, long digits)
{
  const struct ball_answer *a = certified(s, quantity_rows[q->which].of);
  if (!a || !a->value[q->which])
    return "nan";
  flint_free(s->flint->text);
  s->flint->text = decimal_text(a->value[q->which], digits);
  return s->flint->text;
}

/* The value of a formula with all digits */
static bool formula_value(arb_t value, struct at *s, const struct scallop_formula *formula, slong precision)
{
  enum quantity_of of = formula->setting == SCALLOP_STEADY ? OF_STEADY : OF_PHASE;
  const struct ball_answer *given = formula_takes_given(formula) ? certified(s, OF_PHASE) : NULL;
  if (of == OF_PHASE)
    start_phase(s);
  if (formula_takes_given(formula) && (!given || !given->phase.switches))
    return false;
  bool found = published_in_balls(value, formula, &s->flint->crawler, s->point.phase, s->flint->v0, s->flint->T[of],
                                  given, precision);
  if (gait_has_ends(s->point.crawler.gait) || (found && !formula_takes(formula, SCALLOP_SYMBOL_L_kin)))
    return found;
  at_fail(s, gait_no_ends); /* L_kin is 0 there, and nothing is said of it */
  return false;
}

/* Is every number of the error at most that part of what it is an error of? */
static bool is_below(const arb_t error, const arb_t exact, double accuracy)
{
  mag_t most, least;
  mag_init(most);
  mag_init(least);
  arb_get_mag(most, error);
  arb_get_mag_lower(least, exact);
  bool below = mag_get_d(most) <= accuracy * mag_get_d(least);
  mag_clear(most);
  mag_clear(least);
  return below;
}

static struct comparison compare(struct at *s, const struct quantity *series, int quantity)
{
  slong precision = bits_of(s, series->order);
  bool of_phase = quantity_is_of_phase(&s->asked->quantities, series);
  const struct ball_answer *answer = certified(s, of_phase ? OF_PHASE : OF_STEADY);
  const arb_struct *exact = answer ? answer->value[quantity] : NULL;
  arb_t value;
  arb_init(value);
  bool found = series->kind == QUANTITY_PUBLISHED ? formula_value(value, s, series->formula, precision)
                                                  : derived_value(value, s, series, precision);
  struct comparison c = { .value = found ? middle(value) : NAN, .exact = exact ? middle(exact) : NAN, .error = NAN };
  if (found && exact) {
    arb_sub(value, value, exact, precision);
    c.error = is_below(value, exact, s->asked->accuracy) ? 0 : middle(value);
  }
  arb_clear(value);
  return c;
}

static bool modes(struct at *s, enum quantity_of of, enum scallop_regime *regime, struct scallop_modes modes[2])
{
  const struct ball_answer *a = certified(s, of);
  if (a) {
    *regime = a->regime;
    memcpy(modes, a->modes, sizeof a->modes);
  }
  return a != NULL;
}

const struct at_flint_functions at_flint = { flint_new, flint_end, move, certify, sum, compare, text, modes };
