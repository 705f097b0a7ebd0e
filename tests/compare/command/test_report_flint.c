/* What `scallop series` keeps of a motion that has no series. */
#include "tests/support/check.h"

#include "compare/command/report_flint.h"

/* The reason ends with the motion that has none, before it is told on standard error. */
TEST(reason_outlives_its_motion)
{
  const struct series_options options = { .symbolic = true };
  struct report r = { .options = &options, .language = &language_python };
  char first[] = "the limit takes more terms", second[] = "another reason";
  assert_false(report_failure(&r, &(struct reported_motion){ .phase = "period", .start = "product" },
                              SCALLOP_EUNDECIDED, first));
  memset(first, '?', strlen(first));
  assert_false(
      report_failure(&r, &(struct reported_motion){ .phase = "period", .start = "alpha" }, SCALLOP_EUNDECIDED, second));
  assert_string_equal(r.why, "the limit takes more terms");
}
