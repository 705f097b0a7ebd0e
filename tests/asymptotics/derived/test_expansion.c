/* The public face of the derived series and of formulas in balls, against the series inside and against values in
 * double. */
#include <stdio.h>

#include "asymptotics/derived/evaluate.h"
#include "asymptotics/derived/expansion.h"
#include "tests/support/expansions.h"

enum { MANY = 12 };

static void end_series(struct scallop_series **series) { scallop_series_free(*series); }

/* The coefficient of a quantity by the face, beside the one of the series inside: the fraction, where there is one, and
 * the ball */
static void check_coefficient(const struct scallop_series *s, enum scallop_quantity quantity,
                              const struct series *inside, slong power)
{
  SCOPED(fmpq, got, wanted);
  SCOPED(arb, ball, exact);
  bool is_fraction = series_rational_coefficient(wanted, inside, power);
  assert_int_equal(scallop_series_rational(got, s, quantity, power), is_fraction);
  assert_true(!is_fraction || fmpq_equal(got, wanted));
  assert_true(scallop_series_ball(ball, s, quantity, power));
  series_coefficient(exact, inside, power, PRECISION);
  assert_true(arb_equal(ball, exact));
}

static void check_quantity(const struct scallop_series *s, enum scallop_quantity quantity, const struct series *inside)
{
  slong first = scallop_series_first(s, quantity);
  assert_true(first >= inside->first && inside->known >= ORDER);
  for (slong k = -3; k < ORDER; k++) {
    check_coefficient(s, quantity, inside, k);
    assert_true(k >= first || series_coefficient_is_zero(inside, k));
  }
  assert_true(first == ORDER || !series_coefficient_is_zero(inside, first));
}

/* Nothing is said, and nothing changed, of what the motion does not have, and beyond the order. */
static void check_nothing(const struct scallop_series *s, enum scallop_quantity quantity, slong power)
{
  SCOPED(fmpq, fraction);
  SCOPED(arb, ball);
  fmpq_set_si(fraction, 22, 7);
  arb_set_si(ball, 3);
  assert_false(scallop_series_rational(fraction, s, quantity, power) || scallop_series_ball(ball, s, quantity, power));
  assert_true(fmpq_equal_si(fraction, 22) == 0 && arb_equal_si(ball, 3));
  fmpq_sub_si(fraction, fraction, 3);
  assert_int_equal(fmpz_get_si(fmpq_denref(fraction)), 7);
}

static const enum scallop_quantity of_phases[] = { SCALLOP_LAG,           SCALLOP_FIRST_SWITCH,   SCALLOP_REAR_AT_FIRST,
                                                   SCALLOP_REAR_AT_LAST,  SCALLOP_REAR_AT_END,    SCALLOP_FRONT_AT_END,
                                                   SCALLOP_CENTRE_AT_END, SCALLOP_VELOCITY_AT_END };
static const enum scallop_quantity of_steady[] = { SCALLOP_STEADY_VELOCITY, SCALLOP_STEADY_V_MID,
                                                   SCALLOP_STEADY_DISPLACEMENT, SCALLOP_STEADY_MEAN_VELOCITY,
                                                   SCALLOP_STEADY_FRICTION_WORK };
#define COUNT(list) (int)(sizeof(list) / sizeof *(list))

TEST(phases)
{
  struct random r = { 20261123 };
  for (int i = 0; i < check_cases(MANY); i++) {
    SCOPED(pair, p);
    draw(&p, &r, gaits[i % WITH_SERIES_OF_PHASES]);
    enum scallop_phase_kind kind = random_below(&r, 2) ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION;
    bool is_extension = kind == SCALLOP_EXTENSION;
    const struct scallop_expansion *e = &p.phase[0];
    const struct series *const inside[] = { &e->dT,
                                            &e->t1,
                                            &e->rear_at_first,
                                            &e->rear_at_last,
                                            is_extension ? &e->dx1 : &e->dx2,
                                            is_extension ? &e->dx2 : &e->dx1,
                                            &e->dxC,
                                            &e->v_end };
    ENDED_BY(end_series) struct scallop_series *s = NULL;
    assert_true(expand_phase(&p.phase[0], &p.crawler[0], (int)kind, p.v0[0], ORDER));
    assert_int_equal(scallop_series_of_phase(&s, &p.crawler[0], kind, p.v0[0], ORDER, PRECISION, NULL), SCALLOP_OK);
    assert_string_equal(scallop_series_modes(s), e->modes);
    assert_true(e->switches);
    for (int q = 0; q < COUNT(of_phases); q++) {
      check_quantity(s, of_phases[q], inside[q]);
      check_nothing(s, of_phases[q], ORDER);
    }
    for (int q = 0; q < COUNT(of_steady); q++)
      check_nothing(s, of_steady[q], 1);
  }
}

/* v_change is v_end without the v0 that v_end begins with; the velocity of the body that turns is 0. */
TEST(velocities)
{
  struct random r = { 20261124 };
  for (int i = 0; i < check_cases(MANY); i++) {
    SCOPED(pair, p);
    SCOPED(fmpq, start, end, change);
    draw(&p, &r, gaits[i % WITH_SERIES_OF_PHASES]);
    ENDED_BY(end_series) struct scallop_series *s = NULL;
    assert_int_equal(scallop_series_of_phase(&s, &p.crawler[0], SCALLOP_CONTRACTION, p.v0[0], ORDER, PRECISION, NULL),
                     SCALLOP_OK);
    SCOPED(arb, begin);
    assert_true(scallop_series_ball(begin, s, SCALLOP_VELOCITY_AT_END, 0) && arb_contains_fmpq(begin, p.v0[0]));
    assert_true(i % WITH_SERIES_OF_PHASES == 1
                || (scallop_series_rational(start, s, SCALLOP_VELOCITY_AT_END, 0) && fmpq_equal(start, p.v0[0])));
    for (slong k = 0; k < ORDER; k++) {
      SCOPED(arb, of_end, of_change);
      assert_true(scallop_series_ball(of_end, s, SCALLOP_VELOCITY_AT_END, k));
      assert_true(scallop_series_ball(of_change, s, SCALLOP_VELOCITY_CHANGE, k));
      assert_true(k == 0 ? arb_is_zero(of_change) : arb_equal(of_change, of_end));
      bool is_fraction = scallop_series_rational(end, s, SCALLOP_VELOCITY_AT_END, k);
      assert_int_equal(scallop_series_rational(change, s, SCALLOP_VELOCITY_CHANGE, k), is_fraction || k == 0);
      assert_true(k == 0 ? fmpq_is_zero(change) : !is_fraction || fmpq_equal(change, end));
    }
    assert_true(scallop_series_first(s, SCALLOP_VELOCITY_CHANGE) >= 1);
    assert_int_equal(scallop_series_first(s, SCALLOP_VELOCITY_AT_FIRST), ORDER);
    assert_int_equal(scallop_series_first(s, SCALLOP_STEADY_VELOCITY), ORDER);
  }
}

TEST(steady_states)
{
  struct random r = { 20261125 };
  for (int i = 0; i < check_cases(MANY); i++) {
    SCOPED(pair, p);
    draw(&p, &r, gaits[i % WITH_SERIES_OF_PHASES]);
    const struct scallop_expansion *e = &p.steady[0];
    const struct series *const inside[] = { &e->v_start, &e->v_mid, &e->displacement, &e->mean_velocity,
                                            &e->friction_work };
    ENDED_BY(end_series) struct scallop_series *s = NULL;
    if (!expand_steady(&p.steady[0], &p.crawler[0], ORDER))
      continue;
    assert_int_equal(scallop_series_of_steady(&s, &p.crawler[0], ORDER, PRECISION, NULL), SCALLOP_OK);
    assert_string_equal(scallop_series_modes(s), e->modes);
    for (int q = 0; q < COUNT(of_steady); q++) {
      check_quantity(s, of_steady[q], inside[q]);
      check_nothing(s, of_steady[q], ORDER + 1);
    }
    for (int q = 0; q < COUNT(of_phases); q++)
      check_nothing(s, of_phases[q], 1);
  }
}

/* Equal forces and masses from rest: the centre of mass rests, and no body turns. */
TEST(a_phase_without_switches)
{
  SCOPED(scallop_rational, c);
  SCOPED(fmpq, v0);
  ENDED_BY(end_series) struct scallop_series *s = NULL;
  const struct scallop_crawler equal = { 1, 1, 2, 2, 10, 1, 0.5, &scallop_gait_quadratic };
  scallop_rational_of(&c, &equal);
  assert_int_equal(scallop_series_of_phase(&s, &c, SCALLOP_EXTENSION, v0, ORDER, PRECISION, NULL), SCALLOP_OK);
  assert_string_equal(scallop_series_modes(s), "-+");
  static const enum scallop_quantity of_switches[] = {
    SCALLOP_LAG,          SCALLOP_FIRST_SWITCH,      SCALLOP_REAR_AT_FIRST,
    SCALLOP_REAR_AT_LAST, SCALLOP_VELOCITY_AT_FIRST, SCALLOP_VELOCITY_AT_LAST
  };
  for (int q = 0; q < COUNT(of_switches); q++)
    check_nothing(s, of_switches[q], 1);
  assert_int_equal(scallop_series_first(s, SCALLOP_LAG), ORDER);
  assert_int_equal(scallop_series_first(s, SCALLOP_REAR_AT_END), 0);
}

TEST(refusals)
{
  SCOPED(scallop_rational, c);
  SCOPED(fmpq, v0);
  struct scallop_crawler crawler = scallop_crawler_default();
  struct scallop_series *s = NULL;
  const char *why = NULL;
  scallop_rational_of(&c, &crawler);
  assert_int_equal(scallop_series_of_phase(&s, &c, SCALLOP_EXTENSION, v0, 0, PRECISION, &why), SCALLOP_EDOMAIN);
  assert_string_equal(why, "the order is outside of 1 to 1000");
  assert_int_equal(scallop_series_of_steady(&s, &c, ORDER, 15, &why), SCALLOP_EDOMAIN);
  assert_string_equal(why, "fewer than 16 bits");
  c.gait = &minimum_jerk_gait;
  assert_int_equal(scallop_series_of_phase(&s, &c, SCALLOP_EXTENSION, v0, ORDER, PRECISION, &why), SCALLOP_EDOMAIN);
  assert_null(s);
  scallop_series_free(NULL);
}

/* A random crawler, with a v0 and values for what is given */
struct point {
  struct scallop_crawler crawler;
  struct scallop_rational_crawler exact;
  enum scallop_phase_kind kind;
  double v0, given[3];
  fmpq_t start;
  arb_ptr balls;
};
static void point_init(struct point *p)
{
  scallop_rational_init(&p->exact);
  fmpq_init(p->start);
  p->balls = _arb_vec_init(3);
}
static void point_clear(struct point *p)
{
  scallop_rational_clear(&p->exact);
  fmpq_clear(p->start);
  _arb_vec_clear(p->balls, 3);
}
SCOPED_KIND(point, struct point)

static void draw_point(struct point *p, struct random *r, const struct scallop_gait *gait)
{
  double *const sizes[] = {
    &p->crawler.m1, &p->crawler.m2, &p->crawler.F1, &p->crawler.F2, &p->crawler.L, &p->crawler.T
  };
  for (int i = 0; i < 6; i++)
    *sizes[i] = random_decades(r, 0.1, 10);
  p->crawler.alpha = random_between(r, 0.1, 0.9);
  p->crawler.gait = gait;
  p->kind = random_below(r, 2) ? SCALLOP_CONTRACTION : SCALLOP_EXTENSION;
  p->v0 = random_between(r, -3, 3);
  scallop_rational_of(&p->exact, &p->crawler);
  scallop_rational_set_double(p->start, p->v0);
  for (int i = 0; i < 3; i++) {
    p->given[i] = random_between(r, 0, 1);
    arb_set_d(p->balls + i, p->given[i]);
  }
}

/* In every setting, with numbers that are no doubles, from a text that is gone. Both sides round at most 24 times on
 * the way to a term. */
TEST(formulas_of_products)
{
  static const char *const texts[] = {
    "m1*F2/(m2*F1)*L*T^2", "M*L_kin*alpha",    "l0*T/(1 + v0^2)", "-lT/k0^2",           "exp(alpha)*sqrt(L)",
    "l_start + l_end*pi",  "kT*log10(10 + T)", "t1*dT/x_switch",  "max(F1, F2, L)^0.5", "mstar + 0.1"
  };
  static const struct scallop_part parts[] = { { "mstar", "m1*m2/M*0.3" }, { NULL, NULL } };
  struct random r = { 20261126 };
  for (int i = 0; i < check_cases(4) * COUNT(texts) * 3; i++) {
    char text[40], message[SCALLOP_FORMULA_MESSAGE];
    snprintf(text, sizeof text, "%s", texts[i % COUNT(texts)]);
    const struct scallop_formula row = { .setting = (enum scallop_setting)(i / COUNT(texts) % 3),
                                         .text = text,
                                         .parts = parts };
    struct scallop_read_formula *read = scallop_formula_read(&row, message);
    assert_non_null(read);
    memset(text, '?', sizeof text);
    SCOPED(point, p);
    SCOPED(arb, value);
    draw_point(&p, &r, &scallop_gait_sinusoidal);
    double wanted = scallop_formula_double(read, &p.crawler, p.kind, p.v0, p.given[0], p.given[1], p.given[2]);
    assert_int_equal(scallop_formula_ball(value, read, &p.exact, p.kind, p.start, p.balls, PRECISION), SCALLOP_OK);
    CHECK_RELATIVE(middle(value), wanted, 24 * 0x1p-53);
    assert_true(arb_rel_accuracy_bits(value) > PRECISION - 40);
    scallop_formula_free(read);
  }
}

/* What has no value is not finite, and what is no crawler is refused. */
TEST(formulas_without_value)
{
  static const char *const texts[] = { "t1", "1 + dT", "x_switch*0", "L_kin", "1/(l_start*0)", "sqrt(-L)" };
  SCOPED(point, p);
  SCOPED(arb, value);
  struct random r = { 20261128 };
  draw_point(&p, &r, &minimum_jerk_gait);
  for (int i = 0; i < COUNT(texts); i++) {
    char message[SCALLOP_FORMULA_MESSAGE];
    const struct scallop_formula row = { .setting = SCALLOP_AT_REST_START, .text = texts[i] };
    struct scallop_read_formula *read = scallop_formula_read(&row, message);
    assert_int_equal(scallop_formula_ball(value, read, &p.exact, p.kind, p.start, NULL, PRECISION), SCALLOP_OK);
    assert_false(arb_is_finite(value));
    arb_set_si(value, 5);
    assert_int_equal(scallop_formula_ball(value, read, &p.exact, p.kind, p.start, NULL, 1), SCALLOP_EDOMAIN);
    fmpq_neg(p.exact.T, p.exact.T);
    assert_int_equal(scallop_formula_ball(value, read, &p.exact, p.kind, p.start, NULL, PRECISION), SCALLOP_EDOMAIN);
    fmpq_neg(p.exact.T, p.exact.T);
    fmpq_neg(p.exact.m1, p.exact.m1);
    assert_int_equal(scallop_formula_ball(value, read, &p.exact, p.kind, p.start, NULL, PRECISION), SCALLOP_EDOMAIN);
    fmpq_neg(p.exact.m1, p.exact.m1);
    assert_true(arb_equal_si(value, 5));
    scallop_formula_free(read);
  }
}
