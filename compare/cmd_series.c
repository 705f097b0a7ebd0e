#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/exact.h"
#include "compare/points.h"
#include "compare/with_flint.h"

static const char *const accepts[] = { "m1",     "m2",    "F1",    "F2",     "L",      "T",      "alpha",  "gait",  "v0",
                                       "source", "order", "bound", "points", "format", "digits", "output", "quiet", NULL };
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
static enum scallop_status each_value(const struct options *o, value_sink *sink, void *context)
{
  const struct scallop_crawler *c = &o->crawler;
  struct scallop_steady_result steady;
  enum scallop_status status = scallop_steady(c, &steady);
  if (status < 0)
    return status;
  for (const struct scallop_formula *f = scallop_published; f->name; f++) {
    struct value v = { .formula = f, .phase = "period", .quantity = formula_quantity_text(f, SCALLOP_EXTENSION) };
    if (f->setting == SCALLOP_STEADY) {
      v.published = f->steady(c);
      v.exact = f->quantity == SCALLOP_STEADY_VELOCITY ? steady.period.v_start : steady.period.displacement;
      sink(context, &v);
      continue;
    }
    int first = f->setting == SCALLOP_MOVING_CONTRACTION, last = f->setting == SCALLOP_AT_REST_START ? 1 : first;
    for (int k = first; k <= last; k++) {
      enum scallop_phase_kind kind = (enum scallop_phase_kind)k;
      double moving = o->has_v0 ? o->v0 : k == SCALLOP_EXTENSION ? steady.period.v_start : steady.period.v_mid;
      double v0 = f->setting == SCALLOP_AT_REST_START ? 0 : moving;
      struct scallop_phase_point point = scallop_phase_point(c, kind, v0);
      struct exact_phase exact;
      status = exact_phase_solve(c, kind, v0, &exact);
      if (status < 0)
        return status;
      v.phase = k == SCALLOP_EXTENSION ? "extension" : "contraction";
      v.quantity = formula_quantity_text(f, kind);
      v.published = published_value(f, &point, &exact);
      v.exact = exact_quantity(&exact, f->quantity);
      sink(context, &v);
    }
  }
  return SCALLOP_OK;
}

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
  table_number(table, v->published);
  table_number(table, v->exact);
  table_number(table, v->published - v->exact);
}

static void skip_value(void *context, const struct value *v) { (void)context, (void)v; }

static void write_published(void *context, const struct value *v) { table_number(context, v->published); }

/* One row for a point: every formula in a column of its own, "name" or "name:contraction". */
static const char *row(struct table *table, const struct options *point, const char *refused)
{
  enum scallop_status solved = refused ? SCALLOP_EDOMAIN : each_value(point, skip_value, NULL);
  const char *why = refused ? refused : solved < 0 ? scallop_status_text(solved) : NULL;
  point_parameters(table, point, refused);
  table_number(table, point->has_v0 && !refused ? point->v0 : NAN);
  if (why)
    point_blank(table, table->count - table->at - 1);
  else
    each_value(point, write_published, table);
  table_text(table, why ? why : "ok");
  return why;
}

static enum exit_code run_points(const struct options *options)
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
  return for_each_point(options, extra, list, row);
}

static enum exit_code run(const struct options *options)
{
  struct table table;
  if (options->bound || strcmp(options->source, "published") != 0)
    return series_derived(options);
  if (options->points)
    return run_points(options);
  enum scallop_status status = each_value(options, skip_value, NULL);
  if (status < 0) {
    complain("series", "%s", scallop_status_text(status));
    return EXIT_UNSOLVED;
  }
  if (!table_open(&table, options))
    return EXIT_FILE;
  table_note(&table, "scallop " SCALLOP_VERSION);
  table_note(&table, "command: series");
  table_parameters(&table, options);
  if (options->has_v0) {
    char v0[NUMBER_TEXT];
    number_text(v0, options->v0, 0);
    table_note(&table, "v0: %s", v0);
  } else
    table_note(&table, "v0: the exact steady velocity at the start of each phase");
  table_columns(&table, columns);
  table_begin_rows(&table);
  each_value(options, write_value, &table);
  return table_close(&table) ? EXIT_DONE : EXIT_FILE;
}

const struct command command_series = {
  .name = "series",
  .summary = "the paper's formulas as published, beside the exact values",
  .example = "scallop series --T 0.1 --v0 2.5",
  .accepts = accepts,
  .about = "T is the period; the formulas of one phase are evaluated for its duration, alpha T or (1 - alpha) T.\n"
           "Formulas from rest start from rest; the others start with --v0, and without it with the exact steady velocity\n"
           "of their phase. Columns: formula and equation (text_, rest_: the main text; A_, B_: the appendices); phase;\n"
           "quantity; the remainder as printed; published, exact and error = published - exact.\n"
           "With --points: one row for each point, the published value of every formula in a column of its own.",
  .run = run,
};
