#include <stddef.h>

#include "compare/command/commands.h"
#include "compare/workprec/table.h"
#include "compare/answers/flint.h"

static const struct option options_of_workprec[] = {
  OPTIONS_CRAWLER,
  OPTION_FLAG("quick", workprec_options, quick),
  OPTION_NUMBER("limit", workprec_options, limit, FROM_TO(1e-3, 3600, "seconds, from 0.001 to 3600")),
  OPTION_FORMULAS,
  OPTION_FORMAT,
  OPTIONS_PLOT,
  OPTIONS_LAST,
};

static enum exit_code run(const struct arguments *arguments, const void *options)
{
  const struct flint_part *flint = load_flint("workprec", "this command");
  (void)arguments;
  return flint ? flint->workprec_table(options) : EXIT_UNSOLVED;
}

const struct command command_workprec = {
  .name = "workprec",
  .options = options_of_workprec,
  .size = sizeof(struct workprec_options),
  .run = run,
};
