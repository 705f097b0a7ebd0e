/* Steady states by simulation and as the root of a period map: on maps whose answer is known, and on GSL's integrators
 * beside the exact solver. What an integrator's steady state is off by is the error of its period over 1 - multiplier.
 */
#include <gsl/gsl_errno.h>

#include "numerics/integrators/integrator.h"
#include "tests/support/integrators.h"

enum { CRAWLERS = 40, STEPPERS = 2 };
static const double bound_of[STEPPERS] = { 32, 32 }; /* of tests/numerics/integrators/test_integrators.c */

/* A map whose answer is known, in units where L/T = 1 */
struct map {
  struct scallop_integrator integrator;
  double (*value)(struct map *map, double v);
  double multiplier, fixed;
  long calls;
  enum scallop_status status;
};

static enum scallop_status map_period(struct scallop_integrator *self, const struct scallop_crawler *c, double v0,
                                      const struct scallop_patience *patience, struct scallop_integrator_period *period)
{
  struct map *m = (struct map *)self;
  double v = m->value(m, v0);
  (void)c, (void)patience;
  m->calls++;
  if (m->status != SCALLOP_OK || !isfinite(v))
    return m->status != SCALLOP_OK ? m->status : SCALLOP_ERANGE;
  *period = (struct scallop_integrator_period){
    .v_end = v, .displacement = 2 * v0, .steps = 3, .evaluations = 5, .events = 7
  };
  return SCALLOP_OK;
}

static void map_destroy(struct scallop_integrator *self) { ((struct map *)self)->calls = -1; }

static struct map map_of(double (*value)(struct map *map, double v), double multiplier, double fixed)
{
  return (struct map){
    .integrator = { map_period, map_destroy }, .value = value, .multiplier = multiplier, .fixed = fixed
  };
}

static struct scallop_crawler unit_crawler(void)
{
  return (struct scallop_crawler){ 1, 1, 4, 1, 1, 1, 0.75, &scallop_gait_quadratic };
}

static double linear(struct map *m, double v) { return m->fixed + m->multiplier * (v - m->fixed); }

/* Friction alone, and then what the multiplier says. */
static double braked(struct map *m, double v) { return v > 1 ? v - 1e-3 : linear(m, v); }

static double unsure(struct map *m, double v, double noise)
{
  struct random r = { (uint64_t)m->calls };
  return linear(m, v) + random_between(&r, -noise, noise);
}

static double noisy(struct map *m, double v) { return unsure(m, v, 1e-9); }
static double rounded(struct map *m, double v) { return unsure(m, v, 2 * DBL_EPSILON); }

/* Pushed away from where it jumps: no state is steady, and the velocity goes to and fro. */
static double jumping(struct map *m, double v) { return v > m->fixed ? v - 1e-6 : v + 1.3e-6; }

/* To and fro for ever, but only after strides have become long enough not to see it. */
static double ending_in_a_cycle(struct map *m, double v)
{
  return v > 0.5 ? v - 0.01 : v == m->fixed ? 0.41 : m->fixed;
}

/* Friction is seen on one side only. */
static double one_sided(struct map *m, double v) { return v * m->fixed > 0 ? v : v / 2; }

static double escaping(struct map *m, double v) { return linear(m, v) + (v >= 0 ? 1 : -1); }

static struct scallop_integrator_steady simulated(struct map *m, double v0, double tolerance,
                                                  enum scallop_status wanted)
{
  struct scallop_integrator_steady s = { .v_start = NAN };
  struct scallop_crawler c = unit_crawler();
  m->calls = 0;
  assert_int_equal(scallop_integrator_simulate(&m->integrator, &c, v0, tolerance, NULL, &s), wanted);
  assert_int_equal(s.periods, wanted == SCALLOP_OK ? m->calls : 0);
  return s;
}

/* To the tolerance, after few more periods than the change needs to fall to it. */
TEST(simulates_slow_maps)
{
  const double multipliers[] = { 0, 3e-3, 0.5, 0.99, 0.9999, 1 - 1e-6 }, tolerances[] = { 1e-3, 1e-6, 1e-9 };
  for (size_t i = 0; i < sizeof multipliers / sizeof *multipliers; i++)
    for (size_t k = 0; k < sizeof tolerances / sizeof *tolerances; k++) {
      struct map m = map_of(linear, multipliers[i], -0.385);
      struct scallop_integrator_steady s = simulated(&m, 1.7, tolerances[k], SCALLOP_OK);
      CHECK_NEAR(s.v_start, -0.385, 1.385 * tolerances[k]);
      CHECK_NEAR(s.displacement, 2 * -0.385, 4 * 1.385 * tolerances[k]); /* of a period that began as near */
      double needed = multipliers[i] > 0 ? log(tolerances[k]) / log(multipliers[i]) : 0;
      CHECK_AT_MOST((double)s.periods, 1.2 * needed + 4);
      assert_int_equal(s.steps, 3 * s.periods);
      assert_int_equal(s.evaluations, 5 * s.periods);
      assert_int_equal(s.events, 7 * s.periods);
      assert_int_equal(s.root_iterations, 0);
    }
}

/* Begun near the end, where rounding leaves two digits of a change and so none of 1 - m. */
TEST(rounding_does_not_end_a_simulation)
{
  struct map m = map_of(rounded, 1 - 1e-6, -0.385);
  struct scallop_integrator_steady s = simulated(&m, -0.385 + 1e-7, 1e-9, SCALLOP_OK);
  CHECK_NEAR(s.v_start, -0.385, 1.385e-9);
}

/* A change that stays the same is no reason to end, nor to believe the end is near. */
TEST(simulates_what_is_braked)
{
  struct map m = map_of(braked, 0.9, 0.25);
  struct scallop_integrator_steady s = simulated(&m, 20, 1e-8, SCALLOP_OK);
  CHECK_NEAR(s.v_start, 0.25, 1.25e-8);
  assert_true(s.periods > 19000);
}

/* With a tolerance that the noise of the map does not allow, the simulation ends where the noise does. */
TEST(noise_ends_a_simulation)
{
  const double multipliers[] = { 0.5, 0.99, 0.9999 };
  for (int i = 0; i < 3; i++)
    for (int k = 0; k < 2; k++) {
      struct map m = map_of(noisy, multipliers[i], 0.731);
      struct scallop_integrator_steady s = simulated(&m, -1, k ? 1e-13 : 0, SCALLOP_OK);
      CHECK_NEAR(s.v_start, 0.731, 4e-9 / (1 - multipliers[i]));
      CHECK_AT_MOST((double)s.periods, 60 / (1 - multipliers[i]));
    }
  struct map m = map_of(jumping, 0, 0.2);
  struct scallop_integrator_steady s = simulated(&m, 0.20001, 1e-9, SCALLOP_OK);
  CHECK_NEAR(s.v_start, 0.2, 3e-6);
  CHECK_AT_MOST((double)s.periods, 100);
  m = map_of(ending_in_a_cycle, 0, 0.4);
  s = simulated(&m, 1.003, 1e-9, SCALLOP_OK);
  CHECK_NEAR(s.v_start, 0.405, 0.0051);
  CHECK_AT_MOST((double)s.periods, 100);
  m = map_of(linear, 1, 0); /* gives back what it is given */
  assert_int_equal(simulated(&m, 0.3, 1e-9, SCALLOP_OK).periods, 1);
}

TEST(simulation_passes_failures_on)
{
  struct map m = map_of(linear, 3, 0);
  assert_true(isnan(simulated(&m, 1, 1e-9, SCALLOP_ERANGE).v_start)); /* runs away */
  m.status = SCALLOP_ECONVERGE;
  assert_true(isnan(simulated(&m, 1, 1e-9, SCALLOP_ECONVERGE).v_start));
  assert_true(isnan(simulated(&m, INFINITY, 1e-9, SCALLOP_EDOMAIN).v_start));
  assert_int_equal(m.calls, 0);
}

static struct scallop_integrator_steady rooted(struct map *m, double tolerance, enum scallop_status wanted)
{
  struct scallop_integrator_steady s = { .v_start = NAN };
  struct scallop_crawler c = unit_crawler();
  m->calls = 0;
  assert_int_equal(scallop_integrator_root(&m->integrator, &c, tolerance, NULL, &s), wanted);
  assert_int_equal(s.periods, wanted == SCALLOP_OK ? m->calls : 0);
  return s;
}

TEST(roots_of_maps)
{
  const double multipliers[] = { 0, 0.5, 1 - 1e-6 }, tolerances[] = { 1e-3, 1e-9, 0 };
  for (int i = 0; i < 3; i++)
    for (int k = 0; k < 3; k++) {
      struct map m = map_of(linear, multipliers[i], -0.385);
      struct scallop_integrator_steady s = rooted(&m, tolerances[k], SCALLOP_OK);
      CHECK_NEAR(s.v_start, -0.385, 1.385 * tolerances[k] + 4 * DBL_EPSILON / (1 - multipliers[i]));
      CHECK_EQUAL(s.displacement, 2 * s.v_start); /* of the period that starts there */
      assert_true(s.root_iterations > 0 && s.root_iterations < 20);
      assert_int_equal(s.steps, 3 * s.periods);
    }
  struct map m = map_of(linear, 0.5, 3.99); /* the fastest that l' goes against a centre of mass at rest is 4 */
  CHECK_NEAR(rooted(&m, 1e-9, SCALLOP_OK).v_start, 3.99, 5e-9);
  m = map_of(linear, 0.5, -3.99);
  CHECK_NEAR(rooted(&m, 1e-9, SCALLOP_OK).v_start, -3.99, 5e-9);
  m = map_of(noisy, 0.99, 0.731);
  CHECK_NEAR(rooted(&m, 0, SCALLOP_OK).v_start, 0.731, 2e-9 / (1 - 0.99));
  m = map_of(jumping, 0, 0.2);
  CHECK_NEAR(rooted(&m, 1e-12, SCALLOP_OK).v_start, 0.2, 1.2e-12);
}

/* A map that does not slow down what is too fast has no root that could be trusted. */
TEST(no_root)
{
  struct map m = map_of(escaping, 1, 0);
  assert_true(isnan(rooted(&m, 1e-9, SCALLOP_ECONVERGE).v_start));
  m = map_of(linear, 1, 0); /* nor one that changes nothing */
  assert_true(isnan(rooted(&m, 1e-9, SCALLOP_ECONVERGE).v_start));
  for (int side = -1; side <= 1; side += 2) {
    m = map_of(one_sided, 0, side);
    assert_true(isnan(rooted(&m, 1e-9, SCALLOP_ECONVERGE).v_start));
  }
  m = map_of(linear, 0.5, 4.1); /* nor one with a root beyond what anything can drive */
  assert_true(isnan(rooted(&m, 1e-9, SCALLOP_ECONVERGE).v_start));
  m.status = SCALLOP_ERANGE;
  assert_true(isnan(rooted(&m, 1e-9, SCALLOP_ERANGE).v_start));
}

static struct scallop_integrator *make(int stepper, double tolerance)
{
  return scallop_odeiv_integrator((enum scallop_odeiv_stepper)stepper, tolerance);
}

/* The map's error and the search's tolerance, over 1 - multiplier; once more for a multiplier that differs on the two
 * sides of the steady state. */
static void compare(const struct scallop_crawler *c, int stepper, double tolerance, double v0)
{
  INTEGRATOR(integrator, make(stepper, tolerance));
  struct scallop_steady_result exact = steady_of(c);
  double size = fastest_l(c) + fabs(exact.period.v_start);
  check_steady(integrator, c, v0, tolerance,
               (bound_of[stepper] + 2) * tolerance * size * 2 / (1 - exact.period.multiplier));
}

static void agrees_for(const struct scallop_gait *gait)
{
  struct random r = { 2718 };
  int regimes[3] = { 0 };
  worst_share = 0;
  for (int i = 0; i < CRAWLERS; i++) {
    struct scallop_crawler c = random_crawler(&r, i % 2 ? STICK_SLIP : EQUAL_FORCES, gait);
    set_eps(&c, i % 2 ? random_decades(&r, 1, 300) : random_decades(&r, 0.1, 1));
    c.F1 *= i % 4 ? 1 : 3;
    c.alpha = random_between(&r, 0.2, 0.8);
    struct scallop_steady_result exact = steady_of(&c);
    regimes[exact.period.regime]++;
    double v0 = random_start(&r, &c, SCALLOP_EXTENSION);
    for (int stepper = 0; stepper < STEPPERS; stepper++)
      compare(&c, stepper, i % 3 ? 1e-9 : 1e-6, v0);
  }
  print_message("%s: %d sliding, %d stick-slip, %d at rest; worst %.2g of the bound\n", gait->name, regimes[0],
                regimes[1], regimes[2], worst_share);
  for (int i = 0; i < 3; i++)
    assert_true(regimes[i] >= 3);
}

TEST(agrees_quadratic) { agrees_for(&scallop_gait_quadratic); }
TEST(agrees_sinusoidal) { agrees_for(&scallop_gait_sinusoidal); }

/* A body that has been stuck forgets how it began: the third period shows that nothing changes. */
TEST(forgets_at_once)
{
  struct scallop_crawler c = with_gait(&scallop_gait_sinusoidal);
  struct scallop_integrator_steady s;
  c.T = 6;
  struct scallop_steady_result exact = steady_of(&c);
  CHECK_EQUAL(exact.period.multiplier, 0);
  for (int stepper = 0; stepper < STEPPERS; stepper++) {
    INTEGRATOR(integrator, make(stepper, 1e-9));
    assert_int_equal(scallop_integrator_simulate(integrator, &c, 0.37, 1e-9, NULL, &s), SCALLOP_OK);
    assert_true(s.periods <= 3 && s.events > 0);
    compare(&c, stepper, 1e-9, 0.37);
  }
}

/* T = 1e-4: the change falls by 1e-9 of itself a period, and only patience ends that. */
TEST(patience_in_a_search)
{
  struct scallop_crawler c = scallop_crawler_default();
  INTEGRATOR(integrator, make(SCALLOP_ODEIV_RKF45, 1e-12));
  struct scallop_integrator_steady s;
  long left = 0;
  PATIENCE(patience, left);
  c.T = 1e-4;
  assert_int_equal(scallop_integrator_simulate(integrator, &c, 0.25, 1e-9, &patience, &s), SCALLOP_STOPPED);
  CHECK_EQUAL(s.v_start, 0.25);
  CHECK_EQUAL(s.displacement, NAN);
  assert_int_equal(s.periods, 0);
  left = 0;
  assert_int_equal(scallop_integrator_root(integrator, &c, 1e-9, &patience, &s), SCALLOP_STOPPED);
  CHECK_EQUAL(s.v_start, NAN);
  CHECK_EQUAL(s.displacement, NAN);
  left = 20000;
  assert_int_equal(scallop_integrator_simulate(integrator, &c, 0.25, 1e-9, &patience, &s), SCALLOP_STOPPED);
  assert_true(s.periods > 100 && s.v_start != 0.25 && isfinite(s.displacement));
  left = 60;
  assert_int_equal(scallop_integrator_root(integrator, &c, 1e-12, &patience, &s), SCALLOP_STOPPED);
  assert_true(s.periods > 2 && isfinite(s.v_start) && isfinite(s.displacement));
}

/* It ends a search also of an integrator that never asks. */
TEST(patience_between_periods)
{
  struct map m = map_of(linear, 1 - 1e-6, 0.2);
  struct scallop_crawler c = unit_crawler();
  struct scallop_integrator_steady s;
  long left = 11;
  PATIENCE(patience, left);
  assert_int_equal(scallop_integrator_simulate(&m.integrator, &c, 1, 1e-9, &patience, &s), SCALLOP_STOPPED);
  assert_int_equal(s.periods, 11);
  CHECK_NEAR(s.v_start, 1 - 11 * 0.8e-6, 1e-10);
  left = 3;
  assert_int_equal(scallop_integrator_root(&m.integrator, &c, 1e-9, &patience, &s), SCALLOP_STOPPED);
  assert_int_equal(s.periods, 3);
}

static void refused(const struct scallop_crawler *c, double v0, double tolerance, enum scallop_status wanted)
{
  INTEGRATOR(integrator, make(SCALLOP_ODEIV_RKF45, 1e-9));
  REFUSES(scallop_integrator_steady, scallop_integrator_simulate(integrator, c, v0, tolerance, NULL, &out), wanted);
  if (isfinite(v0))
    REFUSES(scallop_integrator_steady, scallop_integrator_root(integrator, c, tolerance, NULL, &out), wanted);
}

TEST(bad_input)
{
  const double bad_tolerances[] = { -1e-9, NAN, INFINITY };
  struct scallop_crawler good = scallop_crawler_default(), c = good;
  struct map m = map_of(linear, 0.5, 0);
  for (int i = 0; i < 3; i++)
    refused(&good, 1, bad_tolerances[i], SCALLOP_EDOMAIN);
  refused(&good, NAN, 1e-9, SCALLOP_EDOMAIN);
  refused(&good, -INFINITY, 1e-9, SCALLOP_EDOMAIN);
  c.alpha = 0;
  refused(&c, 1, 1e-9, SCALLOP_EDOMAIN);
  c = good;
  c.T = 1e-200;
  refused(&c, 1, 1e-9, SCALLOP_ERANGE);
  scallop_integrator_destroy(&m.integrator);
  assert_int_equal(m.calls, -1);
}

int main(void)
{
  gsl_set_error_handler_off();
  return check_run(NULL, NULL);
}
