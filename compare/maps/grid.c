/* breakdown --map X Y: one row for each point of a grid: the crawler, its steady state, and how good the series are there. */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/answers/answer.h"
#include "compare/answers/gaits.h"
#include "compare/breakdown/asked.h"
#include "compare/maps/axis.h"
#include "compare/maps/maps.h"
#include "compare/maps/journal.h"
#include "compare/text/progress.h"
#include "compare/answers/defaults.h"
#include "model/flint.h"
#include "numerics/threads.h"

enum { MOST_TOLERANCES = 2, MOST_MEASURES = BREAKDOWN_SOURCES * (1 + MOST_TOLERANCES), MOST_ROWS = 10000000 };
enum { NAME = 48, TITLE = 2048, JOURNAL_PATH = 4096 };

/* A column that takes long: the error of a series at T; with a tolerance, the largest T up to which the error is below that. */
struct measure {
  struct breakdown_series series;
  double tolerance; /* 0: the error */
  char name[NAME];
};

struct grid {
  const struct breakdown_options *options;
  struct axis axes[2];
  int width;
  struct measure measures[MOST_MEASURES];
  long rows, done_count, unsolved;
  double *values; /* of the measures, row by row */
  bool *done;
  struct journal journal;
  bool journalled, failed;
  struct progress progress;
};

static void add_measure(struct grid *g, struct breakdown_series series, double tolerance)
{
  struct measure *m = &g->measures[g->width++];
  char what[NAME / 2] = "error", order[NAME / 2] = "";
  if (tolerance > 0) {
    double power = log10(tolerance);
    snprintf(what, sizeof what, power == rint(power) ? "T_1e%.0f" : "T_%g", power == rint(power) ? power : tolerance);
  }
  if (series.source == FROM_DERIVED)
    snprintf(order, sizeof order, "_%ld", series.order);
  *m = (struct measure){ .series = series, .tolerance = tolerance };
  snprintf(m->name, NAME, "%.23s_%s%.23s", what, breakdown_source_text(series.source), order);
}

static bool choose_measures(struct grid *g)
{
  static const double usual[MOST_TOLERANCES] = { BREAKDOWN_MAP_TOLERANCES };
  const struct breakdown_options *o = g->options;
  struct breakdown_series all[BREAKDOWN_SOURCES];
  enum quantity_id quantity = Q_DISPLACEMENT;
  int count = 0;
  if (o->quantity && !breakdown_quantity_read(&quantity, o->quantity, OF_STEADY))
    return false;
  for (int s = 0; s < BREAKDOWN_SOURCES; s++)
    if (!o->source.given || strcmp(o->source.value, breakdown_source_text((enum breakdown_source)s)) == 0)
      all[count++] = (struct breakdown_series){ (enum breakdown_source)s, o->order.value, quantity };
  for (int s = 0; s < count; s++)
    add_measure(g, all[s], 0);
  for (int s = 0; s < count; s++)
    for (int t = 0; t < (o->tolerance.given ? 1 : MOST_TOLERANCES); t++)
      add_measure(g, all[s], o->tolerance.given ? o->tolerance.value : usual[t]);
  return true;
}

static struct scallop_crawler crawler_of(const struct grid *g, long row)
{
  long columns = g->axes[0].count;
  return axes_crawler(g->axes, &g->options->request.point.crawler, axis_node(&g->axes[0], row % columns),
                      axis_node(&g->axes[1], row / columns));
}

/* Rows that differ in T alone are a line: how far a series reaches is the same in all of them. */
struct lines {
  long count, length;    /* lines, and rows of each                                                          */
  long to_line, to_next; /* rows from the first of a line to that of the next line, and to the next of the line */
};

static struct lines lines_of(const struct grid *g)
{
  long columns = g->axes[0].count, rows = g->axes[1].count;
  if (strcmp(axis_sets(g->axes[0].kind), "T") == 0)
    return (struct lines){ rows, columns, columns, 1 };
  if (strcmp(axis_sets(g->axes[1].kind), "T") == 0)
    return (struct lines){ columns, rows, 1, columns };
  return (struct lines){ g->rows, 1, 1, 1 };
}

static double *values_of(const struct grid *g, long row) { return g->values + row * g->width; }

/* first: the row of its line for which the reaches are computed. */
static void compute(const struct grid *g, long row, long first, double *values)
{
  const struct scallop_crawler c = crawler_of(g, row);
  for (int i = 0; i < g->width; i++) {
    const struct measure *m = &g->measures[i];
    values[i] = m->tolerance == 0 ? breakdown_error(&c, &m->series)
                : row == first    ? breakdown_reach(&c, &m->series, m->tolerance)
                                  : values_of(g, first)[i];
  }
}

static bool store(void *context, long row, int count, const double *values)
{
  struct grid *g = context;
  if (row < 0 || row >= g->rows || count != g->width)
    return false;
  memcpy(values_of(g, row), values, (size_t)count * sizeof *values);
  g->done_count += !g->done[row];
  return g->done[row] = true;
}

/* By one thread at a time. False: the journal cannot be written. */
static bool finish(struct grid *g, long row, const double *values)
{
  store(g, row, g->width, values);
  g->failed = g->failed || (g->journalled && !journal_add(&g->journal, row, g->width, values));
  progress_show(&g->progress, "%ld of %ld", g->done_count, g->rows);
  return !g->failed;
}

static void compute_line(struct grid *g, const struct lines *lines, long line)
{
  double values[MOST_MEASURES];
  bool going = true;
  for (long i = 0, first = line * lines->to_line, row = first; i < lines->length && going; i++, row += lines->to_next) {
    if (g->done[row])
      continue;
    compute(g, row, first, values);
#ifdef _OPENMP
#pragma omp critical
#endif
    going = finish(g, row, values);
  }
}

static void compute_all(struct grid *g)
{
  const struct lines lines = lines_of(g);
#pragma omp parallel num_threads(threads_for(0, lines.count))
  {
#pragma omp for schedule(dynamic)
    for (long line = 0; line < lines.count; line++)
      compute_line(g, &lines, line);
    flint_cleanup();
  }
  progress_end(&g->progress);
}

/* All that the values depend on */
static void make_title(const struct grid *g, char title[TITLE])
{
  const struct point *point = &g->options->request.point;
  const struct scallop_gait *gait = point->crawler.gait;
  double numbers[CRAWLER_NUMBERS];
  crawler_numbers(&point->crawler, numbers);
  FILE *f = fmemopen(title, TITLE, "w");
  if (!f)
    return;
  fprintf(f, "scallop " SCALLOP_VERSION " journal of breakdown --map: gait %.200s (%08lx)", gait->name,
          (unsigned long)gait_checksum(gait));
  for (int i = 0; i < 2; i++)
    fprintf(f, " %s %a:%a:%ld:%d", axis_name(g->axes[i].kind), g->axes[i].from, g->axes[i].to, g->axes[i].count,
            g->axes[i].log);
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    fprintf(f, " %a", numbers[i]);
  for (int i = 0; i < g->width; i++)
    fprintf(f, " %s %d %a", g->measures[i].name, (int)g->measures[i].series.quantity, g->measures[i].tolerance);
  fclose(f);
}

static enum exit_code open_journal(struct grid *g)
{
  char path[JOURNAL_PATH], title[TITLE] = "";
  if ((size_t)snprintf(path, sizeof path, "%s.rows", g->options->request.style.output) >= sizeof path) {
    complain("breakdown", "cannot write beside %s: the name is too long", g->options->request.style.output);
    return EXIT_FILE;
  }
  make_title(g, title);
  switch (journal_open(&g->journal, path, title, store, g)) {
  case JOURNAL_OTHER:
    complain("breakdown",
             "%s is no journal of this map: it is of another map, of another version, or of a measured gait whose file has "
             "changed since; remove it, or write elsewhere",
             path);
    return EXIT_FILE;
  case JOURNAL_BUSY: complain("breakdown", "%s: another process is at work on this map", path); return EXIT_FILE;
  case JOURNAL_ERROR: complain("breakdown", "cannot write %s: %s", path, strerror(errno)); return EXIT_FILE;
  case JOURNAL_FOUND:
    if (!g->options->request.style.quiet)
      complain("breakdown", "going on from %s: %ld of %ld are done", path, g->done_count, g->rows);
    break;
  case JOURNAL_NEW: break;
  }
  g->journalled = true;
  return EXIT_DONE;
}

/* What the axes set, and what may be wanted beside it; F1/F2 as an axis is not F1. */
static const char *const parameters[] = { "m1", "m2", "F1", "F2", "T", "alpha", "froude", NULL };

static const enum quantity_id states[] = { Q_V_START, Q_DISPLACEMENT, Q_MEAN_VELOCITY };
enum { STATES = sizeof states / sizeof *states };

static bool is_axis(const struct grid *g, const char *name)
{
  return strcmp(name, axis_name(g->axes[0].kind)) == 0 || strcmp(name, axis_name(g->axes[1].kind)) == 0;
}

static void begin_table(const struct grid *g, struct table *t)
{
  axes_head(t, g->options, g->axes, "");
  table_note(
      t, "series: of the %s; error: series/exact - 1 at this T; T: the largest up to which its size is below that number",
      quantity_rows[g->measures[0].series.quantity].name);
  table_columns(t, (const char *const[]){ axis_name(g->axes[0].kind), axis_name(g->axes[1].kind), NULL });
  for (const char *const *p = parameters; *p; p++)
    if (!is_axis(g, *p))
      table_columns(t, (const char *const[]){ *p, NULL });
  table_columns(t, (const char *const[]){ "modes", "regime", NULL });
  for (int i = 0; i < STATES; i++)
    table_columns(t, (const char *const[]){ quantity_rows[states[i]].name, NULL });
  for (int i = 0; i < g->width; i++)
    table_columns(t, (const char *const[]){ g->measures[i].name, NULL });
  table_columns(t, (const char *const[]){ "status", NULL });
  table_begin_rows(t);
}

static void write_row(struct grid *g, struct table *t, long row)
{
  const struct motion m = { .of = OF_STEADY, .crawler = crawler_of(g, row) };
  const struct scallop_crawler *c = &m.crawler;
  struct answer a;
  char modes[MOTION_MODES_TEXT];
  bool solved = answer_in_double(&a, &m);
  table_number(t, axis_node(&g->axes[0], row % g->axes[0].count));
  table_number(t, axis_node(&g->axes[1], row / g->axes[0].count));
  for (const char *const *p = parameters; *p; p++)
    if (!is_axis(g, *p))
      table_number(t, strcmp(*p, "froude") == 0 ? (c->m1 + c->m2) * c->L / (c->T * c->T * (c->F1 + c->F2))
                                                : crawler_parameter(c, *p));
  table_text(t, solved ? motion_modes_text(modes, OF_STEADY, a.modes) : "-");
  table_text(t, solved ? scallop_regime_text(a.regime) : "-");
  for (int i = 0; i < STATES; i++)
    table_number(t, a.value[states[i]].high);
  for (int i = 0; i < g->width; i++)
    table_number(t, values_of(g, row)[i]);
  table_text(t, scallop_status_text(a.status));
  g->unsolved += !solved;
}

static enum exit_code write_table(struct grid *g, struct table *t)
{
  begin_table(g, t);
  for (long row = 0; row < g->rows && !table_failed(t); row++)
    write_row(g, t, row);
  if (!table_close(t))
    return EXIT_FILE;
  if (g->unsolved > 0)
    complain("breakdown", "%ld of %ld points have no steady state: see the column status", g->unsolved, g->rows);
  return g->unsolved > 0 ? EXIT_UNSOLVED : EXIT_DONE;
}

static enum exit_code run(struct grid *g)
{
  struct table t;
  if (!table_open(&t, &g->options->request.style))
    return EXIT_FILE;
  enum exit_code code = t.out.target ? open_journal(g) : EXIT_DONE;
  if (code == EXIT_DONE)
    compute_all(g);
  if (g->failed) {
    complain("breakdown", "cannot write %s: %s", g->journal.path, strerror(g->journal.error));
    code = EXIT_FILE;
  }
  if (code == EXIT_DONE)
    code = write_table(g, &t);
  else
    table_abandon(&t);
  if (g->journalled)
    journal_close(&g->journal, code == EXIT_DONE || code == EXIT_UNSOLVED);
  return code;
}

enum exit_code breakdown_map(const struct breakdown_options *o)
{
  struct grid g = { .options = o, .progress = progress_begin(o->request.style.quiet) };
  if (!axes_read(g.axes, o->map, o->range, &o->request.point) || !choose_measures(&g))
    return EXIT_USAGE;
  g.rows = g.axes[0].count * g.axes[1].count;
  if (g.rows > MOST_ROWS) {
    complain("breakdown", "--map: %ld x %ld values are more than 10000000 rows", g.axes[0].count, g.axes[1].count);
    return EXIT_USAGE;
  }
  g.values = calloc((size_t)(g.rows * g.width), sizeof *g.values);
  g.done = calloc((size_t)g.rows, sizeof *g.done);
  enum exit_code code = EXIT_UNSOLVED;
  if (g.values && g.done)
    code = run(&g);
  else
    complain("breakdown", "out of memory");
  free(g.values);
  free(g.done);
  return code;
}
