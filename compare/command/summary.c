#include <stddef.h>

#include "compare/answers/flint.h"
#include "compare/command/commands.h"

struct summary_options {
  struct request request;
};
static const struct summary_options initial = { .request.style.format = FORMAT_TABLE };

static const struct option options_of_summary[] = {
  OPTIONS_CRAWLER, OPTION_FORMULAS, OPTION_POINTS, OPTION_FORMAT, OPTION_DIGITS(DIGITS_OF_DOUBLES, DOUBLE_DIGITS),
  OPTIONS_LAST,
};

static const char *plan(const void *options, struct rows *rows)
{
  (void)options;
  const struct flint_part *flint = load_flint("summary", "this command");
  return flint ? flint->summary_plan(rows) : "";
}

const struct command command_summary = {
  .name = "summary",
  .options = options_of_summary,
  .size = sizeof(struct summary_options),
  .initial = &initial,
  .plan = plan,
};
