#include "tests/support/check.h"

#include <stdlib.h>

enum { MOST_TESTS = 40 };
static struct CMUnitTest tests[MOST_TESTS];
void (*check_failed)(void);

static int explain(void **state)
{
  (void)state;
  if (check_failed)
    check_failed();
  check_failed = NULL;
  return 0;
}

void check_add(const char *name, CMUnitTestFunction test)
{
  int i = 0;
  while (i < MOST_TESTS && tests[i].name)
    i++;
  if (i == MOST_TESTS)
    abort();
  tests[i] = (struct CMUnitTest){ name, test, NULL, explain, NULL };
}

int check_run(CMFixtureFunction set_up, CMFixtureFunction tear_down)
{
  return cmocka_run_group_tests(tests, set_up, tear_down);
}

__attribute__((weak)) int main(void) { return check_run(NULL, NULL); }

bool check_near(double got, double wanted, double tolerance)
{
  if (isnan(got) || isnan(wanted))
    return isnan(got) && isnan(wanted);
  if (isinf(got) || isinf(wanted))
    return got == wanted;
  return fabs(got - wanted) <= tolerance;
}

bool check_relative(double got, double wanted, double tolerance)
{
  return check_near(got, wanted, tolerance * fabs(wanted));
}

long check_cases(long many)
{
  const char *thin = getenv("SCALLOP_TEST_THIN");
  long every = thin ? strtol(thin, NULL, 10) : 1;
  return every > 1 ? (many + every - 1) / every : many;
}

void check_fail(const char *expression, double got, double wanted, double tolerance, const char *kind, const char *file,
                int line)
{
  print_error("%s = %.17g, wanted %.17g: off by %.3g, %s tolerance %.3g\n", expression, got, wanted, got - wanted, kind,
              tolerance);
  _fail(file, line);
}
