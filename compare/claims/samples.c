#include "compare/claims/samples.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/answers/answer_flint.h"
#include "compare/claims/evidence.h"

struct sample {
  fmpq_t T;    /* of the phase, or the period                                                        */
  bool solved; /* and the modes are those of the limit                                               */
  long digits;
  struct ball_answer exact;
};

static enum quantity_of answered(const struct trial *m) { return trial_is_steady(m) ? OF_STEADY : OF_PHASE; }

static void solve_sample(struct sample *s, const struct trial *m)
{
  struct scallop_rational_crawler crawler;
  char modes[MOTION_MODES_TEXT];
  fmpq_t fraction;
  scallop_rational_init(&crawler);
  fmpq_init(fraction);
  scallop_rational_copy(&crawler, &m->crawler);
  fmpq_set(crawler.T, s->T);
  if (!trial_is_steady(m)) {
    scallop_rational_fraction(fraction, &crawler, m->condition->kind);
    fmpq_div(crawler.T, s->T, fraction);
  }
  s->solved = answer_in_balls(&s->exact, &crawler, answered(m), m->condition->kind, m->v0, s->digits)
              && strcmp(motion_modes_text(modes, answered(m), s->exact.modes), trial_modes(m)) == 0;
  scallop_rational_clear(&crawler);
  fmpq_clear(fraction);
}

/* The expansion is one in T^2 over the smaller mass and the difference of the forces: where these are far apart, T is
 * smaller. */
static double decades_apart(const struct scallop_rational_crawler *c)
{
  double m1 = fmpq_get_d(c->m1), m2 = fmpq_get_d(c->m2), F1 = fmpq_get_d(c->F1), F2 = fmpq_get_d(c->F2);
  double force = F1 == F2 ? F1 : fmin(fmin(F1, F2), fabs(F1 - F2)); /* equal forces cancel */
  double apart = fmin(m1, m2) / (m1 + m2) * force / (F1 + F2);
  return apart < 0.001 ? ceil(-log10(apart)) : 0;
}

struct sample *samples_take(const struct trial *m)
{
  const struct scallop_rational_crawler *c = &m->crawler;
  struct sample *samples = calloc(CLAIM_POINTS, sizeof *samples);
  double M = fmpq_get_d(c->m1) + fmpq_get_d(c->m2), F = fmpq_get_d(c->F1) + fmpq_get_d(c->F2);
  double natural = sqrt(M * fmpq_get_d(c->L) / F), decades = decades_apart(c);
  fmpq_t T0;
  fmpq_init(T0);
  trial_set_rounded(T0, natural * pow(10, -decades));
  for (int k = 0; samples && k < CLAIM_POINTS; k++) {
    struct sample *s = &samples[k];
    fmpq_init(s->T);
    fmpq_div_2exp(s->T, T0, 2 * (flint_bitcnt_t)k);
    s->digits = 40 + (long)(10 * (0.602 * k + 1.5 * decades)); /* of c T^p, p <= 9 or so, c of size 1, ten are left */
    ball_answer_init(&s->exact);
    solve_sample(s, m);
  }
  fmpq_clear(T0);
  return samples;
}

void samples_free(struct sample *samples)
{
  for (int k = 0; samples && k < CLAIM_POINTS; k++) {
    fmpq_clear(samples[k].T);
    ball_answer_clear(&samples[k].exact);
  }
  free(samples);
}

/* The leading term of the steady state at T */
static void leading_term(arb_t x, const struct trial *m, const struct scallop_formula *f, const fmpq_t T,
                         slong precision)
{
  series_coefficient(x, trial_series(m, f->quantity), trial_leading_power(f), precision);
  if (trial_leading_power(f) < 0) {
    arb_mul_fmpz(x, x, fmpq_denref(T), precision);
    arb_div_fmpz(x, x, fmpq_numref(T), precision);
  }
}

/* exact - formula at one T, enclosed */
static bool error_at(arb_t error, const struct sample *s, const struct trial *m, const struct scallop_formula *f)
{
  const slong precision = 4 * s->digits + 64;
  const enum scallop_phase_kind kind = m->condition->kind;
  const arb_struct *exact = s->solved ? s->exact.value[quantity_of_formula(f, kind)] : NULL;
  if (!exact)
    return false;
  if (!f->text)
    leading_term(error, m, f, s->T, precision);
  else if (!published_in_balls(error, f, &m->crawler, kind, m->v0, s->T, &s->exact, precision))
    return false;
  arb_sub(error, exact, error, precision);
  return true;
}

/* How far the sum of what is left out is from the error, over the error; 0 where it does not reach beyond what its last
 * terms are */
static double mismatch_at(const arb_t error, const struct series *left_out, const fmpq_t T, slong precision)
{
  enum { LAST = 2, MORE = 1000 };
  double mismatch = 0;
  arb_t x, sum, last;
  arb_init(x);
  arb_init(sum);
  arb_init(last);
  arb_set_fmpq(x, T, precision);
  series_value(sum, left_out, x, left_out->known, precision);
  series_value(last, left_out, x, left_out->known - LAST, precision);
  arb_sub(last, sum, last, precision);
  arb_sub(sum, sum, error, precision);
  arb_div(x, sum, error, precision);
  arb_div(last, last, error, precision);
  if (!arb_contains_zero(sum))
    mismatch = arb_is_finite(x) ? fabs(middle(x)) : INFINITY;
  if (arb_is_finite(last) && mismatch <= MORE * fabs(middle(last)))
    mismatch = 0;
  arb_clear(x);
  arb_clear(sum);
  arb_clear(last);
  return mismatch;
}

void samples_measure(struct claim_row *row, const struct trial *m, const struct scallop_formula *f,
                     const struct series *left_out)
{
  enum { ACCURATE = 20 };
  arb_t error;
  arb_init(error);
  for (const struct sample *s = m->samples; s && s < m->samples + CLAIM_POINTS; s++)
    if (error_at(error, s, m, f)) {
      if (arb_rel_accuracy_bits(error) >= ACCURATE)
        row->mismatch = mismatch_at(error, left_out, s->T, 4 * s->digits + 64);
      row->points[row->count++] = (struct scallop_order_point){ .h = nearest_double(s->T),
                                                                .err = middle(error),
                                                                .noise = mag_get_d(arb_radref(error)) };
    }
  arb_clear(error);
}
