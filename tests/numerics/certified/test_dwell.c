/* Dwells: stretches in which l rests, and both bodies are one on friction F1 + F2 until they rest as well. */
#include "asymptotics/derived/branch.h"
#include "tests/support/certified_balls.h"
#include "tests/support/odd_gaits.h"

static const struct scallop_gait *const dwelling[] = { &pause_gait, &wait_gait, &hesitant_gait };
enum { DWELLING = sizeof dwelling / sizeof *dwelling, DIGITS = 30 };

/* Body 1 is held whenever it is at rest in the extension: its friction is above m2 |l''| + F2. */
static struct scallop_crawler anchored(const struct scallop_gait *gait)
{
  struct scallop_crawler c = with_gait(gait);
  c.F1 = 127;
  c.L = 1;
  return c;
}

/* In the dwell at the start v' = -(F1 + F2)/M = -64: from v0 = 3 both rest after 3/64, 9/128 further on; then body 2
 * goes out and back. */
TEST(comes_to_rest_in_a_dwell)
{
  struct scallop_crawler c = anchored(&wait_gait);
  double tau = 0.75, way = 9. / 128;
  struct scallop_phase_result r = phase_of(&c, SCALLOP_EXTENSION, 3);
  modes_are(&r.modes, "++ 00 0+ 00 0- 00");
  CHECK_RELATIVE(r.t1, 3. / 64, 2e-16);
  CHECK_RELATIVE(r.dT, tau / 8, 2e-16);
  CHECK_EQUAL(r.v_end, 0);
  CHECK_RELATIVE(r.dx1, way, 1e-15);
  CHECK_RELATIVE(r.dx2, 1 + way, 1e-15);
  CHECK_RELATIVE(r.dxC, 0.5 + way, 1e-15);
  assert_int_equal(r.regime, SCALLOP_STICK_SLIP);
  r = phase_of(&c, SCALLOP_EXTENSION, -3);
  modes_are(&r.modes, "-- 00 0+ 00 0- 00");
  CHECK_RELATIVE(r.dx1, -way, 1e-15);
}

/* Body 1 never moves: at rest, whatever body 2 does. */
TEST(rests)
{
  struct scallop_crawler c = anchored(&wait_gait);
  c.F1 = 1023; /* the contraction is a third as long */
  struct scallop_phase_result r = phase_of(&c, SCALLOP_EXTENSION, 0);
  modes_are(&r.modes, "00 0+ 00 0- 00");
  CHECK_RELATIVE(r.t1, 0.75 / 8, 2e-16);
  CHECK_EQUAL(r.dx1, 0);
  CHECK_RELATIVE(r.dx2, 1, 1e-15);
  assert_int_equal(r.regime, SCALLOP_AT_REST);
  struct scallop_period_result p = period_of(&c, 0);
  modes_are(&p.modes[SCALLOP_CONTRACTION], "00 0- 00 0+ 00");
  CHECK_EQUAL(p.v_end, 0);
  CHECK_EQUAL(p.multiplier, 0);
  CHECK_EQUAL(p.displacement, 0);
  assert_int_equal(p.regime, SCALLOP_AT_REST);
}

/* Above every curve the dwells are nothing special: v' = -(F1 + F2)/M throughout. */
TEST(passes_a_dwell)
{
  struct scallop_crawler c = anchored(&pause_gait);
  double v0 = 1000, tau = 0.75, xC = v0 * tau - 64 * tau * tau / 2;
  struct scallop_phase_result r = phase_of(&c, SCALLOP_EXTENSION, v0);
  modes_are(&r.modes, "++");
  CHECK_RELATIVE(r.v_end, v0 - 64 * tau, 2e-16);
  CHECK_RELATIVE(r.dxC, xC, 1e-15);
  assert_int_equal(r.regime, SCALLOP_SLIDING);
  struct scallop_period_result p = period_of(&c, v0);
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
  struct scallop_period_result again = period_of(&c, s.period.v_start);
  CHECK_RELATIVE(again.v_end, s.period.v_start, 1e-15);
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
  struct scallop_period_result q = period_of(&c, -2);
  assert_int_equal(p.regime, SCALLOP_STICK_SLIP);
  CHECK_EQUAL(p.multiplier, 0);
  CHECK_EQUAL(p.v_end, q.v_end);
}

/* While l rests so do the bodies once they have stopped. */
struct watched {
  double x1, t;
  int samples;
};

static bool watch(void *context, const struct scallop_sample *s)
{
  struct watched *w = context;
  if (s->t <= 0.75 / 8) {
    double t = fmin(s->t, 3. / 64), x = 3 * t - 32 * t * t;
    CHECK_NEAR(s->x1, x, 1e-16);
    CHECK_NEAR(s->x2, x, 1e-16);
    CHECK_NEAR(s->v1, 3 - 64 * t, 1e-15);
    CHECK_EQUAL(s->l, 0);
    w->samples++;
  }
  return true;
}

TEST(trajectory_through_a_dwell)
{
  struct scallop_crawler c = anchored(&wait_gait);
  struct watched w = { 0, 0, 0 };
  assert_int_equal(scallop_trajectory(&c, 3, 1, 512, watch, &w), SCALLOP_OK);
  assert_int_equal(w.samples, 512 * 3 / 32 + 1);
}

/* In doubles the same is done in test_odd_gaits.c. */
TEST(binary128_and_certified)
{
  struct random r = { 20261201 };
  if (scallop_width_bits(SCALLOP_BINARY128) == 0)
    skip();
  SCOPED(scallop_certified_phase, exact);
  for (int i = 0; i < 60 * DWELLING; i++) {
    struct scallop_crawler c = random_crawler(&r, i % 2 ? ORDINARY : STICK_SLIP, dwelling[i % DWELLING]);
    enum scallop_phase_kind kind = random_below(&r, 2) ? SCALLOP_EXTENSION : SCALLOP_CONTRACTION;
    double v0 = random_start(&r, &c, kind), tau = scallop_phase_duration(&c, kind);
    struct scallop_wide_phase w;
    assert_int_equal(scallop_wide_phase(SCALLOP_BINARY128, &c, kind, v0, &w), SCALLOP_OK);
    certify_phase(&exact, &c, kind, v0, DIGITS);
    assert_true(modes_alike(&w.modes, &exact.modes));
    assert_int_equal(w.regime, exact.regime);
    check_wide(&w.v_end, exact.v_end, 1e-27 * (c.L / tau + fabs(v0)), &c);
    check_wide(&w.dx1, exact.dx1, 1e-27 * (c.L + fabs(v0) * tau), &c);
    check_wide(&w.dx2, exact.dx2, 1e-27 * (c.L + fabs(v0) * tau), &c);
  }
}

/* Seen in a mirror from the other side body 1 is body 2. */
TEST(mirror)
{
  struct random r = { 20261202 };
  for (int i = 0; i < 50 * DWELLING; i++) {
    struct scallop_crawler c = random_crawler(&r, i % 2 ? ORDINARY : STICK_SLIP, dwelling[i % DWELLING]),
                           m = exchanged(&c);
    double v0 = random_start(&r, &c, SCALLOP_EXTENSION), size = c.L + fabs(v0) * c.T;
    struct scallop_phase_result one = phase_of(&c, SCALLOP_EXTENSION, v0);
    struct scallop_phase_result other = phase_of(&m, SCALLOP_EXTENSION, -v0);
    assert_int_equal(one.modes.count, other.modes.count);
    CHECK_NEAR(one.v_end, -other.v_end, 1e-14 * size / c.T / c.alpha);
    CHECK_NEAR(one.dx1, -other.dx2, 1e-14 * size);
    CHECK_NEAR(one.dxC, -other.dxC, 1e-14 * size);
  }
}

/* There is no series for it, and the reason says that l' is 0 within a phase. */
TEST(no_series)
{
  for (int i = 0; i < DWELLING; i++)
    assert_false(branch_is_possible(dwelling[i]));
  assert_non_null(strstr(branch_impossible, "l' is 0"));
}
