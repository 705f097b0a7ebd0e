/* Formulas against the numbers that asymptotics/derived gets by another arithmetic: exactly equal, at crawlers that the
 * formulas were not derived from. */
#include <string.h>

#include "asymptotics/symbolic/symbolic.h"
#include "tests/support/exact.h"
#include "tests/support/random_gait.h"
#include "tests/support/solved.h"

enum { ORDER = 8, STEADY_ORDER = 14, PRECISION = 128, CRAWLERS = 300, NAMES = 8 };

static const struct series *series_of(const struct scallop_expansion *e, int i)
{
  const struct series *const all[NAMES] = { &e->t1,  &e->dT,  &e->v_end,         &e->dx1,
                                            &e->dx2, &e->dxC, &e->rear_at_first, &e->rear_at_last };
  return all[i];
}

static int compared;

/* All coefficients below x^order */
static void check_series(const struct series *numeric, const struct series *series, slong order, struct symbols *s,
                         const fmpq *values, const struct scallop_rational_crawler *c, int which)
{
  SCOPED(fmpq, got, wanted);
  for (slong k = -2; k < order; k++) {
    assert_true(series_rational_coefficient(wanted, numeric, k));
    symbolic coefficient = symbolic_coefficient(s, series, k);
    if (!coefficient || !symbolic_value(got, coefficient, s, values) || !fmpq_equal(got, wanted)) {
      print_exact_crawler(c);
      fail_msg("quantity %d, T^%ld", which, (long)k);
    }
    compared += !fmpq_is_zero(wanted);
  }
}

/* Another crawler with the same sign of F1 - F2, and a start velocity with this sign: in a phase they have the same
 * modes. */
static void draw_like(struct scallop_rational_crawler *other, fmpq_t v0, const struct scallop_rational_crawler *c,
                      int sign, struct random *r)
{
  do {
    random_exact_crawler(other, r, c->gait);
  } while (fmpq_cmp(other->F1, other->F2) * fmpq_cmp(c->F1, c->F2) < 0);
  random_positive(v0, r);
  fmpq_mul_si(v0, v0, sign);
}

/* The formula of one crawler at another: false where this gait has no series */
static bool check_phase(const struct scallop_gait *gait, struct random *r)
{
  SCOPED(scallop_rational, from, at);
  SCOPED(scallop_expansion, numeric, phase);
  SCOPED(fmpq, v0, pi_squared);
  struct symbols s;
  int sign = random_below(r, 3) - 1, kind = random_below(r, 2);
  random_exact_crawler(&from, r, gait);
  random_positive(v0, r);
  fmpq_mul_si(v0, v0, sign);
  symbols_init(&s);
  if (symbolic_expand_phase(&s, &from, (enum scallop_phase_kind)kind, v0, ORDER, &phase, NULL) != SCALLOP_OK)
    return false;
  draw_like(&at, v0, &from, sign, r);
  random_positive(pi_squared, r);
  assert_int_equal(
      scallop_expand_phase(&at, (enum scallop_phase_kind)kind, v0, ORDER, PRECISION, pi_squared, &numeric, NULL),
      SCALLOP_OK);
  assert_string_equal(phase.modes, numeric.modes);
  assert_true(phase.switches == numeric.switches);
  fmpq *values = _fmpq_vec_init(s.count);
  symbols_values(values, &s, &at, v0, pi_squared);
  for (int i = 0; i < NAMES; i++)
    if (!series_is_unknown(series_of(&numeric, i)))
      check_series(series_of(&numeric, i), series_of(&phase, i), ORDER, &s, values, &at, i);
  _fmpq_vec_clear(values, s.count);
  symbols_end(&s);
  return true;
}

static const struct scallop_gait *draw_gait(struct random *r, struct random_gait *made)
{
  static const enum random_gait_kind kinds[] = { TRAPEZOIDAL, SKEWED, POLYNOMIAL, POLYNOMIAL, SPLINE };
  int of = random_below(r, 10);
  return of < ALL_GAITS ? every_gait[of] : random_gait(r, kinds[of - ALL_GAITS], made);
}

TEST(phases)
{
  struct random r = { 20261122 };
  struct random_gait made;
  long done = 0, most = check_cases(2 * CRAWLERS);
  compared = 0;
  for (long i = 0; i < most; i++)
    done += check_phase(draw_gait(&r, &made), &r);
  assert_true(done > most / 2);
  print_message("%ld formulas of phases, %d coefficients\n", done, compared);
}

TEST(equal_forces_from_rest_are_those_of_F1_at_least_F2)
{
  SCOPED(scallop_rational, c);
  SCOPED(scallop_expansion, numeric, phase);
  SCOPED(fmpq, v0);
  struct random r = { 7 };
  struct symbols s;
  random_exact_crawler(&c, &r, &scallop_gait_quadratic);
  fmpq_set(c.F2, c.F1);
  symbols_init(&s);
  assert_int_equal(symbolic_expand_phase(&s, &c, SCALLOP_EXTENSION, v0, ORDER, &phase, NULL), SCALLOP_OK);
  assert_int_equal(scallop_expand_phase(&c, SCALLOP_EXTENSION, v0, ORDER, PRECISION, NULL, &numeric, NULL), SCALLOP_OK);
  fmpq *values = _fmpq_vec_init(s.count);
  symbols_values(values, &s, &c, v0, NULL);
  for (int i = 1; i < 6; i++) /* nothing turns: there is no t1, and no place where a body does */
    check_series(series_of(&numeric, i), series_of(&phase, i), ORDER, &s, values, &c, i);
  _fmpq_vec_clear(values, s.count);
  symbols_end(&s);
}

/* The formulas of one crawler at others, where these have the same modes. How many had, or -1 where this crawler has no
 * formula. */
static int check_steady(const struct scallop_gait *gait, struct random *r)
{
  enum { AT = 16 };
  SCOPED(scallop_rational, c);
  SCOPED(scallop_expansion, numeric);
  struct symbols s;
  struct symbolic_steady steady;
  SCOPED(series, v_start, v_mid, displacement);
  struct series *const series[] = { &v_start, &v_mid, &displacement };
  int checked = 0;
  random_exact_crawler(&c, r, gait);
  symbols_init(&s);
  if (symbolic_solve_steady(&s, &c, &steady, NULL) != SCALLOP_OK)
    return -1;
  const symbolic formulas[] = { steady.v_start, steady.v_mid, steady.displacement };
  for (int q = 0; q < 3; q++)
    symbolic_in_T(series[q], &s, formulas[q], STEADY_ORDER + 1);
  fmpq *values = _fmpq_vec_init(s.count);
  for (int i = 0; i < AT; i++, random_exact_crawler(&c, r, gait)) {
    if (scallop_expand_steady(&c, STEADY_ORDER, PRECISION, &numeric, NULL) != SCALLOP_OK
        || strcmp(numeric.modes, steady.modes) != 0)
      continue;
    const struct series *const wanted[] = { &numeric.v_start, &numeric.v_mid, &numeric.displacement };
    symbols_values(values, &s, &c, NULL, NULL);
    for (int q = 0; q < 3; q++)
      check_series(wanted[q], series[q], STEADY_ORDER, &s, values, &c, q);
    checked++;
  }
  _fmpq_vec_clear(values, s.count);
  symbols_end(&s);
  return checked;
}

TEST(steady_states)
{
  struct random r = { 20261123 };
  struct random_gait made;
  long done = 0, crawlers = 0, most = check_cases(CRAWLERS / 5);
  compared = 0;
  for (long i = 0; i < most; i++) {
    int checked = check_steady(i % 6 ? &scallop_gait_quadratic : draw_gait(&r, &made), &r);
    done += checked >= 0;
    crawlers += checked > 0 ? checked : 0;
  }
  assert_true(done > most / 2 && crawlers > 2 * most);
  print_message("%ld closed forms at %ld crawlers, %d coefficients\n", done, crawlers, compared);
}

/* At a T so small that the modes are those of T -> 0, and yet far from it: the closed form has no remainder. */
static bool check_closed(struct random *r)
{
  SCOPED(scallop_rational, c);
  SCOPED(scallop_certified_steady, exact);
  SCOPED(fmpq, value);
  struct symbols s;
  struct symbolic_steady steady;
  char modes[BOTH_MODES_TEXT];
  random_exact_crawler(&c, r, &scallop_gait_quadratic);
  set_small_T(&c, 0.3);
  symbols_init(&s);
  if (symbolic_solve_steady(&s, &c, &steady, NULL) != SCALLOP_OK)
    return false;
  bool same = scallop_certified_steady(&c, 60, &exact, NULL) == SCALLOP_OK
              && strcmp(both_modes(exact.modes, modes), steady.modes) == 0;
  fmpq *values = _fmpq_vec_init(s.count);
  symbols_values(values, &s, &c, NULL, NULL);
  const symbolic formulas[] = { steady.v_start, steady.v_mid, steady.displacement };
  const arb_struct *const balls[] = { exact.v_start, exact.v_mid, exact.displacement };
  for (int q = 0; same && q < 3; q++) {
    assert_true(symbolic_value(value, formulas[q], &s, values));
    if (!arb_contains_fmpq(balls[q], value) || arb_rel_accuracy_bits(balls[q]) < 190) {
      print_exact_crawler(&c);
      fail_msg("closed form %d", q);
    }
  }
  _fmpq_vec_clear(values, s.count);
  symbols_end(&s);
  return same;
}

TEST(closed_forms_are_the_certified_steady_state)
{
  struct random r = { 28 };
  long done = 0, most = check_cases(CRAWLERS / 3);
  for (long i = 0; i < most; i++)
    done += check_closed(&r);
  assert_true(done > most / 3);
  print_message("%ld certified steady states\n", done);
}

static void refuses_phase(const struct scallop_gait *gait, slong order, const char *wanted)
{
  SCOPED(scallop_rational, c);
  SCOPED(fmpq, v0);
  struct random r = { 1 };
  struct symbols s;
  SCOPED(scallop_expansion, phase);
  const char *why = "";
  random_exact_crawler(&c, &r, gait);
  symbols_init(&s);
  assert_int_equal(symbolic_expand_phase(&s, &c, SCALLOP_EXTENSION, v0, order, &phase, &why), SCALLOP_EDOMAIN);
  assert_non_null(strstr(why, wanted));
  assert_int_equal(symbolic_expand_phase(&s, &c, SCALLOP_EXTENSION, v0, order, &phase, NULL), SCALLOP_EDOMAIN);
  assert_int_equal(s.count, 0);
}

TEST(what_has_no_formula_is_refused)
{
  refuses_phase(&scallop_gait_quadratic, 0, "1 to 16");
  refuses_phase(&scallop_gait_quadratic, SYMBOLIC_ORDERS + 1, "1 to 16");
  refuses_phase(&minimum_jerk_gait, ORDER, "l'' = 0");
}

static void refuses_steady(const struct scallop_rational_crawler *c, enum scallop_status status, const char *wanted)
{
  struct symbols s;
  struct symbolic_steady steady;
  const char *why = "";
  symbols_init(&s);
  assert_int_equal(symbolic_solve_steady(&s, c, &steady, &why), status);
  assert_non_null(strstr(why, wanted));
  assert_int_equal(symbolic_solve_steady(&s, c, &steady, NULL), status);
  assert_int_equal(s.count, 0);
}

TEST(what_has_no_closed_form_is_refused)
{
  SCOPED(scallop_rational, c);
  struct random r = { 3 };
  random_exact_crawler(&c, &r, &scallop_gait_sinusoidal);
  refuses_steady(&c, SCALLOP_EDOMAIN, "not linear");
  c.gait = &scallop_gait_quadratic;
  fmpq_set_si(c.alpha, 1, 2);
  refuses_steady(&c, SCALLOP_EDOMAIN, "alpha = 1/2");
  fmpq_set_si(c.alpha, 2, 1);
  refuses_steady(&c, SCALLOP_EDOMAIN, "domain");
}
