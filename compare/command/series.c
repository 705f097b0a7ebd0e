#include <math.h>
#include <stdio.h>
#include <string.h>

#include "numerics/numerics.h"
#include "compare/answers/answer.h"
#include "compare/answers/gaits.h"
#include "compare/answers/points.h"
#include "compare/command/commands.h"
#include "compare/command/series_flint.h"
#include "compare/command/with_flint.h"

#define DIGITS DIGITS_PROVEN("with --source derived or limit")
static const char *const sources[] = { "published", "derived", "limit", NULL };
static const struct option options_of_series[] = {
  OPTIONS_CRAWLER(NULL, NULL),
  OPTION_V0("the steady velocity of the phase; with --source derived only phases from rest"),
  OPTION_WORD("source", "SOURCE", "published, derived or limit", NULL, series_options, source, sources),
  OPTION_COUNT("order", "N", "derive all terms below T^N, N from 1 to 1000", NULL, series_options, order, 1, 1000),
  OPTION_FLAG("bound", "bounds for the error of the derived terms below T^N", series_options, bound),
  OPTION_POINTS,
  OPTION_FORMAT("tsv"),
  OPTION_DIGITS(DIGITS, READ_BACK "; with --source derived fractions, or 17 digits", MOST_DIGITS),
  OPTIONS_LAST,
};
static const struct series_options initial = { .source = { "published", false }, .order = { 8, false } };
static const char *const columns[] = { "formula",   "equation", "phase", "quantity", "remainder",
                                       "published", "exact",    "error", NULL };
static const char *const extra[] = { "v0", NULL };

/* A formula at a point, and what the exact motion has there. */
struct value {
  const struct scallop_formula *formula;
  const char *phase; /* "extension", "contraction" or "period"                        */
  const char *quantity;
  double published, exact;
};
typedef void value_sink(void *context, const struct value *value);

/* Where v0 is not given, the formulas with a start velocity take the exact steady one of their phase. */
static enum scallop_status each_value(const struct point *p, value_sink *sink, void *context)
{
  const struct scallop_crawler *c = &p->crawler;
  const struct motion period = motion_of(p, OF_STEADY);
  struct answer steady;
  if (!answer_in_double(&steady, &period))
    return steady.status;
  for (const struct scallop_formula *f = scallop_published; f->name; f++) {
    struct value v = { .formula = f, .phase = "period", .quantity = formula_quantity_text(f, SCALLOP_EXTENSION) };
    if (f->setting == SCALLOP_STEADY) {
      v.published = f->steady(c);
      v.exact = steady.value[quantity_of_formula(f, SCALLOP_EXTENSION)].high;
      sink(context, &v);
      continue;
    }
    int first = f->setting == SCALLOP_MOVING_CONTRACTION, last = f->setting == SCALLOP_AT_REST_START ? 1 : first;
    for (int k = first; k <= last; k++) {
      enum scallop_phase_kind kind = (enum scallop_phase_kind)k;
      double start = steady.value[k == SCALLOP_EXTENSION ? Q_V_START : Q_V_MID].high;
      const struct motion m = { OF_PHASE, *c, kind, f->setting == SCALLOP_AT_REST_START ? 0 : p->has_v0 ? p->v0 : start };
      struct scallop_phase_point point = scallop_phase_point(c, kind, m.v0);
      struct answer exact;
      if (!answer_in_double(&exact, &m) || !answer_turnings(&exact, &m))
        return exact.status;
      v.phase = k == SCALLOP_EXTENSION ? "extension" : "contraction";
      v.quantity = formula_quantity_text(f, kind);
      v.published = published_value(f, &point, &m, &exact);
      v.exact = exact.value[quantity_of_formula(f, kind)].high;
      sink(context, &v);
    }
  }
  return SCALLOP_OK;
}

/* Where l'' = 0 at an end of a phase a formula that divides by it has no value, and no infinite one. */
static const char no_ends[] = "l'' = 0 where a phase of this gait begins or ends: formulas that divide by it are nan";

static double finite(double x) { return isfinite(x) ? x : NAN; }

static void write_value(void *context, const struct value *v)
{
  struct table *table = context;
  char order[32] = "-";
  if (v->formula->remainder > 0)
    snprintf(order, sizeof order, v->formula->remainder == 1 ? "O(T)" : "O(T^%d)", v->formula->remainder);
  table_text(table, v->formula->name);
  table_text(table, v->formula->equation);
  table_text(table, v->phase);
  table_text(table, v->quantity);
  table_text(table, order);
  table_number(table, finite(v->published));
  table_number(table, v->exact);
  table_number(table, finite(v->published) - v->exact);
}

static void skip_value(void *context, const struct value *v) { (void)context, (void)v; }

static void write_published(void *context, const struct value *v) { table_number(context, finite(v->published)); }

/* One row for a point: every formula in a column of its own, "name" or "name:contraction". */
static const char *row(struct table *table, const struct point *point, const void *context, const char *refused)
{
  enum scallop_status solved = refused ? SCALLOP_EDOMAIN : each_value(point, skip_value, NULL);
  const char *why = refused ? refused : solved < 0 ? scallop_status_text(solved) : NULL;
  (void)context;
  point_crawler(table, &point->crawler, refused);
  table_number(table, point->has_v0 && !refused ? point->v0 : NAN);
  if (why)
    point_blank(table, table->count - table->at - 1);
  else
    each_value(point, write_published, table);
  table_text(table, why ? why : gait_has_ends(point->crawler.gait) ? "ok" : no_ends);
  return why;
}

static enum exit_code run_points(const struct request *request)
{
  enum { MOST = TABLE_COLUMNS, LONGEST = 64 };
  static char names[MOST][LONGEST];
  const char *list[MOST];
  int n = 0;
  for (const struct scallop_formula *f = scallop_published; f->name; f++) {
    snprintf(names[n], LONGEST, "%s", f->name);
    list[n] = names[n];
    n++;
    if (f->setting == SCALLOP_AT_REST_START) {
      snprintf(names[n], LONGEST, "%s:contraction", f->name);
      list[n] = names[n];
      n++;
    }
  }
  list[n++] = "status";
  list[n] = NULL;
  const struct point_table table = { .extra = extra, .columns = list, .v0_may_be_nan = true, .row = row };
  return for_each_point(request, &table);
}

enum { MOST_ORDER_OF_BOUND = 60 }; /* beyond, a bound takes minutes */

/* NULL, or which options do not go together */
static const char *excluded(const struct series_options *o)
{
  bool derived = strcmp(o->source.value, "derived") == 0, published = strcmp(o->source.value, "published") == 0;
  if (o->bound && o->source.given && !derived)
    return "--bound is for the derived series: leave --source out";
  if (o->bound && o->order.value > MOST_ORDER_OF_BOUND)
    return "--bound takes an --order from 1 to 60";
  if (o->bound && o->request.style.digits > 0)
    return "--digits and --bound exclude each other: bounds are rounded to four digits, to the safe side";
  if (o->order.given && !o->bound && !derived)
    return published ? "--order needs --source derived, or --bound: the published formulas end where they end"
                     : "--order and --source limit exclude each other: the limit is one term";
  if (o->request.point.has_v0 && (o->bound || (!derived && !published)))
    return "--v0 is for the formulas and series of a phase: --bound and --source limit are about the steady state";
  return NULL;
}

static bool is_sound(const void *options)
{
  const struct series_options *o = options;
  bool published = !o->bound && strcmp(o->source.value, "published") == 0;
  const char *wrong = excluded(o);
  if (wrong)
    complain("series", "%s", wrong);
  return !wrong && digits_hold(&o->request.style, !published, DIGITS);
}

static enum exit_code run(const struct arguments *arguments, const void *options)
{
  const struct series_options *o = options;
  struct table table;
  if (o->bound || strcmp(o->source.value, "published") != 0) {
    const char *what = o->bound ? "--bound" : "--source derived or limit";
    return has_flint(arguments, what) ? series_derived(o) : EXIT_UNSOLVED;
  }
  if (o->request.points)
    return run_points(&o->request);
  enum scallop_status status = each_value(&o->request.point, skip_value, NULL);
  if (status < 0) {
    complain("series", "%s", scallop_status_text(status));
    return EXIT_UNSOLVED;
  }
  if (!table_open(&table, &o->request.style))
    return EXIT_FILE;
  table_note(&table, "scallop " SCALLOP_VERSION);
  table_note(&table, "command: series");
  note_parameters(&table, &o->request.point, NULL, false);
  if (o->request.point.has_v0) {
    char v0[NUMBER_TEXT];
    number_text(v0, o->request.point.v0, 0);
    table_note(&table, "v0: %s", v0);
  } else
    table_note(&table, "v0: the exact steady velocity at the start of each phase");
  if (!gait_has_ends(o->request.point.crawler.gait))
    table_note(&table, "%s", no_ends);
  if (!gait_has_ends(o->request.point.crawler.gait) && !o->request.style.quiet)
    complain("series", "%s", no_ends);
  table_columns(&table, columns);
  table_begin_rows(&table);
  each_value(&o->request.point, write_value, &table);
  return table_close(&table) ? EXIT_DONE : EXIT_FILE;
}

const struct command command_series = {
  .name = "series",
  .summary = "the paper's formulas as published, and the series derived to any order, beside the exact values",
  .example = "scallop series --source derived --order 8 --T 0.1",
  .options = options_of_series,
  .size = sizeof(struct series_options),
  .initial = &initial,
  .is_sound = is_sound,
  .about =
      "--source published (the default): T is the period; the formulas of one phase are evaluated for its duration,\n"
      "alpha T or (1 - alpha) T. Formulas from rest start from rest; the others start with --v0, and without it with the\n"
      "exact steady velocity of their phase. Columns: formula and equation (text_, rest_: the main text; A_, B_: the\n"
      "appendices); phase; quantity; the remainder as printed; published, exact and error = published - exact.\n"
      "v(t1) and v(T-dT) are the velocity of the body that turns then, and 0; equations (A.4) and (12) print the "
      "remainders\n"
      "O(t1^2) and O(dT^2).\n"
      "With --points: one row for each point, the published value of every formula in a column of its own.\n\n"
      "--source derived: all terms below T^N (--order N) of a phase from rest, of a phase from --v0 if it is given, and of\n"
      "the steady state. Columns: phase, start, quantity as in `phase` and `steady`; power of T, the duration of the phase\n"
      "or the period; coefficient, an exact fraction where gait and parameters are rational and --digits is not given,\n"
      "else decimals right to a unit of the last one; sum of the terms so far at this T; error = sum - certified value;\n"
      "status: ok, or that at this T the motion has other modes than for T -> 0, so that the series is not about it.\n"
      "The parameters are exactly the numbers that are written: 0.7 is 7/10, in a gait and in its table too (but for the\n"
      "polynomials that `steady --help` names).\n"
      "--source limit: the first term of the steady state alone, the limit T -> 0.\n\n"
      "--bound: |exact - terms below T^N| <= C T^power for every 0 < T <= T0, proven, for v_start and displacement;\n"
      "bound: C T^power at this T (nan beyond T0); T_end: up to there the motion has the modes of T -> 0; ends: what\n"
      "happens there. T0 is 0.9 of T_end.",
  .run = run,
};
