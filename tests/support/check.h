/* Comparisons of doubles for the tests. Accept-form: a check fails unless the error is within the
 * tolerance, so a NaN that nobody asked for always fails. NaN equals only NaN; infinities are equal
 * only with the same sign. Each macro prints what it got, what it wanted, by how much it missed, and
 * the expression, and then fails the running cmocka test. */
#ifndef SCALLOP_TESTS_SUPPORT_CHECK_H
#define SCALLOP_TESTS_SUPPORT_CHECK_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

bool check_near(double got, double wanted, double tolerance);     /* |got - wanted| <= tolerance */
bool check_relative(double got, double wanted, double tolerance); /* ... <= tolerance |wanted|   */

void check_fail(const char *expression, double got, double wanted, double tolerance, const char *kind, const char *file,
                int line);

/* TEST(name) { ... } is a test: the tests of a program run in the order of its file, and main is in check.c. A program
 * with something to do first has a main of its own, which ends with check_run. */
#define TEST(name) \
  static void name(void **state); \
  __attribute__((constructor)) static void add_##name(void) { check_add(#name, name); } \
  static void name(void **state __attribute__((unused)))

void check_add(const char *name, CMUnitTestFunction test);
int check_run(CMFixtureFunction set_up, CMFixtureFunction tear_down); /* either may be NULL */

/* What a test sets at its begin, and to NULL at its end, is called if it failed: to say of what. */
extern void (*check_failed)(void);

/* How many of so many random cases: all, or where the environment has SCALLOP_TEST_THIN=N every Nth, rounded up. For
 * scripts/dev/valgrind.sh, under which a case takes fifty times as long: a few go all the ways through the code that
 * many go. */
long check_cases(long many);

#define CHECK_NEAR(got, wanted, tolerance) CHECK_WITH(check_near, "absolute", got, wanted, tolerance)
#define CHECK_RELATIVE(got, wanted, tolerance) CHECK_WITH(check_relative, "relative", got, wanted, tolerance)
#define CHECK_EQUAL(got, wanted) CHECK_NEAR(got, wanted, 0.0)
/* What has the same bits both ways, unless it is compiled with fused multiply-add (scripts/dev/matrix.sh, which says so
 * by CONTRACTED): vector and scalar code are contracted differently. Displacements that cancel to 1e-14 keep 12
 * digits. */
#ifdef CONTRACTED
#define SAME_BITS 1e-11
#else
#define SAME_BITS 0.0
#endif
#define CHECK_AT_MOST(got, bound) \
  do { \
    double check_got = (got), check_bound = (bound); \
    if (!(check_got <= check_bound)) \
      check_fail(#got, check_got, check_bound, 0, "at most", __FILE__, __LINE__); \
  } while (0)

#define CHECK_WITH(compare, kind, got, wanted, tolerance) \
  do { \
    double check_got = (got), check_wanted = (wanted), check_tolerance = (tolerance); \
    if (!compare(check_got, check_wanted, check_tolerance)) \
      check_fail(#got, check_got, check_wanted, check_tolerance, kind, __FILE__, __LINE__); \
  } while (0)

#endif
