/* The certified solver against 50-digit values of a third program, against itself with more digits, and against laws of
 * motion that it does not use. Against the other solvers: test_agree.c. */
#include "tests/support/agree.h"
#include "tests/support/reference.h"

enum { REFERENCE_DIGITS = 45 };

static void check_digits(const arb_t x, long digits, const char *what)
{
  if (!arb_contains_zero(x) && (double)arb_rel_accuracy_bits(x) < 3.3219 * (double)digits)
    fail_msg("%s: %ld bits, not %ld digits", what, (long)arb_rel_accuracy_bits(x), digits);
}

/* The text has 50 digits: half a unit of the last one, and what counts as 0 there, is left to it. */
static void check_reference(const arb_t ball, const char *text, double unit)
{
  SCOPED(arb, wanted);
  assert_int_equal(arb_set_str(wanted, text, 400), 0);
  check_digits(ball, REFERENCE_DIGITS, text);
  CHECK_NEAR(apart(ball, wanted), 0, 1e-44 * fabs(middle(wanted)) + 1e-60 * unit);
}

static void check_reference_row(const struct row *r)
{
  static const enum quantity_id in_table[] = { Q_V_START, Q_V_MID, Q_DISPLACEMENT, Q_T1, Q_DT, Q_V_END, Q_DXC };
  static const char *const inputs[] = { "m1", "m2", "F1", "F2", "L", "T", "alpha", "v0" };
  char modes[MOTION_MODES_TEXT];
  SCOPED(scallop_rational, c);
  SCOPED(ball_answer, a);
  SCOPED(fmpq, v0);
  fmpq *const to[] = { c.m1, c.m2, c.F1, c.F2, c.L, c.T, c.alpha, v0 };
  bool steady = of_steady_state(r);
  enum quantity_of of = steady ? OF_STEADY : OF_PHASE;
  for (int i = 0; i < (steady ? 7 : 8); i++)
    assert_true(scallop_rational_parse(to[i], cell(r, "", inputs[i])));
  c.gait = scallop_gait_named(cell(r, "", "gait"));
  assert_true(answer_in_balls(&a, &c, of, steady ? 0 : phase_in(r), v0, REFERENCE_DIGITS));
  double unit = number_in(r, "", "L") * (1 + 1 / number_in(r, "", "T"));
  for (size_t i = 0; i < sizeof in_table / sizeof *in_table; i++) {
    const arb_struct *value = a.value[in_table[i]];
    if (value)
      check_reference(value, cell(r, "", quantity_rows[in_table[i]].name), unit);
    else
      assert_true(quantity_rows[in_table[i]].of != of || strcmp(cell(r, "", "t1"), "nan") == 0);
  }
  assert_string_equal(motion_modes_text(modes, of, a.modes), cell(r, "", "modes"));
}

TEST(every_reference_row) { for_reference_rows(check_reference_row); }

/* With more digits, the same; and as many as were wanted. */
static void check_longer(const struct motion *m, long digits, long more)
{
  SCOPED(ball_answer, few, many);
  assert_true(answer_of_doubles(&few, m, digits) && answer_of_doubles(&many, m, more));
  for (int q = quantity_first(m->of); q < (int)quantity_end(m->of); q++)
    if (few.value[q] && many.value[q]) {
      check_overlap(few.value[q], many.value[q], quantity_rows[q].name);
      if (m->of == OF_STEADY)
        check_digits(few.value[q], digits, quantity_rows[q].name);
      check_digits(many.value[q], more, quantity_rows[q].name);
    }
}

TEST(more_digits_agree)
{
  struct random r = { 20260703 };
  for (int i = 0; i < 20 * SMOOTH_GAITS; i++) {
    struct scallop_crawler c = random_crawler(&r, (enum family)(i / SMOOTH_GAITS % FAMILIES),
                                              every_gait[i % SMOOTH_GAITS]);
    const struct motion both[2] = { steady_motion(&c),
                                    phase_motion(&c, SCALLOP_CONTRACTION, random_start(&r, &c, SCALLOP_CONTRACTION)) };
    for (int k = 0; k < 2; k++)
      check_longer(&both[k], 30, 300);
  }
}

/* A thousand digits where a double has none: T = 1e-30. The displacement of the default crawler tends to (F1 - F2)(2
 * alpha - 1) L m / (alpha^2 F1 m1 + (1 - alpha)^2 F2 m2), m = m1 m2/M, with an error of order T^4: 120/37. */
TEST(a_thousand_digits_of_a_small_period)
{
  struct scallop_crawler c = with_gait(&scallop_gait_sinusoidal);
  SCOPED(scallop_certified_steady, s);
  SCOPED(arb, limit);
  c.T = 1e-30;
  for (int g = 1; g >= 0; g--) {
    c.gait = every_gait[g];
    const struct motion m = steady_motion(&c);
    check_longer(&m, 1000, 1100);
  }
  certify_steady(&s, &c, 1000);
  arb_set_ui(limit, 120);
  arb_div_ui(limit, limit, 37, 4000);
  CHECK_NEAR(apart(s.displacement, limit), 0, 10 * 1e-119);
  assert_false(arb_overlaps(s.displacement, limit));
}

/* dx2 - dx1 = +-L; dxC is their mean; d v_end / d v0 is what a change of v0 by 1e-40 makes of it. True: slid through
 * three modes */
static bool check_laws(const struct scallop_crawler *doubles, enum scallop_phase_kind kind, double v0)
{
  SCOPED(arb, x, y);
  SCOPED(fmpq, start, change);
  SCOPED(scallop_rational, c);
  SCOPED(scallop_certified_phase, p, moved);
  scallop_rational_of(&c, doubles);
  scallop_rational_set_double(start, v0);
  assert_int_equal(scallop_certified_phase(&c, kind, start, 80, &p, NULL), SCALLOP_OK);
  arb_sub(x, p.dx2, p.dx1, 400);
  arb_set_fmpq(y, c.L, 400);
  arb_mul_si(y, y, kind == SCALLOP_EXTENSION ? 1 : -1, 400);
  check_overlap(x, y, "dx2 - dx1");
  arb_add(x, p.dx2, p.dx1, 400);
  arb_mul_2exp_si(y, p.dxC, 1);
  check_overlap(x, y, "dxC");
  assert_true(scallop_rational_parse(change, "1e-40"));
  fmpq_add(start, start, change);
  if (scallop_certified_phase(&c, kind, start, 80, &moved, NULL) == SCALLOP_OK
      && (v0 == 0 || modes_alike(&p.modes, &moved.modes))) {
    arb_sub(x, moved.v_end, p.v_end, 400);
    arb_set_fmpq(y, change, 400);
    arb_div(x, x, y, 400);
    CHECK_NEAR(apart(x, p.multiplier), 0, 1e-10);
  }
  return p.regime == SCALLOP_SLIDING && p.modes.count == 3;
}

TEST(phases_obey_laws)
{
  struct random r = { 20260704 };
  int slid = 0;
  for (int i = 0; i < 60 * SMOOTH_GAITS; i++) {
    struct scallop_crawler c = random_crawler(&r, i % 2 ? ORDINARY : STICK_SLIP, every_gait[i % SMOOTH_GAITS]);
    enum scallop_phase_kind kind = i / SMOOTH_GAITS % 2 ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
    slid += check_laws(&c, kind, random_start(&r, &c, kind));
  }
  assert_true(slid > 30);
}

/* Where the rear body, 1 of an extension, is at the first and at the last change of mode, whether it turns then or body
 * 2 does: in the quadratic gait l = 2 L (t/tau)^2 at both ends, where both bodies go the same way. */
TEST(turning_places)
{
  static const struct {
    double F1, v0;
    const char *modes;
    int first, last; /* the way that both go; 0: they do not */
  } phases[] = { { 4, 3, "++ -+ ++", 1, 1 }, { 4, 0, "-+ ++", 0, 1 }, { 0.7, 0, "-+ --", 0, -1 } };
  for (int i = 0; i < 3; i++) {
    const struct scallop_crawler c = { 1.3, 0.8, phases[i].F1, 1.9, 3, 1.1, 0.6, &scallop_gait_quadratic };
    const struct motion m = phase_motion(&c, SCALLOP_EXTENSION, phases[i].v0);
    double tau = c.alpha * c.T, M = c.m1 + c.m2, slowing = (c.F1 + c.F2) / M / 2,
           way = c.m2 / M * 2 * c.L / (tau * tau);
    struct answer a;
    SCOPED(scallop_certified_phase, p);
    certify_phase(&p, &c, SCALLOP_EXTENSION, m.v0, 20);
    modes_are(&p.modes, phases[i].modes);
    assert_true(answer_in_double(&a, &m) && answer_complete(&a, &m) >= 0);
    double t1 = middle(p.t1), dT = middle(p.dT), first = m.v0 * t1 - (phases[i].first * slowing + way) * t1 * t1;
    double last = middle(p.dx1) - (middle(p.v_end) + phases[i].last * slowing * dT - way * dT) * dT;
    CHECK_RELATIVE(middle(p.at_first), phases[i].first ? first : last, 1e-13);
    CHECK_RELATIVE(a.value[Q_AT_FIRST].high, middle(p.at_first), 1e-13);
    CHECK_RELATIVE(middle(p.at_last), last, 1e-13);
    CHECK_RELATIVE(a.value[Q_AT_LAST].high, middle(p.at_last), 1e-13);
  }
}

/* A period that is its own mirror image, half of it late, leads nowhere: whatever the masses and the forces. */
TEST(mirrored_periods_lead_nowhere)
{
  struct random r = { 20260705 };
  SCOPED(scallop_rational, exact);
  SCOPED(scallop_certified_steady, s);
  for (int i = 0; i < 5 * SMOOTH_GAITS; i++) {
    struct scallop_crawler c = random_crawler(&r, i % 2 ? ORDINARY : STICK_SLIP, every_gait[i % SMOOTH_GAITS]);
    c.alpha = 0.5;
    scallop_rational_of(&exact, &c);
    assert_int_equal(scallop_certified_steady(&exact, 30, &s, NULL), SCALLOP_OK);
    assert_true(arb_is_zero(s.displacement) && arb_is_zero(s.mean_velocity));
    arb_neg(s.v_mid, s.v_mid);
    assert_true(arb_overlaps(s.v_start, s.v_mid));
    assert_true(fmpq_set_str(exact.alpha, "499999999999/1000000000000", 10) == 0);
    assert_int_equal(scallop_certified_steady(&exact, 30, &s, NULL), SCALLOP_OK);
    assert_true(arb_is_zero(s.displacement) == (s.regime == SCALLOP_AT_REST));
  }
}
