#include <stddef.h>

#include "compare/command/commands.h"
#include "compare/command/flint.h"
#include "compare/summary/summary.h"

struct summary_options {
  struct request request;
};
static const struct summary_options initial = { .request.style.format = FORMAT_TABLE };

static const struct option options_of_summary[] = {
  OPTIONS_CRAWLER(NULL, NULL),
  OPTION_BOOK("the formulas of this book too"),
  OPTION_POINTS,
  OPTION_FORMAT("table"),
  OPTION_DIGITS(DIGITS_OF_DOUBLES, "6, in the other formats " READ_BACK, DOUBLE_DIGITS),
  OPTIONS_LAST,
};

static enum exit_code run(const struct arguments *arguments, const void *options)
{
  const struct summary_options *o = options;
  const struct flint_part *flint = flint_for("summary", "this command");
  (void)arguments;
  return flint ? flint->summary_table(&o->request) : EXIT_UNSOLVED;
}

const struct command command_summary = {
  .name = "summary",
  .summary = "one page about a crawler: what it does, which formulas hold for it, and up to which T",
  .example = "scallop summary --F1 3 --T 0.5",
  .options = options_of_summary,
  .size = sizeof(struct summary_options),
  .initial = &initial,
  .run = run,
};
