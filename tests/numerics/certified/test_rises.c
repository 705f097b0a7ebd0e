/* Gaits that rise within 1e-2 to 1e-10 of a phase: every number of a phase and of the steady state within the units
 * that are promised. */
#include "compare/stress/stress.h"
#include "tests/support/random_rises.h"
#include "tests/support/solved.h"

static void judge(struct stress_case *stressed)
{
  char text[STRESS_ARGUMENTS];
  stress_judge(stressed);
  assert_true(stressed->outcome == STRESS_SOLVED || stressed->outcome == STRESS_REFUSED);
  for (int q = 0; q < QUANTITIES; q++) {
    const struct stress_number *n = &stressed->number[q];
    if (!n->judged || n->error <= STRESS_PROMISE * n->unit)
      continue;
    stress_arguments(stressed, text);
    fail_msg("%s: %.17g, wanted %.17g: off by %.3g units, condition %.3g; %s", stress_quantity_name(stressed, q),
             n->got, n->exact, n->error / n->unit, n->unit / n->ulp, text);
  }
}

/* Of one crawler in three friction does much within a rise. */
static struct stress_case draw(struct random *r, const struct scallop_gait *gait, enum quantity_of of)
{
  struct stress_case s = {
    .motion = { .of = of, .crawler = random_crawler(r, random_below(r, 2) ? ORDINARY : STICK_SLIP, gait) }
  };
  if (random_below(r, 3) == 0)
    set_eps(&s.motion.crawler, random_decades(r, 1e2, 1e9));
  s.motion.phase = random_below(r, 2) ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
  s.motion.v0 = random_start(r, &s.motion.crawler, s.motion.phase);
  return s;
}

TEST(within_units)
{
  struct random r = { 20261501 };
  struct rises g;
  for (int i = 0; i < 54; i++) {
    const struct scallop_gait *gait = rises_draw(&g, &r, pow(10, -2 - i % 9));
    for (int n = 0; n < 4; n++) {
      struct stress_case s = draw(&r, gait, n < 3 ? OF_PHASE : OF_STEADY);
      judge(&s);
    }
  }
}

/* Three rises of 1e-8 between dwells: dx1 was off by 7e6 units. */
TEST(steps_of_a_motor)
{
  struct rises g = { .knots = { { { 0 } }, { { 0, 1, 0 }, { 1, 0, 0 } } } };
  const struct scallop_knot *const knots[2] = { g.knots[0], g.knots[1] };
  const double times[8] = { 0, 1, 1.00000001, 2, 2.00000001, 3, 3.00000001 }, lengths[8] = { 0, 0, 1, 1, 2, 2, 3 };
  for (int i = 0; i < 7; i++)
    g.knots[0][i] = (struct scallop_knot){ .time = scallop_knot_round(times[i] / times[6]),
                                           .length = scallop_knot_round(lengths[i] / 3) };
  g.spline = (struct scallop_spline){ .pieces = g.pieces, .laws = g.laws };
  assert_int_equal(scallop_make_spline(&g.spline, "motor", knots, (const int[]){ 7, 2 }), SCALLOP_OK);
  struct stress_case s = { .motion = { .of = OF_PHASE,
                                       .crawler = { 0.14, 2, 2.9, 1.48, 1, 1.7, 3.00000001 / 5, &g.spline.gait },
                                       .phase = SCALLOP_EXTENSION } };
  judge(&s);
  s.motion.of = OF_STEADY;
  judge(&s);
}

/* Where friction brings all to rest v_start is 0, and not -0. */
TEST(no_minus_zero)
{
  struct random r = { 20261502 };
  struct rises g;
  int zeros = 0;
  for (int i = 0; i < 60; i++) {
    struct stress_case s = draw(&r, rises_draw(&g, &r, 1e-3), OF_STEADY);
    set_eps(&s.motion.crawler, 1e4);
    struct scallop_steady_result steady = steady_of(&s.motion.crawler);
    const double v[] = { steady.period.v_start, steady.period.v_mid, steady.period.v_end, steady.v_low, steady.v_high };
    for (int k = 0; k < 5; k++) {
      zeros += v[k] == 0;
      assert_false(v[k] == 0 && signbit(v[k]));
    }
  }
  assert_true(zeros > 60);
}
