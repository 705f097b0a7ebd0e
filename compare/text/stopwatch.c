#include "compare/text/stopwatch.h"

#include <math.h>
#include <time.h>

static volatile double sink; /* consumes results */

double stopwatch_now(void)
{
  struct timespec t;
  return clock_gettime(CLOCK_MONOTONIC, &t) == 0 ? (double)t.tv_sec + 1e-9 * (double)t.tv_nsec : NAN;
}

struct stopwatch_clock stopwatch_clock(void)
{
  enum { READINGS = 40000 };
  struct stopwatch_clock clock = { .step = INFINITY };
  double start = stopwatch_now(), last = start;
  for (int i = 0; i < READINGS; i++) {
    double now = stopwatch_now();
    clock.step = now > last ? fmin(clock.step, now - last) : clock.step;
    last = now;
  }
  clock.cost = (last - start) / READINGS;
  return clock;
}

double stopwatch_batch(stopwatch_task *task, void *context, long passes)
{
  double sum = 0, start = stopwatch_now();
  for (long i = 0; i < passes; i++)
    sum += task(context);
  double end = stopwatch_now();
  sink = sum;
  return end - start;
}

long stopwatch_passes(stopwatch_task *task, void *context, double seconds)
{
  long passes = 1;
  while (stopwatch_batch(task, context, passes) < seconds)
    passes *= 2;
  return passes;
}

double stopwatch_long_enough(const struct stopwatch_clock *clock)
{
  return fmax(2e-4, 1e3 * fmax(clock->cost, clock->step));
}

bool stopwatch_is_running(void *context)
{
  struct stopwatch_limit *limit = context;
  return limit->checks++ % 16 != 0 || stopwatch_now() < limit->end;
}
