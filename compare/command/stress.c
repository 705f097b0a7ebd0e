#include <stddef.h>

#include "compare/command/commands.h"
#include "compare/stress/stress.h"
#include "compare/points/defaults.h"
#include "compare/command/with_flint.h"

#pragma weak stress_table
#pragma weak stress_point
#pragma weak stress_stiff

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
  if (!has_flint(arguments, "this command"))
    return EXIT_UNSOLVED;
  return (o->stiff ? stress_stiff : given_option(arguments, OF_A_POINT) ? stress_point : stress_table)(o);
}

const struct command command_stress = {
  .name = "stress",
  .summary = "how many digits survive, on stiff and extreme cases",
  .example = "scallop stress --family near-grazing --cases 50",
  .options = options_of_stress,
  .rules = rules,
  .size = sizeof(struct stress_options),
  .initial = &initial,
  .about = "One row for each family of cases and gait: quasi-random parameters where digits are in danger,\n"
           "solved in double and judged by certified values. Errors are counted in units: the ulp of the result\n"
           "or, if that is more, the sum of what one ulp of each parameter changes it by (condition times ulp;\n"
           "differences, in binary128, so that the corners and square roots at boundaries of modes count for\n"
           "what they are). Promised: at most 8 units; docs/stability.md lists the exceptions. units: the\n"
           "largest error; quantity, ulp, condition, digits (kept) there; worst_at: its parameters, for steady\n"
           "or phase. ulp_median: over all numbers of all cases. refused: left by the solver with 'out of\n"
           "range'. undecided: by the certified solver (a body touches exactly); binary128 stands in for it\n"
           "there. other_modes: cases in which binary128 finds other modes, within rounding of a boundary; what\n"
           "jumps there (multiplier, t1, dT) is not judged then. rounding: spread over the four IEEE rounding\n"
           "modes, in units, promised: 32 (each operation errs by twice as much, and it is the distance of two).\n"
           "perturbed: largest change when one parameter is an ulp off, promised: 1 + 2 * 8. lost_...: most\n"
           "decimal digits that double, 80-bit long double and binary128 lose in a number, conditioning\n"
           "included. estimate_least, _most: estimate of the error (steady --error) over the error. Promised:\n"
           "from 1 to 100, errors below the 128th part of an ulp counting as that.\n"
           "Which families there are, and what each is, stands in the '#' lines of a table (--cases 1 is fast).\n"
           "With parameters: the same for one point, a row for each number (certified rounded to a double;\n"
           "estimate: of the error itself); with --phase or --v0 of a phase. A broken promise is reported with\n"
           "that command.\n"
           "--stiff: friction smoothed over a velocity delta, for stiff ODE solvers: error and cost as delta ->\n"
           "0, the order in delta measured, where each stepper gives up, and how far a body that should stick\n"
           "creeps. With parameters: of that crawler.",
  .run = run,
};
