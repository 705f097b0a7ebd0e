/* Results beyond the normal range of a double are refused, whichever of them it
 * is, and the same motion in moderate units is not. */
#include <float.h>

#include "numerics/integrators/integrator.h"
#include "tests/support/random_crawler.h"
#include "tests/support/solved.h"

/* In units of L/T, with eps = T^2 (F1 + F2)/(M L); m1 = m2 and F1 = 4 F2, L and
 * T as they come. */
static struct scallop_crawler crawler_in(double L, double T, double eps, double alpha)
{
  double friction = eps * (L / T) / T, M = friction < 1 ? 1e9 : 1; /* friction: (F1 + F2)/M */
  return (struct scallop_crawler){ M / 2, M / 2, 0.8 * M * friction,     0.2 * M * friction, L,
                                   T,     alpha, &scallop_gait_quadratic };
}

enum phase_number { V_END, DX1, DX2, DXC, T1, DT, PHASE_NUMBERS };
static const char *const phase_names[] = { "v_end", "dx1", "dx2", "dxC", "t1", "dT" };
static void take(double x[PHASE_NUMBERS], const struct scallop_phase_result *r)
{
  const double all[PHASE_NUMBERS] = { r->v_end, r->dx1, r->dx2, r->dxC, r->t1, r->dT };
  memcpy(x, all, sizeof all);
}

static bool in_range(double x) { return x == 0 || (fabs(x) >= DBL_MIN && fabs(x) <= DBL_MAX); }

/* Extensions of half a period. v0 in units of L/tau; of the numbers in their
 * order this is the first that is beyond the range. */
static const struct {
  double L, T, eps, v0;
  enum phase_number first;
} phases[] = {
  { 1e-307, 1, 0.5, 0, V_END },    { 1e308, 2e3, 0.5, 50, DX1 },  { 1e308, 2e3, 0.5, -50, DX1 },
  { 1e308, 2e3, 0.1, 1.45, DX2 },  { 1e-307, 1e-6, 0.1, 0, DXC }, { 1e-295, 2e-300, 0.5, 1e-9, T1 },
  { 1e-290, 2e-300, 1e-9, 0, DT },
};

TEST(one_phase)
{
  for (size_t i = 0; i < sizeof phases / sizeof *phases; i++) {
    struct scallop_crawler c = crawler_in(phases[i].L, phases[i].T, phases[i].eps, 0.5);
    struct scallop_crawler moderate = crawler_in(1, 2, phases[i].eps, 0.5);
    double x[PHASE_NUMBERS], tau = c.T / 2;
    REFUSES(scallop_phase_result, scallop_phase(&c, SCALLOP_EXTENSION, phases[i].v0 * (c.L / tau), &out),
            SCALLOP_ERANGE);
    struct scallop_phase_result r = phase_of(&moderate, SCALLOP_EXTENSION, phases[i].v0);
    take(x, &r);
    const double unit[PHASE_NUMBERS] = { c.L / tau, c.L, c.L, c.L, tau, tau };
    for (int q = 0; q <= (int)phases[i].first; q++)
      if (in_range(x[q] * unit[q]) != (q < (int)phases[i].first))
        fail_msg("%zu: %s = %g", i, phase_names[q], x[q] * unit[q]);
  }
}

static void check_integrators(const struct scallop_crawler *c, double v0)
{
  struct scallop_integrator *integrator[] = { scallop_odeiv_integrator(SCALLOP_ODEIV_RKF45, 1e-6),
                                              scallop_cvode_integrator(1e-6), scallop_smoothed_integrator(1e-2, 1e-6) };
  for (size_t i = 0; i < sizeof integrator / sizeof *integrator; i++)
    if (integrator[i]) {
      struct scallop_integrator_period p = { .v_end = 7 };
      assert_int_equal(integrator[i]->period(integrator[i], c, v0, NULL, &p), SCALLOP_ERANGE);
      CHECK_EQUAL(p.v_end, 7);
      scallop_integrator_destroy(integrator[i]);
    }
}

TEST(one_period)
{
  static const struct {
    double L, T, eps, v0;
    bool overflows;
  } periods[] = {
    { 1e-305, 1, 1e-3, 0, false }, /* v_mid, which is of the order of eps */
    { 1e-302, 1, 1e-4, 0, false }, /* v_end, which is of that of eps^2    */
    { 1e308, 1e3, 0.5, 50, true }, /* the displacement                    */
    { 1e308, 1e3, 0.5, -50, true },
  };
  for (size_t i = 0; i < sizeof periods / sizeof *periods; i++) {
    struct scallop_crawler c = crawler_in(periods[i].L, periods[i].T, periods[i].eps, 0.5);
    struct scallop_crawler moderate = crawler_in(1, 1, periods[i].eps, 0.5);
    double v0 = periods[i].v0 * (c.L / c.T);
    REFUSES(scallop_period_result, scallop_period(&c, v0, &out), SCALLOP_ERANGE);
    if (periods[i].overflows)
      check_integrators(&c, v0);
    struct scallop_period_result r = period_of(&moderate, periods[i].v0);
    assert_int_equal(in_range(r.v_mid * (c.L / c.T)), i != 0);
    assert_int_equal(in_range(r.v_mid * (c.L / c.T)) && in_range(r.v_end * (c.L / c.T)), i > 1);
  }
}

TEST(steady_states)
{
  static const struct {
    double L, T, eps, alpha;
  } states[] = {
    { 1, 1e154, 1e308, 0.75 },    /* the Froude number is 1e-308 */
    { 3e-308, 1, 1, 0.75 },       /* v_start                     */
    { 1e-304, 1, 31.9999, 0.25 }, /* v_mid: v_start is 0         */
    { 3e-308, 1e-10, 0.1, 0.75 }, /* the displacement            */
  };
  for (size_t i = 0; i < sizeof states / sizeof *states; i++) {
    struct scallop_crawler c = crawler_in(states[i].L, states[i].T, states[i].eps, states[i].alpha);
    REFUSES(scallop_steady_result, scallop_steady(&c, &out), SCALLOP_ERANGE);
    if (i > 0) {
      struct scallop_crawler moderate = crawler_in(1, 1, states[i].eps, states[i].alpha);
      struct scallop_steady_result r = steady_of(&moderate);
      double velocity = c.L / c.T;
      assert_int_equal(in_range(r.period.v_start * velocity), i != 1);
      assert_int_equal(in_range(r.period.v_start * velocity) && in_range(r.period.v_mid * velocity), i > 2);
    }
  }
}

struct last_sample {
  long count;
  struct scallop_sample sample;
};
static bool keep(void *context, const struct scallop_sample *sample)
{
  struct last_sample *last = context;
  last->count++;
  last->sample = *sample;
  return isfinite(sample->t) && isfinite(sample->x1) && isfinite(sample->x2) && isfinite(sample->v1)
         && isfinite(sample->v2);
}

/* v0 in units of L/T. Whichever number of the next sample would overflow, those
 * before it are given. */
static const struct {
  double L, T, eps, v0;
} motions[] = { { 1e308, 1e3, 0.5, -1 },  { 1e308, 1e3, 0.5, 1 },  { 1e308, 1e3, 1e-3, 0.5 },
                { 8e307, 1, 0.01, -0.5 }, { 8e307, 1, 0.01, 0.5 }, { 1e10, 1e308, 1e300, 0 } };

TEST(trajectories)
{
  for (size_t i = 0; i < sizeof motions / sizeof *motions; i++) {
    struct scallop_crawler c = crawler_in(motions[i].L, motions[i].T, motions[i].eps, 0.5);
    struct last_sample last = { 0 };
    assert_int_equal(scallop_trajectory(&c, motions[i].v0 * (c.L / c.T), 10, 64, keep, &last), SCALLOP_ERANGE);
    assert_true(last.count > 1 && last.count < 10 * 64);
    assert_true(keep(&(struct last_sample){ 0 }, &last.sample));
  }
}

TEST(smoothed_phases)
{
  enum { TIMES = 50 };
  static const double v0[] = { -50, 50, 1.45, -0.5, 0.5 };
  struct scallop_integrator *integrator = scallop_smoothed_integrator(1e-2, 1e-6);
  assert_non_null(integrator);
  for (int i = 0; i < 5; i++) {
    bool fast = i >= 3; /* velocities overflow, and not positions */
    struct scallop_crawler c = crawler_in(fast ? 8e307 : 1e308, fast ? 1 : 2e3, fast ? 0.01 : 0.1, 0.5);
    struct scallop_sample samples[TIMES];
    double unit = fast ? c.L / c.T : 2 * (c.L / c.T);
    for (int k = 0; k < TIMES; k++)
      samples[k] = (struct scallop_sample){ .t = k * (c.T / 2) / TIMES, .x1 = NAN };
    assert_int_equal(scallop_smoothed_phase(integrator, &c, SCALLOP_EXTENSION, v0[i] * unit, NULL, samples, TIMES),
                     SCALLOP_ERANGE);
    struct last_sample last = { 0 };
    while (last.count < TIMES && !isnan(samples[last.count].x1))
      assert_true(keep(&last, &samples[last.count]));
    assert_true(last.count > 0 && last.count < TIMES);
  }
  scallop_integrator_destroy(integrator);
}

/* The bracket of the root, 1.01 times the largest velocity of a body, is beyond
 * the range. */
TEST(a_root_beyond)
{
  struct scallop_integrator *integrator = scallop_odeiv_integrator(SCALLOP_ODEIV_RKF45, 1e-6);
  assert_non_null(integrator);
  for (int lopsided = 0; lopsided < 2; lopsided++) { /* then forward only */
    struct scallop_crawler c = crawler_in(lopsided ? 5e307 : 8.95e307, 1, 0.01, lopsided ? 0.3 : 0.5);
    struct scallop_integrator_steady steady = { .v_start = 7 };
    c.m1 = lopsided ? c.m2 / 9 : c.m1;
    assert_int_equal(scallop_integrator_root(integrator, &c, 1e-6, NULL, &steady), SCALLOP_ERANGE);
    CHECK_EQUAL(steady.v_start, 7);
  }
  scallop_integrator_destroy(integrator);
}
