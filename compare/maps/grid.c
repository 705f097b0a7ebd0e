/* breakdown --map X Y: one row for each point of a grid: the crawler, its steady state, and how good the series are
 * there. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/points/defaults.h"
#include "compare/points/gaits.h"
#include "compare/book/book.h"
#include "compare/breakdown/motion.h"
#include "compare/maps/maps.h"
#include "compare/text/memory.h"
#include "compare/text/progress.h"
#include "numerics/threads.h"

enum {
  MOST_TOLERANCES = 2,
  MOST_MEASURES = (BREAKDOWN_SOURCES - 1 + BOOK_MOST) * (1 + MOST_TOLERANCES),
  MOST_ROWS = 10000000
};
enum { NAME = 96 };

/* A column that takes long: the error of a series at T; with a tolerance, the largest T up to which the error is below
 * that. */
struct measure {
  enum breakdown_source source;
  const struct scallop_formula *formula; /* of a book, else NULL */
  double tolerance;                      /* 0: the error */
  bool used;                             /* by what is written; else it is not computed */
  char name[NAME];
};

struct grid {
  const struct breakdown_options *options;
  struct axis axes[2];
  enum quantity_id quantity;
  int width;
  struct measure measures[MOST_MEASURES];
  double *values; /* of the measures, row by row */
  struct progress progress;
};

/* Beside a picture of a named column, where no others are chosen, the table has of the measures that alone which is
 * drawn. */
static bool is_asked(const struct style *style, const char *name)
{
  const char *y = style->plot.y;
  return !style->plot.file || !y || style->choice || strcmp(y, name) == 0;
}

static void add_measure(struct grid *g, enum breakdown_source source, const struct scallop_formula *formula,
                        double tolerance)
{
  struct measure *m = &g->measures[g->width++];
  double power = log10(tolerance);
  char what[NAME / 4] = "error", order[NAME / 4] = "";
  if (tolerance > 0)
    snprintf(what, sizeof what, power == rint(power) ? "T_1e%.0f" : "T_%g", power == rint(power) ? power : tolerance);
  if (source == FROM_DERIVED)
    snprintf(order, sizeof order, "_%ld", g->options->order.value);
  *m = (struct measure){ source, formula, tolerance, .name = "" };
  snprintf(m->name, NAME, "%s_%s%s", what, formula ? formula->name : breakdown_sources[source], order);
  g->width -= !is_asked(&g->options->request.style, m->name);
}

static const struct motion any_motion = { .of = OF_STEADY };

static bool is_about_quantity(const void *context, const struct scallop_formula *f)
{
  const struct grid *g = context;
  return series_is_about(f, &any_motion, g->quantity);
}

static bool serves(const struct grid *g)
{
  char what[80];
  snprintf(what, sizeof what, "the %s of the steady state", quantity_rows[g->quantity].name);
  return book_serves("breakdown", g->options->request.book, is_about_quantity, g, what);
}

/* For each formula of the book, and for each other source */
static void add_measures(struct grid *g, const double *tolerances, int count)
{
  const struct scallop_formula *f;
  for (int s = 0; s < BREAKDOWN_SOURCES; s++)
    for (int i = 0; i < count; i++) {
      if (!breakdown_takes(g->options, (enum breakdown_source)s))
        continue;
      if (s != FROM_BOOK)
        add_measure(g, (enum breakdown_source)s, NULL, tolerances[i]);
      for (int k = 0; s == FROM_BOOK && (f = book_formula(k)); k++)
        if (is_about_quantity(g, f))
          add_measure(g, FROM_BOOK, f, tolerances[i]);
    }
}

static long columns_of(const struct grid *g) { return g->axes[0].count; }

static struct scallop_crawler crawler_of(const struct grid *g, long row)
{
  return axes_crawler(g->axes, &g->options->request.point.crawler, axis_node(&g->axes[0], row % columns_of(g)),
                      axis_node(&g->axes[1], row / columns_of(g)));
}

static bool sets_T(const struct axis *a) { return strcmp(a->sets, "T") == 0; }

/* How far a series reaches is the same in all rows that differ in T alone: it is computed for the first of them. */
static long first_of(const struct grid *g, long row)
{
  return sets_T(&g->axes[0]) ? row - row % columns_of(g) : sets_T(&g->axes[1]) ? row % columns_of(g) : row;
}

/* The measures that are used, of any tolerance or of the error at T */
static int used_of(const struct grid *g, bool of_tolerance)
{
  int count = 0;
  for (int i = 0; i < g->width; i++)
    count += g->measures[i].used && (g->measures[i].tolerance > 0) == of_tolerance;
  return count;
}

static void compute(const struct grid *g, long row, double *values)
{
  const struct motion at = { .of = OF_STEADY, .crawler = crawler_of(g, row) };
  const long order = g->options->order.value, least = 6; /* that holds the first term, which is the limit */
  struct series_item items[MOST_ITEMS];
  struct expansions e;
  struct comparison c = { .expansions = &e };
  for (int i = 0; i < g->width; i++)
    values[i] = NAN;
  bool reaches = first_of(g, row) == row && used_of(g, true) > 0;
  if (scallop_crawler_check(&at.crawler, NULL) != SCALLOP_OK || !(reaches || used_of(g, false) > 0))
    return;
  c.cache = reaches ? exact_cache_new(&at) : NULL;
  expansions_init(&e, &at, order > least ? order : least, BREAKDOWN_BITS);
  int count = series_items(items, &e, g->quantity, order);
  for (int i = 0; i < g->width; i++) {
    const struct measure *m = &g->measures[i];
    const struct series_item *item = NULL;
    for (int k = 0; k < count; k++) /* of two formulas of the paper the last one, (27), is the simpler */
      if (items[k].source == m->source && (!m->formula || items[k].formula == m->formula))
        item = &items[k];
    if (!item || !m->used || (m->tolerance > 0 && !c.cache))
      continue;
    c.item = *item;
    c.tolerance = m->tolerance;
    values[i] = m->tolerance == 0 ? comparison_error(&c, at.crawler.T) : comparison_reach(&c);
  }
  free(c.cache);
  expansions_clear(&e);
}

static long rows_of(const struct grid *g) { return g->axes[0].count * g->axes[1].count; }

static void compute_all(struct grid *g)
{
  const long rows = rows_of(g);
  long done = 0;
#pragma omp parallel num_threads(threads_for(0, rows))
  {
#pragma omp for schedule(dynamic)
    for (long row = 0; row < rows; row++) {
      compute(g, row, g->values + row * g->width);
#ifdef _OPENMP
#pragma omp critical
#endif
      progress_count(++done, rows);
    }
    flint_cleanup();
  }
  progress_end(&g->progress);
}

/* What the axes set, and what may be wanted beside it; F1/F2 as an axis is not F1. */
static const char *const parameters[] = { "m1", "m2", "F1", "F2", "T", "alpha", "froude", NULL };

static const enum quantity_id states[] = { Q_V_START, Q_DISPLACEMENT, Q_MEAN_VELOCITY };

/* One cell of a row, or its name in the head of the table. */
static void cell(struct table *t, bool is_head, const char *name, const char *text, double x)
{
  if (is_head)
    table_columns(t, (const char *const[]){ name, NULL });
  else if (text)
    table_text(t, text);
  else
    table_number(t, x);
}

/* The cells of a row, or the names of its columns. Returns whether it has a steady state. */
static bool write_row(const struct grid *g, struct table *t, bool is_head, long row)
{
  const struct motion m = { .of = OF_STEADY, .crawler = crawler_of(g, row) };
  const struct scallop_crawler *c = &m.crawler;
  struct answer a;
  char modes[MOTION_MODES_TEXT];
  const char *axes[] = { g->axes[0].name, g->axes[1].name };
  const long place[] = { row % columns_of(g), row / columns_of(g) };
  bool solved = answer_in_double(&a, &m);
  for (int i = 0; i < 2; i++)
    cell(t, is_head, axes[i], NULL, axis_node(&g->axes[i], place[i]));
  for (const char *const *p = parameters; *p; p++)
    if (strcmp(*p, axes[0]) != 0 && strcmp(*p, axes[1]) != 0)
      cell(t, is_head, *p, NULL,
           strcmp(*p, "froude") == 0 ? (c->m1 + c->m2) * c->L / (c->T * c->T * (c->F1 + c->F2))
                                     : crawler_parameter(c, *p));
  cell(t, is_head, "modes", solved ? motion_modes_text(modes, OF_STEADY, a.modes) : "-", 0);
  cell(t, is_head, "regime", solved ? scallop_regime_text(a.regime) : "-", 0);
  for (size_t i = 0; i < sizeof states / sizeof *states; i++)
    cell(t, is_head, quantity_rows[states[i]].name, NULL, a.value[states[i]].high);
  for (int i = 0; i < g->width; i++) {
    const struct measure *measure = &g->measures[i];
    long computed = measure->tolerance > 0 ? first_of(g, row) : row;
    cell(t, is_head, measure->name, NULL, g->values[computed * g->width + i]);
  }
  cell(t, is_head, "status", scallop_status_text(a.status), 0);
  return solved;
}

/* The head, which tells what is used of a row. False: the table has failed. */
static bool begin_table(struct grid *g, struct table *t)
{
  t->of = "map";
  axes_head(t, g->options, g->axes, "");
  table_note(
      t,
      "series: of the %s; error: series/exact - 1 at this T; T: the largest up to which its size is below that number",
      quantity_rows[g->quantity].name);
  write_row(g, t, true, 0);
  table_begin_rows(t);
  for (int i = 0; i < g->width; i++)
    g->measures[i].used = table_uses(t, g->measures[i].name);
  return !table_failed(t);
}

static enum exit_code write_rows(const struct grid *g, struct table *t)
{
  long unsolved = 0;
  for (long row = 0; row < rows_of(g) && !table_failed(t); row++)
    unsolved += !write_row(g, t, false, row);
  if (!table_close(t))
    return EXIT_FILE;
  if (unsolved > 0)
    complain("breakdown", "%ld of %ld points have no steady state: see the column status", unsolved, rows_of(g));
  return unsolved > 0 ? EXIT_UNSOLVED : EXIT_DONE;
}

static enum exit_code run(struct grid *g)
{
  struct table t;
  if (!table_open(&t, &g->options->request.style))
    return EXIT_FILE;
  if (!begin_table(g, &t)) {
    table_abandon(&t);
    return EXIT_FILE;
  }
  compute_all(g);
  return write_rows(g, &t);
}

enum exit_code breakdown_map(const struct breakdown_options *o)
{
  static const double usual[MOST_TOLERANCES] = { BREAKDOWN_MAP_TOLERANCES };
  struct grid g = { .options = o,
                    .quantity = quantity_of_name(o->quantity.value),
                    .progress = progress_begin(o->request.style.quiet) };
  if (!axes_read(g.axes, o->map, o->range, &o->request.point) || !serves(&g))
    return EXIT_USAGE;
  if (rows_of(&g) > MOST_ROWS) {
    complain("breakdown", "--map: %ld x %ld values are more than 10000000 rows", g.axes[0].count, g.axes[1].count);
    return EXIT_USAGE;
  }
  add_measures(&g, (const double[]){ 0 }, 1);
  add_measures(&g, o->tolerance.given ? &o->tolerance.value : usual, o->tolerance.given ? 1 : MOST_TOLERANCES);
  g.values = calloc((size_t)(rows_of(&g) * g.width) + 1, sizeof *g.values);
  if (!g.values)
    complain("breakdown", "out of memory");
  enum exit_code code = g.values ? run(&g) : EXIT_UNSOLVED;
  free(g.values);
  return code;
}
