#include <stddef.h>

#include "compare/command/commands.h"
#include "compare/stress/stress.h"
#include "compare/points/defaults.h"
#include "compare/answers/flint.h"

static const struct option options_of_stress[] = {
  OPTIONS_CRAWLER("%s where another parameter is given, else those of the cases", "each in turn; of a single point %s"),
  OPTION_PHASE("with --v0 %s, else the steady state"),
  OPTION_V0("with --phase %s"),
  OPTION_TEXT("family", "NAME", "this family only", "all", stress_options, family, "the name of a family"),
  OPTION_COUNT("cases", "N", "cases of each family and gait",
               TEXT_OF(STRESS_CASES) "; with --check " TEXT_OF(STRESS_CHECK_STEADY) ", of phases " TEXT_OF(
                   STRESS_CHECK_PHASES) ", with --full " TEXT_OF(STRESS_FULL_CASES),
               stress_options, cases, 1, 1000000),
  OPTION_COUNT("seed", "N", "seed of the parameters of the cases", NULL, stress_options, seed, 0, 1000000000),
  OPTION_FLAG("check", "few cases, for a gait of each kind but measured; exit code 1 if a promise is broken",
              stress_options, check),
  OPTION_FLAG("full", "many cases: takes hours; each row is written when its family is done", stress_options, full),
  OPTION_FLAG("stiff", "friction smoothed for stiff ODE solvers, instead", stress_options, stiff),
  OPTION_FLAG("quick", "with --stiff: delta down to 1e-5 only", stress_options, quick),
  OPTION_FLAG("summary", "with --stiff: the order in delta, and where each stepper gives up", stress_options, summary),
  OPTION_FORMAT("tsv"),
  OPTIONS_PLOT,
  OPTIONS_LAST,
};
static const struct stress_options initial = { .seed = { 1, false } };

#define OF_A_POINT "m1 m2 F1 F2 L T alpha phase v0"
static const struct option_rule rules[] = {
  { "family cases seed full check phase v0", RULE_WITH, "stiff", NULL },
  { "quick summary", RULE_WITHOUT, "stiff", NULL },
  { "family cases seed full", RULE_WITH, OF_A_POINT, "has nothing to do where one point is examined" },
  { NULL, RULE_WITH, NULL, NULL },
};

static enum exit_code run(const struct arguments *arguments, const void *options)
{
  const struct stress_options *o = options;
  const struct flint_part *flint = flint_for("stress", "this command");
  if (!flint)
    return EXIT_UNSOLVED;
  if (o->stiff)
    return flint->stress_stiff(o);
  return given_option(arguments, OF_A_POINT) ? flint->stress_point(o) : flint->stress_table(o);
}

const struct command command_stress = {
  .name = "stress",
  .summary = "how many digits survive, on stiff and extreme cases",
  .example = "scallop stress --family near-grazing --cases 50",
  .options = options_of_stress,
  .rules = rules,
  .size = sizeof(struct stress_options),
  .initial = &initial,
  .run = run,
};
