/* Timing: the cost of the clock is measured and stays below a thousandth of the timed interval, calls are batched until
 * they take long enough, results are consumed, and a median has its quartiles. */
#ifndef SCALLOP_COMPARE_TEXT_STOPWATCH_H
#define SCALLOP_COMPARE_TEXT_STOPWATCH_H

#include <stdbool.h>

/* Returns the seconds since an arbitrary start, never decreasing; nan without a monotonic clock. */
double stopwatch_now(void);

struct stopwatch_clock { /* in seconds */
  double cost;           /* of one reading */
  double step;           /* the smallest observed difference > 0 of two readings */
};
struct stopwatch_clock stopwatch_clock(void);

/* A task to time. Its result must depend on all of its work, to keep the compiler from omitting some. */
typedef double stopwatch_task(void *context);

/* Returns the seconds of `passes` calls. */
double stopwatch_batch(stopwatch_task *task, void *context, long passes);
/* Returns a power of 2: a number of calls that take at least `seconds`. The trials also warm up the caches. */
long stopwatch_passes(stopwatch_task *task, void *context, double seconds);
/* Returns the shortest interval in seconds of which the clock costs less than a thousandth. */
double stopwatch_long_enough(const struct stopwatch_clock *clock);

struct stopwatch_spread {
  double median, least, q1, q3; /* quartiles: interpolated linearly between sorted samples */
  int repetitions;
};
/* Sorts count >= 0 samples, without nan, and returns their quartiles; nan if count is 0. */
struct stopwatch_spread stopwatch_spread(double *samples, int count);

/* A time limit for loops that check it often: only every 16th check reads the clock. */
struct stopwatch_limit {
  double end; /* a time of stopwatch_now() */
  long checks;
};
bool stopwatch_is_running(void *limit); /* returns true before the end */

#endif
