/* Moreau and Jean's time stepping: each step against bisection on its own inclusion, and the whole against the exact
 * period, which it must approach in first order: error <= BOUND eps/steps for every crawler and start, and the worst of
 * them proportional to 1/steps. (The error of one crawler does not fall smoothly: it hangs on where in a step it
 * turns.) That pins the exact solver without sharing a line with it. */
#include "numerics/integrators/integrator.h"
#include "tests/support/integrators.h"

static struct scallop_integrator_period stepped(const struct scallop_crawler *c, double v0, long steps)
{
  INTEGRATOR(integrator, scallop_moreau_integrator(steps));
  struct scallop_integrator_period p = integrator_period(integrator, c, v0);
  assert_true(p.steps == 2 * steps && p.evaluations == 2 * steps && p.events == 0);
  return p;
}

enum { REFERENCED = 60, CRAWLERS = 300, COARSEST = 64, LEVELS = 5 };

struct inclusion {
  double k1, k2, rest1, rest2; /* c + k1 Sgn(c - rest1) + k2 Sgn(c - rest2) */
};

static double sign(double x) { return (x > 0) - (x < 0); }

/* The least c at which all values of the left side are at least b, by bisection. */
static double bisect(const struct inclusion *i, double b)
{
  double low = b - 2 * (i->k1 + i->k2) - 1e-3, high = b + 2 * (i->k1 + i->k2) + 1e-3;
  for (double mid; (mid = 0.5 * (low + high)) > low && mid < high;)
    *(mid + i->k1 * sign(mid - i->rest1) + i->k2 * sign(mid - i->rest2) < b ? &low : &high) = mid;
  return high;
}

/* In the crawler's own units. */
static void reference_phase(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, int steps, double *c,
                            double *x)
{
  double M = crawler->m1 + crawler->m2, tau = scallop_phase_duration(crawler, kind), h = tau / steps;
  for (int k = 1; k <= steps; k++) {
    double rate, before = *c;
    scallop_gait_at(crawler->gait, kind, (double)k / steps, NULL, &rate, NULL);
    rate *= crawler->L / tau;
    struct inclusion i = { h * crawler->F1 / M, h * crawler->F2 / M, crawler->m2 / M * rate, -crawler->m1 / M * rate };
    *c = bisect(&i, before);
    *x += 0.5 * h * (before + *c);
  }
}

TEST(each_step_by_bisection)
{
  struct random r = { 19880501 };
  for (int i = 0; i < REFERENCED; i++) {
    struct scallop_crawler c = random_crawler(&r, (enum family)(i % SMALL_PERIOD), every_gait[i % ALL_GAITS]);
    double v0 = random_start(&r, &c, SCALLOP_EXTENSION), v = v0, x = 0;
    double fastest = fastest_l(&c) + fabs(v0);
    int steps = 1 + random_below(&r, 40);
    struct scallop_integrator_period p = stepped(&c, v0, steps);
    reference_phase(&c, SCALLOP_EXTENSION, steps, &v, &x);
    CHECK_NEAR(p.v_mid, v, 1e-13 * fastest);
    reference_phase(&c, SCALLOP_CONTRACTION, steps, &v, &x);
    CHECK_NEAR(p.v_end, v, 1e-13 * fastest);
    CHECK_NEAR(p.displacement, x, 1e-13 * fastest * c.T);
  }
}

/* From the steady start, from rest, and from anything. */
static double a_start(struct random *r, const struct scallop_crawler *c, int i)
{
  struct scallop_steady_result steady;
  assert_true(scallop_steady(c, &steady) >= 0);
  return i % 3 == 0 ? steady.period.v_start : i % 3 == 1 ? 0 : random_start(r, c, SCALLOP_EXTENSION);
}

static void first_order(const struct scallop_gait *gait)
{
  const double bound = 2;
  double worst[LEVELS] = { 0 }, largest = 0;
  int regimes[3] = { 0 };
  struct random r = { 1999 };
  for (int i = 0; i < CRAWLERS; i++) {
    struct scallop_crawler c = random_crawler(&r, i % 2 ? STICK_SLIP : ORDINARY, gait);
    double v0 = a_start(&r, &c, i);
    struct scallop_period_result exact = period_of(&c, v0);
    regimes[exact.regime]++;
    for (int level = 0; level < LEVELS; level++) {
      long steps = COARSEST << 2 * level;
      struct scallop_integrator_period p = stepped(&c, v0, steps);
      double error = fmax(distance(&c, &p, exact.v_end, exact.displacement), fabs(p.v_mid - exact.v_mid) * c.T / c.L);
      double share = error / crawler_eps(&c);
      worst[level] = fmax(worst[level], share);
      largest = fmax(largest, share * (double)steps);
      CHECK_AT_MOST(share, bound / (double)steps);
    }
  }
  for (int level = 1; level < LEVELS; level++)
    CHECK_AT_MOST(worst[level], 0.5 * worst[level - 1]);
  print_message("%s: %d sliding, %d stick-slip, %d at rest; worst %.3g eps/steps, order %.3f\n", gait->name, regimes[0],
                regimes[1], regimes[2], largest, observed_order(worst, LEVELS, 4));
  CHECK_NEAR(observed_order(worst, LEVELS, 4), 1, 0.1);
  for (int i = 0; i < 3; i++)
    assert_true(regimes[i] >= 3);
}

TEST(first_order_quadratic) { first_order(&scallop_gait_quadratic); }
TEST(first_order_sinusoidal) { first_order(&scallop_gait_sinusoidal); }
TEST(first_order_trapezoid) { first_order(&trapezoid_gait); }
TEST(first_order_minimum_jerk) { first_order(&minimum_jerk_gait); }

/* The steady state is a fixed point of the stepped map, to what the error of a period becomes: 1/(1 - multiplier) times
 * as much. */
TEST(steady_states)
{
  const long steps = 4096;
  struct random r = { 31 };
  for (int i = 0; i < 96; i++) {
    struct scallop_crawler c = random_crawler(&r, i % 2 ? STICK_SLIP : ORDINARY, every_gait[i / 2 % SMOOTH_GAITS]);
    c.alpha = random_between(&r, 0.2, 0.8);
    set_eps(&c, i % 2 ? random_decades(&r, 2, 60) : random_decades(&r, 0.3, 5));
    INTEGRATOR(integrator, scallop_moreau_integrator(steps));
    struct scallop_integrator_steady s;
    struct scallop_steady_result exact = steady_of(&c);
    double bound = 2 * 2 * crawler_eps(&c) / (double)steps / (1 - exact.period.multiplier);
    assert_int_equal(scallop_integrator_root(integrator, &c, 1e-3 * bound, NULL, &s), SCALLOP_OK);
    CHECK_NEAR(s.v_start, exact.period.v_start, bound * c.L / c.T);
    CHECK_NEAR(s.displacement, exact.period.displacement, bound * c.L);
  }
}

/* No body turns: nothing is left of the error but rounding, and for the sinusoidal gait too. */
TEST(exact_without_crossings)
{
  struct scallop_crawler c = with_gait(&scallop_gait_sinusoidal);
  for (int direction = -1; direction <= 1; direction += 2) {
    double v0 = direction * 1013.7;
    struct scallop_period_result exact = period_of(&c, v0);
    for (long steps = 1; steps <= 1000; steps *= 10) {
      struct scallop_integrator_period p = stepped(&c, v0, steps);
      CHECK_RELATIVE(p.v_end, exact.v_end, 1e-13);
      CHECK_RELATIVE(p.displacement, exact.displacement, 1e-13);
    }
  }
}

/* The sawtooth ends its phases in motion: a body that is stuck is so to the last bit, or c would not be the other's
 * share of l'. */
TEST(stuck_exactly)
{
  struct scallop_crawler c = { 1, 2, 300, 7, 3, 1.7, 0.6, &sawtooth_gait };
  struct scallop_scaled s;
  for (int stuck = 1; stuck <= 2; stuck++) {
    assert_int_equal(scallop_scale(&c, &s), SCALLOP_OK);
    struct scallop_integrator_period p = stepped(&c, 0.1, 1000);
    double share = stuck == 1 ? s.mu2 : -s.mu1;
    CHECK_EQUAL(p.v_mid, share / s.fraction[SCALLOP_EXTENSION] * s.velocity);
    CHECK_EQUAL(p.v_end, -share / s.fraction[SCALLOP_CONTRACTION] * s.velocity);
    c.F1 = 7;
    c.F2 = 300;
  }
}
