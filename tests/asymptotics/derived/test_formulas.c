/* The texts of the formulas: in double and as series. */
#include <float.h>

#include "asymptotics/derived/evaluate.h"
#include "asymptotics/derived/formula_flint.h"
#include "asymptotics/published/read.h"
#include "model/gaits.h"
#include "tests/support/exact.h"
#include "tests/support/odd_gaits.h"

enum { PRECISION = 300, LENGTH = 24 };
static const struct ring ring = { LENGTH, PRECISION };

static bool of_extension(const struct scallop_formula *f)
{
  return f->setting != SCALLOP_MOVING_CONTRACTION && f->setting != SCALLOP_STEADY;
}

/* What rounding can make of the formula in double: what 53 bits lose in balls, if each input is a unit off */
static double rounding_of(const struct scallop_formula *f, const struct scallop_values *values)
{
  arb_ptr inputs = _arb_vec_init(SCALLOP_SYMBOLS);
  char message[FORMULA_MESSAGE];
  struct formula read;
  SCOPED(arb, ball);
  for (int i = 0; i < SCALLOP_SYMBOLS; i++)
    if (isfinite(values->of[i])) {
      arb_set_d(inputs + i, values->of[i]);
      mag_set_d(arb_radref(inputs + i), DBL_EPSILON * fabs(values->of[i]));
    } else
      arb_indeterminate(inputs + i);
  assert_null(scallop_formula_text(&read, f, NULL, message));
  formula_ball(ball, &read, inputs, DBL_MANT_DIG);
  _arb_vec_clear(inputs, SCALLOP_SYMBOLS);
  assert_true(arb_is_finite(ball));
  return mag_get_d(arb_radref(ball));
}

static void check_value(const struct scallop_formula *f, const struct scallop_symbols *s, enum scallop_phase_kind kind,
                        double got, const struct scallop_values *values)
{
  const bool exchanged = of_extension(f) && kind == SCALLOP_CONTRACTION;
  const struct scallop_values as_read = exchanged ? scallop_exchanged(values) : *values;
  SCOPED(series, value);
  SCOPED(arb, ball);
  char message[FORMULA_MESSAGE];
  assert_null(scallop_formula_expand(&value, f, s, kind, &ring, message));
  assert_int_equal(next_nonzero(&value, 1, LENGTH), LENGTH);
  series_coefficient(ball, &value, 0, PRECISION);
  if (!check_near(got, middle(ball), rounding_of(f, &as_read)))
    fail_msg("%s: %.17g in double, %.17g as a series, rounding %g", f->name, got, middle(ball),
             rounding_of(f, &as_read));
}

static void set_symbol(struct scallop_symbols *s, enum scallop_symbol symbol, double value)
{
  SCOPED(fmpq, exact);
  scallop_rational_set_double(exact, value);
  series_set_rational(&s->value[symbol], exact);
}

static void check_phase_texts(const struct scallop_crawler *c, struct scallop_symbols *s, enum scallop_phase_kind kind,
                              struct random *r)
{
  static const enum scallop_symbol given[] = { SCALLOP_SYMBOL_t1, SCALLOP_SYMBOL_dT, SCALLOP_SYMBOL_x_switch };
  double start = random_between(r, -3, 3), T = scallop_phase_duration(c, kind);
  double times[] = { T * random_between(r, 0, 0.5), T * random_between(r, 0, 0.5), random_between(r, -9, 9) };
  SCOPED(fmpq, v0);
  SCOPED(scallop_rational, exact);
  scallop_rational_of(&exact, c);
  scallop_rational_set_double(v0, start);
  scallop_symbols_set(s, &exact, kind, v0, NULL, &ring);
  set_symbol(s, SCALLOP_SYMBOL_T, T);
  struct scallop_values values = scallop_phase_values(c, kind, start);
  for (int i = 0; i < 3; i++) {
    set_symbol(s, given[i], times[i]);
    values.of[given[i]] = times[i];
  }
  const struct scallop_formula *const lists[] = { scallop_published, scallop_corrected };
  for (int i = 0; i < 2; i++)
    for (const struct scallop_formula *f = lists[i]; f->name; f++)
      if (f->setting != SCALLOP_STEADY && (of_extension(f) || kind == SCALLOP_CONTRACTION))
        check_value(f, s, kind, scallop_published_value(f, c, kind, start, times[0], times[1], times[2]), &values);
}

static void check_steady_texts(const struct scallop_crawler *c, struct scallop_symbols *s)
{
  SCOPED(scallop_rational, exact);
  scallop_rational_of(&exact, c);
  scallop_symbols_set(s, &exact, SCALLOP_EXTENSION, NULL, NULL, &ring);
  set_symbol(s, SCALLOP_SYMBOL_T, c->T);
  const struct scallop_values values = scallop_steady_values(c);
  const struct scallop_formula *const lists[] = { scallop_published, scallop_corrected };
  for (int i = 0; i < 2; i++)
    for (const struct scallop_formula *f = lists[i]; f->name; f++)
      if (f->setting == SCALLOP_STEADY)
        check_value(f, s, SCALLOP_EXTENSION, scallop_published_value(f, c, SCALLOP_EXTENSION, NAN, NAN, NAN, NAN),
                    &values);
}

/* k0 and kT in double, of laws of each kind */
TEST(fourth_derivatives)
{
  struct scallop_polynomial made[2];
  const char *why;
  const struct scallop_gait *gaits[] = { &scallop_gait_quadratic, &scallop_gait_sinusoidal,
                                         &trapezoid_gait,         &made[0].gait,
                                         &made[1].gait,           &leaning_gait };
  assert_int_equal(scallop_make_polynomial(&made[0], "a", (double[]){ 0, 0, 3, -2 }, 3, &why), SCALLOP_OK);
  assert_int_equal(scallop_make_polynomial(&made[1], "b", (double[]){ 0, 0, 0, 10, -15, 6 }, 5, &why), SCALLOP_OK);
  SCOPED(scallop_rational, exact);
  SCOPED(scallop_symbols, s);
  SCOPED(arb, k);
  fmpq_set_si(exact.L, 1, 1);
  for (size_t i = 0; i < 2 * sizeof gaits / sizeof *gaits; i++)
    for (int end = 0; end < 2; end++) {
      enum scallop_phase_kind kind = i % 2 ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION;
      exact.gait = gaits[i / 2];
      scallop_symbols_set(&s, &exact, kind, NULL, NULL, &ring);
      series_coefficient(k, &s.value[end ? SCALLOP_SYMBOL_kT : SCALLOP_SYMBOL_k0], 0, 128);
      double wanted = arf_get_d(arb_midref(k), ARF_RND_NEAR);
      CHECK_NEAR(scallop_fourth_derivative(&exact.gait->phase[kind], end), wanted,
                 8 * DBL_EPSILON * (fabs(wanted) + 1));
    }
  const struct scallop_piece lawless = { .end = 1, .direction = 1 };
  CHECK_EQUAL(scallop_fourth_derivative(&(struct scallop_shape){ .pieces = &lawless, .count = 1 }, true), NAN);
}

TEST(a_text_is_the_same_number_in_double_and_as_a_series)
{
  static const struct scallop_gait *const gaits[] = { &scallop_gait_quadratic, &scallop_gait_sinusoidal,
                                                      &trapezoid_gait };
  struct random r = { 20260851 };
  SCOPED(scallop_symbols, s);
  for (int i = 0; i < 300; i++) {
    struct scallop_crawler c = random_crawler(&r, ORDINARY, gaits[i % 3]);
    check_phase_texts(&c, &s, SCALLOP_EXTENSION, &r);
    check_phase_texts(&c, &s, SCALLOP_CONTRACTION, &r);
    check_steady_texts(&c, &s);
  }
}

/* What corrects a formula gives the same quantity, and no less of it. */
TEST(corrected_ones_exist)
{
  for (const struct scallop_formula *f = scallop_published; f->name; f++) {
    if (!f->corrected)
      continue;
    const struct scallop_formula *right = scallop_formula_named(f->corrected);
    assert_non_null(right);
    assert_int_equal(right->quantity, f->quantity);
    assert_true(right->remainder >= f->remainder);
    assert_true(right->setting == f->setting
                || (f->setting == SCALLOP_MOVING_CONTRACTION && right->setting == SCALLOP_MOVING_EXTENSION));
    assert_non_null(strstr(right->equation, f->equation));
  }
  for (const struct scallop_formula *f = scallop_corrected; f->name; f++)
    assert_true(f->text && !f->corrected);
}
