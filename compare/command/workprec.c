#include <stddef.h>

#include "compare/command/commands.h"
#include "compare/workprec/table.h"
#include "compare/points/defaults.h"
#include "compare/command/with_flint.h"

#pragma weak workprec_table

static const struct option options_of_workprec[] = {
  OPTIONS_TO_L(NULL),
  OPTION_T(TEXT_OF(WORKPREC_T) "; with --quick " TEXT_OF(WORKPREC_QUICK_T)),
  OPTIONS_ALPHA_GAIT(NULL, "both of the paper: quadratic and sinusoidal"),
  OPTION_FLAG("quick", "few settings, few T and a short limit: a look, in seconds", workprec_options, quick),
  OPTION_NUMBER("limit", "SECONDS", "for each method and setting, from 0.001 to 3600",
                TEXT_OF(WORKPREC_LIMIT) "; with --quick " TEXT_OF(WORKPREC_QUICK_LIMIT), workprec_options, limit,
                FROM_TO(1e-3, 3600, "seconds, from 0.001 to 3600")),
  OPTION_BOOK("the formulas of this book for the steady state too"),
  OPTION_FORMAT("tsv"),
  OPTIONS_PLOT,
  OPTIONS_LAST,
};

static enum exit_code run(const struct arguments *arguments, const void *options)
{
  return has_flint(arguments, "this command") ? workprec_table(options) : EXIT_UNSOLVED;
}

const struct command command_workprec = {
  .name = "workprec",
  .summary = "error against run time, of every way to get the steady state",
  .example = "scallop workprec --quick --gait quadratic --T 0.5",
  .options = options_of_workprec,
  .size = sizeof(struct workprec_options),
  .about = "One row for each method, setting, gait, T and quantity: v_start (velocity at the start of the\n"
           "extension) and displacement (of the geometric centre over a period). \n"
           "kind: formula, exact, root or simulation (both of rivals). error: |answer - certified| /\n"
           "|certified|; over L/T and L where the certified value is 0; of a certified answer the far end of its\n"
           "ball. Parameters are the doubles nearest to what is written, for every method. time: seconds for one\n"
           "solve: median, minimum and quartiles over the repetitions. Methods take turns; fast ones are batched\n"
           "until the clock's own cost is below a thousandth. Only ratios within one table mean anything.\n"
           "gait_evaluations, events, root_iterations, periods: work that a solve takes; nan where there is no\n"
           "such thing. pareto: yes where, at this gait, T and quantity, no other row is as exact and as fast,\n"
           "and better in one. status: ok: the method was content, however wrong: a root or a simulation of a\n"
           "map whose own error outweighs what friction does in a period settles somewhere else; cut off: by the\n"
           "limit (time is what it took until then, error that of where it stood); or why there is no answer.\n"
           "The whole run takes some 5 minutes. Methods:\n"
           "published: the paper's formula; corrected: what stands in its place where in the limit a body does\n"
           "not turn. limit, derived series: derived and summed, all of it timed. exact: the double solver.\n"
           "certified: ball arithmetic.\n"
           "The rivals, each simulated from rest until its periods repeat, and as the root of its period map:\n"
           "gsl rkf45, rk8pd, SUNDIALS cvode, with events located; smoothed: tanh(v/delta) for sgn v, on GSL's\n"
           "stiff stepper msbdf; moreau: time stepping, which steps over events.\n"
           "Which method is the cheapest for a wanted error: LC_ALL=C awk -f cheapest.awk FILE, in scripts/ of\n"
           "the sources, installed in share/scallop/.",
  .run = run,
};
