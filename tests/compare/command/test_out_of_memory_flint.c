/* Where memory is short there is no integrator, and nothing is left behind. That is so for allocations of our own and
 * the first and last of the libraries': in between they fall themselves. Only where the allocator lets itself be
 * called by another name: glibc's, and the address sanitizer's. */
#include "tests/support/check.h"

#include <stdlib.h>

#include "numerics/integrators/integrator.h"

#ifdef __GLIBC__
static volatile long fails_in = -1; /* allocations until one fails; below 0: none does */
static volatile long in_use;

#ifdef __has_feature
#define SANITIZED __has_feature(address_sanitizer)
#elif defined __SANITIZE_ADDRESS__
#define SANITIZED 1
#else
#define SANITIZED 0
#endif
#if SANITIZED
#define REAL(name) __interceptor_##name
#else
#define REAL(name) __libc_##name
#endif
void *REAL(malloc)(size_t size);
void *REAL(calloc)(size_t count, size_t size);
void REAL(free)(void *block);

static bool refused(void) { return fails_in >= 0 && fails_in-- == 0; }

static void *counted(void *block)
{
  in_use += block != NULL;
  return block;
}

void *malloc(size_t size) { return refused() ? NULL : counted(REAL(malloc)(size)); }

void *calloc(size_t count, size_t size) { return refused() ? NULL : counted(REAL(calloc)(count, size)); }

void free(void *block)
{
  in_use -= block != NULL;
  REAL(free)(block);
}

typedef struct scallop_integrator *maker(int kind);

static void check_failures(maker *make, int kind, long from, long to)
{
  for (long n = from; n < to; n++) {
    long before = in_use;
    fails_in = n;
    struct scallop_integrator *integrator = make(kind);
    bool failed = fails_in < 0;
    fails_in = -1;
    assert_true(failed);
    assert_null(integrator);
    assert_int_equal(in_use, before);
  }
}

static struct scallop_integrator *make_odeiv(int kind)
{
  return scallop_odeiv_integrator((enum scallop_odeiv_stepper)kind, 1e-6);
}
static struct scallop_integrator *make_smoothed(int kind)
{
  return (void)kind, scallop_smoothed_integrator(1e-3, 1e-6);
}
static struct scallop_integrator *make_cvode(int kind) { return (void)kind, scallop_cvode_integrator(1e-6); }
TEST(making_integrators)
{
  for (int kind = 0; kind < 2; kind++)
    check_failures(make_odeiv, kind, 0, 3);
  check_failures(make_smoothed, 0, 0, 3);
  if (scallop_has_cvode())
    check_failures(make_cvode, 0, 0, 2);
}

#else
TEST(making_integrators) { skip(); }
#endif
