/* The general-purpose rival against the exact solver. They share the model and nothing else, so each
 * checks the other: over seeded crawlers of every regime they agree to the rival's tolerance.
 *
 * The bound: bound_of[stepper] tolerance (L/(T min(alpha, 1 - alpha)) + |v|) for velocities, and T times that for the
 * displacement. Friction never lets an error in velocity grow (the multiplier is at most 1), so the errors of the steps
 * add up and no more; Adams's method takes the more of them. The largest share of the bound that was seen is printed. */
#include "tests/check.h"

#include <float.h>

#include "numerics/numerics.h"
#include "numerics/odeiv.h"
#include "tests/random_crawler.h"

enum { CRAWLERS = 200, EXTREMES = 2000, STEPPERS = 3, EACH = 40 };
static const double bound_of[STEPPERS] = { 32, 32, 512 };

static uint64_t seed;

static double uniform(double low, double high) /* splitmix64 */
{
  uint64_t z = seed += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return low + (high - low) * (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

static double spread(double low, double high) { return exp(uniform(log(low), log(high))); }

/* Both orders of the forces and of the masses, both signs of 2 alpha - 1, eps from 1e-3 to 1e3. */
static struct scallop_crawler any_crawler(const char *gait)
{
  struct scallop_crawler c = { .m1 = spread(0.2, 5),
                               .m2 = spread(0.2, 5),
                               .F1 = spread(0.2, 5),
                               .F2 = spread(0.2, 5),
                               .L = spread(0.01, 100),
                               .alpha = uniform(0.05, 0.95),
                               .gait = scallop_gait_named(gait) };
  c.T = sqrt(spread(1e-3, 1e3) * (c.m1 + c.m2) * c.L / (c.F1 + c.F2));
  return c;
}

/* From rest, anything, the steady velocity, and that the wrong way round. */
static double any_start(const struct scallop_crawler *c, int i)
{
  struct scallop_steady_result steady;
  if (i % 4 == 0)
    return 0;
  if (i % 4 == 1)
    return uniform(-2, 2) * c->L / c->T;
  assert_true(scallop_steady(c, &steady) >= 0);
  return i % 4 == 2 ? steady.period.v_start : -steady.period.v_start;
}

static double worst_share;

static void check_share(double got, double wanted, double tolerance)
{
  worst_share = fmax(worst_share, fabs(got - wanted) / tolerance);
  CHECK_NEAR(got, wanted, tolerance);
}

static void compare(const struct scallop_crawler *c, double v0, const struct scallop_period_result *exact,
                    enum scallop_odeiv_stepper stepper, double tolerance)
{
  struct scallop_rival_period r;
  double unit = c->L / (c->T * fmin(c->alpha, 1 - c->alpha)), bound = bound_of[stepper] * tolerance;
  assert_int_equal(scallop_odeiv_period(c, v0, stepper, tolerance, &r), SCALLOP_OK);
  check_share(r.v_mid, exact->v_mid, bound * (unit + fabs(exact->v_mid)));
  check_share(r.v_end, exact->v_end, bound * (unit + fabs(exact->v_end)));
  check_share(r.displacement, exact->displacement, bound * c->T * (unit + fabs(v0)));
  assert_true(r.steps >= 0 && r.evaluations >= r.steps && r.events >= 0);
}

/* Every regime and both directions of travel must have been among the crawlers. */
static void agrees_for(const char *gait)
{
  int regimes[3] = { 0 }, backward = 0, reversed = 0;
  seed = 20130311;
  worst_share = 0;
  for (int i = 0; i < CRAWLERS; i++) {
    struct scallop_crawler c = any_crawler(gait);
    struct scallop_period_result exact;
    double v0 = any_start(&c, i);
    assert_int_equal(scallop_period(&c, v0, &exact), SCALLOP_OK);
    for (int digits = 6; digits <= 12; digits += 3)
      for (int stepper = SCALLOP_ODEIV_RKF45; stepper <= SCALLOP_ODEIV_MSADAMS; stepper++)
        compare(&c, v0, &exact, (enum scallop_odeiv_stepper)stepper, pow(10, -digits));
    regimes[exact.regime]++;
    backward += exact.displacement < 0;
    reversed += v0 * exact.v_end < 0;
  }
  print_message("%s: %d sliding, %d stick-slip, %d at rest; %d backward, %d turned round\n", gait, regimes[0], regimes[1],
                regimes[2], backward, reversed);
  print_message("%s: worst %.2g of the bound\n", gait, worst_share);
  for (int i = 0; i < 3; i++)
    assert_true(regimes[i] >= 10);
  assert_true(backward >= 20 && reversed >= 10);
}

TEST(agrees_quadratic) { agrees_for("quadratic"); }
TEST(agrees_sinusoidal) { agrees_for("sinusoidal"); }

/* Gaits with plateaus, with l'' = 0 at both ends of a phase and with a jump of l', and crawlers of every family. */
TEST(other_gaits)
{
  struct random r = { 1311 };
  struct scallop_rival_period p;
  long events[STEPPERS] = { 0 };
  worst_share = 0;
  for (int family = 0; family < FAMILIES; family++)
    for (int i = 0; i < EACH * ALL_GAITS; i++) {
      struct scallop_crawler c = random_crawler(&r, (enum family)family, every_gait[i % ALL_GAITS]);
      double v0 = random_start(&r, &c, SCALLOP_EXTENSION);
      struct scallop_period_result exact;
      assert_int_equal(scallop_period(&c, v0, &exact), SCALLOP_OK);
      for (int stepper = 0; stepper < STEPPERS; stepper++) {
        compare(&c, v0, &exact, (enum scallop_odeiv_stepper)stepper, 1e-8);
        assert_int_equal(scallop_odeiv_period(&c, v0, (enum scallop_odeiv_stepper)stepper, 1e-8, &p), SCALLOP_OK);
        events[stepper] += p.events;
      }
    }
  /* what the steps of Adams's method are off by must not look like a body that stops again and again */
  CHECK_NEAR((double)events[SCALLOP_ODEIV_RKF45], (double)events[SCALLOP_ODEIV_RK8PD], 0.01 * (double)events[0]);
  CHECK_NEAR((double)events[SCALLOP_ODEIV_MSADAMS], (double)events[SCALLOP_ODEIV_RK8PD], 0.01 * (double)events[0]);
  print_message("other gaits: worst %.2g of the bound\n", worst_share);
}

/* Both at rest where l'' = 0, with equal forces: friction could hold either, but l' is about to part them, and then neither can
 * hold the other. */
TEST(parted_from_rest)
{
  struct scallop_crawler c = { 3.2, 0.28, 0.024, 0.024, 12.6, 1.45, 0.4, &minimum_jerk_gait };
  struct scallop_rival_period r;
  for (int stepper = 0; stepper < STEPPERS; stepper++) {
    assert_int_equal(scallop_odeiv_period(&c, 0, (enum scallop_odeiv_stepper)stepper, 1e-10, &r), SCALLOP_OK);
    CHECK_NEAR(r.v_mid, 0, bound_of[stepper] * 1e-10 * c.L / (c.T * c.alpha));
    CHECK_NEAR(r.v_end, 0, bound_of[stepper] * 1e-10 * c.L / (c.T * c.alpha));
  }
}

/* No tolerance bounds the error from below: tightening it must pay. */
TEST(tolerance_controls_error)
{
  const double tolerance[] = { 1e-4, 1e-8, 1e-12 };
  double error[STEPPERS][3];
  struct scallop_crawler c = scallop_crawler_default();
  struct scallop_period_result exact;
  struct scallop_rival_period r;
  c.gait = &scallop_gait_sinusoidal;
  assert_int_equal(scallop_period(&c, 1.317, &exact), SCALLOP_OK);
  for (int stepper = 0; stepper < STEPPERS; stepper++) {
    for (int i = 0; i < 3; i++) {
      assert_int_equal(scallop_odeiv_period(&c, 1.317, (enum scallop_odeiv_stepper)stepper, tolerance[i], &r), SCALLOP_OK);
      error[stepper][i] = fabs(r.v_end - exact.v_end);
    }
    CHECK_AT_MOST(error[stepper][1], 1e-2 * error[stepper][0]);
    CHECK_AT_MOST(error[stepper][2], 1e-2 * error[stepper][1]);
  }
}

/* Body 1 comes to zero and is off again within one step, which begins and ends with it moving forward:
 * only a look inside the step can tell. */
TEST(dip_within_a_step)
{
  struct scallop_crawler c = { 1, 1, 1, 1, 1, 2, 0.5, &scallop_gait_sinusoidal };
  struct scallop_period_result exact;
  char modes[SCALLOP_MODES_TEXT];
  assert_int_equal(scallop_period(&c, 1.32, &exact), SCALLOP_OK);
  scallop_modes_text(&exact.modes[0], modes);
  assert_string_equal(modes, "++ 0+ ++");
  for (int digits = 4; digits <= 8; digits++) {
    compare(&c, 1.32, &exact, SCALLOP_ODEIV_RKF45, pow(10, -digits));
    compare(&c, 1.32, &exact, SCALLOP_ODEIV_RK8PD, pow(10, -digits));
    compare(&c, 1.32, &exact, SCALLOP_ODEIV_MSADAMS, pow(10, -digits));
  }
}

/* One body 1e17 times lighter: its acceleration cannot be had as a difference from the other's, or
 * locating its events takes over a hundred steps. A crawler from a random search. */
TEST(light_body)
{
  struct scallop_crawler c = { .m1 = 330326390.34026927,
                               .m2 = 1.1252853324524996e-09,
                               .F1 = 234226.26838151389,
                               .F2 = 280.42533842860473,
                               .L = 1,
                               .T = 92.04635526320547,
                               .alpha = 0.78442465681124307,
                               .gait = &scallop_gait_sinusoidal };
  const double v0 = -0.02662866572576535;
  struct scallop_period_result exact;
  struct scallop_rival_period r;
  assert_int_equal(scallop_period(&c, v0, &exact), SCALLOP_OK);
  for (int stepper = SCALLOP_ODEIV_RKF45; stepper <= SCALLOP_ODEIV_MSADAMS; stepper++) {
    compare(&c, v0, &exact, (enum scallop_odeiv_stepper)stepper, 1e-9);
    assert_int_equal(scallop_odeiv_period(&c, v0, (enum scallop_odeiv_stepper)stepper, 1e-9, &r), SCALLOP_OK);
    assert_true(r.steps < (stepper == SCALLOP_ODEIV_MSADAMS ? 500 : 50));
  }
}

/* Friction far above what the gait asks for: one body never moves, and the other returns. */
TEST(at_rest)
{
  for (int i = 0; scallop_gait_name(i); i++)
    for (int heavy = 1; heavy <= 2; heavy++) {
      struct scallop_crawler c = scallop_crawler_default();
      struct scallop_rival_period r;
      c.gait = scallop_gait_named(scallop_gait_name(i));
      c.F1 = heavy == 1 ? 4e5 : 1e3;
      c.F2 = heavy == 1 ? 1e3 : 4e5;
      assert_int_equal(scallop_odeiv_period(&c, 0, SCALLOP_ODEIV_RK8PD, 1e-10, &r), SCALLOP_OK);
      CHECK_NEAR(r.displacement, 0, 4 * DBL_EPSILON * c.L);
      CHECK_EQUAL(r.v_end, 0);
      assert_int_equal(r.evaluations, 0); /* a stuck body needs no integration */
    }
}

/* Lengths, times and forces in other units: powers of two, so every digit must stay. */
TEST(any_units)
{
  struct scallop_rival_period a, b;
  struct scallop_crawler c = scallop_crawler_default(), d;
  const double length = 0x1p200, time = 0x1p-150, mass = 0x1p-300;
  c.gait = &scallop_gait_sinusoidal;
  const double force = mass * length / time / time;
  d = (struct scallop_crawler){ c.m1 * mass,  c.m2 * mass, c.F1 * force, c.F2 * force,
                                c.L * length, c.T * time,  c.alpha,      c.gait };
  double v0 = 0.731, v0_there = v0 * length / time;
  assert_int_equal(scallop_odeiv_period(&c, v0, SCALLOP_ODEIV_RKF45, 1e-9, &a), SCALLOP_OK);
  assert_int_equal(scallop_odeiv_period(&d, v0_there, SCALLOP_ODEIV_RKF45, 1e-9, &b), SCALLOP_OK);
  CHECK_EQUAL(b.v_mid, a.v_mid * length / time);
  CHECK_EQUAL(b.v_end, a.v_end * length / time);
  CHECK_EQUAL(b.displacement, a.displacement * length);
}

/* A workspace used before gives what a new one gives. */
TEST(workspace_forgets)
{
  struct scallop_crawler c = scallop_crawler_default(), other;
  c.gait = &scallop_gait_sinusoidal;
  other = c;
  other.T = 37;
  for (int k = 0; k < STEPPERS; k++) {
    enum scallop_odeiv_stepper stepper = (enum scallop_odeiv_stepper)k;
    struct scallop_odeiv *odeiv = scallop_odeiv_make(stepper);
    struct scallop_rival_period first, again;
    assert_non_null(odeiv);
    assert_int_equal(scallop_odeiv_period(&c, 2.385, stepper, 1e-11, &first), SCALLOP_OK);
    assert_int_equal(scallop_odeiv_run(odeiv, &other, -3.1, 1e-5, &again), SCALLOP_OK);
    assert_int_equal(scallop_odeiv_run(odeiv, &c, 2.385, 1e-11, &again), SCALLOP_OK);
    CHECK_EQUAL(again.v_end, first.v_end);
    CHECK_EQUAL(again.displacement, first.displacement);
    assert_int_equal(again.evaluations, first.evaluations);
    assert_int_equal(again.steps, first.steps);
    scallop_odeiv_destroy(odeiv);
  }
}

static void refused(const struct scallop_crawler *c, double v0, int stepper, double tolerance, enum scallop_status wanted)
{
  struct scallop_rival_period r, before;
  memset(&r, 0x5a, sizeof r);
  before = r;
  assert_int_equal(scallop_odeiv_period(c, v0, (enum scallop_odeiv_stepper)stepper, tolerance, &r), wanted);
  assert_memory_equal(&r, &before, sizeof r);
}

TEST(bad_input)
{
  const double bad_tolerances[] = { 0, -1e-9, 0.1001, 1, 2e-16, NAN, INFINITY };
  struct scallop_crawler good = scallop_crawler_default(), c = good;
  for (size_t i = 0; i < sizeof bad_tolerances / sizeof *bad_tolerances; i++)
    refused(&good, 1, SCALLOP_ODEIV_RKF45, bad_tolerances[i], SCALLOP_EDOMAIN);
  refused(&good, NAN, SCALLOP_ODEIV_RKF45, 1e-9, SCALLOP_EDOMAIN);
  refused(&good, -INFINITY, SCALLOP_ODEIV_RK8PD, 1e-9, SCALLOP_EDOMAIN);
  refused(&good, 1, 3, 1e-9, SCALLOP_EDOMAIN);
  refused(&good, 1, -1, 1e-9, SCALLOP_EDOMAIN);
  assert_null(scallop_odeiv_make((enum scallop_odeiv_stepper)3));
  scallop_odeiv_destroy(NULL);
  c.alpha = 1;
  refused(&c, 1, SCALLOP_ODEIV_RKF45, 1e-9, SCALLOP_EDOMAIN);
  c = good;
  c.gait = NULL;
  refused(&c, 1, SCALLOP_ODEIV_RKF45, 1e-9, SCALLOP_EDOMAIN);
  c = good;
  c.T = 1e-200; /* eps underflows */
  refused(&c, 1, SCALLOP_ODEIV_RKF45, 1e-9, SCALLOP_ERANGE);
  refused(&good, 5e-324, SCALLOP_ODEIV_RKF45, 1e-9, SCALLOP_ERANGE);
}

/* A gait that breaks its promise to be smooth: no step across the jump is short enough. */
static double rough_acceleration(const struct scallop_piece *p, double u)
{
  (void)p;
  return u < 1 / 3.0 ? 1 : 1e20;
}

/* Or to be monotone: no end of steps. */
static double restless_acceleration(const struct scallop_piece *p, double u)
{
  (void)p;
  return 1e6 * sin(1e8 * u);
}

TEST(no_convergence)
{
  const struct scallop_curve *linear = &scallop_curve_linear;
  struct scallop_curve curve = { linear->length, linear->velocity, rough_acceleration, linear->when, NULL };
  const struct scallop_piece piece = { .begin = 0, .end = 1, .direction = 1, .velocity = 1, .curve = &curve };
  const struct scallop_shape shape = { .pieces = &piece, .count = 1, .l0 = 1, .lT = -1, .peak = 1, .net = 1 };
  const struct scallop_gait gait = { "rough", { shape, shape } };
  struct scallop_crawler c = scallop_crawler_default();
  c.gait = &gait;
  for (int stepper = 0; stepper < STEPPERS; stepper++)
    refused(&c, 100, stepper, 1e-9, SCALLOP_ECONVERGE);
  curve.acceleration = restless_acceleration;
  refused(&c, 100, SCALLOP_ODEIV_RKF45, 1e-9, SCALLOP_ECONVERGE);
}

/* Whatever the crawler, there is an answer that agrees or a status, and never an endless run. */
TEST(extremes_end)
{
  seed = 1736;
  worst_share = 0;
  for (int i = 0; i < EXTREMES; i++) {
    struct scallop_crawler c = { .m1 = spread(1e-9, 1e9),
                                 .m2 = spread(1e-9, 1e9),
                                 .F1 = spread(1e-9, 1e9),
                                 .F2 = spread(1e-9, 1e9),
                                 .L = 1,
                                 .T = spread(1e-12, 1e12),
                                 .alpha = i % 3 ? uniform(0, 1) : spread(1e-9, 1e-3),
                                 .gait = scallop_gait_named(scallop_gait_name(i % 2)) };
    double v0 = i % 5 ? uniform(-1, 1) * spread(1e-9, 1e9) / c.T : 0;
    struct scallop_period_result exact;
    assert_int_equal(scallop_period(&c, v0, &exact), SCALLOP_OK);
    compare(&c, v0, &exact, (enum scallop_odeiv_stepper)(i / 6 % STEPPERS), 1e-8);
  }
  print_message("extremes: worst %.2g of the bound\n", worst_share);
}
