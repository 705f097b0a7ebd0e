/* The certified solver against 50-digit values of a third program, and against itself with more digits. Against the
 * other solvers: test_agree.c. */
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
