#include "compare/answers/counts.h"

#include <stdatomic.h>

static atomic_long counts[COUNTS];

static const char *const names[COUNTS] = {
  "points",     "gaits", "onsets",    "steady",           "phases",       "root_iterations", "gait_evaluations", "formulas",
  "expansions", "sums",  "certified", "certified_digits", "trajectories", "samples",         "integrators",      "orders",
  "commands",   "rows",  "plots"
};

void count_add(enum count what, long n) { atomic_fetch_add_explicit(&counts[what], n, memory_order_relaxed); }

long count_of(enum count what) { return atomic_load_explicit(&counts[what], memory_order_relaxed); }

const char *count_name(enum count what) { return names[what]; }

static void add_work(const struct scallop_work *work)
{
  if (work->root_iterations > 0)
    count_add(COUNT_ROOT_ITERATIONS, work->root_iterations);
  if (work->gait_evaluations > 0)
    count_add(COUNT_GAIT_EVALUATIONS, work->gait_evaluations);
}

enum scallop_status counted_steady(const struct scallop_crawler *crawler, struct scallop_steady_result *result)
{
  enum scallop_status status = scallop_steady(crawler, result);
  count_add(COUNT_STEADY, 1);
  if (status >= 0)
    add_work(&result->work);
  return status;
}

enum scallop_status counted_phase(const struct scallop_crawler *crawler, enum scallop_phase_kind kind, double v0,
                                  struct scallop_phase_result *result)
{
  enum scallop_status status = scallop_phase(crawler, kind, v0, result);
  count_add(COUNT_PHASES, 1);
  if (status >= 0)
    add_work(&result->work);
  return status;
}

/* What a trajectory is made of and what it costs its caller */
struct counted_samples {
  scallop_sampler *sampler;
  void *context;
  long count;
};

static bool count_sample(void *context, const struct scallop_sample *sample)
{
  struct counted_samples *c = context;
  c->count++;
  return c->sampler(c->context, sample);
}

enum scallop_status counted_trajectory(const struct scallop_crawler *crawler, double v0, long periods, long samples,
                                       scallop_sampler *sampler, void *context)
{
  struct counted_samples c = { sampler, context, 0 };
  enum scallop_status status = scallop_trajectory(crawler, v0, periods, samples, count_sample, &c);
  count_add(COUNT_TRAJECTORIES, 1);
  count_add(COUNT_SAMPLES, c.count);
  return status;
}
