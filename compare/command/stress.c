#include <stddef.h>

#include "compare/command/commands.h"
#include "compare/stress/stress.h"
#include "compare/answers/flint.h"

static const struct option options_of_stress[] = {
  OPTIONS_CRAWLER,
  OPTIONS_PHASE,
  OPTION_TEXT("family", stress_options, family, "the name of a family"),
  OPTION_COUNT("cases", stress_options, cases, 1, 1000000),
  OPTION_COUNT("seed", stress_options, seed, 0, 1000000000),
  OPTION_FLAG("check", stress_options, check),
  OPTION_FLAG("full", stress_options, full),
  OPTION_FLAG("stiff", stress_options, stiff),
  OPTION_FLAG("quick", stress_options, quick),
  OPTION_FORMAT,
  OPTIONS_PLOT,
  OPTIONS_LAST,
};
static const struct stress_options initial = { .seed = { 1, false } };

#define OF_A_POINT "m1 m2 F1 F2 L T alpha phase v0"
static const struct option_rule rules[] = {
  { "family cases seed full check phase v0", RULE_WITH, "stiff", NULL },
  { "quick", RULE_WITHOUT, "stiff", NULL },
  { "family cases seed full", RULE_WITH, OF_A_POINT, "has nothing to do where one point is examined" },
  { NULL, RULE_WITH, NULL, NULL },
};

static enum exit_code run(const struct arguments *arguments, const void *options)
{
  const struct stress_options *o = options;
  const struct flint_part *flint = load_flint("stress", "this command");
  if (!flint)
    return EXIT_UNSOLVED;
  if (o->stiff)
    return flint->stress_stiff(o);
  return given_option(arguments, OF_A_POINT) ? flint->stress_point(o) : flint->stress_table(o);
}

const struct command command_stress = {
  .name = "stress",
  .options = options_of_stress,
  .rules = rules,
  .size = sizeof(struct stress_options),
  .initial = &initial,
  .run = run,
};
