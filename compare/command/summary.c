#include <stddef.h>

#include "compare/command/commands.h"
#include "compare/command/with_flint.h"
#include "compare/summary/summary.h"

#pragma weak summary_plan

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

static const char *plan(const void *options, struct rows *rows)
{
  (void)options;
  return summary_plan(rows);
}

const struct command command_summary = {
  .name = "summary",
  .summary = "one page about a crawler: what it does, which formulas hold for it, and up to which T",
  .example = "scallop summary --F1 3 --T 0.5",
  .options = options_of_summary,
  .size = sizeof(struct summary_options),
  .initial = &initial,
  .about = "A page for each crawler, in words: how it moves, and when its bodies turn; the paper's formulas for\n"
           "the steady state, each with its value, its error now, the verdict for this gait and these\n"
           "parameters, and the T from which it is off by more than 1 % and 5 %; the best order of the derived\n"
           "series; and the events that end the expansion. Nothing is computed otherwise than by `steady`,\n"
           "`claims` and `breakdown`, which show more.\n"
           "\n"
           "--format json, tsv, csv or markdown gives a row for each crawler instead: its steady state (`steady\n"
           "--help` has the names), motion (the modes in words, with times since the start of the extension),\n"
           "and for each formula NAME its value NAME, NAME_error (NAME/exact - 1), NAME_reach_1 and NAME_reach_5\n"
           "(the largest T up to which |error| stays below 1 % and 5 %; 0: it does not as T -> 0; inf: at every\n"
           "T), NAME_limit (what |error| tends to as T -> 0, if not to 0), NAME_verdict and NAME_order (of its\n"
           "error, proven; inf: exact). first_event, with its T and Froude number, is where the modes change\n"
           "first as T grows; reversals: the T at which the direction of crawling reverses; best_order: of the\n"
           "derived displacement, that the terms below T^best_order have the least error at this T, best_error.",
  .plan = plan,
  .needs_flint = true,
};
