/* The certified solver at the edges: what it refuses, what it says that it cannot decide, and what must be exact. */
#include "tests/support/certified_balls.h"
#include "tests/support/odd_gaits.h"

/* m1 = m2 = 1, tau = 1, L = 1 in all: exact coincidences are said. While both go forward v1 = v0 - (F1 + F2) t/2 -
 * l'/2. */
static const struct undecided {
  double F1, F2;
  const struct scallop_gait *gait;
  const char *v0, *why;
} undecided[] = {
  { 2, 1, &parabola_gait, "1.6875", "body 1 touches" }, /* v0 - 3 t/2 - 3 t (1 - t): 0 and least at t = 3/4 */
  /* v0 - 3 t/4 - 2 t until t = 1/2, where it is 0 */
  { 1, 0.5, &scallop_gait_quadratic, "1.375", "body 1 comes to rest just as" },
  { 7, 1, &parabola_gait, "0", "force that holds body 1" }, /* m2 l'' = 6 = F1 - F2 at the start, and falls */
  { 1, 7, &parabola_gait, "0", "force that holds body 2" },
  /* With l' to its digits the limit can be met within a phase as well: minimum jerk at t = 1/4, where l' = 135/128 and
   * l'' = 45/8. Body 1 comes to rest there, v0 - l'/2 - (F1 + F2) t/2 = 0, and F1 - F2 = 45/8 is what it takes to hold
   * it. */
  { 6, 0.375, &minimum_jerk_gait, "1.32421875", "force that holds body 1" },
  { 2, 1, &sawtooth_gait, "0.5", "cannot be told from 0" }, /* l' jumps from 0 to 1, and v1 with it from 1/2 to 0 */
};

static void check_undecided(const struct undecided *u)
{
  const struct scallop_crawler c = { 1, 1, u->F1, u->F2, 1, 2, 0.5, u->gait };
  const char *why = NULL;
  SCOPED(fmpq, v0);
  SCOPED(scallop_rational, exact);
  SCOPED(scallop_certified_phase, p);
  scallop_rational_of(&exact, &c);
  assert_true(scallop_rational_parse(v0, u->v0));
  arb_set_ui(p.v_end, 7);
  p.modes.count = 77;
  assert_int_equal(scallop_certified_phase(&exact, SCALLOP_EXTENSION, v0, 20, &p, &why), SCALLOP_EUNDECIDED);
  if (!why || !strstr(why, u->why))
    fail_msg("%s, not %s", why, u->why);
  assert_true(arb_equal_si(p.v_end, 7) && p.modes.count == 77);
}

TEST(exact_coincidences_are_said)
{
  for (size_t i = 0; i < sizeof undecided / sizeof *undecided; i++)
    check_undecided(&undecided[i]);
}

/* l grows by 3/2, while the amplitude is 1: nothing is decided of any motion, and it is said why. */
TEST(a_law_against_its_amplitude)
{
  const struct scallop_law law = { SCALLOP_LAW_POLYNOMIAL, 2, .polynomial = { { 0, 9, -9 }, 1 } };
  struct scallop_piece pieces[2] = { parabola_extension[0], parabola_contraction[0] };
  struct scallop_gait gait = parabola_gait;
  struct scallop_crawler c = { 1, 1, 2, 1, 1, 2, 0.5, &gait };
  const char *why = NULL;
  SCOPED(scallop_rational, exact);
  SCOPED(scallop_certified_steady, s);
  for (int kind = 0; kind < 2; kind++) {
    pieces[kind].law = &law;
    gait.phase[kind].pieces = &pieces[kind];
  }
  check_undecided(&(struct undecided){ 2, 1, &gait, "3", "contradicts its amplitude" });
  arb_set_ui(s.v_start, 7);
  scallop_rational_of(&exact, &c);
  assert_int_equal(scallop_certified_steady(&exact, 20, &s, &why), SCALLOP_EUNDECIDED);
  assert_non_null(strstr(why, "contradicts its amplitude"));
  assert_int_equal(scallop_certified_steady(&exact, 20, &s, NULL), SCALLOP_EUNDECIDED);
  assert_true(arb_equal_si(s.v_start, 7));
}

/* From rest, where the search for the steady state begins, body 2 comes to rest exactly in the middle of the
 * contraction, with l' at its peak: there v = 2 m1/M + eps/2 in L/tau. M = 100, and eps = 1 in the extension: it ends
 * with v = 2 m1/M a + 1/(2 a), a = alpha/(1 - alpha), for that F1/F2. Velocities nearby are decided; unless, at alpha =
 * 5/6, from rest is the steady state. */
static const struct from_rest {
  const char *crawler, *v0; /* v0: at the start of the contraction */
  double F1, F2, alpha;
  bool steady;
} from_rest[] = {
  { "1 99 654493/7443 358582/7443 1 1 6/7", "427/1800", 654493. / 7443, 358582. / 7443, 6. / 7, false },
  { "1 99 10656/115 5904/115 1 1 5/6", "6/25", 10656. / 115, 5904. / 115, 5. / 6, true },
};

TEST(a_search_from_an_undecided_velocity)
{
  SCOPED(fmpq, v0);
  SCOPED(scallop_rational, c);
  SCOPED(scallop_certified_phase, p);
  SCOPED(scallop_certified_steady, s);
  for (const struct from_rest *a = from_rest; a < from_rest + 2; a++) {
    const struct scallop_crawler doubles = { 1, 99, a->F1, a->F2, 1, 1, a->alpha, &scallop_gait_quadratic };
    const char *why = NULL;
    crawler_of_fractions(&c, a->crawler, &scallop_gait_quadratic);
    fmpq_zero(v0);
    assert_int_equal(scallop_certified_phase(&c, SCALLOP_EXTENSION, v0, 20, &p, NULL), SCALLOP_OK);
    fmpq_set_str(v0, a->v0, 10);
    CHECK_RELATIVE(middle(p.v_end), fmpq_get_d(v0), 1e-15);
    assert_int_equal(scallop_certified_phase(&c, SCALLOP_CONTRACTION, v0, 20, &p, &why), SCALLOP_EUNDECIDED);
    assert_non_null(strstr(why, "body 2 comes to rest just as"));
    why = NULL;
    assert_int_equal(scallop_certified_steady(&c, 20, &s, &why), a->steady ? SCALLOP_EUNDECIDED : SCALLOP_OK);
    struct scallop_steady_result d = steady_of(&doubles);
    if (a->steady) {
      assert_non_null(strstr(why, "body 2 comes to rest just as"));
      CHECK_NEAR(d.period.v_start, 0, 1e-15);
    } else {
      CHECK_RELATIVE(d.period.v_start, middle(s.v_start), 1e-13);
      CHECK_RELATIVE(d.period.displacement, middle(s.displacement), 1e-13);
    }
  }
}

static void check_domain(const struct scallop_rational_crawler *c, long digits)
{
  SCOPED(fmpq, v0);
  SCOPED(scallop_certified_phase, p);
  SCOPED(scallop_certified_steady, s);
  arb_set_ui(p.t1, 7);
  arb_set_ui(s.v_start, 7);
  assert_int_equal(scallop_certified_phase(c, SCALLOP_EXTENSION, v0, digits, &p, NULL), SCALLOP_EDOMAIN);
  assert_int_equal(scallop_certified_steady(c, digits, &s, NULL), SCALLOP_EDOMAIN);
  assert_true(arb_equal_si(p.t1, 7) && arb_equal_si(s.v_start, 7));
}

TEST(domain)
{
  struct scallop_crawler c = scallop_crawler_default();
  struct scallop_piece lawless = parabola_extension[0];
  struct scallop_gait unknown = parabola_gait, unmarked = sawtooth_gait;
  SCOPED(scallop_rational, exact);
  SCOPED(scallop_certified_steady, s);
  fmpq *inputs[] = { exact.m1, exact.m2, exact.F1, exact.F2, exact.L, exact.T, exact.alpha };
  for (int i = 0; i < 7; i++)
    for (int value = -1; value <= (i == 6 ? 1 : 0); value++) {
      scallop_rational_of(&exact, &c);
      fmpq_set_si(inputs[i], value, 1);
      check_domain(&exact, 20);
    }
  scallop_rational_of(&exact, &c);
  check_domain(&exact, 0);
  check_domain(&exact, SCALLOP_MOST_DIGITS + 1L);
  exact.gait = NULL;
  check_domain(&exact, 20);
  lawless.law = NULL;
  unknown.phase[0].pieces = &lawless;
  exact.gait = &unknown;
  check_domain(&exact, 20);
  /* as if l' did not jump; and then so that it is 0 where the first phase begins */
  struct scallop_piece no_jump[] = { sawtooth_gait.phase[0].pieces[0], sawtooth_gait.phase[0].pieces[0] };
  no_jump[0].jump = no_jump[1].jump = false;
  no_jump[1].velocity = 0;
  no_jump[1].acceleration = 2;
  exact.gait = &unmarked;
  unmarked.phase[0].count = 1;
  for (int i = 0; i < 2; i++) {
    unmarked.phase[0].pieces = &no_jump[i];
    assert_int_equal(scallop_certified_steady(&exact, 20, &s, NULL), SCALLOP_EDOMAIN);
  }
}

TEST(zeros_are_exact)
{
  SCOPED(scallop_certified_steady, s);
  for (int g = 0; g < SMOOTH_GAITS; g++)
    for (int held = 0; held < 2; held++) {
      const struct scallop_crawler c = { 0.3, 0.7, held ? 200 : 1.1, 1.1, 3, held ? 30 : 0.9, 0.3, every_gait[g] };
      certify_steady(&s, &c, 40);
      assert_true(arb_is_zero(s.v_start) && arb_is_zero(s.v_mid) && arb_is_zero(s.displacement));
      assert_int_equal(s.regime, held ? SCALLOP_AT_REST : SCALLOP_SLIDING);
      assert_true(!held || arb_is_zero(s.multiplier));
    }
}

/* F1 - F2 exceeds m2 l'' = 4 by 1e-60: too little to see in the first rough steps, which must not keep it from the
 * exact answer. */
TEST(barely_held)
{
  SCOPED(scallop_rational, c);
  SCOPED(scallop_certified_steady, s);
  crawler_of_fractions(&c, "1 1 5.000000000000000000000000000000000000000000000000000000000001 1 1 2 1/2",
                       &scallop_gait_quadratic);
  assert_int_equal(scallop_certified_steady(&c, 100, &s, NULL), SCALLOP_OK);
  assert_true(arb_is_zero(s.v_start));
  assert_int_equal(s.regime, SCALLOP_AT_REST);
}

/* tau^2 l'' = +-4 L in all of them. m2 |l''| = F1 - F2 or F1 + F2, or the same with the bodies exchanged: in the
 * extension, in the contraction or in both. Thirds and fifths are no doubles: exact arithmetic it is. */
static const struct at_limit {
  const char *crawler, *modes[2];
} at_limits[] = {
  { "1 1 5 1 1 2 1/2", { "0+", "0-" } },          /* 4 = F1 - F2 from the first moment on    */
  { "1 1 1 5 1 2 1/2", { "-0", "+0" } },          /* the mirror image                        */
  { "1 1 6 2 2 2 1/2", { "-+ 0+", "+- 0-" } },    /* 8 = F1 + F2: caught while l' slows down */
  { "1 1 3 2 1 4 1/2", { "0+", "0-" } },          /* 1 = F1 - F2                             */
  { "5 5 3 2 1 3 2/3", { "-- -+ 0+", "+- --" } }, /* 5 = F1 + F2 in the extension            */
  { "6 2 1 5 1 3 2/3", { "++ -+ -0", "+- ++" } }, /* 6 = F1 + F2, body 2                     */
  { "4 1 2 1 3 3 1/3", { "-+ ++", "++ +- 0-" } }, /* 3 = F1 + F2 in the contraction          */
  { "2 4 3 6 2 2 2/3", { "++ -+ -0", "+- ++" } }, /* 9 = F1 + F2, body 2                     */
};

/* Held, and so at rest: the motion of a body that friction would just let slide with acceleration 0 is the same. */
TEST(forces_at_their_limits_hold)
{
  SCOPED(scallop_rational, c);
  SCOPED(scallop_certified_steady, s);
  for (size_t i = 0; i < sizeof at_limits / sizeof *at_limits; i++) {
    crawler_of_fractions(&c, at_limits[i].crawler, &scallop_gait_quadratic);
    assert_int_equal(scallop_certified_steady(&c, 40, &s, NULL), SCALLOP_OK);
    modes_are(&s.modes[0], at_limits[i].modes[0]);
    modes_are(&s.modes[1], at_limits[i].modes[1]);
    assert_true(arb_is_zero(s.multiplier)); /* a body has stuck: the start is forgotten */
  }
}
