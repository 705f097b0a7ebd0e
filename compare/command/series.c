#include <stdlib.h>
#include <string.h>

#include "compare/answers/flint.h"
#include "compare/book/book.h"
#include "compare/command/commands.h"
#include "compare/command/series_options.h"

#define DIGITS DIGITS_PROVEN("with --source derived or limit")
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
  OPTION_BOOK,
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
  OPTION_DIGITS(DIGITS, MOST_DIGITS),
  OPTIONS_PLOT,
  OPTIONS_LAST,
};
static const struct series_options initial = {
  .source = { "published", false }, .order = { 8, false }, .emit = { "text", false }, .tolerance = { 0.1, false }
};
static const char *const columns[] = { "formula",   "equation", "phase", "quantity", "remainder",
                                       "published", "exact",    "error", NULL };

static void write_formula(struct table *table, const struct series_use *use, double published, double exact)
{
  static const char *const motions[] = { "extension", "contraction", "period" };
  const struct scallop_formula *f = use->formula;
  char order[32] = "-";
  if (f->remainder > 0)
    snprintf(order, sizeof order, f->remainder == 1 ? "O(T)" : "O(T^%d)", f->remainder);
  const char *const texts[] = { f->name, f->equation, motions[use->of],
                                formula_quantity_text(f, (enum scallop_phase_kind)(use->of % PERIOD)), order };
  for (int i = 0; i < 5; i++)
    table_text(table, texts[i]);
  table_number(table, published);
  table_number(table, exact);
  table_number(table, published - exact);
}

static bool open_table(struct table *table, const struct request *request)
{
  /* Where l'' = 0 at an end of a phase a formula that divides by it has no value, and no infinite one. */
  static const char no_ends[] = "l'' = 0 where a phase of this gait begins or ends: formulas that divide by it are nan";
  char v0[80] = "the exact steady velocity at the start of each phase";
  if (!table_head(table, &request->style, "series"))
    return false;
  table->of = "published";
  note_parameters(table, &request->point, NULL, false);
  if (request->point.has_v0)
    number_text(v0, request->point.v0, 0);
  table_note(table, "v0: %s", v0);
  if (!gait_has_ends(request->point.crawler.gait)) {
    table_note(table, "%s", no_ends);
    if (!request->style.quiet)
      complain("series", "%s", no_ends);
  }
  table_columns(table, columns);
  table_begin_rows(table);
  return true;
}

/* A row for each formula at the one point */
static enum exit_code write_formulas(struct at *at, const struct series_options *o, int steady,
                                     const struct series_use *uses, const int places[][2], int count)
{
  struct table table;
  sweep_place_set(&at->place, &o->request.point);
  at_move(at);
  at_number(at, steady);
  if (at->why[0] != '\0')
    return complain("series", "%s", at->why), EXIT_UNSOLVED;
  if (!open_table(&table, &o->request))
    return EXIT_FILE;
  for (int i = 0; i < count; i++)
    write_formula(&table, &uses[i], at_number(at, places[i][0]), at_number(at, places[i][1]));
  return table_close(&table) ? EXIT_DONE : EXIT_FILE;
}

static enum exit_code run_point(const struct series_options *o)
{
  struct asked *asked = o->request.asked;
  struct series_use uses[MOST_SERIES];
  int count = series_uses(uses, o), places[MOST_SERIES][2], steady = quantity_named(&asked->quantities, "v_start");
  asked->from_steady = true;
  asked->accuracy = 0;
  for (int i = 0; i < count; i++) {
    char name[QUANTITY_NAME], exact[2 * QUANTITY_NAME];
    snprintf(exact, sizeof exact, "exact.%s", series_use_name(name, &uses[i]));
    places[i][0] = quantity_named(&asked->quantities, name);
    places[i][1] = quantity_named(&asked->quantities, exact);
  }
  struct at *at = at_new(asked);
  enum exit_code code = at ? write_formulas(at, o, steady, uses, places, count) : EXIT_UNSOLVED;
  at_free(at);
  return code;
}

static bool has_rows(const void *options)
{
  const struct series_options *o = options;
  return o->rows || o->orders || (has_many_points(&o->request) && !o->symbolic && !o->bound);
}

#define DERIVED "bound source=derived source=limit source=closed"
static const struct option_rule rules[] = {
  { "digits", RULE_WITH, "bound",
    "and --bound exclude each other: bounds are rounded to four digits, to the safe side" },
  { "bound digits points book only", RULE_WITH, "symbolic",
    "and --symbolic exclude each other: formulas are exact, and of one motion" },
  { "format plot columns", RULE_WITH, "emit=latex emit=python", "is for tables: with --emit it is of no use" },
  { "symbolic", RULE_WITH, "source=published",
    "is for the derived series: the published ones are formulas as they stand" },
  { "source=closed", RULE_WITHOUT, "symbolic", "closed needs --symbolic: it is the steady state as a formula" },
  { "emit=latex emit=python", RULE_WITHOUT, "source=derived symbolic",
    "is for derived series: give --source derived, or --symbolic" },
  { "order", RULE_WITH, "source=closed", "and --source closed exclude each other: a closed form has no terms" },
  { "order", RULE_WITHOUT, "source=derived bound symbolic",
    "needs --source derived, or --bound: the published formulas end where they end, and the limit is one term" },
  { "bound", RULE_WITH, "source=published source=limit", "is for the derived series: leave --source out" },
  { "only", RULE_WITH, DERIVED,
    "is for the published formulas, and names derived ones: leave --source and --bound out" },
  { "book", RULE_WITH, DERIVED, "is for the published formulas: --source derived, limit and --bound have none" },
  { "points", RULE_WITH, "bound source=closed", "is for --source published and derived: one point at a time here" },
  { "rows orders", RULE_WITH, "symbolic bound source=closed emit=latex emit=python",
    "is for the values of series: one point at a time here" },
  { "expect tol", RULE_WITHOUT, "orders", "needs --orders" },
  { "parts", RULE_WITH, "orders", "and --orders exclude each other: orders are those of the errors" },
  { "v0", RULE_WITH, "bound source=limit source=closed",
    "is for the formulas and series of a phase: --bound and --source limit and closed are about the steady state" },
  { NULL, RULE_WITH, NULL, NULL },
};

/* Bounds and formulas of higher orders take minutes. */
static long most_order(const struct series_options *o)
{
  return o->bound ? 60 : !o->symbolic ? o->order.value : is_from(o, "limit") ? 10 : 16;
}

static bool is_sound(const void *options)
{
  const struct series_options *o = options;
  bool published = !o->symbolic && is_from(o, "published");
  if (o->order.value > most_order(o))
    return complain("series", "--%s takes an --order from 1 to %ld",
                    o->bound              ? "bound"
                    : is_from(o, "limit") ? "symbolic --source limit"
                                          : "symbolic",
                    most_order(o));
  const char *of_rows = o->parts                     ? "parts"
                        : o->request.accuracy.given  ? "accuracy"
                        : o->request.reference.given ? "reference"
                                                     : NULL;
  if (of_rows && !has_rows(o))
    return complain("series", "--%s is about rows of points: give --rows, or a list or a range", of_rows);
  return has_rows(o) || digits_hold(&o->request.style, !published, DIGITS);
}

/* Is each item of --only a formula? Books have been read. False: the message is on stderr. */
static bool only_holds(const char *only)
{
  char item[FORMULA_PLACE];
  while (next_item(item, sizeof item, &only)) {
    const struct scallop_formula *f = formula_named(item), *listed = NULL;
    for (int i = 0; f && (listed = listed_formula(i)) && listed != f; i++)
      ;
    if (!listed)
      return complain("series", "--only: there is no formula '%s' here%s", item, formula_instead(item));
  }
  return true;
}

static enum exit_code run(const struct arguments *arguments, const void *options)
{
  const struct series_options *o = options;
  (void)arguments;
  if (o->only && !only_holds(o->only))
    return EXIT_USAGE;
  if (!o->symbolic && is_from(o, "published"))
    return run_point(o);
  const struct flint_part *flint = flint_for("series", o->symbolic ? "--symbolic"
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
  .is_sound = is_sound,
  .plan = series_plan,
  .has_rows = has_rows,
  .run = run,
};
