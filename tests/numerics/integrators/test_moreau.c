/* Moreau and Jean's time stepping: each step against bisection on its own inclusion, and the whole against the exact
 * period, which it must approach in first order: error <= BOUND eps/steps for every crawler and start, and the worst of
 * them proportional to 1/steps. (The error of one crawler does not fall smoothly: it hangs on where in a step it
 * turns.) That pins the exact solver without sharing a line with it. */
#include "tests/support/integrators.h"

static struct scallop_integrator_period stepped(const struct scallop_crawler *c, double v0, long steps)
{
  INTEGRATOR(integrator, scallop_moreau_integrator(steps));
  struct scallop_integrator_period p = integrator_period(integrator, c, v0);
  assert_true(p.steps == 2 * steps && p.evaluations == 2 * steps && p.events == 0);
  return p;
}

enum { REFERENCED = 60, CRAWLERS = 200, COARSEST = 64, LEVELS = 5 };

/* In the crawler's own units: in each step the least c at which all values of c + h F1/M Sgn(c - rest1) + h F2/M Sgn(c
 * - rest2) are at least what c was, by bisection */
static void reference_phase(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, int steps, double *c,
                            double *x)
{
  double M = crawler->m1 + crawler->m2, tau = scallop_phase_duration(crawler, kind), h = tau / steps;
  double k1 = h * crawler->F1 / M, k2 = h * crawler->F2 / M;
  for (int k = 1; k <= steps; k++) {
    double rate, before = *c, low = before - 2 * (k1 + k2) - 1e-3, high = before + 2 * (k1 + k2) + 1e-3;
    scallop_gait_at(crawler->gait, kind, (double)k / steps, NULL, &rate, NULL);
    rate *= crawler->L / tau;
    for (double mid; (mid = 0.5 * (low + high)) > low && mid < high;) {
      double v1 = mid - crawler->m2 / M * rate, v2 = mid + crawler->m1 / M * rate;
      *(mid + k1 * ((v1 > 0) - (v1 < 0)) + k2 * ((v2 > 0) - (v2 < 0)) < before ? &low : &high) = mid;
    }
    *c = high;
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

/* From the steady start, from rest, and from anything */
static void first_order(const struct scallop_gait *gait)
{
  const double bound = 2;
  double worst[LEVELS] = { 0 }, largest = 0;
  int regimes[3] = { 0 };
  struct random r = { 1999 };
  for (int i = 0; i < CRAWLERS; i++) {
    struct scallop_crawler c = random_crawler(&r, i % 2 ? STICK_SLIP : ORDINARY, gait);
    double v0 = i % 3 == 0 ? steady_of(&c).period.v_start : i % 3 == 1 ? 0 : random_start(&r, &c, SCALLOP_EXTENSION);
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
  assert_true(regimes[0] >= 3 && regimes[1] >= 3 && regimes[2] >= 3);
}

TEST(error_of_first_order)
{
  for (int g = 0; g < SMOOTH_GAITS; g++)
    first_order(every_gait[g]);
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
