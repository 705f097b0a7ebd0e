/* compare/stopwatch: what does not depend on how fast the machine is. */
#include "tests/support/check.h"
#include "compare/text/stopwatch.h"

TEST(spread_of_known_samples)
{
  static const struct {
    int count;
    double samples[5], median, least, q1, q3;
  } cases[] = { { 5, { 7.5, 1.25, 3.5, 2.25, 100 }, 3.5, 1.25, 2.25, 7.5 },
                { 4, { 4, 1, 3, 2 }, 2.5, 1, 1.75, 3.25 },
                { 2, { 8, 4 }, 6, 4, 5, 7 },
                { 1, { 2.385 }, 2.385, 2.385, 2.385, 2.385 },
                { 0, { 0 }, NAN, NAN, NAN, NAN } };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    double samples[5];
    memcpy(samples, cases[i].samples, sizeof samples);
    struct stopwatch_spread s = stopwatch_spread(samples, cases[i].count);
    CHECK_EQUAL(s.median, cases[i].median);
    CHECK_EQUAL(s.least, cases[i].least);
    CHECK_EQUAL(s.q1, cases[i].q1);
    CHECK_EQUAL(s.q3, cases[i].q3);
    assert_int_equal(s.repetitions, cases[i].count);
  }
}

TEST(the_clock_never_falls)
{
  double last = stopwatch_now();
  for (int i = 0; i < 100000; i++) {
    double now = stopwatch_now();
    assert_true(now >= last);
    last = now;
  }
  struct stopwatch_clock clock = stopwatch_clock();
  assert_true(clock.cost > 0 && clock.cost < 1);
  assert_true(clock.step > 0 && clock.step < 1);
  CHECK_AT_MOST(clock.cost, 1e-3 * stopwatch_long_enough(&clock));
  CHECK_AT_MOST(clock.step, 1e-3 * stopwatch_long_enough(&clock));
  struct stopwatch_clock slow = { .cost = 1.5, .step = 2.5 };
  CHECK_EQUAL(stopwatch_long_enough(&slow), 2500);
}

static double busy(void *context)
{
  double end = stopwatch_now() + *(const double *)context;
  while (stopwatch_now() < end)
    ;
  return end;
}

TEST(passes_fill_the_time)
{
  double half_a_millisecond = 5e-4;
  assert_int_equal(stopwatch_passes(busy, &half_a_millisecond, 1e-5), 1);
  long passes = stopwatch_passes(busy, &half_a_millisecond,
                                 1.5e-3); /* fewer than 4 only where something else got in between */
  assert_true(passes >= 1 && passes <= 4);
  double start = stopwatch_now(), took = stopwatch_batch(busy, &half_a_millisecond, 3);
  assert_true(took >= 3 * half_a_millisecond && took < 4 * (stopwatch_now() - start));
}

TEST(a_limit_ends)
{
  double start = stopwatch_now();
  struct stopwatch_limit over = { .end = start }, limit = { .end = start + 0.02 };
  assert_false(stopwatch_is_running(&over));
  assert_true(stopwatch_is_running(&limit));
  while (stopwatch_is_running(&limit))
    ;
  assert_true(stopwatch_now() - start >= 0.02);
}
