#include "compare/points/counts.h"

#include <stdio.h>
#include <sys/resource.h>

bool counts_are_printed;
static long counts[COUNTS]; /* by any thread */

static const char *const names[COUNTS] = {
  "points", "onsets",    "steady",       "phases",          "formulas",         "expansions",
  "sums",   "certified", "trajectories", "samples",         "orders",           "commands",
  "rows",   "plots",     "gaits",        "root_iterations", "gait_evaluations", "certified_digits"
};

void count_add(enum count what, long n) { __atomic_fetch_add(&counts[what], n, __ATOMIC_RELAXED); }

void count_work(const struct scallop_work *work)
{
  count_add(COUNT_ROOT_ITERATIONS, work->root_iterations);
  count_add(COUNT_GAIT_EVALUATIONS, work->gait_evaluations);
}

void counts_print(void)
{
  struct rusage usage;
  fputs("# what was done\nstage\tcount\n", stderr);
  for (int k = 0; k < COUNTS; k++)
    fprintf(stderr, "%s\t%ld\n", names[k], counts[k]);
  if (getrusage(RUSAGE_SELF, &usage) == 0)
    fprintf(stderr, "peak_memory_kB\t%ld\n", usage.ru_maxrss);
}
