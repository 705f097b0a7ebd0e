#include <stddef.h>

#include "compare/command/commands.h"
#include "compare/workprec/table.h"
#include "compare/points/defaults.h"
#include "compare/answers/flint.h"

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
  const struct flint_part *flint = flint_for("workprec", "this command");
  (void)arguments;
  return flint ? flint->workprec_table(options) : EXIT_UNSOLVED;
}

const struct command command_workprec = {
  .name = "workprec",
  .summary = "error against run time, of every way to get the steady state",
  .example = "scallop workprec --quick --gait quadratic --T 0.5",
  .options = options_of_workprec,
  .size = sizeof(struct workprec_options),
  .run = run,
};
