/* The numbers in the texts of --help (docs/help/) are those that the code uses. */
#include <stdio.h>

#include "compare/breakdown/breakdown.h"
#include "compare/command/commands.h"
#include "compare/points/defaults.h"
#include "compare/stress/stress.h"
#include "compare/summary/summary.h"
#include "compare/text/shipped.h"
#include "tests/support/check.h"

TEST(every_command_has_a_text)
{
  for (const struct command *const *c = commands; *c; c++)
    assert_non_null(shipped_text(shipped_help, (*c)->name));
}

TEST(numbers_are_those_of_the_code)
{
  static const double map[] = { BREAKDOWN_MAP_TOLERANCES };
  enum { TEXT = 80, CASES = 8 };
  char said[CASES][TEXT];
  const char *const commands_of[CASES] = { "stress",    "stress",    "stress",  "stress",
                                           "breakdown", "breakdown", "summary", "breakdown" };
  snprintf(said[0], TEXT, "Promised: at most %d units", STRESS_PROMISE);
  snprintf(said[1], TEXT, "promised: %d (each operation", STRESS_ROUNDING);
  snprintf(said[2], TEXT, "promised: %d + 2 * %d", STRESS_PERTURBED - 2 * STRESS_PROMISE, STRESS_PROMISE);
  snprintf(said[3], TEXT, "\nfrom 1 to %d,", STRESS_GENEROUS);
  snprintf(said[4], TEXT, "the terms below T^%d, are off", SUMMARY_ORDER);
  snprintf(said[5], TEXT, "up to %d, with the least error", STUDY_MANY);
  snprintf(said[6], TEXT, "more than %g %% and %g %%", 100 * summary_levels[0], 100 * summary_levels[1]);
  snprintf(said[7], TEXT, "for 1e-%.0f and 1e-%.0f", -log10(map[0]), -log10(map[1]));
  for (int i = 0; i < CASES; i++)
    if (!strstr(shipped_text(shipped_help, commands_of[i]), said[i]))
      fail_msg("docs/help/%s.txt does not have: %s", commands_of[i], said[i]);
}
