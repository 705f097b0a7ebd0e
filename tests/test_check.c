/* The comparator must fail when it should, above all on NaN. */
#include "tests/check.h"

#include <stdlib.h>

static void accepts(void **state)
{
  (void)state;
  assert_true(check_near(1, 1 + 1e-15, 1e-14));
  assert_true(check_near(NAN, NAN, 0));
  assert_true(check_near(INFINITY, INFINITY, 0));
  assert_true(check_relative(1e-300, 1.0000001e-300, 1e-6));
}

static void refuses(void **state)
{
  (void)state;
  assert_false(check_near(NAN, 1, 1e300));
  assert_false(check_near(1, NAN, 1e300));
  assert_false(check_near(INFINITY, -INFINITY, INFINITY));
  assert_false(check_near(INFINITY, 1, INFINITY));
  assert_false(check_near(1, 1.1, 0.05));
  assert_false(check_near(1, 1, NAN));
  assert_false(check_relative(1e-300, 2e-300, 0.1));
}

static void thins_out_only_when_asked(void **state)
{
  (void)state;
  static const char name[] = "SCALLOP_TEST_THIN";
  unsetenv(name);
  assert_int_equal(check_cases(41), 41);
  setenv(name, "not a number", 1);
  assert_int_equal(check_cases(41), 41);
  setenv(name, "20", 1);
  assert_int_equal(check_cases(41), 3);
  assert_int_equal(check_cases(1), 1);
}

int main(void)
{
  const struct CMUnitTest tests[] = { cmocka_unit_test(accepts), cmocka_unit_test(refuses),
                                      cmocka_unit_test(thins_out_only_when_asked) };
  return cmocka_run_group_tests_name("check", tests, NULL, NULL);
}
