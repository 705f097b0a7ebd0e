/* The comparator must fail when it should, above all on NaN. */
#include "tests/support/check.h"

#include <stdlib.h>

TEST(accepts)
{
  assert_true(check_near(1, 1 + 1e-15, 1e-14));
  assert_true(check_near(NAN, NAN, 0));
  assert_true(check_near(INFINITY, INFINITY, 0));
  assert_true(check_relative(1e-300, 1.0000001e-300, 1e-6));
}

TEST(refuses)
{
  assert_false(check_near(NAN, 1, 1e300));
  assert_false(check_near(1, NAN, 1e300));
  assert_false(check_near(INFINITY, -INFINITY, INFINITY));
  assert_false(check_near(INFINITY, 1, INFINITY));
  assert_false(check_near(1, 1.1, 0.05));
  assert_false(check_near(1, 1, NAN));
  assert_false(check_relative(1e-300, 2e-300, 0.1));
}

TEST(thins_out_only_when_asked)
{
  static const char name[] = "SCALLOP_TEST_THIN";
  unsetenv(name);
  assert_int_equal(check_cases(41), 41);
  setenv(name, "not a number", 1);
  assert_int_equal(check_cases(41), 41);
  setenv(name, "20", 1);
  assert_int_equal(check_cases(41), 3);
  assert_int_equal(check_cases(1), 1);
}
