/* Smoothed friction looked at inside a phase: against the period of the same solver, and against the exact motion. */
#include "tests/check.h"

#include <gsl/gsl_errno.h>

#include "numerics/smoothed.h"
#include "tests/rivals.h"

enum { STEPPERS = 3 };

static enum scallop_smoothed_stepper stepper_of(int i) { return (enum scallop_smoothed_stepper)i; }

enum { LOOKS = 41 };
struct look {
  struct scallop_sample samples[LOOKS];
  int count, wanted; /* wanted: after so many it has seen enough */
};

static bool note(void *context, const struct scallop_sample *sample)
{
  struct look *look = context;
  look->samples[look->count++] = *sample;
  return look->count < look->wanted;
}

static enum scallop_status look_at(const struct scallop_crawler *c, enum scallop_phase_kind kind, double v0, int stepper,
                                   double delta, const double *times, int count, struct look *look)
{
  RIVAL(rival, scallop_smoothed_rival(stepper_of(stepper), delta, 1e-8 * delta));
  look->count = 0;
  look->wanted = look->wanted > 0 ? look->wanted : count + 1;
  return scallop_smoothed_phase(rival, c, kind, v0, NULL, times, count, note, look);
}

/* Looked at only at its ends, an extension is the very one of the period; a contraction begins with another step. */
TEST(phase_is_that_of_the_period)
{
  struct scallop_crawler c = scallop_crawler_default();
  for (int i = 0; i < ALL_GAITS; i++)
    for (int stepper = 0; stepper < STEPPERS; stepper++) {
      c.gait = every_gait[i];
      RIVAL(rival, scallop_smoothed_rival(stepper_of(stepper), 0x1p-4, 1e-8 * 0x1p-4));
      struct scallop_rival_period p = rival_period(rival, &c, 3.1);
      struct look first = { .count = 0 }, second = first;
      const double ends[2][2] = { { 0, scallop_phase_duration(&c, SCALLOP_EXTENSION) },
                                  { 0, scallop_phase_duration(&c, SCALLOP_CONTRACTION) } };
      assert_int_equal(look_at(&c, SCALLOP_EXTENSION, 3.1, stepper, 0x1p-4, ends[0], 2, &first), SCALLOP_OK);
      assert_int_equal(look_at(&c, SCALLOP_CONTRACTION, p.v_mid, stepper, 0x1p-4, ends[1], 2, &second), SCALLOP_OK);
      assert_true(first.count == 2 && second.count == 2);
      const struct scallop_sample *a = first.samples, *b = second.samples;
      CHECK_EQUAL(a[0].x1, 0);
      CHECK_EQUAL(a[0].l, 0);
      CHECK_EQUAL(b[0].x1, 0);
      CHECK_EQUAL(b[0].x2, c.L);
      CHECK_RELATIVE(a[1].x2 - a[1].x1, c.L, 4 * DBL_EPSILON);
      CHECK_EQUAL(b[1].t, ends[1][1]);
      CHECK_NEAR(b[1].l, 0, 4 * DBL_EPSILON * c.L);
      CHECK_NEAR(a[1].xC - a[0].xC + b[1].xC - b[0].xC, p.displacement, 1e-7 * c.L);
      if (!c.gait->phase[0].pieces[0].jump) { /* else the bodies begin and end with velocities of their own */
        CHECK_RELATIVE(a[0].v1, 3.1, 4 * DBL_EPSILON);
        CHECK_NEAR(a[1].v1, p.v_mid, 1e-13 * c.L / c.T);
        CHECK_NEAR(a[1].v2, p.v_mid, 1e-13 * c.L / c.T);
        CHECK_NEAR(b[1].v2, p.v_end, 1e-7 * c.L / c.T);
      }
    }
}

/* Against the exact motion, at times of all sorts; two may be the same. */
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
  return look->count < look->wanted;
}

TEST(samples_follow_the_exact_motion)
{
  struct scallop_crawler c = scallop_crawler_default();
  for (int i = 0; i < 2; i++)
    for (int stuck = 0; stuck < 2; stuck++) {
      c.gait = i == 0 ? &scallop_gait_quadratic : &scallop_gait_sinusoidal;
      c.T = stuck ? 4 : 1;
      double times[LOOKS];
      for (int k = 0; k < LOOKS; k++)
        times[k] = k * c.T / 64;
      struct look look = { .count = 0 };
      assert_int_equal(look_at(&c, SCALLOP_EXTENSION, 1.3, SCALLOP_SMOOTHED_MSBDF, 1e-7, times, LOOKS, &look), SCALLOP_OK);
      assert_int_equal(look.count, LOOKS);
      look.wanted = LOOKS;
      look.count = 0;
      assert_int_equal(scallop_trajectory(&c, 1.3, 1, 64, compare_with, &look), SCALLOP_STOPPED);
      const double twice[] = { 0.3, 0.3, nextafter(0.3, 1), 0.375, 0.375 };
      struct look again = { .count = 0 };
      for (int stepper = 0; stepper < STEPPERS; stepper++) {
        assert_int_equal(look_at(&c, SCALLOP_EXTENSION, 1.3, stepper, 1e-3, twice, 5, &again), SCALLOP_OK);
        assert_int_equal(again.count, 5);
        CHECK_EQUAL(again.samples[0].v1, again.samples[1].v1);
        CHECK_EQUAL(again.samples[3].x1, again.samples[4].x1);
      }
    }
}

TEST(looks_that_end)
{
  const double good[] = { 0, 0.2, 0.4 };
  const double bad[][2] = { { -1e-9, 0.1 }, { 0.2, 0.1 }, { 0.1, 0.8 }, { NAN, 0.1 }, { 0.1, NAN }, { 0.1, INFINITY } };
  struct scallop_crawler c = scallop_crawler_default();
  struct look look = { .count = 0 };
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
    assert_int_equal(look_at(&c, SCALLOP_EXTENSION, 1, SCALLOP_SMOOTHED_MSBDF, 1e-3, bad[i], 2, &look), SCALLOP_EDOMAIN);
    assert_int_equal(look.count, 0);
  }
  assert_int_equal(look_at(&c, SCALLOP_EXTENSION, 1, SCALLOP_SMOOTHED_MSBDF, 1e-3, good, -1, &look), SCALLOP_EDOMAIN);
  assert_int_equal(look_at(&c, SCALLOP_EXTENSION, NAN, SCALLOP_SMOOTHED_MSBDF, 1e-3, good, 3, &look), SCALLOP_EDOMAIN);
  for (int wanted = 1; wanted <= 2; wanted++) {
    look.wanted = wanted;
    assert_int_equal(look_at(&c, SCALLOP_EXTENSION, 1, SCALLOP_SMOOTHED_MSBDF, 1e-3, good, 3, &look), SCALLOP_STOPPED);
    assert_int_equal(look.count, wanted);
  }
  RIVAL(rival, scallop_smoothed_rival(SCALLOP_SMOOTHED_BSIMP, 1e-3, 1e-9));
  long left = 0;
  PATIENCE(none, left);
  look = (struct look){ .wanted = 9 };
  assert_int_equal(scallop_smoothed_phase(rival, &c, SCALLOP_EXTENSION, 1, &none, good, 3, note, &look), SCALLOP_ESTOPPED);
  assert_int_equal(look.count, 1); /* of the start */
}

int main(void)
{
  gsl_set_error_handler_off();
  return check_run(NULL, NULL);
}
