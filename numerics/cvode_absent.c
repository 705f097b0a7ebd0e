/* In the place of cvode.c where a program is built without SUNDIALS. */
#include <stddef.h>

#include "numerics/cvode.h"

bool scallop_has_cvode(void) { return false; }

struct scallop_rival *scallop_cvode_rival(double tolerance)
{
  (void)tolerance;
  return NULL;
}
