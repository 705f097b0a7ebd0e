#include "tests/check.h"

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

void check_fail(const char *expression, double got, double wanted, double tolerance, const char *kind, const char *file,
                int line)
{
  print_error("%s = %.17g, wanted %.17g: off by %.3g, %s tolerance %.3g\n", expression, got, wanted, got - wanted, kind,
              tolerance);
  _fail(file, line);
}
