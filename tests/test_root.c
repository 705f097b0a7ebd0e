/* The root finder of the solver: roots at the ends, and functions on which Newton's method has nothing to go by. */
#include "tests/check.h"

#include <float.h>

#include "numerics/root.h"

struct power { /* f = sign (u - root)^n + lift */
  double root, sign, lift;
  int n;
};

static double power(const void *context, double u, double *slope)
{
  const struct power *p = context;
  *slope = p->sign * p->n * pow(u - p->root, p->n - 1);
  return p->sign * pow(u - p->root, p->n) + p->lift;
}

static double between(const struct power *p, double from, double to)
{
  struct root_end a = { .u = from }, b = { .u = to };
  a.f = power(p, from, &a.slope);
  b.f = power(p, to, &b.slope);
  return root_between(power, p, a, b);
}

static void at_the_ends(void **state)
{
  (void)state;
  for (int n = 1; n <= 3; n += 2)
    for (int sign = -1; sign <= 1; sign += 2) {
      const struct power p = { 0.375, sign, 0, n };
      CHECK_EQUAL(between(&p, 0.375, 1), 0.375);
      CHECK_EQUAL(between(&p, 0.125, 0.375), 0.375);
      CHECK_EQUAL(between(&p, 1, 0.375), 0.375);
    }
}

/* Simple roots to the last digit, and from either side */
static void simple_roots(void **state)
{
  (void)state;
  for (int n = 1; n <= 5; n++)
    for (int sign = -1; sign <= 1; sign += 2) {
      const struct power p = { 0, sign, -sign * pow(0.3, n), n };
      CHECK_RELATIVE(between(&p, 0.1, 1), 0.3, 4 * DBL_EPSILON);
      CHECK_RELATIVE(between(&p, 1, 0.1), 0.3, 4 * DBL_EPSILON);
    }
}

/* f' = 0 at the root: as near as f tells. */
static void flat_roots(void **state)
{
  (void)state;
  for (int sign = -1; sign <= 1; sign += 2) {
    const struct power p = { 0.3, sign, 0, 3 };
    CHECK_NEAR(between(&p, 0.1, 1), 0.3, 1e-6);
    CHECK_NEAR(between(&p, 1, 0.1), 0.3, 1e-6);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(at_the_ends),
    cmocka_unit_test(simple_roots),
    cmocka_unit_test(flat_roots),
  };
  return cmocka_run_group_tests_name("root", tests, NULL, NULL);
}
