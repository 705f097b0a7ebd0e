/* Timing that can be believed: the clock's own cost is known and kept below a thousandth of what is timed, calls are
 * batched until they are long enough, results are consumed, and a median comes with its spread. */
#ifndef SCALLOP_COMPARE_TEXT_STOPWATCH_H
#define SCALLOP_COMPARE_TEXT_STOPWATCH_H

#include <stdbool.h>

/* Seconds since some start, never falling; nan where there is no monotonic clock. */
double stopwatch_now(void);

struct stopwatch_clock { /* seconds                                                                     */
  double cost;           /* of one reading                                                              */
  double step;           /* the smallest difference seen between two readings that were not the same    */
};
struct stopwatch_clock stopwatch_clock(void);

/* Does what is timed, once; the number depends on all of it, so that no work can be left out. */
typedef double stopwatch_task(void *context);

/* Seconds for so many calls, one after the other. */
double stopwatch_batch(stopwatch_task *task, void *context, long passes);
/* How many calls take at least so many seconds: a power of 2. Trying this warms everything up. */
long stopwatch_passes(stopwatch_task *task, void *context, double seconds);
/* So many seconds, and the clock costs less than a thousandth of them. */
double stopwatch_long_enough(const struct stopwatch_clock *clock);

struct stopwatch_spread {
  double median, least, q1, q3; /* quartiles: linear between the two nearest of the sorted samples              */
  int repetitions;
};
/* Sorts the samples, count >= 0 of them, none nan; all are nan for none. */
struct stopwatch_spread stopwatch_spread(double *samples, int count);

/* A limit for what asks again and again whether to go on: every 16th answer costs a reading of the clock. */
struct stopwatch_limit {
  double end; /* of the time that is allowed: stopwatch_now() and some */
  long answers;
};
bool stopwatch_lasts(void *limit); /* still within it */

#endif
