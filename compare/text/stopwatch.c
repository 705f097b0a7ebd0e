#include "compare/text/stopwatch.h"

#include <math.h>
#include <time.h>

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>

enum { CLOCK_READINGS = 4096, CLOCK_TRIES = 9, MOST_STRIDE = 1000 };

static const double clock_share = 1e-3, shortest_batch = 2e-4, between_readings = 5e-5;

static volatile double sink; /* results go here */

double stopwatch_now(void)
{
  struct timespec t;
  return clock_gettime(CLOCK_MONOTONIC, &t) == 0 ? (double)t.tv_sec + 1e-9 * (double)t.tv_nsec : NAN;
}

struct stopwatch_clock stopwatch_clock(void)
{
  double costs[CLOCK_TRIES];
  struct stopwatch_clock clock = { .step = INFINITY };
  for (int try = 0; try < CLOCK_TRIES; try++) {
    double start = stopwatch_now(), last = start;
    for (int i = 0; i < CLOCK_READINGS; i++) {
      double now = stopwatch_now();
      if (now > last)
        clock.step = fmin(clock.step, now - last);
      last = now;
    }
    costs[try] = (last - start) / CLOCK_READINGS;
  }
  clock.cost = stopwatch_spread(costs, CLOCK_TRIES).median;
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
  return fmax(shortest_batch, fmax(clock->cost, clock->step) / clock_share);
}

struct stopwatch_spread stopwatch_spread(double *samples, int count)
{
  if (count <= 0)
    return (struct stopwatch_spread){ NAN, NAN, NAN, NAN, 0 };
  size_t n = (size_t)count;
  gsl_sort(samples, 1, n);
  return (struct stopwatch_spread){ .median = gsl_stats_median_from_sorted_data(samples, 1, n),
                                    .least = samples[0],
                                    .q1 = gsl_stats_quantile_from_sorted_data(samples, 1, n, 0.25),
                                    .q3 = gsl_stats_quantile_from_sorted_data(samples, 1, n, 0.75),
                                    .repetitions = count };
}

struct stopwatch_limit stopwatch_limit(double seconds)
{
  double now = stopwatch_now();
  return (struct stopwatch_limit){ .end = now + seconds, .last = now, .stride = 1, .ask = 1 };
}

bool stopwatch_lasts(void *context)
{
  struct stopwatch_limit *limit = context;
  if (--limit->ask > 0)
    return true;
  double now = stopwatch_now();
  long faster = 2 * limit->stride < MOST_STRIDE ? 2 * limit->stride : MOST_STRIDE;
  limit->stride = now - limit->last < between_readings ? faster : 1;
  limit->ask = limit->stride;
  limit->last = now;
  return now < limit->end;
}
