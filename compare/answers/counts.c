#include "compare/answers/counts.h"

static long counts[COUNTS];

static const char *const names[COUNTS] = {
  "points", "onsets",    "steady",       "phases",          "formulas",         "expansions",
  "sums",   "certified", "trajectories", "samples",         "orders",           "commands",
  "rows",   "plots",     "gaits",        "root_iterations", "gait_evaluations", "certified_digits"
};

void count_add(enum count what, long n) { counts[what] += n; }

void count_work(const struct scallop_work *work)
{
  counts[COUNT_ROOT_ITERATIONS] += work->root_iterations;
  counts[COUNT_GAIT_EVALUATIONS] += work->gait_evaluations;
}

long count_of(enum count what) { return counts[what]; }

const char *count_name(enum count what) { return names[what]; }
