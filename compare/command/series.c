/* Options of `scallop series`. */
#include "compare/command/series_options.h"

#include "compare/answers/flint.h"
#include "compare/command/commands.h"

static const char *const sources[] = { "published", "derived", "limit", "closed", NULL };
static const char *const languages[] = { "text", "latex", "python", NULL };
static const struct option options_of_series[] = {
  OPTIONS_CRAWLER,
  OPTION_POINT("v0"),
  OPTION_WORD("source", series_options, source, sources),
  OPTION_COUNT("order", series_options, order, 1, 1000),
  OPTION_FLAG("symbolic", series_options, symbolic),
  OPTION_WORD("emit", series_options, emit, languages),
  OPTION_FLAG("bound", series_options, bound),
  OPTION_FORMULAS,
  OPTION_TEXT("only", series_options, only, "names or equations of formulas, separated by commas"),
  OPTION_POINTS,
  OPTIONS_VARY,
  OPTION_FLAG("rows", series_options, rows),
  OPTION_TEXT("parts", series_options, parts, "names of parts, separated by commas"),
  OPTION_FLAG("orders", series_options, orders),
  OPTION_NUMBER("expect", series_options, expect, FINITE),
  OPTION_NUMBER("tol", series_options, tolerance, POSITIVE),
  OPTIONS_ERRORS,
  OPTION_STATS,
  OPTION_FORMAT,
  OPTION_DIGITS(DIGITS_PROVEN("with --source derived or limit"), MAX_DIGITS),
  OPTIONS_PLOT,
  OPTIONS_LAST,
};
static const struct series_options initial = {
  .source = { "published", false }, .order = { 8, false }, .emit = { "text", false }, .tolerance = { 0.1, false }
};

#define DERIVED "bound source=derived source=limit source=closed"
static const struct option_rule rules[] = {
  { "digits", RULE_WITH, "bound",
    "and --bound exclude each other: bounds are rounded to four digits, to the safe side" },
  { "bound digits points formulas only", RULE_WITH, "symbolic",
    "and --symbolic exclude each other: formulas are exact, and of one motion" },
  { "format plot columns", RULE_WITH, "emit=latex emit=python", "is for tables: with --emit it is of no use" },
  { "symbolic", RULE_WITH, "source=published", "is for the derived series: the published ones are formulas already" },
  { "source=closed", RULE_WITHOUT, "symbolic", "closed needs --symbolic: it is the steady state as a formula" },
  { "emit=latex emit=python", RULE_WITHOUT, "source=derived symbolic",
    "is for derived series: give --source derived, or --symbolic" },
  { "order", RULE_WITH, "source=closed", "and --source closed exclude each other: a closed form has no terms" },
  { "order", RULE_WITHOUT, "source=derived bound symbolic",
    "needs --source derived, or --bound: the published formulas have a fixed order, and the limit is one term" },
  { "bound", RULE_WITH, "source=published source=limit", "is for the derived series: leave --source out" },
  { "only", RULE_WITH, DERIVED,
    "is for the published formulas, and names derived ones: leave --source and --bound out" },
  { "formulas", RULE_WITH, DERIVED, "is for the published formulas: --source derived, limit and --bound have none" },
  { "points", RULE_WITH, "bound source=closed", "is for --source published and derived: one point at a time here" },
  { "rows orders", RULE_WITH, "symbolic bound source=closed emit=latex emit=python",
    "is for the values of series: one point at a time here" },
  { "expect tol", RULE_WITHOUT, "orders", "needs --orders" },
  { "parts", RULE_WITH, "orders", "and --orders exclude each other: orders are those of the errors" },
  { "v0", RULE_WITH, "bound source=limit source=closed",
    "is for the formulas and series of a phase: --bound and --source limit and closed are about the steady state" },
  { NULL, RULE_WITH, NULL, NULL },
};

static bool has_rows(const void *options)
{
  const struct series_options *o = options;
  return series_are_rows(o) || (!o->symbolic && is_from(o, "published"));
}

/* Checks that no rule covers */
static const char *complete(void *options)
{
  const struct series_options *o = options;
  /* bounds and formulas of higher orders take minutes */
  long max = o->bound ? 60 : !o->symbolic ? o->order.value : is_from(o, "limit") ? 10 : 16;
  const char *what = o->bound ? "bound" : is_from(o, "limit") ? "symbolic --source limit" : "symbolic";
  const char *of_rows = o->parts                     ? "parts"
                        : o->request.accuracy.given  ? "accuracy"
                        : o->request.reference.given ? "reference"
                                                     : NULL;
  if (o->order.value > max)
    return wrong_text("--%s takes an --order from 1 to %ld", what, max);
  if (of_rows && !series_are_rows(o))
    return wrong_text("--%s is about rows of points: give --rows, or a list or a range", of_rows);
  return NULL;
}

static enum exit_code run(const struct arguments *arguments, const void *options)
{
  const struct series_options *o = options;
  (void)arguments;
  const struct flint_part *flint = load_flint("series", o->symbolic ? "--symbolic"
                                                        : o->bound  ? "--bound"
                                                                    : "--source derived or limit");
  return flint ? flint->series_report(o) : EXIT_UNSOLVED;
}

const struct command command_series = {
  .name = "series",
  .options = options_of_series,
  .size = sizeof(struct series_options),
  .initial = &initial,
  .rules = rules,
  .complete = complete,
  .plan = series_plan,
  .has_rows = has_rows,
  .run = run,
};
