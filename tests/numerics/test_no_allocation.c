/* No solve allocates: every allocation of this program is counted, and none is made between the first call and the
 * last. Not where a sanitizer has its own allocator, nor with a C library that does not let itself be asked. */
#include <stdlib.h>

#include "tests/support/columns.h"
#include "tests/support/random_crawler.h"

#if defined __GLIBC__ && !defined __SANITIZE_ADDRESS__
static volatile long allocations; /* the compiler must not think that it knows what malloc does */

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *old, size_t size);

void *malloc(size_t size)
{
  allocations++;
  return __libc_malloc(size);
}

void *calloc(size_t count, size_t size)
{
  allocations++;
  return __libc_calloc(count, size);
}

void *realloc(void *old, size_t size)
{
  allocations++;
  return __libc_realloc(old, size);
}

static long counted(void)
{
  void *volatile block = malloc(1); /* or it counts nothing */
  free(block);
  return allocations;
}
#else
static long counted(void) { return 0; }
#endif

enum { CRAWLERS = 300 };

static bool count_sample(void *context, const struct scallop_sample *sample)
{
  double *sum = context;
  *sum += sample->x1;
  return true;
}

static void solve(const struct scallop_crawler *c)
{
  struct scallop_steady_result steady;
  struct scallop_phase_result phase;
  struct scallop_period_result period;
  double sum = 0;
  if (scallop_steady(c, &steady) < 0)
    return;
  (void)scallop_period(c, steady.period.v_start * 0.9, &period);
  (void)scallop_phase(c, SCALLOP_CONTRACTION, steady.period.v_mid * 1.1, &phase);
  (void)scallop_trajectory(c, 0, 2, 3, count_sample, &sum);
}

static void solve_all(const struct columns *in, long count)
{
  static double v[CRAWLERS];
  struct scallop_crawlers all = columns_all(in, count);
  struct scallop_steady_states states = { .v_start = v };
  struct scallop_phases phases = { .v_end = v };
  for (long i = 0; i < count; i++) {
    const struct scallop_crawler c = columns_row(in, i);
    solve(&c);
  }
  (void)scallop_steady_batch(&all, &states, 1);
  (void)scallop_phase_batch(&all, SCALLOP_EXTENSION, in->alpha, &phases, 1); /* from any start velocities */
}

TEST(no_solve_allocates)
{
  static struct columns in;
  struct random r = { 20261125 };
  for (int i = 0; i < CRAWLERS; i++) {
    struct scallop_crawler c = random_crawler(&r, (enum family)(i % FAMILIES), every_gait[i % ALL_GAITS]);
    columns_put(&in, i, &c);
  }
  solve_all(&in, 1); /* what the C library does the first time is not ours */
  long before = counted();
  solve_all(&in, CRAWLERS);
  long after = counted();
  assert_true(after == 0 ? before == 0 : after == before + 1);
}
