/* Expansions of a motion in powers of T, in numbers and in formulas. */
#include "compare/command/expansion_flint.h"

#include <string.h>

/* Returns true if every coefficient is exact or has the requested digits. */
static bool is_precise(const struct expansion *e)
{
  bool precise = true;
  SCOPED(arb, x);
  for (int q = 0; q < QUANTITIES; q++) {
    const struct series *s = e->derived.value[q];
    for (slong k = s ? s->first : e->order; k < e->order && s->kind == SERIES_BALLS && precise; k++) {
      series_coefficient(x, s, k, 64);
      precise = arb_rel_accuracy_bits(x) > bits_of_digits(e->digits) + 4 || arb_contains_zero(x);
    }
  }
  return precise;
}

/* Returns true if the exact values have enough digits for the errors of all sums. */
static bool errors_are_resolved(const struct expansion *e)
{
  bool resolved = true;
  SCOPED(arb, error);
  for (int q = 0; q < QUANTITIES; q++)
    if (e->derived.value[q] && e->exact.value[q]) {
      series_value(error, e->derived.value[q], e->at, e->order, e->precision);
      arb_sub(error, error, e->exact.value[q], e->precision);
      resolved = resolved && (arb_is_zero(error) || arb_rel_accuracy_bits(error) > 12);
    }
  return resolved;
}

/* Returns the digits of a sum at T before its last term; the errors of the sums require about as many. */
static long digits_before_last_terms(const struct expansion *e)
{
  slong bits = 0;
  SCOPED(arb, sum, last, power);
  for (int q = 0; q < QUANTITIES; q++) {
    const struct series *s = e->derived.value[q];
    slong k = e->order - 1;
    while (s && k > 0 && series_coefficient_is_zero(s, k))
      k--;
    if (!s || k <= 0)
      continue;
    series_value(sum, s, e->at, e->order, e->precision);
    series_coefficient(last, s, k, e->precision);
    arb_pow_ui(power, e->at, (ulong)k, e->precision);
    arb_mul(last, last, power, e->precision);
    bits = FLINT_MAX(bits, arf_abs_bound_lt_2exp_si(arb_midref(sum)) - arf_abs_bound_lt_2exp_si(arb_midref(last)));
  }
  return (long)(0.302 * (double)bits);
}

/* Sets the status: the series is of this motion if the modes are those for T -> 0. */
static void set_status(struct expansion *e)
{
  char modes[MOTION_MODES_TEXT];
  if (e->exact.status != SCALLOP_OK)
    snprintf(e->status, sizeof e->status, "not certified: %s",
             e->exact.why ? e->exact.why : scallop_status_text(e->exact.status));
  else if (strcmp(motion_modes_text(modes, e->of, e->exact.modes), e->derived.modes) != 0)
    snprintf(e->status, sizeof e->status, "not of this motion: its modes are %s", modes);
  else
    snprintf(e->status, sizeof e->status, "ok");
}

/* Increases the precision until coefficients and errors have their digits, up to a limit. The first FEW terms of a long
 * series give the decrease of the last terms, and thus the digits of the errors. */
void expand_numbers(struct expansion *e)
{
  enum { TRIES = 9, MAX_FAILURES = 6, MAX_DIGITS = 10000, FEW = 64 };
  int main_quantity = e->of == OF_STEADY ? Q_V_START : Q_V_END;
  bool derived = false, enough = false;
  const long order = e->order;
  symbols_add(e->symbols, NAMED_T, 0, SCALLOP_EXTENSION);
  symbols_begin(e->symbols);
  if (e->of == OF_STEADY)
    fmpq_set(e->T, e->crawler->T);
  else
    scallop_rational_duration(e->T, e->crawler, e->kind);
  for (long i = 0, more = e->digits + 20; i < TRIES && !enough; i++) {
    long digits = more < MAX_DIGITS ? more : MAX_DIGITS;
    const bool is_trial = i == 0 && e->is_certified && order > 2 * FEW;
    e->order = is_trial ? FEW : order;
    e->precision = 4 * digits + 128 + e->order;
    arb_set_fmpq(e->at, e->T, e->precision);
    if (!derived || e->derived.value[main_quantity]->kind == SERIES_BALLS)
      derived = answer_in_series(&e->derived, e->crawler, e->of, e->kind, e->v0, e->order, e->precision);
    if (!derived && (e->derived.status == SCALLOP_EDOMAIN || i + 1 == MAX_FAILURES))
      break;
    more = is_trial && derived ? more + digits_before_last_terms(e) * order / FEW : 2 * more;
    derived = derived && !is_trial;
    enough = derived && (is_precise(e) || i + 1 == TRIES)
             && (!e->is_certified || !answer_in_balls(&e->exact, e->crawler, e->of, e->kind, e->v0, digits)
                 || digits == MAX_DIGITS || errors_are_resolved(e));
  }
  e->order = order;
  if (derived)
    set_status(e);
}

static void expand_phase(struct expansion *e)
{
  struct scallop_expansion *phase = &e->derived.phase;
  e->derived.status = symbolic_expand_phase(e->symbols, e->crawler, e->kind, e->v0, e->order, phase, &e->derived.why);
  const struct series *const values[] = { phase->switches ? &phase->t1 : NULL,
                                          phase->switches ? &phase->dT : NULL,
                                          &phase->v_end,
                                          &phase->dx1,
                                          &phase->dx2,
                                          &phase->dxC };
  e->derived.modes = phase->modes;
  memcpy(e->derived.value + Q_T1, values, sizeof values);
}

/* Expands the steady state as series in T, or in closed form. */
static void expand_steady(struct expansion *e)
{
  struct series *const series[] = { &e->derived.steady.v_start, &e->derived.steady.v_mid,
                                    &e->derived.steady.displacement };
  e->derived.status = symbolic_solve_steady(e->symbols, e->crawler, &e->closed, &e->derived.why);
  e->derived.modes = e->closed.modes;
  if (e->derived.status != SCALLOP_OK)
    return;
  const symbolic values[] = { e->closed.v_start, e->closed.v_mid, e->closed.displacement };
  for (int i = 0; i < 3; i++) {
    e->derived.value[Q_V_START + i] = series[i];
    if (e->is_closed)
      series_set_ratio(series[i], values[i]);
    else
      symbolic_in_T(series[i], e->symbols, values[i], e->order + 1);
  }
}

void expand_formulas(struct expansion *e) { (e->of == OF_PHASE ? expand_phase : expand_steady)(e); }

void expand_limit(struct expansion *e)
{
  e->derived.status = symbolic_expand_limit(e->symbols, e->crawler, e->in, e->order, &e->limit, &e->derived.why);
  e->derived.modes = e->limit.modes;
  e->derived.value[Q_V_START] = &e->limit.term;
}
