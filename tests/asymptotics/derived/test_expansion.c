/* The public face of the derived series, against the series inside; and the texts of formulas: in double, as series and
 * in balls. */
#include <float.h>
#include <stdio.h>

#include "asymptotics/derived/evaluate.h"
#include "asymptotics/derived/expansion.h"
#include "asymptotics/derived/formula_flint.h"
#include "asymptotics/published/read.h"
#include "model/gaits.h"
#include "tests/support/expansions.h"
#include "tests/support/odd_gaits.h"

#define COUNT(list) (int)(sizeof(list) / sizeof *(list))

static void end_series(struct scallop_series **series) { scallop_series_free(*series); }

/* The coefficients of a quantity by the face, beside those of the series inside: the fraction, where there is one, and
 * the ball */
static void check_quantity(const struct scallop_series *s, enum scallop_quantity quantity, const struct series *inside)
{
  SCOPED(fmpq, got, wanted);
  SCOPED(arb, ball, exact);
  slong first = scallop_series_first(s, quantity);
  assert_true(first >= inside->first && inside->known >= ORDER);
  for (slong k = -3; k < ORDER; k++) {
    bool is_fraction = series_rational_coefficient(wanted, inside, k);
    assert_int_equal(scallop_series_rational(got, s, quantity, k), is_fraction);
    assert_true(!is_fraction || fmpq_equal(got, wanted));
    assert_true(scallop_series_ball(ball, s, quantity, k));
    series_coefficient(exact, inside, k, PRECISION);
    assert_true(arb_equal(ball, exact));
    assert_true(k >= first || series_coefficient_is_zero(inside, k));
  }
  assert_true(first == ORDER || !series_coefficient_is_zero(inside, first));
}

/* Nothing is said, and nothing changed, of what the motion does not have, and beyond the order. */
static void check_nothing(const struct scallop_series *s, enum scallop_quantity quantity, slong power)
{
  SCOPED(fmpq, fraction, kept);
  SCOPED(arb, ball);
  fmpq_set_si(kept, 22, 7);
  fmpq_set(fraction, kept);
  arb_set_si(ball, 3);
  assert_false(scallop_series_rational(fraction, s, quantity, power) || scallop_series_ball(ball, s, quantity, power));
  assert_true(fmpq_equal(fraction, kept) && arb_equal_si(ball, 3));
}

/* Every quantity is there, or is not. */
static void check_all(const struct scallop_series *s, const struct scallop_expansion *e, bool steady)
{
  const struct series *const inside[SCALLOP_QUANTITIES] = {
    &e->dT,    &e->t1,           &e->rear_at_first, &e->rear_at_last, &e->rear_at_end, &e->front_at_end,
    &e->dxC,   &e->v_end,        &e->v_change,      &e->v_at_first,   &e->v_at_last,   &e->v_start,
    &e->v_mid, &e->displacement, &e->mean_velocity, &e->friction_work
  };
  assert_string_equal(scallop_series_modes(s), e->modes);
  for (int i = 0; i <= SCALLOP_QUANTITIES; i++) {
    enum scallop_quantity q = (enum scallop_quantity)i;
    bool of_switch = q <= SCALLOP_REAR_AT_LAST || q == SCALLOP_VELOCITY_AT_FIRST || q == SCALLOP_VELOCITY_AT_LAST;
    bool there = q < SCALLOP_QUANTITIES && steady == (q >= SCALLOP_STEADY_VELOCITY) && (e->switches || !of_switch);
    if (there || steady || e->switches)
      check_nothing(s, q, ORDER);
    if (there)
      check_quantity(s, q, inside[i]);
    else {
      check_nothing(s, q, 1);
      assert_int_equal(scallop_series_first(s, q), ORDER);
    }
  }
}

/* v_change is v_end without the v0 that v_end begins with; rear and front are bodies 1 and 2, or 2 and 1. */
static void check_phase(struct subject *s, enum scallop_phase_kind kind, const char *modes)
{
  const struct scallop_expansion *e = &s->phase;
  const struct series *rear = kind == SCALLOP_EXTENSION ? &e->dx1 : &e->dx2,
                      *front = kind == SCALLOP_EXTENSION ? &e->dx2 : &e->dx1;
  SCOPED(fmpq, start);
  SCOPED(arb, of_end, of_change);
  ENDED_BY(end_series) struct scallop_series *series = NULL;
  expand_phase(s, (int)kind, ORDER);
  assert_int_equal(scallop_series_of_phase(&series, &s->crawler, kind, s->v0, ORDER, PRECISION, NULL), SCALLOP_OK);
  check_all(series, e, false);
  check_quantity(series, SCALLOP_REAR_AT_END, rear);
  check_quantity(series, SCALLOP_FRONT_AT_END, front);
  assert_true(!modes || strcmp(e->modes, modes) == 0);
  assert_true(scallop_series_ball(of_end, series, SCALLOP_VELOCITY_AT_END, 0) && arb_contains_fmpq(of_end, s->v0));
  assert_true(s->crawler.gait == &scallop_gait_sinusoidal
              || (scallop_series_rational(start, series, SCALLOP_VELOCITY_AT_END, 0) && fmpq_equal(start, s->v0)));
  for (slong k = 0; k < ORDER; k++) {
    assert_true(scallop_series_ball(of_end, series, SCALLOP_VELOCITY_AT_END, k));
    assert_true(scallop_series_ball(of_change, series, SCALLOP_VELOCITY_CHANGE, k));
    assert_true(k == 0 ? arb_is_zero(of_change) : arb_equal(of_change, of_end));
  }
  if (e->switches) /* the velocity of the body that turns is 0 */
    assert_int_equal(scallop_series_first(series, SCALLOP_VELOCITY_AT_FIRST), ORDER);
}

TEST(phases_and_steady_states)
{
  struct random r = { 20261123 };
  SCOPED(subject, s);
  for (int i = 0; i < check_cases(12); i++) {
    ENDED_BY(end_series) struct scallop_series *series = NULL;
    draw(&s, &r, every_gait[i % WITH_SERIES_OF_PHASES]);
    check_phase(&s, i % 2 ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION, NULL);
    assert_true(s.phase.switches);
    if (!expand_steady(&s, ORDER))
      continue;
    assert_int_equal(scallop_series_of_steady(&series, &s.crawler, ORDER, PRECISION, NULL), SCALLOP_OK);
    check_all(series, &s.steady, true);
  }
  /* equal forces and masses from rest: the centre of mass rests, and no body turns */
  const struct scallop_crawler equal = { 1, 1, 2, 2, 10, 1, 0.5, &scallop_gait_quadratic };
  scallop_rational_of(&s.crawler, &equal);
  fmpq_zero(s.v0);
  check_phase(&s, SCALLOP_EXTENSION, "-+");
  assert_false(s.phase.switches);
}

/* A refused series is none; test_derived_laws.c has what is refused. */
TEST(refusals)
{
  SCOPED(subject, subject);
  struct scallop_crawler c = scallop_crawler_default();
  struct scallop_series *s = NULL;
  const char *why = NULL;
  scallop_rational_of(&subject.crawler, &c);
  assert_int_equal(scallop_series_of_phase(&s, &subject.crawler, SCALLOP_EXTENSION, subject.v0, 0, PRECISION, &why),
                   SCALLOP_EDOMAIN);
  assert_string_equal(why, "the order is outside of 1 to 1000");
  assert_int_equal(scallop_series_of_steady(&s, &subject.crawler, ORDER, 15, &why), SCALLOP_EDOMAIN);
  assert_string_equal(why, "fewer than 16 bits");
  assert_null(s);
  scallop_series_free(NULL);
}

/* A random crawler, with a v0 and values for t1, dT and x_switch */
struct point {
  struct scallop_crawler crawler;
  struct scallop_rational_crawler exact;
  enum scallop_phase_kind kind;
  double v0, given[3];
  fmpq_t start;
  arb_struct balls[3];
};
#define POINT(of) \
  of(scallop_rational, &s->exact) of(fmpq, s->start) of(arb, &s->balls[0]) of(arb, &s->balls[1]) of(arb, &s->balls[2])
SCOPED_PARTS(point, struct point, POINT)

static void draw_point(struct point *p, struct random *r, const struct scallop_gait *gait, enum scallop_phase_kind kind)
{
  p->crawler = random_crawler(r, ORDINARY, gait);
  p->kind = kind;
  p->v0 = random_between(r, -3, 3);
  scallop_rational_of(&p->exact, &p->crawler);
  scallop_rational_set_double(p->start, p->v0);
  for (int i = 0; i < 3; i++) {
    p->given[i] = random_between(r, 0, 0.5);
    arb_set_d(&p->balls[i], p->given[i]);
  }
}

static enum scallop_status value_at(arb_t value, const struct scallop_read_formula *read, const struct point *p,
                                    bool given, slong precision)
{
  return scallop_formula_ball(value, read, &p->exact, p->kind, p->start, given ? p->balls : NULL, precision);
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

/* The series is a number, as T is one. */
static void check_formula(const struct scallop_formula *f, const struct scallop_symbols *s, const struct point *p,
                          const struct scallop_values *values)
{
  const struct scallop_values as_read = scallop_formula_is_exchanged(f, p->kind) ? scallop_exchanged(values) : *values;
  const struct ring ring = { ORDER, PRECISION };
  SCOPED(series, value);
  SCOPED(arb, of_series, ball);
  char message[FORMULA_MESSAGE];
  struct scallop_read_formula *read = scallop_formula_read(f, message);
  assert_non_null(read);
  double got = scallop_formula_double(read, &p->crawler, p->kind, p->v0, p->given[0], p->given[1], p->given[2]);
  if (scallop_formula_expand(&value, f, s, p->kind, &ring, message))
    fail_msg("%s: %s", f->name, message);
  assert_int_equal(next_nonzero(&value, 1, ORDER), ORDER);
  series_coefficient(of_series, &value, 0, PRECISION);
  assert_int_equal(value_at(ball, read, p, true, PRECISION), SCALLOP_OK);
  double rounding = rounding_of(f, &as_read);
  if (!check_near(got, middle(of_series), rounding) || !check_near(got, middle(ball), rounding)
      || mag_cmp_2exp_si(arb_radref(ball), -PRECISION / 2) > 0)
    fail_msg("%s: %.17g in double, %.17g as a series, %.17g in balls, rounding %g", f->name, got, middle(of_series),
             middle(ball), rounding);
  scallop_formula_free(read);
}

static void set_symbol(struct scallop_symbols *s, int symbol, double value)
{
  SCOPED(fmpq, exact);
  scallop_rational_set_double(exact, value);
  series_set_rational(&s->value[symbol], exact);
}

/* In every setting that the point is of */
static void check_formulas(const struct point *p, bool steady)
{
  static const struct scallop_part parts[] = { { "mstar", "m1*m2/M*0.3" }, { NULL, NULL } };
  static const struct scallop_formula made_up[] = {
    { .name = "a", .setting = SCALLOP_AT_REST_START, .text = "exp(alpha)*sqrt(L) + mstar + 0.1", .parts = parts },
    { .name = "b", .setting = SCALLOP_MOVING_EXTENSION, .text = "M*L_kin*alpha + l0*T/(1 + v0^2) - lT*k0/l0^2" },
    { .name = "c", .setting = SCALLOP_MOVING_CONTRACTION, .text = "l_start + l_end*pi + t1*kT*dT/x_switch" },
    { .name = NULL }
  };
  const struct scallop_formula *const lists[] = { scallop_published, scallop_corrected, made_up };
  const struct ring ring = { ORDER, PRECISION };
  struct scallop_values values = steady ? scallop_steady_values(&p->crawler)
                                        : scallop_phase_values(&p->crawler, p->kind, p->v0);
  SCOPED(scallop_symbols, s);
  scallop_symbols_set(&s, &p->exact, p->kind, steady ? NULL : p->start, NULL, &ring);
  set_symbol(&s, SCALLOP_SYMBOL_T, steady ? p->crawler.T : scallop_phase_duration(&p->crawler, p->kind));
  for (int i = 0; i < 3 && !steady; i++) {
    set_symbol(&s, SCALLOP_SYMBOL_t1 + i, p->given[i]);
    values.of[SCALLOP_SYMBOL_t1 + i] = p->given[i];
  }
  for (int i = 0; i < 3; i++)
    for (const struct scallop_formula *f = lists[i]; f->name; f++)
      if ((f->setting == SCALLOP_STEADY) == steady
          && (f->setting != SCALLOP_MOVING_CONTRACTION || p->kind == SCALLOP_CONTRACTION))
        check_formula(f, &s, p, &values);
}

TEST(a_formula_is_the_same_number_in_double_as_a_series_and_in_balls)
{
  struct random r = { 20260851 };
  SCOPED(point, p);
  for (int i = 0; i < check_cases(300); i++) {
    draw_point(&p, &r, every_gait[i % WITH_SERIES_OF_PHASES], i / 3 % 3 == 1 ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION);
    check_formulas(&p, i / 3 % 3 == 2);
  }
}

/* k0 and kT in double, of laws of each kind */
TEST(fourth_derivatives)
{
  struct scallop_polynomial made[2];
  const char *why;
  const struct scallop_gait *of[] = { &scallop_gait_quadratic, &scallop_gait_sinusoidal,
                                      &trapezoid_gait,         &made[0].gait,
                                      &made[1].gait,           &leaning_gait };
  assert_int_equal(scallop_make_polynomial(&made[0], "a", (double[]){ 0, 0, 3, -2 }, 3, &why), SCALLOP_OK);
  assert_int_equal(scallop_make_polynomial(&made[1], "b", (double[]){ 0, 0, 0, 10, -15, 6 }, 5, &why), SCALLOP_OK);
  SCOPED(scallop_rational, exact);
  SCOPED(scallop_symbols, s);
  SCOPED(arb, k);
  const struct ring ring = { ORDER, PRECISION };
  fmpq_one(exact.L);
  for (size_t i = 0; i < 2 * sizeof of / sizeof *of; i++)
    for (int end = 0; end < 2; end++) {
      enum scallop_phase_kind kind = i % 2 ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION;
      exact.gait = of[i / 2];
      scallop_symbols_set(&s, &exact, kind, NULL, NULL, &ring);
      series_coefficient(k, &s.value[end ? SCALLOP_SYMBOL_kT : SCALLOP_SYMBOL_k0], 0, 128);
      double wanted = middle(k);
      CHECK_NEAR(scallop_fourth_derivative(&exact.gait->phase[kind], end), wanted,
                 8 * DBL_EPSILON * (fabs(wanted) + 1));
    }
  const struct scallop_piece lawless = { .end = 1, .direction = 1 };
  CHECK_EQUAL(scallop_fourth_derivative(&(struct scallop_shape){ .pieces = &lawless, .count = 1 }, true), NAN);
}

/* What has no value is not finite, and what is no crawler, or no formula, is refused. */
TEST(formulas_without_value)
{
  static const char *const texts[] = { "t1", "1 + dT", "x_switch*0", "L_kin", "1/(l_start*0)", "sqrt(-L)" };
  SCOPED(point, p);
  SCOPED(arb, value);
  struct random r = { 20261128 };
  draw_point(&p, &r, &minimum_jerk_gait, SCALLOP_EXTENSION);
  for (int i = 0; i < COUNT(texts); i++) {
    char message[SCALLOP_FORMULA_MESSAGE];
    char text[20];
    snprintf(text, sizeof text, "%s", texts[i]);
    const struct scallop_formula row = { .setting = SCALLOP_AT_REST_START, .text = text };
    struct scallop_read_formula *read = scallop_formula_read(&row, message);
    memset(text, '?', sizeof text); /* is kept by what was read */
    assert_int_equal(value_at(value, read, &p, false, PRECISION), SCALLOP_OK);
    assert_false(arb_is_finite(value));
    arb_set_si(value, 5);
    assert_int_equal(value_at(value, read, &p, false, 1), SCALLOP_EDOMAIN);
    fmpq *const fields[] = { p.exact.T, p.exact.m1 };
    for (int k = 0; k < 2; k++) {
      fmpq_neg(fields[k], fields[k]);
      assert_int_equal(value_at(value, read, &p, false, PRECISION), SCALLOP_EDOMAIN);
      fmpq_neg(fields[k], fields[k]);
    }
    assert_true(arb_equal_si(value, 5));
    scallop_formula_free(read);
  }
  const struct scallop_formula unknown = { .setting = SCALLOP_STEADY, .text = "L_kinematic + 1" };
  char message[FORMULA_MESSAGE];
  SCOPED(series, series);
  SCOPED(scallop_symbols, symbols);
  assert_non_null(scallop_formula_expand(&series, &unknown, &symbols, p.kind, &(const struct ring){ 1, 64 }, message));
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
