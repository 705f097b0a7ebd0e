#include <stddef.h>

#include "compare/command/compare.h"
#include "compare/answers/defaults.h"
#include "compare/command/with_flint.h"

static const char *const accepts[] = { "m1",    "m2",      "F1",     "F2",     "L",     "T",     "alpha", "gait",
                                       "phase", "v0",      "family", "cases",  "seed",  "check", "full",  "stiff",
                                       "quick", "summary", "format", "output", "quiet", NULL };

static bool is_point(const struct options *o)
{
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    if (o->point.written[i])
      return true;
  return o->point.has_phase || o->point.has_v0;
}

/* An option that the table asked for has no use for; NULL if there is none. */
static const char *useless(const struct options *o, bool point)
{
  if (o->stiff)
    return o->family            ? "family"
           : o->cases > 0       ? "cases"
           : o->has_seed        ? "seed"
           : o->full            ? "full"
           : o->check           ? "check"
           : o->point.has_phase ? "phase"
           : o->point.has_v0    ? "v0"
                                : NULL;
  if (o->quick || o->summary)
    return o->quick ? "quick" : "summary";
  if (point)
    return o->family ? "family" : o->cases > 0 ? "cases" : o->has_seed ? "seed" : o->full ? "full" : NULL;
  return NULL;
}

static enum exit_code run(const struct options *options)
{
  bool point = is_point(options);
  const char *idle = useless(options, point);
  if (idle) {
    complain("stress", "--%s has nothing to do %s", idle,
             options->stiff ? "with --stiff"
             : point        ? "where one point is examined"
                            : "without --stiff");
    return EXIT_USAGE;
  }
  if (!has_flint(options, "this command"))
    return EXIT_UNSOLVED;
  return options->stiff ? with_flint.stress_stiff(options)
         : point        ? with_flint.stress_point(options)
                        : with_flint.stress(options);
}

static const struct unless_given unless_given[] = {
  { "m1 m2 F1 F2 L T alpha", "%s where another parameter is given, else those of the cases" },
  { "gait", "each in turn; of a single point %s" },
  { "phase", "with --v0 %s, else the steady state" },
  { "v0", "with --phase %s" },
  { "family", "all" },
  { "cases", TEXT_OF(STRESS_CASES) "; with --check " TEXT_OF(STRESS_CHECK_STEADY) ", of phases " TEXT_OF(
                 STRESS_CHECK_PHASES) ", with --full " TEXT_OF(STRESS_FULL_CASES) },
  { NULL, NULL },
};

const struct command command_stress = {
  .name = "stress",
  .summary = "how many digits survive, on stiff and extreme cases",
  .example = "scallop stress --family near-grazing --cases 50",
  .accepts = accepts,
  .about =
      "One row for each family of cases and gait: quasi-random parameters where digits are in danger, solved in double and\n"
      "judged by certified values. Errors are counted in units: the ulp of the result or, if that is more, the sum of what\n"
      "one ulp of each parameter changes it by (condition times ulp; differences, in binary128, so that the corners and\n"
      "square roots at boundaries of modes count for what they are). Promised: at most 8 units, everywhere.\n"
      "units: the largest error; quantity, ulp, condition, digits (kept) there; worst_at: its parameters, for steady or "
      "phase.\n"
      "ulp_median: over all numbers of all cases. refused: left by the solver with 'out of range'. undecided: by the "
      "certified\n"
      "solver (a body touches exactly); binary128 stands in for it there.\n"
      "other_modes: cases in which binary128 finds other modes, within rounding of a boundary; what jumps there "
      "(multiplier, t1,\n"
      "dT) is not judged then.\n"
      "rounding: spread over the four IEEE rounding modes, in units, promised: 32 (each operation errs by twice as much, "
      "and\n"
      "it is the distance of two). perturbed: largest change when one parameter is an ulp off, promised: 1 + 2 * 8.\n"
      "lost_...: most decimal digits that double, 80-bit long double and binary128 lose in a number, conditioning "
      "included.\n"
      "estimate_least, _most: estimate of the error (steady --error) over the error. Promised: from 1 to 100, errors below "
      "the\n"
      "128th part of an ulp counting as that.\n"
      "Which families there are, and what each is, stands in the '#' lines of a table (--cases 1 is fast).\n"
      "With parameters: the same for one point, a row for each number (certified rounded to a double; estimate: of the "
      "error itself); with --phase or --v0 of a phase. A broken promise "
      "is\n"
      "reported with that command.\n"
      "--stiff: friction smoothed over a velocity delta, for stiff ODE solvers: error and cost as delta -> 0, the order in "
      "delta\n"
      "measured, where each stepper gives up, and how far a body that should stick creeps. With parameters: of that "
      "crawler.",
  .unless_given = unless_given,
  .run = run,
};
