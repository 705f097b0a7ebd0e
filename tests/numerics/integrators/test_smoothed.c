/* Friction smoothed and integrated by a stiff solver, against the exact period. What smoothing does is measured with a
 * tolerance far below delta: an error at most proportional to delta, but for a logarithm in stick-slip, that falls
 * with every decade of delta for every crawler. What the solver does is measured at one delta, against the tightest
 * tolerance. */
#include <gsl/gsl_errno.h>

#include "tests/support/integrators.h"

enum { CRAWLERS = 40, DECADES = 5 };

static struct scallop_integrator_period smoothed(const struct scallop_crawler *c, double v0, double delta,
                                                 double tolerance)
{
  INTEGRATOR(integrator, scallop_smoothed_integrator(delta, tolerance));
  struct scallop_integrator_period p = integrator_period(integrator, c, v0);
  assert_true(p.steps > 0 && p.evaluations > p.steps && p.events == 0);
  return p;
}

/* A period from the steady start, of which steady states may fill an interval */
static struct scallop_period_result steady_period(const struct scallop_crawler *c)
{
  struct scallop_steady_result steady;
  assert_true(scallop_steady(c, &steady) >= 0);
  return period_of(c, steady.period.v_start);
}

/* Of one crawler, delta by delta; the errors over delta are raised to the worst. */
static void errors_of(const struct scallop_crawler *c, double worst[3][DECADES])
{
  struct scallop_period_result exact = steady_period(c);
  double before = INFINITY;
  for (int i = 0; i < DECADES; i++) {
    double delta = pow(10, -2 - i);
    struct scallop_integrator_period p = smoothed(c, exact.v_start, delta, 1e-6 * delta);
    double error = distance(c, &p, exact.v_end, exact.displacement);
    worst[exact.regime][i] = fmax(worst[exact.regime][i], error);
    CHECK_AT_MOST(error, (exact.regime == SCALLOP_SLIDING ? 4 : 1.5 + 0.25 * log(1 / delta)) * delta);
    CHECK_AT_MOST(error, 0.3 * before + 0.02 * delta);
    before = error;
  }
}

static void first_order_in_delta(const struct scallop_gait *gait)
{
  double worst[3][DECADES] = { { 0 } };
  struct random r = { 20130311 };
  for (int i = 0; i < CRAWLERS; i++) {
    struct scallop_crawler c = random_crawler(&r, i % 2 ? STICK_SLIP : ORDINARY, gait);
    if (i % 8 == 7)
      set_eps(&c, 3e3);
    errors_of(&c, worst);
  }
  for (int regime = 0; regime < 3; regime++) {
    print_message("%s, %s: worst/delta", gait->name, scallop_regime_text((enum scallop_regime)regime));
    for (int i = 0; i < DECADES; i++)
      print_message(" %.3g", worst[regime][i] * pow(10, 2 + i));
    print_message(", order %.3f\n", observed_order(worst[regime], DECADES, 10));
    CHECK_NEAR(observed_order(worst[regime], DECADES, 10), 1, 0.1);
  }
}

TEST(error_of_first_order)
{
  first_order_in_delta(&scallop_gait_quadratic);
  first_order_in_delta(&scallop_gait_sinusoidal);
}

/* A body that sticks and is released goes (delta/4) ln(1/delta) ahead of the exact one, and here nothing in the rest
 * of the phase takes that away: the slope of error/delta against ln(1/delta) is 1/4. */
TEST(logarithm_of_a_release)
{
  struct scallop_crawler c = { 1, 1, 1, 1, 1, 2, 0.5, &scallop_gait_sinusoidal };
  struct scallop_period_result exact = period_of(&c, 1.32);
  modes_are(&exact.modes[0], "++ 0+ ++");
  double before = NAN;
  for (int digits = 3; digits <= 7; digits++) {
    double delta = pow(10, -digits);
    struct scallop_integrator_period p = smoothed(&c, 1.32, delta, 1e-7 * delta);
    double now = (p.v_mid - exact.v_mid) * c.T / c.L / delta;
    if (digits > 3)
      CHECK_NEAR((now - before) / log(10), 0.25, 3 * sqrt(delta));
    before = now;
  }
}

TEST(tolerance_controls_error)
{
  enum { TOLERANCES = 4 };
  const double tolerances[TOLERANCES] = { 1e-4, 1e-6, 1e-8, 1e-10 };
  double worst[TOLERANCES] = { 0 };
  struct random r = { 31 };
  for (int i = 0; i < 12; i++) {
    struct scallop_crawler c = random_crawler(&r, i % 2 ? STICK_SLIP : ORDINARY, every_gait[i % ALL_GAITS]);
    struct scallop_period_result exact = steady_period(&c);
    struct scallop_integrator_period best = smoothed(&c, exact.v_start, 0.05, 1e-13);
    for (int j = 0; j < TOLERANCES; j++) {
      struct scallop_integrator_period p = smoothed(&c, exact.v_start, 0.05, tolerances[j]);
      worst[j] = fmax(worst[j], distance(&c, &p, best.v_end, best.displacement));
    }
  }
  for (int j = 0; j < TOLERANCES; j++) {
    print_message("worst/tolerance %.2g\n", worst[j] / tolerances[j]);
    CHECK_AT_MOST(worst[j], 1000 * tolerances[j]);
    if (j >= 1)
      CHECK_AT_MOST(worst[j], 0.2 * worst[j - 1]);
  }
}

/* With a wrong Jacobian the implicit steps do not converge, or only short ones do. Body 1 sticks, then body 2. */
TEST(jacobian_pays)
{
  struct scallop_crawler c = with_gait(&scallop_gait_sinusoidal);
  c.T = 5;
  for (int i = 0; i < 2; i++, c = exchanged(&c)) {
    struct scallop_period_result exact = steady_period(&c);
    assert_int_equal(exact.regime, SCALLOP_STICK_SLIP);
    assert_true(smoothed(&c, exact.v_start, 1e-4, 1e-8).steps <= 750);
  }
}

/* Smoothed beyond recognition, friction does nothing; far above its layer, it is what it is without one. */
TEST(large_arguments)
{
  struct scallop_crawler c = with_gait(&scallop_gait_sinusoidal);
  const double v0 = 1013.7;
  struct scallop_period_result exact = period_of(&c, v0);
  CHECK_RELATIVE(smoothed(&c, v0, 1e300, 1e-9).v_end, v0, 1e-9);
  CHECK_RELATIVE(smoothed(&c, v0, 1e-3, 1e-9).v_end, exact.v_end, 1e-9);
  CHECK_RELATIVE(smoothed(&c, v0, 1e-300, 1e-9).v_end, exact.v_end, 1e-9);
  CHECK_RELATIVE(smoothed(&c, 1e150, 1e-3, 1e-9).v_end, 1e150, 1e-9);
}

/* Whatever the crawler, delta and tolerance: an answer or a status, soon. */
TEST(extremes_end)
{
  int answered = 0;
  struct random r = { 1736 };
  for (int i = 0; i < 600; i++) {
    struct scallop_crawler c = random_crawler(&r, (enum family)random_below(&r, FAMILIES), every_gait[i % ALL_GAITS]);
    double v0 = random_start(&r, &c, SCALLOP_EXTENSION), delta = random_decades(&r, 1e-12, 1e3);
    INTEGRATOR(integrator, scallop_smoothed_integrator(delta, random_decades(&r, 1e-15, 0.1)));
    long left = 2000;
    PATIENCE(patience, left);
    struct scallop_integrator_period p;
    enum scallop_status status = integrator->period(integrator, &c, v0, &patience, &p);
    assert_true(status == SCALLOP_OK ? isfinite(p.v_mid) && isfinite(p.v_end) && isfinite(p.displacement)
                                     : status == SCALLOP_ESTOPPED || status == SCALLOP_ECONVERGE);
    answered += status == SCALLOP_OK;
  }
  assert_true(answered >= 400);
}

/* Inside a phase: of `count` samples, as many as are given */
enum { LOOKS = 50 };
struct look {
  struct scallop_sample samples[LOOKS];
  int count;
};

static struct look look_at(const struct scallop_crawler *c, enum scallop_phase_kind kind, double v0, double delta,
                           const double *times, int count, enum scallop_status wanted)
{
  struct look look = { .count = 0 };
  INTEGRATOR(integrator, scallop_smoothed_integrator(delta, 1e-8 * delta));
  for (int i = 0; i < LOOKS; i++)
    look.samples[i] = (struct scallop_sample){ .t = i < count ? times[i] : NAN, .x1 = NAN };
  assert_int_equal(scallop_smoothed_phase(integrator, c, kind, v0, NULL, look.samples, count), wanted);
  while (look.count < LOOKS && !isnan(look.samples[look.count].x1))
    look.count++;
  return look;
}

/* Looked at only at its ends, an extension is the very one of the period; a contraction begins with another step. */
TEST(phase_is_that_of_the_period)
{
  for (int i = 0; i < ALL_GAITS; i++) {
    struct scallop_crawler c = with_gait(every_gait[i]);
    const double ends[2][2] = { { 0, scallop_phase_duration(&c, SCALLOP_EXTENSION) },
                                { 0, scallop_phase_duration(&c, SCALLOP_CONTRACTION) } };
    struct scallop_integrator_period p = smoothed(&c, 3.1, 0x1p-4, 1e-8 * 0x1p-4);
    struct look first = look_at(&c, SCALLOP_EXTENSION, 3.1, 0x1p-4, ends[0], 2, SCALLOP_OK),
                second = look_at(&c, SCALLOP_CONTRACTION, p.v_mid, 0x1p-4, ends[1], 2, SCALLOP_OK);
    const struct scallop_sample *a = first.samples, *b = second.samples;
    assert_true(first.count == 2 && second.count == 2);
    assert_true(a[0].x1 == 0 && a[0].l == 0 && b[0].x1 == 0 && b[0].x2 == c.L && b[1].t == ends[1][1]);
    CHECK_RELATIVE(a[1].x2 - a[1].x1, c.L, 4 * DBL_EPSILON);
    CHECK_NEAR(b[1].l, 0, 4 * DBL_EPSILON * c.L);
    CHECK_NEAR(a[1].xC - a[0].xC + b[1].xC - b[0].xC, p.displacement, 1e-7 * c.L);
    if (c.gait == &sawtooth_gait) /* the bodies begin and end with velocities of their own */
      continue;
    CHECK_RELATIVE(a[0].v1, 3.1, 4 * DBL_EPSILON);
    CHECK_NEAR(a[1].v1, p.v_mid, 1e-13 * c.L / c.T);
    CHECK_NEAR(a[1].v2, p.v_mid, 1e-13 * c.L / c.T);
    CHECK_NEAR(b[1].v2, p.v_end, 1e-7 * c.L / c.T);
  }
}

static bool compare_with(void *context, const struct scallop_sample *exact)
{
  struct look *look = context;
  const struct scallop_sample *s = &look->samples[look->count++];
  CHECK_RELATIVE(s->t, exact->t, 4 * DBL_EPSILON);
  CHECK_NEAR(s->l, exact->l, 1e-14 * 10);
  CHECK_NEAR(s->x1, exact->x1, 1e-6);
  CHECK_NEAR(s->x2, exact->x2, 1e-6);
  CHECK_NEAR(s->xC, exact->xC, 1e-6);
  CHECK_NEAR(s->v1, exact->v1, 1e-5);
  CHECK_NEAR(s->v2, exact->v2, 1e-5);
  return look->count < 41;
}

/* Against the exact motion; and at times that are the same */
TEST(samples_follow_the_exact_motion)
{
  static const double twice[] = { 0.3, 0.3, 0.30000000000000004, 0.375, 0.375 };
  for (int i = 0; i < 2; i++)
    for (int stuck = 0; stuck < 2; stuck++) {
      struct scallop_crawler c = with_gait(every_gait[i]);
      double times[41];
      c.T = stuck ? 4 : 1;
      for (int k = 0; k < 41; k++)
        times[k] = k * c.T / 64;
      struct look look = look_at(&c, SCALLOP_EXTENSION, 1.3, 1e-7, times, 41, SCALLOP_OK);
      assert_int_equal(look.count, 41);
      look.count = 0;
      assert_int_equal(scallop_trajectory(&c, 1.3, 1, 64, compare_with, &look), SCALLOP_STOPPED);
      struct look again = look_at(&c, SCALLOP_EXTENSION, 1.3, 1e-3, twice, 5, SCALLOP_OK);
      assert_int_equal(again.count, 5);
      CHECK_EQUAL(again.samples[0].v1, again.samples[1].v1);
      CHECK_EQUAL(again.samples[3].x1, again.samples[4].x1);
    }
}

/* Bad times, count or start: no sample; impatience: that of the start alone */
TEST(looks_that_end)
{
  static const double bad[][2] = { { -1e-9, 0.1 }, { 0.2, 0.1 }, { 0.1, 0.8 },
                                   { NAN, 0.1 },   { 0.1, NAN }, { 0.1, INFINITY } };
  const struct scallop_crawler c = scallop_crawler_default();
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
    assert_int_equal(look_at(&c, SCALLOP_EXTENSION, 1, 1e-3, bad[i], 2, SCALLOP_EDOMAIN).count, 0);
  assert_int_equal(look_at(&c, SCALLOP_EXTENSION, 1, 1e-3, bad[0], -1, SCALLOP_EDOMAIN).count, 0);
  assert_int_equal(look_at(&c, SCALLOP_EXTENSION, NAN, 1e-3, (double[]){ 0, 0.2 }, 2, SCALLOP_EDOMAIN).count, 0);
  INTEGRATOR(integrator, scallop_smoothed_integrator(1e-3, 1e-9));
  long left = 0;
  PATIENCE(none, left);
  struct scallop_sample samples[] = { { .t = 0 }, { .t = 0.2, .x1 = NAN }, { .t = 0.4, .x1 = NAN } };
  assert_int_equal(scallop_smoothed_phase(integrator, &c, SCALLOP_EXTENSION, 1, &none, samples, 3), SCALLOP_ESTOPPED);
  assert_true(samples[0].l == 0 && samples[0].v1 != 0 && isnan(samples[1].x1));
}

/* Positions overflow, and then velocities, and not positions: the samples before are given, and are numbers. */
TEST(samples_out_of_range)
{
  static const double v0[] = { -50, 50, 1.45, -0.5, 0.5 };
  for (int i = 0; i < 5; i++) {
    double L = i < 3 ? 1e308 : 8e307, T = i < 3 ? 2e3 : 1, force = (i < 3 ? 0.1 : 0.01) * (L / T) / T, times[LOOKS];
    const struct scallop_crawler c = { 0.5, 0.5, 0.8 * force, 0.2 * force, L, T, 0.5, &scallop_gait_quadratic };
    for (int k = 0; k < LOOKS; k++)
      times[k] = k * (T / 2) / LOOKS;
    const struct look look = look_at(&c, SCALLOP_EXTENSION, v0[i] * (i < 3 ? 2 * (L / T) : L / T), 1e-2, times, LOOKS,
                                     SCALLOP_ERANGE);
    assert_true(look.count > 0 && look.count < LOOKS);
    for (int k = 0; k < look.count; k++)
      assert_true(isfinite(look.samples[k].x2 - look.samples[k].x1 + look.samples[k].v1 + look.samples[k].v2));
  }
}

int main(void)
{
  gsl_set_error_handler_off();
  return check_run(NULL, NULL);
}
