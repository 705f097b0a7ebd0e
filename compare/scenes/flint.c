#include "compare/scenes/flint.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asymptotics/derived/derived.h"
#include "numerics/certified.h"
#include "compare/answers/answer_flint.h"
#include "compare/answers/point_flint.h"
#include "compare/answers/gaits.h"

/* Series that do not depend on T are kept for so many crawlers: those derived last. */
enum { KEPT = 64, SUM_DIGITS = 20, SPARE_DIGITS = 8, GUARD_BITS = 128, TEXT_DIGITS = 3 };

struct kept_series {
  bool used;
  enum quantity_of of;
  struct scallop_rational_crawler crawler; /* but for its T                                                  */
  fmpq_t v0;
  struct series_answer answer;
};

struct scene_flint {
  struct kept_series kept[KEPT];
  int next;       /* the series that makes room for a new one */
  bool has_point; /* what follows is of this point                                             */
  struct scallop_rational_crawler crawler;
  fmpq_t v0, T[2]; /* T by enum quantity_of: the period, the duration of the phase              */
  bool has_answer[2];
  struct ball_answer answer[2]; /* likewise */
  char *text;
};

static struct scene_flint *flint_new(void)
{
  struct scene_flint *f = calloc(1, sizeof *f);
  if (!f)
    return NULL;
  scallop_rational_init(&f->crawler);
  fmpq_init(f->v0);
  for (int of = 0; of < 2; of++) {
    fmpq_init(f->T[of]);
    ball_answer_init(&f->answer[of]);
  }
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
  for (int of = 0; of < 2; of++) {
    fmpq_clear(f->T[of]);
    ball_answer_clear(&f->answer[of]);
  }
  flint_free(f->text);
  free(f);
}

static void scene_flint_forget(struct scene_flint *f)
{
  f->has_point = f->has_answer[OF_STEADY] = f->has_answer[OF_PHASE] = false;
}

/* The first reason stays. Returns false. */
static bool fail(struct scene_asked *a, const char *why)
{
  if (a->why[0] == '\0')
    snprintf(a->why, sizeof a->why, "%s", why);
  return false;
}

/* The point's parameters as they are written; a start velocity that is a steady one is the double that it is. NULL: no memory. */
static struct scene_flint *at_point(struct scene_asked *a)
{
  struct scene_flint *f = a->flint = a->flint ? a->flint : flint_new();
  if (!f) {
    fail(a, "out of memory");
    return NULL;
  }
  if (!f->has_point) {
    rational_point(&f->crawler, NULL, a->at);
    fmpq_set(f->T[OF_STEADY], f->crawler.T);
    scallop_rational_duration(f->T[OF_PHASE], &f->crawler, a->scene->phase);
    fmpq_zero(f->v0);
    f->has_point = true;
  }
  if (a->at->has_v0 && a->at->written_v0 && a->v0 != 0)
    scallop_rational_parse(f->v0, a->at->written_v0);
  else
    scallop_rational_set_double(f->v0, a->v0);
  return f;
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

/* How many digits errors need, where they are certified. */
static long digits_of_errors(const struct scene_needs *needs)
{
  return needs->certified_errors ? (long)ceil(-log10(needs->accuracy) + SPARE_DIGITS) : 0;
}

static slong bits_of(long digits, long order) { return (slong)(3.33 * (double)digits) + GUARD_BITS + order; }

/* The series of the steady state or of the phase at the point, derived if it is not kept. */
static const struct series_answer *series_at(const struct scene_asked *a, struct scene_flint *f, enum quantity_of of)
{
  const struct scene_needs *needs = &a->scene->plan.needs;
  struct kept_series *k = find_series(f, of);
  if (k)
    return &k->answer;
  long order = of == OF_STEADY ? needs->steady_order : needs->phase_order, digits = digits_of_errors(needs);
  k = &f->kept[f->next++ % KEPT];
  clear_series(k);
  *k = (struct kept_series){ .used = true, .of = of };
  scallop_rational_init(&k->crawler);
  scallop_rational_copy(&k->crawler, &f->crawler);
  fmpq_init(k->v0);
  fmpq_set(k->v0, f->v0);
  series_answer_init(&k->answer);
  count_add(COUNT_EXPANSIONS, 1);
  answer_in_series(&k->answer, &k->crawler, of, a->scene->phase, k->v0, order,
                   bits_of(digits > SUM_DIGITS ? digits : SUM_DIGITS, order));
  return &k->answer;
}

static slong first_power(const struct series *series)
{
  slong k = series->first;
  while (k < series->known && k < series->first + SCALLOP_MOST_TERMS && series_coefficient_is_zero(series, k))
    k++;
  return k;
}

/* Its sum at the point, as a ball. False: there is none, and asked->why says why. */
static bool derived_value(arb_t value, struct scene_asked *asked, struct scene_flint *f, const struct quantity *q,
                          slong precision)
{
  enum quantity_of of = quantity_rows[q->which].of;
  const struct series_answer *a = series_at(asked, f, of);
  if (a->status != SCALLOP_OK)
    return fail(asked, a->why ? a->why : scallop_status_text(a->status));
  const struct series *series = a->value[q->which];
  if (!series)
    return false; /* there is no such time */
  arb_t time;
  arb_init(time);
  arb_set_fmpq(time, f->T[of], precision);
  series_value(value, series, time, q->kind == QUANTITY_LIMIT ? first_power(series) + 1 : q->order, precision);
  count_add(COUNT_SUMS, 1);
  arb_clear(time);
  return true;
}

static double scene_flint_sum(struct scene_asked *a, const struct quantity *q)
{
  struct scene_flint *f = at_point(a);
  double sum = NAN;
  arb_t value;
  arb_init(value);
  if (f && derived_value(value, a, f, q, bits_of(SUM_DIGITS, q->order)))
    sum = arf_get_d(arb_midref(value), ARF_RND_NEAR);
  arb_clear(value);
  return sum;
}

static long certified_digits(const struct scene_needs *needs)
{
  long of_texts = needs->digits + TEXT_DIGITS, of_errors = digits_of_errors(needs);
  return of_texts > of_errors ? of_texts : of_errors;
}

/* The certified answer; NULL: there is none, and asked->why says why. */
static const struct ball_answer *certified(struct scene_asked *asked, struct scene_flint *f, enum quantity_of of)
{
  struct ball_answer *a = &f->answer[of];
  if (!f->has_answer[of]) {
    long digits = certified_digits(&asked->scene->plan.needs);
    count_add(COUNT_CERTIFIED, 1);
    count_add(COUNT_CERTIFIED_DIGITS, digits);
    answer_in_balls(a, &f->crawler, of, asked->scene->phase, f->v0, digits);
    f->has_answer[of] = true;
  }
  if (a->status == SCALLOP_OK)
    return a;
  char text[POINT_STATUS];
  snprintf(text, sizeof text, "%s%s%s", scallop_status_text(a->status), a->why ? ": " : "", a->why ? a->why : "");
  fail(asked, text);
  return NULL;
}

static const char *scene_flint_certified(struct scene_asked *asked, const struct quantity *q, long digits)
{
  struct scene_flint *f = at_point(asked);
  const struct ball_answer *a = f ? certified(asked, f, quantity_rows[q->which].of) : NULL;
  if (!a || !a->value[q->which])
    return "nan";
  flint_free(f->text);
  f->text = decimal_text(a->value[q->which], digits);
  return f->text;
}

/* The value of a formula with all digits. */
static bool formula_value(arb_t value, struct scene_asked *a, struct scene_flint *f, const struct scallop_formula *formula,
                          slong precision)
{
  enum quantity_of of = formula->setting == SCALLOP_STEADY ? OF_STEADY : OF_PHASE;
  count_add(COUNT_FORMULAS, 1);
  const struct ball_answer *given = formula_takes_given(formula) ? certified(a, f, OF_PHASE) : NULL;
  if (formula_takes_given(formula) && (!given || !given->phase.switches))
    return false;
  bool found = published_in_balls(value, formula, &f->crawler, a->scene->phase, f->v0, f->T[of], given, precision);
  if (!gait_has_ends(a->at->crawler.gait) && (!found || strstr(formula->text, "L_kin")))
    return fail(a, gait_no_ends); /* L_kin is 0 there, and nothing is said of it */
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

static double scene_flint_error(struct scene_asked *a, const struct quantity *series, double *rounded, double *exact)
{
  struct scene_flint *f = at_point(a);
  double error = *rounded = *exact = NAN;
  if (!f)
    return NAN;
  const struct scene_needs *needs = &a->scene->plan.needs;
  slong precision = bits_of(certified_digits(needs), series->order);
  bool published = series->kind == QUANTITY_PUBLISHED;
  int q = published ? (int)quantity_of_formula(series->formula, a->scene->phase) : series->which;
  const struct ball_answer *answer = certified(a, f,
                                               quantity_is_of_phase(&a->scene->quantities, series) ? OF_PHASE : OF_STEADY);
  const arb_struct *counterpart = answer ? answer->value[q] : NULL;
  arb_t value;
  arb_init(value);
  if (counterpart)
    *exact = arf_get_d(arb_midref(counterpart), ARF_RND_NEAR);
  bool found = published ? formula_value(value, a, f, series->formula, precision)
                         : derived_value(value, a, f, series, precision);
  if (found)
    *rounded = arf_get_d(arb_midref(value), ARF_RND_NEAR);
  if (found && counterpart) {
    arb_sub(value, value, counterpart, precision);
    error = told(value, counterpart, needs->accuracy);
  }
  arb_clear(value);
  return error;
}

const struct scene_flint_functions scene_flint = { scene_flint_free, scene_flint_forget, scene_flint_sum, scene_flint_error,
                                                   scene_flint_certified };
