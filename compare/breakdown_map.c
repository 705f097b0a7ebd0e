#include "compare/breakdown.h"
#include "compare/with_flint.h"

enum exit_code breakdown_map(const struct options *options)
{
  (void)options;
  return EXIT_UNSOLVED;
}

enum exit_code breakdown_boundaries(const struct options *options)
{
  (void)options;
  return EXIT_UNSOLVED;
}
