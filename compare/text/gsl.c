#include <math.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>

#include "compare/text/stopwatch.h"

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

/* Turns off GSL's error handler, because it ends the program. A build without GSL omits this file. */
static void __attribute__((constructor)) begin(void) { gsl_set_error_handler_off(); }
