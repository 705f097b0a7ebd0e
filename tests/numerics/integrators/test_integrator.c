/* Steady states by simulation and as the root of a period map, on maps whose answer is known. On integrators, beside
 * the exact solver: test_all_integrators.c. */
#include <limits.h>

#include <gsl/gsl_errno.h>

#include "tests/support/integrators.h"

/* A map whose answer is known, in units where L/T = 1 */
struct map {
  struct scallop_integrator integrator;
  double (*value)(struct map *map, double v);
  double multiplier, fixed;
  enum scallop_status status;
  long calls;
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

static const struct scallop_crawler unit_crawler = { 1, 1, 4, 1, 1, 1, 0.75, &scallop_gait_quadratic };

static double linear(struct map *m, double v) { return m->fixed + m->multiplier * (v - m->fixed); }

/* Friction alone, and then what the multiplier says. A change that stays the same is no reason to end, nor to believe
 * the end is near. */
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
static double giving_up(struct map *m, double v) { return m->status = SCALLOP_ECONVERGE, v; }

enum how { SIMULATED, ROOT };
static struct scallop_integrator_steady steady(struct map *m, enum how how, double v0, double tolerance,
                                               enum scallop_status wanted)
{
  const struct scallop_crawler *c = &unit_crawler;
  struct scallop_integrator_steady s = { .v_start = NAN };
  m->calls = 0;
  assert_int_equal(how == ROOT ? scallop_integrator_root(&m->integrator, c, tolerance, NULL, &s)
                               : scallop_integrator_simulate(&m->integrator, c, v0, tolerance, NULL, &s),
                   wanted);
  assert_int_equal(s.periods, wanted == SCALLOP_OK ? m->calls : 0);
  if (wanted == SCALLOP_OK) {
    assert_true(s.steps == 3 * s.periods && s.evaluations == 5 * s.periods && s.events == 7 * s.periods);
    assert_true(how == ROOT ? s.root_iterations > 0 && s.root_iterations < 100 : s.root_iterations == 0);
  }
  return s;
}

/* To the tolerance; by simulation after few more periods than the change needs to fall to it. */
TEST(slow_maps)
{
  const double multipliers[] = { 0, 3e-3, 0.5, 0.99, 0.9999, 1 - 1e-6 }, tolerances[] = { 1e-3, 1e-6, 1e-9, 0 };
  for (int i = 0; i < 6; i++)
    for (int k = 0; k < 4; k++) {
      struct map m = map_of(linear, multipliers[i], -0.385);
      struct scallop_integrator_steady s = steady(&m, ROOT, NAN, tolerances[k], SCALLOP_OK);
      CHECK_NEAR(s.v_start, -0.385, 1.385 * tolerances[k] + 4 * DBL_EPSILON / (1 - multipliers[i]));
      CHECK_EQUAL(s.displacement, 2 * s.v_start); /* of the period that starts there */
      assert_true(s.root_iterations < 20);
      if (k == 3)
        continue;
      s = steady(&m, SIMULATED, 1.7, tolerances[k], SCALLOP_OK);
      CHECK_NEAR(s.v_start, -0.385, 1.385 * tolerances[k]);
      CHECK_NEAR(s.displacement, 2 * -0.385, 4 * 1.385 * tolerances[k]); /* of a period that began as near */
      /* of none the third shows that nothing changes */
      CHECK_AT_MOST((double)s.periods, i == 0 ? 3 : 4 + 1.2 * log(tolerances[k]) / log(multipliers[i]));
    }
}

/* Where the search ends, at most `within` off, with at least and at most so many periods; or how it fails. With a
 * tolerance that the noise of the map does not allow a simulation ends where the noise does. A map that does not slow
 * down what is too fast has no root that could be trusted, nor has one that changes nothing, or whose root is beyond
 * what anything can drive: 4 is the fastest that l' goes against a centre of mass at rest. */
#define FAILS(wanted) NAN, 0, 0, 0, wanted
static const struct search {
  const char *what;
  enum how how;
  double (*value)(struct map *map, double v);
  double multiplier, fixed, v0, tolerance, end, within;
  long least, most;
  enum scallop_status wanted;
} searches[] = {
  { "rounding leaves none of 1 - m", SIMULATED, rounded, 1 - 1e-6, -0.385, -0.385 + 1e-7, 1e-9, -0.385, 1.385e-9, 0,
    LONG_MAX, SCALLOP_OK },
  { "braked", SIMULATED, braked, 0.9, 0.25, 20, 1e-8, 0.25, 1.25e-8, 19001, LONG_MAX, SCALLOP_OK },
  { "noise", SIMULATED, noisy, 0.5, 0.731, -1, 0, 0.731, 8e-9, 0, 120, SCALLOP_OK },
  { "noise", SIMULATED, noisy, 0.5, 0.731, -1, 1e-13, 0.731, 8e-9, 0, 120, SCALLOP_OK },
  { "noise", SIMULATED, noisy, 0.99, 0.731, -1, 0, 0.731, 4e-7, 0, 6000, SCALLOP_OK },
  { "noise", SIMULATED, noisy, 0.99, 0.731, -1, 1e-13, 0.731, 4e-7, 0, 6000, SCALLOP_OK },
  { "noise", SIMULATED, noisy, 0.9999, 0.731, -1, 0, 0.731, 4e-5, 0, 600000, SCALLOP_OK },
  { "noise", SIMULATED, noisy, 0.9999, 0.731, -1, 1e-13, 0.731, 4e-5, 0, 600000, SCALLOP_OK },
  { "to and fro", SIMULATED, jumping, 0, 0.2, 0.20001, 1e-9, 0.2, 3e-6, 0, 100, SCALLOP_OK },
  { "a cycle at last", SIMULATED, ending_in_a_cycle, 0, 0.4, 1.003, 1e-9, 0.405, 0.0051, 0, 100, SCALLOP_OK },
  { "gives back what it is given", SIMULATED, linear, 1, 0, 0.3, 1e-9, 0.3, 0, 1, 1, SCALLOP_OK },
  { "runs away", SIMULATED, linear, 3, 0, 1, 1e-9, FAILS(SCALLOP_ERANGE) },
  { "gives up", SIMULATED, giving_up, 0, 0, 1, 1e-9, FAILS(SCALLOP_ECONVERGE) },
  { "no start", SIMULATED, linear, 3, 0, INFINITY, 1e-9, FAILS(SCALLOP_EDOMAIN) },
  { "fast", ROOT, linear, 0.5, 3.99, 0, 1e-9, 3.99, 5e-9, 0, LONG_MAX, SCALLOP_OK },
  { "fast backward", ROOT, linear, 0.5, -3.99, 0, 1e-9, -3.99, 5e-9, 0, LONG_MAX, SCALLOP_OK },
  { "noise", ROOT, noisy, 0.99, 0.731, 0, 0, 0.731, 2e-7, 0, LONG_MAX, SCALLOP_OK },
  { "a jump", ROOT, jumping, 0, 0.2, 0, 1e-12, 0.2, 1.2e-12, 0, LONG_MAX, SCALLOP_OK },
  { "not slowed down", ROOT, escaping, 1, 0, 0, 1e-9, FAILS(SCALLOP_ECONVERGE) },
  { "nothing changes", ROOT, linear, 1, 0, 0, 1e-9, FAILS(SCALLOP_ECONVERGE) },
  { "slowed down forward only", ROOT, one_sided, 0, -1, 0, 1e-9, FAILS(SCALLOP_ECONVERGE) },
  { "slowed down backward only", ROOT, one_sided, 0, 1, 0, 1e-9, FAILS(SCALLOP_ECONVERGE) },
  { "a root beyond", ROOT, linear, 0.5, 4.1, 0, 1e-9, FAILS(SCALLOP_ECONVERGE) },
  { "gives up", ROOT, giving_up, 0, 0, 0, 1e-9, FAILS(SCALLOP_ECONVERGE) },
};

TEST(known_ends)
{
  for (const struct search *k = searches; k < searches + sizeof searches / sizeof *searches; k++) {
    struct map m = map_of(k->value, k->multiplier, k->fixed);
    struct scallop_integrator_steady s = steady(&m, k->how, k->v0, k->tolerance, k->wanted);
    bool as_known = k->wanted == SCALLOP_OK
                        ? fabs(s.v_start - k->end) <= k->within && s.periods >= k->least && s.periods <= k->most
                        : isnan(s.v_start) && (m.calls > 0) == isfinite(k->v0);
    if (!as_known)
      fail_msg("%s, multiplier %g: ended at %.17g after %ld periods", k->what, k->multiplier, s.v_start, s.periods);
  }
}

/* T = 1e-4: the change falls by 1e-9 of itself a period, and only patience ends that. It ends a search also of a map,
 * which never asks. The first of the limits ends the search within its first period: nothing is known. */
TEST(patience_in_a_search)
{
  struct scallop_crawler c = scallop_crawler_default();
  struct map m = map_of(linear, 1 - 1e-6, 0.2);
  struct scallop_integrator_steady s;
  INTEGRATOR(integrator, scallop_odeiv_integrator(SCALLOP_ODEIV_RKF45, 1e-12));
  c.T = 1e-4;
  for (int how = SIMULATED; how <= ROOT; how++)
    for (int begun = 0; begun < 2; begun++) {
      long left = begun == 0 ? 0 : how == ROOT ? 60 : 20000;
      PATIENCE(patience, left);
      assert_int_equal(how == ROOT ? scallop_integrator_root(integrator, &c, 1e-12, &patience, &s)
                                   : scallop_integrator_simulate(integrator, &c, 0.25, 1e-9, &patience, &s),
                       SCALLOP_STOPPED);
      assert_true(begun ? s.periods > (how == ROOT ? 2 : 100) : s.periods == 0);
      assert_int_equal(isfinite(s.displacement), begun);
      assert_int_equal(isfinite(s.v_start) && s.v_start != 0.25, begun);
      assert_int_equal(isfinite(s.v_start), begun || how == SIMULATED);
    }
  long left = 11;
  PATIENCE(patience, left);
  assert_int_equal(scallop_integrator_simulate(&m.integrator, &unit_crawler, 1, 1e-9, &patience, &s), SCALLOP_STOPPED);
  assert_int_equal(s.periods, 11);
  CHECK_NEAR(s.v_start, 1 - 11 * 0.8e-6, 1e-10);
  left = 3;
  assert_int_equal(scallop_integrator_root(&m.integrator, &unit_crawler, 1e-9, &patience, &s), SCALLOP_STOPPED);
  assert_int_equal(s.periods, 3);
}

#define UNIT 1, 1, 4, 1, 1
#define LONG(L) 0.008 * (L), 0.002 * (L), L, 1 /* eps = 0.01; the bracket, 1.01 times the fastest, is out of range */
static const struct refused {
  struct scallop_crawler crawler;
  double v0, tolerance;
  bool simulated, root;
  enum scallop_status wanted;
} refused[] = {
  { { UNIT, 1, 0.75, &scallop_gait_quadratic }, 1, -1e-9, true, true, SCALLOP_EDOMAIN },
  { { UNIT, 1, 0.75, &scallop_gait_quadratic }, 1, NAN, true, true, SCALLOP_EDOMAIN },
  { { UNIT, 1, 0.75, &scallop_gait_quadratic }, 1, INFINITY, true, true, SCALLOP_EDOMAIN },
  { { UNIT, 1, 0.75, &scallop_gait_quadratic }, NAN, 1e-9, true, false, SCALLOP_EDOMAIN },
  { { UNIT, 1, 0.75, &scallop_gait_quadratic }, -INFINITY, 1e-9, true, false, SCALLOP_EDOMAIN },
  { { UNIT, 1, 0, &scallop_gait_quadratic }, 1, 1e-9, true, true, SCALLOP_EDOMAIN },
  { { UNIT, 1e-200, 0.75, &scallop_gait_quadratic }, 1, 1e-9, true, true, SCALLOP_ERANGE },
  { { 0.5, 0.5, LONG(8.95e307), 0.5, &scallop_gait_quadratic }, 0, 1e-6, false, true, SCALLOP_ERANGE },
  { { 0.5 / 9, 0.5, LONG(5e307), 0.3, &scallop_gait_quadratic }, 0, 1e-6, false, true, SCALLOP_ERANGE }, /* forward */
};

TEST(bad_input)
{
  struct map m = map_of(linear, 0.5, 0);
  for (const struct refused *r = refused; r < refused + sizeof refused / sizeof *refused; r++) {
    INTEGRATOR(i, scallop_odeiv_integrator(SCALLOP_ODEIV_RKF45, 1e-9));
    if (r->simulated)
      REFUSES(scallop_integrator_steady, scallop_integrator_simulate(i, &r->crawler, r->v0, r->tolerance, NULL, &out),
              r->wanted);
    if (r->root)
      REFUSES(scallop_integrator_steady, scallop_integrator_root(i, &r->crawler, r->tolerance, NULL, &out), r->wanted);
  }
  scallop_integrator_destroy(&m.integrator);
  assert_int_equal(m.calls, -1);
}

int main(void)
{
  gsl_set_error_handler_off();
  return check_run(NULL, NULL);
}
