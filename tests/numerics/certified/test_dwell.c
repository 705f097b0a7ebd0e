/* Dwells: stretches in which l rests, and both bodies are one on friction F1 + F2 until they rest as well. By hand, in
 * double; the solvers against each other: test_agree.c. */
#include "asymptotics/derived/branch.h"
#include "tests/support/certified_balls.h"
#include "tests/support/odd_gaits.h"

static const struct scallop_gait *const dwelling[] = { &pause_gait, &wait_gait, &hesitant_gait };
enum { DWELLING = sizeof dwelling / sizeof *dwelling };

/* Extensions of tau = 3/4. Body 1 is held whenever it is at rest: its friction is above m2 |l''| + F2. In the dwell at
 * the start v' = -(F1 + F2)/M = -64: from v0 = 3 both rest after 3/64, 9/128 further on; then body 2 goes out and back.
 * Above every curve the dwells are nothing special: v' = -64 throughout. nan: not looked at */
static const struct {
  const struct scallop_gait *gait;
  double F1, v0;
  const char *modes;
  enum scallop_regime regime;
  double t1, dT, v_end, dx1, dx2, dxC;
} extensions[] = {
  { &wait_gait, 127, 3, "++ 00 0+ 00 0- 00", SCALLOP_STICK_SLIP, 3. / 64, 0.75 / 8, 0, 9. / 128, 137. / 128,
    73. / 128 },
  { &wait_gait, 127, -3, "-- 00 0+ 00 0- 00", SCALLOP_STICK_SLIP, 3. / 64, 0.75 / 8, 0, -9. / 128, NAN, NAN },
  { &wait_gait, 1023, 0, "00 0+ 00 0- 00", SCALLOP_AT_REST, 0.75 / 8, 0.75 / 8, 0, 0, 1, 0.5 },
  { &pause_gait, 127, 1000, "++", SCALLOP_SLIDING, NAN, NAN, 952, NAN, NAN, 732 },
};

static struct scallop_crawler anchored(const struct scallop_gait *gait, double F1)
{
  struct scallop_crawler c = with_gait(gait);
  c.F1 = F1;
  c.L = 1;
  return c;
}

static void check_known(double got, double wanted, double tolerance)
{
  if (!isnan(wanted))
    CHECK_RELATIVE(got, wanted, tolerance);
}

TEST(extensions_by_hand)
{
  for (size_t i = 0; i < sizeof extensions / sizeof *extensions; i++) {
    struct scallop_crawler c = anchored(extensions[i].gait, extensions[i].F1);
    struct scallop_phase_result r = phase_of(&c, SCALLOP_EXTENSION, extensions[i].v0);
    modes_are(&r.modes, extensions[i].modes);
    assert_int_equal(r.regime, extensions[i].regime);
    check_known(r.t1, extensions[i].t1, 2e-16);
    check_known(r.dT, extensions[i].dT, 2e-16);
    check_known(r.v_end, extensions[i].v_end, 2e-16);
    check_known(r.dx1, extensions[i].dx1, 1e-15);
    check_known(r.dx2, extensions[i].dx2, 1e-15);
    check_known(r.dxC, extensions[i].dxC, 1e-15);
  }
}

/* Body 1 never moves, whatever body 2 does; with less friction, but fast, no body ever rests. */
TEST(periods_by_hand)
{
  struct scallop_crawler c = anchored(&wait_gait, 1023);
  struct scallop_period_result p = period_of(&c, 0);
  modes_are(&p.modes[SCALLOP_CONTRACTION], "00 0- 00 0+ 00");
  assert_true(p.v_end == 0 && p.multiplier == 0 && p.displacement == 0);
  assert_int_equal(p.regime, SCALLOP_AT_REST);
  c = anchored(&pause_gait, 127);
  p = period_of(&c, 1000);
  CHECK_EQUAL(p.multiplier, 1);
  CHECK_RELATIVE(p.balance, -1, 1e-15);
}

/* A dwell of a fourth of the time costs a fourth of the friction there is. What the phases of unlike duration bring has
 * to be more, or it comes to rest there however short the period is: (F1 - F2)/(F1 + F2) (2 alpha - 1) 3/4 = 0.576
 * here, and 0.225 by default. With phases of one duration what the contraction does is the mirror image of what the
 * extension does, half a period late. */
TEST(slides_on)
{
  struct scallop_crawler c = with_gait(&pause_gait);
  c.T = 1. / 64;
  struct scallop_steady_result s = steady_of(&c);
  modes_are(&s.period.modes[0], "++ -+ ++ 00 -+ ++");
  c.F1 = 49;
  c.alpha = 0.9;
  s = steady_of(&c);
  modes_are(&s.period.modes[0], "++ -+ ++ -+ ++");
  modes_are(&s.period.modes[1], "++ +- ++ +- ++");
  assert_int_equal(s.period.regime, SCALLOP_SLIDING);
  CHECK_NEAR(s.period.balance, 0, 1e-15);
  CHECK_RELATIVE(period_of(&c, s.period.v_start).v_end, s.period.v_start, 1e-15);
  assert_true(s.period.multiplier > 0 && s.period.multiplier < 1);
  c.alpha = 0.5;
  s = steady_of(&c);
  CHECK_RELATIVE(s.period.v_mid, -s.period.v_start, 1e-13);
  CHECK_EQUAL(s.period.displacement, 0);
}

/* Held by a dwell for any length of time, and moving otherwise: stick-slip, and the start is forgotten. */
TEST(a_dwell_forgets)
{
  struct scallop_crawler c = with_gait(&wait_gait);
  c.F1 = 60;
  c.F2 = 50;
  struct scallop_period_result p = period_of(&c, 0.5);
  assert_int_equal(p.regime, SCALLOP_STICK_SLIP);
  CHECK_EQUAL(p.multiplier, 0);
  CHECK_EQUAL(p.v_end, period_of(&c, -2).v_end);
}

/* While l rests so do the bodies once they have stopped. */
static bool watch(void *context, const struct scallop_sample *s)
{
  if (s->t <= 0.75 / 8) {
    double t = fmin(s->t, 3. / 64), x = 3 * t - 32 * t * t;
    CHECK_NEAR(s->x1, x, 1e-16);
    CHECK_NEAR(s->x2, x, 1e-16);
    CHECK_NEAR(s->v1, 3 - 64 * t, 1e-15);
    CHECK_EQUAL(s->l, 0);
    ++*(int *)context;
  }
  return true;
}

TEST(trajectory_through_a_dwell)
{
  struct scallop_crawler c = anchored(&wait_gait, 127);
  int samples = 0;
  assert_int_equal(scallop_trajectory(&c, 3, 1, 512, watch, &samples), SCALLOP_OK);
  assert_int_equal(samples, 512 * 3 / 32 + 1);
}

/* There is no series for it, and the reason says that l' is 0 within a phase. */
TEST(no_series)
{
  for (int i = 0; i < DWELLING; i++)
    assert_false(branch_is_possible(dwelling[i]));
  assert_non_null(strstr(branch_impossible, "l' is 0"));
}
