#include <math.h>
#include <stdio.h>
#include <string.h>

#include "numerics/numerics.h"
#include "compare/answers/answer.h"
#include "compare/book/book.h"
#include "compare/points/gaits.h"
#include "compare/answers/points.h"
#include "compare/command/commands.h"
#include "compare/command/series_options.h"
#include "compare/command/flint.h"

#define DIGITS DIGITS_PROVEN("with --source derived or limit")
static const char *const sources[] = { "published", "derived", "limit", "closed", NULL };
static const char *const languages[] = { "text", "latex", "python", NULL };
static const struct option options_of_series[] = {
  OPTIONS_CRAWLER(NULL, NULL),
  OPTION_V0("the steady velocity of the phase; with --source derived only phases from rest"),
  OPTION_WORD("source", "SOURCE", "published, derived or limit; with --symbolic also closed", NULL, series_options,
              source, sources),
  OPTION_COUNT("order", "N", "derive all terms below T^N, N from 1 to 1000", NULL, series_options, order, 1, 1000),
  OPTION_FLAG("symbolic", "derived series with coefficients as formulas (--order to 16)", series_options, symbolic),
  OPTION_WORD("emit", "LANGUAGE", "derived series as text (a table), latex or python", NULL, series_options, emit,
              languages),
  OPTION_FLAG("bound", "bounds for the error of the derived terms below T^N", series_options, bound),
  OPTION_BOOK("the formulas of this book too, before the paper's"),
  OPTION_TEXT("only", "LIST", "these published formulas only: names or equations, \"(28)\", separated by commas", "all",
              series_options, only, "names or equations of formulas, separated by commas"),
  OPTION_POINTS,
  OPTION_FORMAT("tsv"),
  OPTION_DIGITS(DIGITS, READ_BACK "; with --source derived fractions, or 17 digits", MOST_DIGITS),
  OPTIONS_PLOT,
  OPTIONS_LAST,
};
static const struct series_options initial = { .source = { "published", false },
                                               .order = { 8, false },
                                               .emit = { "text", false } };
static const char *const columns[] = { "formula",   "equation", "phase", "quantity", "remainder",
                                       "published", "exact",    "error", NULL };
static const char *const extra[] = { "v0", NULL };

/* A formula and the motion that it is about: a kind of phase, or the period. */
enum { PERIOD = SCALLOP_CONTRACTION + 1, MOST_FORMULAS = 96 };
struct use {
  const struct scallop_formula *formula;
  int of;
};

/* Each formula that is asked for, once for each motion that it is about. Returns how many. */
static int list_uses(struct use uses[MOST_FORMULAS], const struct series_options *o)
{
  int n = 0;
  const struct scallop_formula *f;
  for (int i = 0; (f = listed_formula(i)) && n <= MOST_FORMULAS - 2; i++) {
    if (o->only && !formula_is_listed(o->only, f->name))
      continue;
    if (f->setting == SCALLOP_STEADY)
      uses[n++] = (struct use){ f, PERIOD };
    if (f->setting == SCALLOP_AT_REST_START || f->setting == SCALLOP_MOVING_EXTENSION)
      uses[n++] = (struct use){ f, SCALLOP_EXTENSION };
    if (f->setting == SCALLOP_AT_REST_START || f->setting == SCALLOP_MOVING_CONTRACTION)
      uses[n++] = (struct use){ f, SCALLOP_CONTRACTION };
  }
  return n;
}

static double finite(double x) { return isfinite(x) ? x : NAN; }

/* What the formulas and the exact motion have at a point. Where v0 is not given, the formulas with a start velocity
 * take the exact steady one of their phase. */
static enum scallop_status solve(const struct point *p, const struct use *uses, int count,
                                 double published[MOST_FORMULAS], double exact[MOST_FORMULAS])
{
  const struct scallop_crawler *c = &p->crawler;
  const struct motion period = motion_of(p, OF_STEADY);
  struct answer steady, phase;
  if (!answer_in_double(&steady, &period))
    return steady.status;
  for (int i = 0; i < count; i++) {
    const struct scallop_formula *f = uses[i].formula;
    if (uses[i].of == PERIOD) {
      published[i] = finite(published_value(f, &period, NULL));
      exact[i] = steady.value[quantity_of_formula(f, SCALLOP_EXTENSION)].high;
      continue;
    }
    enum scallop_phase_kind kind = (enum scallop_phase_kind)uses[i].of;
    double start = p->has_v0 ? p->v0 : steady.value[kind == SCALLOP_EXTENSION ? Q_V_START : Q_V_MID].high;
    const struct motion m = { OF_PHASE, *c, kind, f->setting == SCALLOP_AT_REST_START ? 0 : start };
    if (!answer_in_double(&phase, &m) || !answer_turnings(&phase, &m))
      return phase.status;
    published[i] = finite(published_value(f, &m, &phase));
    exact[i] = phase.value[quantity_of_formula(f, kind)].high;
  }
  return SCALLOP_OK;
}

static void write_formula(struct table *table, const struct use *use, double published, double exact)
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

/* Where l'' = 0 at an end of a phase a formula that divides by it has no value, and no infinite one. */
static const char no_ends[] = "l'' = 0 where a phase of this gait begins or ends: formulas that divide by it are nan";

/* What a row for a point has of each formula, "name" or "name:contraction": its value; of those of --only the exact
 * value and the relative error too, called as in scenes. */
static const char *const parts[] = { "", "exact.", "relative." };
static int parts_of(const struct series_options *o) { return o->only ? (int)(sizeof parts / sizeof *parts) : 1; }

static const char *row(struct table *table, const struct point *point, const void *context, const char *refused)
{
  const struct series_options *o = context;
  struct use uses[MOST_FORMULAS];
  double published[MOST_FORMULAS] = { 0 }, exact[MOST_FORMULAS] = { 0 };
  int count = list_uses(uses, o);
  enum scallop_status solved = refused ? SCALLOP_EDOMAIN : solve(point, uses, count, published, exact);
  const char *why = refused ? refused : solved < 0 ? scallop_status_text(solved) : NULL;
  for (int i = 0; i < count; i++) {
    const double values[] = { published[i], exact[i], finite((published[i] - exact[i]) / exact[i]) };
    for (int k = 0; k < parts_of(o); k++)
      table_number(table, why ? NAN : values[k]);
  }
  table_text(table, why ? why : gait_has_ends(point->crawler.gait) ? "ok" : no_ends);
  return why;
}

static enum exit_code run_points(const struct series_options *o)
{
  enum { LONGEST = 96, MOST = 3 * MOST_FORMULAS };
  struct use uses[MOST_FORMULAS];
  char names[MOST][LONGEST];
  const char *list[MOST + 2];
  int n = 0;
  for (int i = 0, count = list_uses(uses, o); i < count; i++)
    for (int k = 0; k < parts_of(o); k++) {
      bool again = i > 0 && uses[i].formula == uses[i - 1].formula;
      snprintf(names[n], LONGEST, "%s%s%s", parts[k], uses[i].formula->name, again ? ":contraction" : "");
      list[n] = names[n];
      n++;
    }
  list[n] = "status";
  list[n + 1] = NULL;
  const struct point_table table = { .extra = extra, .columns = list, .v0_may_be_nan = true, .row = row, .context = o };
  return for_each_point(&o->request, &table);
}

static enum exit_code run_point(const struct series_options *o)
{
  const struct request *request = &o->request;
  struct table table;
  struct use uses[MOST_FORMULAS];
  int count = list_uses(uses, o);
  double published[MOST_FORMULAS] = { 0 }, exact[MOST_FORMULAS] = { 0 };
  char v0[80] = "the exact steady velocity at the start of each phase";
  enum scallop_status status = solve(&request->point, uses, count, published, exact);
  if (status < 0) {
    complain("series", "%s", scallop_status_text(status));
    return EXIT_UNSOLVED;
  }
  if (!table_head(&table, &request->style, "series"))
    return EXIT_FILE;
  table.of = "published";
  note_parameters(&table, &request->point, NULL, false);
  if (request->point.has_v0)
    number_text(v0, request->point.v0, 0);
  table_note(&table, "v0: %s", v0);
  if (!gait_has_ends(request->point.crawler.gait)) {
    table_note(&table, "%s", no_ends);
    if (!request->style.quiet)
      complain("series", "%s", no_ends);
  }
  table_columns(&table, columns);
  table_begin_rows(&table);
  for (int i = 0; i < count; i++)
    write_formula(&table, &uses[i], published[i], exact[i]);
  return table_close(&table) ? EXIT_DONE : EXIT_FILE;
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
  { "only", RULE_WITH, DERIVED, "is for the published formulas: leave --source and --bound out" },
  { "book", RULE_WITH, DERIVED, "is for the published formulas: --source derived, limit and --bound have none" },
  { "points", RULE_WITH, DERIVED, "is for --source published: one point at a time here" },
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
  if (o->request.sweep.products > 0 && !published)
    return complain("series", "a list or a range of a parameter is for --source published: one point at a time here");
  return digits_hold(&o->request.style, !published, DIGITS);
}

/* Is each item of --only a formula? Books have been read. False: the message is on stderr. */
static bool only_holds(const char *only)
{
  const char *end = only;
  for (; only && *end; only = end + (*end == ',')) {
    char item[FORMULA_PLACE];
    end = only + strcspn(only, ",");
    snprintf(item, sizeof item, "%.*s", (int)(end - only), only);
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
    return (has_many_points(&o->request) ? run_points : run_point)(o);
  const struct flint_part *flint = flint_for("series", o->symbolic ? "--symbolic"
                                                       : o->bound  ? "--bound"
                                                                   : "--source derived or limit");
  if (!flint)
    return EXIT_UNSOLVED;
  return o->symbolic ? flint->series_symbolic(o) : flint->series_derived(o);
}

const struct command command_series = {
  .name = "series",
  .summary = "the paper's formulas as published, and the series derived to any order, beside the exact values",
  .example = "scallop series --source derived --order 8 --T 0.1",
  .options = options_of_series,
  .size = sizeof(struct series_options),
  .initial = &initial,
  .rules = rules,
  .is_sound = is_sound,
  .run = run,
};
