/* Motion of claims about an order: its expansion as T -> 0, certified samples as T decreases, and the errors of
 * formulas at them. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/claims/decide.h"

enum { TERMS = 14, TERMS_AT_END = 40, PRECISION = 1400 };

bool trial_is_steady(const struct trial *m) { return m->condition->setting == SCALLOP_STEADY; }
static enum quantity_of answered(const struct trial *m) { return trial_is_steady(m) ? OF_STEADY : OF_PHASE; }

const struct series *trial_series(const struct trial *m, enum scallop_quantity quantity)
{
  /* v_end and v_end - v0 have one series */
  const struct scallop_formula about = { .quantity = quantity == SCALLOP_VELOCITY_CHANGE ? SCALLOP_VELOCITY_AT_END
                                                                                         : quantity };
  return m->series.value[quantity_of_formula(&about, m->condition->kind)];
}

slong trial_leading_power(const struct scallop_formula *f) { return f->quantity == SCALLOP_STEADY_VELOCITY ? -1 : 0; }

bool trial_expand(struct trial *m, slong terms)
{
  m->terms = terms;
  return answer_in_series(&m->series, &m->crawler, answered(m), m->condition->kind, m->v0, terms, PRECISION);
}

/* Sets x to two significant digits: fractions stay readable, and do not depend on a library's square root. */
static void set_rounded(fmpq_t x, double value)
{
  char text[32];
  snprintf(text, sizeof text, "%.1e", value);
  scallop_rational_parse(x, text);
}

/* Changes the crawler as its condition states. */
static void set_condition(struct trial *m)
{
  const struct condition *condition = m->condition;
  struct scallop_rational_crawler *r = &m->crawler;
  if (strstr(condition->text, "F1 < F2") || strstr(condition->text, "F2 > F1"))
    fmpq_swap(r->F1, r->F2);
  if (condition->equal_forces)
    fmpq_mul_si(r->F2, r->F1, 1); /* not fmpq_set: it is inline, and gcc 12 then warns of reads beyond F1 */
  if (strstr(condition->text, "m1 a hundredth"))
    fmpq_div_fmpz(r->m1, r->m1, (fmpz[]){ 100 });
  if (strstr(condition->text, "alpha < 1/2"))
    scallop_rational_fraction(r->alpha, r, SCALLOP_CONTRACTION);
  double M = fmpq_get_d(r->m1) + fmpq_get_d(r->m2), F = fmpq_get_d(r->F1) + fmpq_get_d(r->F2), L = fmpq_get_d(r->L);
  set_rounded(m->v0, condition->v0 * sqrt(L * F / M));
  if (m->mirrored) {
    fmpq_swap(r->m1, r->m2);
    fmpq_swap(r->F1, r->F2);
    fmpq_neg(m->v0, m->v0);
  }
}

/* Samples: CLAIM_POINTS of them, T = T0 4^-k */

struct sample {
  fmpq_t T;    /* of the phase, or the period */
  bool solved; /* with the modes of the limit */
  long digits;
  struct ball_answer exact;
};
#define SAMPLE_PARTS(of) of(fmpq, s->T) of(ball_answer, &s->exact)
SCOPED_PARTS(sample, struct sample, SAMPLE_PARTS)
#define TRIAL_PARTS(of) of(fmpq, s->v0) of(scallop_rational, &s->crawler) of(series_answer, &s->series)
SCOPED_PARTS(trial_parts, struct trial, TRIAL_PARTS)

static struct sample *sample_at(const struct trial *m, const fmpq_t T0, int k, long digits)
{
  fmpq_div_2exp(m->samples[k].T, T0, 2 * (ulong)k);
  m->samples[k].digits = digits;
  return &m->samples[k];
}

static void solve_sample(struct sample *s, const struct trial *m)
{
  char modes[MOTION_MODES_TEXT];
  SCOPED(scallop_rational, crawler);
  SCOPED(fmpq, fraction);
  scallop_rational_copy(&crawler, &m->crawler);
  fmpq_one(fraction);
  if (!trial_is_steady(m))
    scallop_rational_fraction(fraction, &crawler, m->condition->kind);
  fmpq_div(crawler.T, s->T, fraction);
  s->solved = answer_in_balls(&s->exact, &crawler, answered(m), m->condition->kind, m->v0, s->digits)
              && strcmp(motion_modes_text(modes, answered(m), s->exact.modes), m->series.modes) == 0;
}

/* Takes samples from T0, the duration at which the Froude number is 1, or less: the expansion is in T^2 over the
 * smaller mass and the difference of the forces, so very different masses or forces need a smaller T. */
static void take_samples(struct trial *m)
{
  const struct scallop_rational_crawler *c = &m->crawler;
  double m1 = fmpq_get_d(c->m1), m2 = fmpq_get_d(c->m2), F1 = fmpq_get_d(c->F1), F2 = fmpq_get_d(c->F2);
  double force = F1 == F2 ? F1 : fmin(fmin(F1, F2), fabs(F1 - F2)); /* equal forces cancel */
  double apart = fmin(m1, m2) / (m1 + m2) * force / (F1 + F2), decades = apart < 0.001 ? ceil(-log10(apart)) : 0;
  SCOPED(fmpq, T0);
  set_rounded(T0, sqrt((m1 + m2) * fmpq_get_d(c->L) / (F1 + F2)) * pow(10, -decades));
  for (int k = 0; k < CLAIM_POINTS; k++) /* an error c T^p, p <= 9 or so, c of size 1, keeps ten digits */
    solve_sample(sample_at(m, T0, k, 40 + (long)(10 * (0.602 * k + 1.5 * decades))), m);
}

void trial_clear(struct trial *m)
{
  for (int k = 0; k < CLAIM_POINTS; k++)
    sample_clear(&m->samples[k]);
  flint_free(m->samples);
  trial_parts_clear(m);
}

/* The end of an extension */

static void sample_end(struct sample *s, const struct scallop_piece *last)
{
  struct scallop_certified_phase *phase = &s->exact.phase;
  SCOPED(arb, before, end);
  arb_set_fmpq(before, s->T, PRECISION);
  scallop_ball_speed(phase->dx1, last, before, PRECISION);
  scallop_ball_way(phase->dx2, last, end, before, PRECISION);
  arb_add_ui(phase->dx2, phase->dx2, 1, PRECISION);
  s->exact.value[Q_DX1] = phase->dx1;
  s->exact.value[Q_DX2] = phase->dx2;
  s->solved = true;
}

/* T = L = 1 */
static void begin_at_end(struct trial *m)
{
  const struct ring ring = { TERMS_AT_END, 256 };
  const struct scallop_shape *shape = &m->crawler.gait->phase[SCALLOP_EXTENSION];
  const struct scallop_piece *last = &shape->pieces[shape->count - 1];
  struct series *speed = &m->series.phase.dx1, *length = &m->series.phase.dx2;
  SCOPED(fmpq, end);
  SCOPED(series, back);
  fmpq_one(m->crawler.L);
  scallop_exact_speed_series(speed, last, end, NULL, &ring); /* so few terms are always exact */
  series_set_x(&back);
  series_neg(&back, &back);
  series_compose(speed, speed, &back, &ring);
  series_integral(length, speed, &ring);
  series_set_si(&back, 1);
  series_sub(length, &back, length, &ring);
  series_truncate(length, TERMS_AT_END);
  m->series.value[Q_DX1] = speed;
  m->series.value[Q_DX2] = length;
  m->series.status = SCALLOP_OK;
  m->terms = SCALLOP_MOST_TERMS; /* further terms do not exist */
  for (int k = 1; k < CLAIM_POINTS; k++)
    sample_end(sample_at(m, m->crawler.L, k, (PRECISION - 64) / 4), last);
}

void trial_begin(struct trial *m, const struct scallop_rational_crawler *crawler, const struct condition *condition,
                 bool mirrored)
{
  trial_parts_init(m);
  m->samples = flint_malloc(CLAIM_POINTS * sizeof *m->samples);
  for (int k = 0; k < CLAIM_POINTS; k++)
    sample_init(&m->samples[k]);
  m->condition = condition;
  m->mirrored = mirrored;
  scallop_rational_copy(&m->crawler, crawler);
  if (condition->at_end) {
    begin_at_end(m);
    return;
  }
  set_condition(m);
  if (trial_expand(m, TERMS))
    take_samples(m);
}

/* Errors */

/* Encloses exact - formula at one T; false: one of them has no value. */
static bool error_at(arb_t error, const struct sample *s, const struct trial *m, const struct scallop_formula *f)
{
  const slong precision = 4 * s->digits + 64;
  const enum scallop_phase_kind kind = m->condition->kind;
  const arb_struct *exact = s->solved ? s->exact.value[quantity_of_formula(f, kind)] : NULL;
  if (!exact)
    return false;
  SCOPED(arb, T);
  arb_set_fmpq(T, s->T, precision);
  if (!f->text) /* the leading term */
    series_value(error, trial_series(m, f->quantity), T, trial_leading_power(f) + 1, precision);
  else if (!published_in_balls(error, f, &m->crawler, kind, m->v0, s->T, &s->exact, precision))
    return false;
  arb_sub(error, exact, error, precision);
  return true;
}

/* Returns the difference between the sum of the terms left out and the error, over the error. */
static double mismatch_at(const arb_t error, const struct series *left_out, const arb_t T, slong precision)
{
  SCOPED(arb, sum);
  series_value(sum, left_out, T, left_out->known, precision);
  arb_sub(sum, sum, error, precision);
  arb_div(sum, sum, error, precision);
  return arb_contains_zero(sum) ? 0 : arb_is_finite(sum) ? fabs(middle(sum)) : INFINITY;
}

double trial_measure(struct claim_row *row, const struct trial *m, const struct scallop_formula *f,
                     const struct series *left_out)
{
  enum { ACCURATE = 20, SMALL = 20 }; /* from the sample SMALL on the terms of the sum suffice */
  SCOPED(arb, error, T);
  double mismatch = NAN;
  for (const struct sample *s = m->samples; s < m->samples + CLAIM_POINTS; s++)
    if (error_at(error, s, m, f)) {
      arb_set_fmpq(T, s->T, 4 * s->digits + 64); /* fmpq_get_d does not round to nearest */
      if (s >= m->samples + SMALL && arb_rel_accuracy_bits(error) >= ACCURATE)
        mismatch = mismatch_at(error, left_out, T, 4 * s->digits + 64);
      row->points[row->count++] =
          (struct scallop_order_point){ .h = middle(T), .err = middle(error), .noise = mag_get_d(arb_radref(error)) };
    }
  return mismatch;
}

double trial_error_at_T(const struct trial *m, const struct scallop_formula *f)
{
  enum { DIGITS = 30, BITS = 256 };
  const enum scallop_phase_kind kind = m->condition->kind;
  SCOPED(ball_answer, exact);
  SCOPED(fmpq, T);
  SCOPED(arb, error);
  fmpq_set(T, m->crawler.T);
  if (!trial_is_steady(m))
    scallop_rational_duration(T, &m->crawler, kind);
  const bool solved = answer_in_balls(&exact, &m->crawler, answered(m), kind, m->v0, DIGITS);
  const arb_struct *value = solved ? exact.value[quantity_of_formula(f, kind)] : NULL;
  if (!value || !published_in_balls(error, f, &m->crawler, kind, m->v0, T, &exact, BITS))
    return NAN;
  arb_sub(error, error, value, BITS);
  arb_div(error, error, value, BITS);
  return arb_is_finite(error) ? middle(error) : NAN;
}
