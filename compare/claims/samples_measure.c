/* Certified samples of a motion as T falls, and the errors of formulas there. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/answers/answer.h"
#include "compare/claims/samples.h"
#include "numerics/certified.h"

struct ledger_sample {
  fmpq_t T;    /* of the phase, or the period                                                        */
  bool solved; /* and the modes are those of the limit                                               */
  long digits;
  struct scallop_certified_phase phase;
  struct scallop_certified_steady steady;
  arb_t turning_velocity; /* of the body that turns: 0                                         */
};

/* Of a term c T^p with p <= 9 or so, c of size 1, ten digits are left. decades: by which T0 has been made smaller. */
static long digits_at(int k, double decades) { return 40 + (long)(10 * (0.602 * k + 1.5 * decades)); }

static bool has_its_modes(const struct ledger_sample *s, const struct ledger_case *c)
{
  char text[MOTION_MODES_TEXT];
  if (c->setting == SCALLOP_STEADY)
    return strcmp(motion_modes_text(text, OF_STEADY, s->steady.modes), c->motion->steady.modes) == 0;
  scallop_modes_text(&s->phase.modes, text);
  return strcmp(text, c->motion->phase.modes) == 0;
}

static void take_sample(struct ledger_sample *s, const struct ledger_case *c)
{
  struct scallop_rational_crawler crawler;
  fmpq_t fraction;
  scallop_rational_init(&crawler);
  fmpq_init(fraction);
  scallop_rational_copy(&crawler, &c->crawler);
  fmpq_set(crawler.T, s->T);
  if (c->setting == SCALLOP_STEADY)
    s->solved = scallop_certified_steady(&crawler, s->digits, &s->steady, NULL) == SCALLOP_OK;
  else {
    scallop_rational_fraction(fraction, &crawler, c->kind);
    fmpq_div(crawler.T, s->T, fraction);
    s->solved = scallop_certified_phase(&crawler, c->kind, c->v0, s->digits, &s->phase, NULL) == SCALLOP_OK;
  }
  s->solved = s->solved && has_its_modes(s, c);
  scallop_rational_clear(&crawler);
  fmpq_clear(fraction);
}

struct ledger_sample *ledger_take_samples(const struct ledger_case *c, const fmpq_t T0, double decades)
{
  struct ledger_sample *samples = calloc(LEDGER_SAMPLES, sizeof *samples);
  for (int k = 0; samples && k < LEDGER_SAMPLES; k++) {
    struct ledger_sample *s = &samples[k];
    fmpq_init(s->T);
    fmpq_div_2exp(s->T, T0, 2 * (flint_bitcnt_t)k);
    s->digits = digits_at(k, decades);
    scallop_certified_phase_init(&s->phase);
    scallop_certified_steady_init(&s->steady);
    arb_init(s->turning_velocity);
    take_sample(s, c);
  }
  return samples;
}

void ledger_free_samples(struct ledger_sample *samples)
{
  for (int k = 0; samples && k < LEDGER_SAMPLES; k++) {
    fmpq_clear(samples[k].T);
    scallop_certified_phase_clear(&samples[k].phase);
    scallop_certified_steady_clear(&samples[k].steady);
    arb_clear(samples[k].turning_velocity);
  }
  free(samples);
}

static bool is_of_a_turn(enum scallop_quantity quantity)
{
  return quantity <= SCALLOP_REAR_AT_LAST || quantity == SCALLOP_VELOCITY_AT_FIRST || quantity == SCALLOP_VELOCITY_AT_LAST;
}

/* NULL where the motion has no such quantity: no body turns */
static const arb_struct *sampled(const struct ledger_sample *s, const struct ledger_case *c, enum scallop_quantity quantity)
{
  bool extension = c->kind == SCALLOP_EXTENSION;
  if (!s->phase.switches && is_of_a_turn(quantity))
    return NULL;
  switch (quantity) {
  case SCALLOP_LAG: return s->phase.dT;
  case SCALLOP_FIRST_SWITCH: return s->phase.t1;
  case SCALLOP_REAR_AT_FIRST: return s->phase.at_first;
  case SCALLOP_REAR_AT_LAST: return s->phase.at_last;
  case SCALLOP_REAR_AT_END: return extension ? s->phase.dx1 : s->phase.dx2;
  case SCALLOP_FRONT_AT_END: return extension ? s->phase.dx2 : s->phase.dx1;
  case SCALLOP_CENTRE_AT_END: return s->phase.dxC;
  case SCALLOP_VELOCITY_AT_END:
  case SCALLOP_VELOCITY_CHANGE: return s->phase.v_end;
  case SCALLOP_VELOCITY_AT_FIRST:
  case SCALLOP_VELOCITY_AT_LAST: return s->turning_velocity;
  case SCALLOP_STEADY_VELOCITY: return s->steady.v_start;
  case SCALLOP_STEADY_DISPLACEMENT: return s->steady.displacement;
  }
  return NULL;
}

/* The leading term of the steady state at T */
static void leading_term(struct series *value, const struct ledger_case *c, enum scallop_quantity quantity, const fmpq_t T,
                         slong precision)
{
  slong power = quantity == SCALLOP_STEADY_VELOCITY ? -1 : 0;
  arb_t x;
  arb_init(x);
  series_coefficient(x, ledger_expansion(c->motion, c, quantity), power, precision);
  if (power < 0) {
    arb_mul_fmpz(x, x, fmpq_denref(T), precision);
    arb_div_fmpz(x, x, fmpq_numref(T), precision);
  }
  series_set_ball(value, x);
  arb_clear(x);
}

/* exact - formula at one T, enclosed */
static bool error_at(arb_t error, const struct ledger_sample *s, const struct ledger_case *c,
                     const struct scallop_formula *formula, enum scallop_quantity quantity, bool limit)
{
  const struct ring ring = { 1, 4 * s->digits + 64 };
  const arb_struct *exact = sampled(s, c, quantity);
  struct scallop_symbols symbols;
  struct series value;
  bool evaluated = s->solved && exact;
  scallop_symbols_init(&symbols);
  series_init(&value);
  if (evaluated && formula) {
    scallop_symbols_set(&symbols, &c->crawler, c->kind, c->v0, NULL, &ring);
    series_set_rational(&symbols.value[SYMBOL_T], s->T);
    series_set_ball(&symbols.value[SYMBOL_t1], s->phase.t1);
    series_set_ball(&symbols.value[SYMBOL_dT], s->phase.dT);
    series_set_ball(&symbols.value[SYMBOL_x_switch], s->phase.at_last);
    evaluated = scallop_formula_expand(&value, formula, &symbols, c->kind, &ring);
    if (quantity == SCALLOP_VELOCITY_CHANGE)
      series_add(&value, &value, &symbols.value[SYMBOL_v0], &ring);
  } else if (evaluated && limit)
    leading_term(&value, c, quantity, s->T, ring.precision);
  series_coefficient(error, &value, 0, ring.precision);
  if (evaluated)
    arb_sub(error, exact, error, ring.precision);
  scallop_symbols_clear(&symbols);
  series_clear(&value);
  return evaluated;
}

/* fmpq_get_d does not round to nearest. */
static double nearest_double(const fmpq_t x)
{
  arb_t ball;
  arb_init(ball);
  arb_set_fmpq(ball, x, 64);
  double value = arf_get_d(arb_midref(ball), ARF_RND_NEAR);
  arb_clear(ball);
  return value;
}

/* log |error|, if the ball says something of it */
static double log_size(const arb_t error)
{
  arb_t size;
  arb_init(size);
  arb_abs(size, error);
  arb_log(size, size, 64);
  double value = arb_rel_accuracy_bits(error) >= 20 ? arf_get_d(arb_midref(size), ARF_RND_NEAR) : NAN;
  arb_clear(size);
  return value;
}

int ledger_measure(struct order_point points[LEDGER_SAMPLES], double *slope, const struct ledger_case *c,
                   const struct scallop_formula *formula, enum scallop_quantity quantity, bool limit)
{
  int count = 0;
  double before = NAN, last = NAN;
  arb_t error;
  arb_init(error);
  *slope = NAN;
  for (int k = 0; c->samples && k < LEDGER_SAMPLES; k++)
    if (error_at(error, &c->samples[k], c, formula, quantity, limit)) {
      before = last;
      last = log_size(error);
      *slope = (before - last) / log(4);
      points[count++] = (struct order_point){ .h = nearest_double(c->samples[k].T),
                                              .err = arf_get_d(arb_midref(error), ARF_RND_NEAR),
                                              .noise = mag_get_d(arb_radref(error)) };
    }
  arb_clear(error);
  return count;
}
