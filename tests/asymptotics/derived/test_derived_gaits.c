/* Derived expansions for gaits of other kinds: right, as the certified solver
 * has it, or refused. */
#include "asymptotics/derived/evaluate.h"
#include "tests/support/expansions.h"
#include "tests/support/odd_gaits.h"
#include "tests/support/solved.h"

enum { DIGITS = 40 };

struct subject {
  struct scallop_crawler doubles;
  struct scallop_rational_crawler exact;
  struct scallop_expansion phase;
  struct scallop_expansion steady;
  struct scallop_bound bounds[2];
  fmpq_t v0;
};

#define PARTS(of) \
  of(scallop_rational, &s->exact) of(scallop_expansion, &s->phase) of(scallop_expansion, &s->steady) \
      of(scallop_bound, &s->bounds[0]) of(scallop_bound, &s->bounds[1]) of(fmpq, s->v0)
SCOPED_PARTS(subject, struct subject, PARTS)

/* The default crawler at T = 1/1024 */
static void subject_set(struct subject *s, const struct scallop_gait *gait, double alpha)
{
  s->doubles = with_gait(gait);
  s->doubles.alpha = alpha;
  s->doubles.T = 0x1p-10;
  scallop_rational_of(&s->exact, &s->doubles);
}

#define SUBJECT(s, gait, alpha) \
  SCOPED(subject, s); \
  subject_set(&(s), gait, alpha)

/* The terms below x^ORDER are what they are of, up to about the next one. */
static void check_sum(const struct series *series, const fmpq_t x, const arb_t wanted, double size, const char *what)
{
  SCOPED(arb, at, value);
  arb_set_fmpq(at, x, PRECISION);
  series_value(value, series, at, ORDER, PRECISION);
  arb_sub(value, value, wanted, PRECISION);
  if (!(at_most(value) <= 1e-34 * size))
    fail_msg("%s: off by %g", what, at_most(value));
}

/* Crossings are found wherever they are, but those at an end that is not an
 * anchor are refused. */
TEST(one_piece)
{
  const char *why = NULL;
  SCOPED(scallop_certified_steady, c);
  for (int forward = 0; forward < 2; forward++) {
    SUBJECT(s, &parabola_gait, forward ? 0.75 : 0.25);
    assert_true(expand_steady(&s.steady, &s.exact, ORDER));
    assert_int_equal(scallop_certified_steady(&s.exact, DIGITS, &c, NULL), SCALLOP_OK);
    check_sum(&s.steady.v_start, s.exact.T, c.v_start, 1e4, "v_start");
    check_sum(&s.steady.displacement, s.exact.T, c.displacement, 1, "displacement");
  }
  SUBJECT(s, &parabola_gait, 0.5);
  assert_int_equal(scallop_expand_steady(&s.exact, 4, PRECISION, &s.steady, &why), SCALLOP_EDOMAIN);
  assert_non_null(strstr(why, "anchored elsewhere"));
  fmpq_set_si(s.v0, 1, 1);
  for (int kind = 0; kind < 2; kind++) {
    why = NULL;
    assert_int_equal(
        scallop_expand_phase(&s.exact, (enum scallop_phase_kind)kind, s.v0, 4, PRECISION, NULL, &s.phase, &why),
        SCALLOP_EDOMAIN);
    assert_non_null(strstr(why, "anchored elsewhere"));
  }
}

/* Each phase of a mixed gait is symmetric about its middle, but they are not
 * mirror images of each other: the displacement has no T^2 but at alpha = 1/2.
 */
TEST(phases_of_two_kinds)
{
  const struct scallop_gait mixed[] = { mixed_gait(&scallop_gait_quadratic, &scallop_gait_sinusoidal),
                                        mixed_gait(&scallop_gait_sinusoidal, &scallop_gait_quadratic) };
  SCOPED(scallop_certified_steady, c);
  for (int i = 0; i < 2; i++)
    for (int quarters = 1; quarters <= 3; quarters++) {
      SCOPED(arb, second);
      SUBJECT(s, &mixed[i], 0.25 * quarters);
      assert_true(expand_steady(&s.steady, &s.exact, ORDER));
      assert_int_equal(scallop_certified_steady(&s.exact, DIGITS, &c, NULL), SCALLOP_OK);
      check_sum(&s.steady.v_start, s.exact.T, c.v_start, 1e4, "v_start");
      check_sum(&s.steady.v_mid, s.exact.T, c.v_mid, 1e4, "v_mid");
      check_sum(&s.steady.displacement, s.exact.T, c.displacement, 1, "displacement");
      series_coefficient(second, &s.steady.displacement, 2, PRECISION);
      assert_int_equal(arb_is_zero(second), quarters != 2);
    }
}

/* By all three, with a reason, and the outputs as they were */
static void refuses(const struct scallop_gait *gait, double alpha, const char *fragment)
{
  const char *why[3] = { NULL, NULL, NULL };
  SUBJECT(s, gait, alpha);
  series_set_si(&s.phase.dxC, 7);
  series_set_si(&s.steady.displacement, 7);
  s.bounds[1].power = 7;
  for (int pass = 0; pass < 2; pass++) {
    assert_int_equal(
        scallop_expand_phase(&s.exact, SCALLOP_EXTENSION, s.v0, 4, PRECISION, NULL, &s.phase, pass ? NULL : &why[0]),
        SCALLOP_EDOMAIN);
    assert_int_equal(scallop_expand_steady(&s.exact, 4, PRECISION, &s.steady, pass ? NULL : &why[1]), SCALLOP_EDOMAIN);
    assert_int_equal(scallop_steady_bounds(&s.exact, 4, PRECISION, s.bounds, pass ? NULL : &why[2]), SCALLOP_EDOMAIN);
  }
  for (int i = 0; i < 3; i++) {
    assert_non_null(why[i]);
    if (!strstr(why[i], fragment))
      fail_msg("%s: %s", gait->name, why[i]);
  }
  const struct series *const kept[] = { &s.phase.dxC, &s.steady.displacement };
  SCOPED(fmpq, seven);
  for (int i = 0; i < 2; i++)
    assert_true(series_rational_coefficient(seven, kept[i], 0) && fmpq_equal_si(seven, 7));
  assert_int_equal(s.bounds[1].power, 7);
}

TEST(gaits_without_a_branch)
{
  struct teeth teeth;
  grow_teeth(&teeth);
  const struct scallop_gait backward = { "backward",
                                         { scallop_gait_quadratic.phase[1], scallop_gait_quadratic.phase[0] } };
  /* l' falls to 0 and jumps away from there, or jumps to 0 */
  static const struct scallop_piece to_0[] = { RUN(0, 0.5, 1, 2, -4), STRIDE(0.5, 1, 1) };
  static const struct scallop_piece from_0[] = { STRIDE(0, 0.5, 1), RUN(0.5, 1, 1, -2, 4) };
  struct scallop_gait falls = trapezoid_gait, rises = trapezoid_gait;
  falls.phase[0].pieces = to_0;
  rises.phase[0].pieces = from_0;
  falls.phase[0].count = rises.phase[0].count = 2;
  for (int halves = 0; halves < 2; halves++) {
    double alpha = halves ? 0.5 : 0.75;
    refuses(&falls, alpha, "within a phase");
    refuses(&rises, alpha, "within a phase");
    refuses(&there_and_back_gait, alpha, "within a phase");
    refuses(&detour_gait, alpha, "within a phase");
    refuses(&teeth.gait, alpha, "within a phase");
    refuses(&backward, alpha, "within a phase");
  }
}

/* One phase, or one piece of it, without a law is enough. */
TEST(gaits_without_a_law)
{
  struct scallop_piece lawless[2][2];
  for (int kind = 0; kind < 2; kind++)
    for (int piece = 0; piece < 2; piece++) {
      struct scallop_gait gait = scallop_gait_sinusoidal;
      memcpy(lawless[kind], gait.phase[kind].pieces, sizeof lawless[kind]);
      gait.phase[kind].pieces = lawless[kind];
      assert_true(scallop_gait_is_exact(&gait) && !scallop_gait_is_rational(&gait));
      lawless[kind][piece].law = NULL;
      assert_true(!scallop_gait_is_exact(&gait) && !scallop_gait_is_rational(&gait));
      refuses(&gait, 0.75, "no exact law");
    }
}

/* A sine has exact coefficients at its zero only, and does not go on as a polynomial nor the other way round. */
TEST(sines_and_polynomials)
{
  const struct scallop_piece *sine = scallop_gait_sinusoidal.phase[0].pieces,
                             *ramp = scallop_gait_quadratic.phase[0].pieces;
  bool turned;
  SCOPED(fmpq_poly, series);
  SCOPED(fmpq, u, ten);
  fmpq_set_si(ten, 10, 1);
  assert_true(scallop_piece_continues(&sine[0], &sine[1], &turned) && turned);
  assert_false(scallop_piece_continues(&sine[0], &ramp[1], &turned));
  assert_false(scallop_piece_continues(&ramp[0], &sine[1], &turned));
  assert_true(scallop_rational_speed_series(series, &sine[0], u, 4, ten));
  assert_int_equal(fmpq_poly_degree(series), 3);
  assert_false(scallop_rational_speed_series(series, &sine[0], u, 4, NULL));
  fmpq_set_si(u, 1, 4);
  assert_false(scallop_rational_speed_series(series, &sine[0], u, 4, ten));
  assert_true(scallop_rational_speed_series(series, &ramp[0], u, 4, NULL));
}

TEST(quantities)
{
  SUBJECT(s, &scallop_gait_quadratic, 0.75);
  for (int q = 0; q < SCALLOP_QUANTITIES; q++)
    assert_null(scallop_expansion_of(&s.phase, (enum scallop_quantity)q));
  for (int kind = 0; kind < 2; kind++) {
    assert_int_equal(
        scallop_expand_phase(&s.exact, (enum scallop_phase_kind)kind, s.v0, 4, PRECISION, NULL, &s.phase, NULL),
        SCALLOP_OK);
    const struct series *rear = scallop_expansion_of(&s.phase, SCALLOP_REAR_AT_END),
                        *front = scallop_expansion_of(&s.phase, SCALLOP_FRONT_AT_END);
    check_equal(rear, kind == 0 ? &s.phase.dx1 : &s.phase.dx2, 1, 4, "rear");
    check_equal(front, kind == 0 ? &s.phase.dx2 : &s.phase.dx1, 1, 4, "front");
    for (int q = 0; q < SCALLOP_QUANTITIES; q++)
      assert_int_equal(scallop_expansion_of(&s.phase, (enum scallop_quantity)q) != NULL, q < SCALLOP_STEADY_VELOCITY);
  }
  assert_int_equal(scallop_expand_steady(&s.exact, 4, PRECISION, &s.steady, NULL), SCALLOP_OK);
  for (int q = 0; q < SCALLOP_QUANTITIES; q++)
    assert_int_equal(scallop_expansion_of(&s.steady, (enum scallop_quantity)q) != NULL, q >= SCALLOP_STEADY_VELOCITY);
  assert_ptr_equal(scallop_expansion_of(&s.steady, SCALLOP_STEADY_DISPLACEMENT), &s.steady.displacement);
}

/* Where l'' = 0 at both ends of a phase the kinematic length is 0/0 and does not exist. A name that the paper does not
 * have has no value. */
TEST(symbols)
{
  const struct ring ring = { 3, PRECISION };
  struct scallop_formula formula = { .name = "made up", .setting = SCALLOP_STEADY, .text = "L_kin + 1" };
  SCOPED(fmpq, x);
  SCOPED(series, value);
  SCOPED(scallop_symbols, symbols);
  for (int curved = 0; curved < 2; curved++) {
    SUBJECT(s, curved ? &minimum_jerk_gait : &scallop_gait_quadratic, 0.75);
    scallop_symbols_set(&symbols, &s.exact, SCALLOP_EXTENSION, NULL, NULL, &ring);
    char message[FORMULA_MESSAGE];
    const char *wrong = scallop_formula_expand(&value, &formula, &symbols, SCALLOP_EXTENSION, &ring, message);
    if (curved)
      assert_string_equal(wrong, "character 1: L_kin does not exist for this motion");
    else {
      assert_null(wrong);
      assert_true(series_rational_coefficient(x, &value, 0));
      CHECK_EQUAL(fmpq_get_d(x), s.doubles.L + 1);
    }
  }
  formula.text = "L_kinematic + 1";
  char message[FORMULA_MESSAGE];
  assert_non_null(scallop_formula_expand(&value, &formula, &symbols, SCALLOP_EXTENSION, &ring, message));
}
