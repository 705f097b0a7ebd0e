/* Where l' jumps over 0 the steady states can fill an interval. Its ends are compared with a computation by
 * hand; ULP is DBL_EPSILON, and a bound is BOUND ulp of the velocities that meet there. */
#include <float.h>

#include "tests/support/random_crawler.h"
#include "tests/support/solved.h"

enum { BOUND = 8, CRAWLERS = 600 };
#define ULP DBL_EPSILON

static double end_of_period(const struct scallop_crawler *c, double v0) { return period_of(c, v0).v_end; }

static void interval_is(const struct scallop_crawler *c, double low, double high)
{
  struct scallop_steady_result s;
  double unit = c->L / c->T, size = fmax(fabs(low), fabs(high)) + crawler_eps(c);
  assert_int_equal(scallop_steady(c, &s), SCALLOP_INTERVAL);
  CHECK_NEAR(s.v_low / unit, low, BOUND * ULP * size);
  CHECK_NEAR(s.v_high / unit, high, BOUND * ULP * size);
  CHECK_NEAR(s.period.v_start, fmin(fmax(0, s.v_low), s.v_high), 0);
  CHECK_NEAR(s.period.balance, 0, ULP);
  for (int k = 1; k < 8; k++) {
    double v = (low + (high - low) * k / 8) * unit;
    CHECK_NEAR(end_of_period(c, v), v, BOUND * ULP * size * unit);
  }
  double outside = (high - low) / 64;
  assert_true(end_of_period(c, (high + outside) * unit) < (high + outside) * unit);
  assert_true(end_of_period(c, (low - outside) * unit) > (low - outside) * unit);
}

/* Velocities in L/T. The curves are at mu2/alpha, -mu1/alpha in extension (rate: eps delta) and at
 * mu1/(1 - alpha), -mu2/(1 - alpha) in contraction (rate: -eps delta). With F1 = F2 c stays where it
 * is between all four. With alpha = 1/2 it goes by eps delta/2 and back. */
TEST(sawtooth_interval)
{
  struct random r = { 21 };
  for (int n = 0; n < 8 * CRAWLERS; n++) {
    struct scallop_crawler c = random_crawler(&r, ORDINARY, &sawtooth_gait);
    double M = c.m1 + c.m2, mu1 = c.m1 / M, mu2 = c.m2 / M, a = c.alpha, b = 1 - c.alpha;
    if (n % 2 == 0) {
      c.F2 = c.F1;
      interval_is(&c, -fmin(mu1 / a, mu2 / b), fmin(mu2 / a, mu1 / b));
      continue;
    }
    c.alpha = 0.5;
    set_eps(&c, random_decades(&r, 1e-6, 2 * fmin(mu1, mu2)));
    double swing = 0.5 * crawler_eps(&c) * (c.F1 - c.F2) / (c.F1 + c.F2), room = 2 * fmin(mu1, mu2);
    interval_is(&c, -room - fmin(swing, 0), room - fmax(swing, 0));
  }
}

/* l' = 9/8 for three quarters of a phase and then 5/8, with the default F1 = 4, F2 = 1, alpha = 3/4 and
 * m1 = m2. Between the curves 5/12 and 3/4 of the two speeds in extension both bodies go forward in the
 * slow quarter, and friction takes there 2 (4/5) (3/4)/4 = 3/10: all of the drive (3/5)(2 alpha - 1), for
 * every start. c goes up by 0.3375 eps, down by 0.1875 eps, and by 0.15 eps in the contraction. */
#define TWO_SPEEDS(sign) \
  { .begin = 0, \
    .end = 0.75, \
    .direction = (sign), \
    .jump = true, \
    .linear = true, \
    .velocity = (sign)*1.125, \
    .curve = &scallop_curve_linear }, \
  { \
    .begin = 0.25, .end = 0, .anchor = SCALLOP_FROM_END, .direction = (sign), .jump = true, .linear = true, \
    .velocity = (sign)*0.625, .curve = &scallop_curve_linear \
  }

static const struct scallop_piece two_speed_extension[] = { TWO_SPEEDS(1) };
static const struct scallop_piece two_speed_contraction[] = { TWO_SPEEDS(-1) };
static const struct scallop_gait two_speed_gait = { "two-speed",
                                                    { { two_speed_extension, 2, 0, 0, 1.125, 1, false, false, false },
                                                      { two_speed_contraction, 2, 0, 0, 1.125, -1, false, false,
                                                        false } } };

TEST(two_speed_interval)
{
  struct scallop_crawler c = { 1, 1, 4, 1, 2560, 1, 0.75, &two_speed_gait };
  double eps = 0x1p-10;
  interval_is(&c, 5. / 12 - 0.15 * eps, 0.75 - 0.3375 * eps);
}
