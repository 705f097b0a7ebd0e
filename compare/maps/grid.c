/* breakdown --map X Y: one row for each point of a grid. */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <time.h>
#include <unistd.h>

#include "compare/breakdown/breakdown.h"
#include "compare/answers/exact.h"
#include "numerics/numerics.h"
#include "compare/answers/gaits.h"
#include "compare/text/journal.h"
#include "compare/maps/map.h"
#include "compare/command/with_flint.h"
#include "model/flint.h"
#include "numerics/threads.h"

enum { MOST_SERIES = BREAKDOWN_SOURCES, MOST_TOLERANCES = 2, MOST_ROWS = 10000000, NAME = 48 };
enum { TITLE = 1024, JOURNAL_PATH = 4096 };

struct map {
  const struct options *options;
  struct axis axes[2];
  int series_count, tolerance_count;
  struct breakdown_series series[MOST_SERIES];
  double tolerances[MOST_TOLERANCES];
  char names[MOST_SERIES * (1 + MOST_TOLERANCES)][NAME]; /* of the columns of errors, then of T                     */
  /* What takes long: items. First how far the series reach, once for each crawler but for T, then the errors of each row. */
  long reaches, rows, unsolved;
  double *values; /* of the items, one after the other                                                              */
  bool *done;
  long done_count;
  struct journal journal;
  bool journalled, failed;
  double shown_at; /* seconds; progress is shown where it is >= 0                                                   */
};

/* ---- what is asked for ---- */

static bool choose_quantity(struct map *m, enum quantity_id *quantity)
{
  const char *name = m->options->quantity, *names[QUANTITIES + 1] = { NULL };
  int n = 0;
  *quantity = Q_DISPLACEMENT;
  for (int q = 0; q < QUANTITIES; q++) {
    if (quantity_rows[q].of != OF_STEADY || !quantity_rows[q].has_series)
      continue;
    names[n++] = quantity_rows[q].name;
    if (name && strcmp(name, quantity_rows[q].name) == 0)
      *quantity = (enum quantity_id)q;
  }
  if (!name || strcmp(name, quantity_rows[*quantity].name) == 0)
    return true;
  const char *near = nearest(name, names);
  complain("breakdown",
           "--quantity: '%s' is not allowed here: a map takes v_start, v_mid, displacement or mean_velocity%s%s%s", name,
           near ? ": did you mean '" : "", near ? near : "", near ? "'?" : "");
  return false;
}

static void name_columns(struct map *m)
{
  static const char *const sources[] = { "published", "derived", "limit" };
  for (int s = 0; s < m->series_count; s++) {
    char name[24];
    const struct breakdown_series *series = &m->series[s];
    if (series->source == FROM_DERIVED)
      snprintf(name, sizeof name, "derived_%ld", series->order);
    else
      snprintf(name, sizeof name, "%s", sources[series->source]);
    snprintf(m->names[s], NAME, "error_%s", name);
    for (int t = 0; t < m->tolerance_count; t++) {
      double power = log10(m->tolerances[t]);
      char *column = m->names[m->series_count + s * m->tolerance_count + t];
      if (power == rint(power))
        snprintf(column, NAME, "T_1e%.0f_%s", power, name);
      else
        snprintf(column, NAME, "T_%g_%s", m->tolerances[t], name);
    }
  }
}

static bool choose_series(struct map *m)
{
  static const char *const sources[] = { "published", "derived", "limit" };
  const struct options *o = m->options;
  enum quantity_id quantity;
  if (!choose_quantity(m, &quantity))
    return false;
  for (int s = 0; s < BREAKDOWN_SOURCES; s++)
    if (!o->has_source || strcmp(o->source, sources[s]) == 0)
      m->series[m->series_count++] = (struct breakdown_series){ (enum breakdown_source)s, o->order, quantity };
  static const double tolerances[MOST_TOLERANCES] = { BREAKDOWN_MAP_TOLERANCES };
  memcpy(m->tolerances, o->has_tolerance ? &o->tolerance : tolerances,
         sizeof tolerances[0] * (o->has_tolerance ? 1 : MOST_TOLERANCES));
  m->tolerance_count = o->has_tolerance ? 1 : MOST_TOLERANCES;
  name_columns(m);
  return true;
}

/* ---- points ---- */

static bool sets_period(const struct axis *a) { return a->kind == AXIS_T || a->kind == AXIS_FROUDE; }

static struct scallop_crawler crawler_of(const struct map *m, long row)
{
  long columns = m->axes[0].count;
  return axes_crawler(m->axes, &m->options->point.crawler, axis_node(&m->axes[0], row % columns),
                      axis_node(&m->axes[1], row / columns));
}

/* Where a series reaches to does not depend on T. */
static long reach_of_row(const struct map *m, long row)
{
  long columns = m->axes[0].count;
  return sets_period(&m->axes[0]) ? row / columns : sets_period(&m->axes[1]) ? row % columns : row;
}

static long row_of_reach(const struct map *m, long reach)
{
  return sets_period(&m->axes[0]) ? reach * m->axes[0].count : reach;
}

static long count_reaches(const struct map *m)
{
  return sets_period(&m->axes[0]) ? m->axes[1].count : sets_period(&m->axes[1]) ? m->axes[0].count : m->rows;
}

/* ---- items ---- */

static long item_count(const struct map *m) { return m->reaches + m->rows; }

static int item_width(const struct map *m, long item)
{
  return item < m->reaches ? m->series_count * m->tolerance_count : m->series_count;
}

static double *item_values(const struct map *m, long item)
{
  long width = m->series_count, reach_width = width * m->tolerance_count;
  return m->values + (item < m->reaches ? item * reach_width : m->reaches * reach_width + (item - m->reaches) * width);
}

/* nan where there is no steady state at all */
static void compute(const struct map *m, long item, double *values)
{
  struct scallop_steady_result r;
  bool is_reach = item < m->reaches;
  struct scallop_crawler c = crawler_of(m, is_reach ? row_of_reach(m, item) : item - m->reaches);
  bool exists = is_reach ? scallop_crawler_check(&c, NULL) == SCALLOP_OK : scallop_steady(&c, &r) >= 0;
  for (int i = 0; i < item_width(m, item); i++) {
    const struct breakdown_series *series = &m->series[is_reach ? i / m->tolerance_count : i];
    values[i] = !exists    ? NAN
                : is_reach ? breakdown_reach(&c, series, m->tolerances[i % m->tolerance_count])
                           : breakdown_error(&c, series);
  }
}

static void store(struct map *m, long item, const double *values)
{
  memcpy(item_values(m, item), values, (size_t)item_width(m, item) * sizeof *values);
  m->done[item] = true;
  m->done_count++;
}

static void show(struct map *m)
{
  struct timespec now;
  if (m->shown_at < 0)
    return;
  clock_gettime(CLOCK_MONOTONIC, &now);
  double seconds = (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
  if (seconds < m->shown_at + 0.2)
    return;
  m->shown_at = seconds;
  fprintf(stderr, "\r%ld of %ld\033[K", m->done_count, item_count(m));
}

static void finish(struct map *m, long item, const double *values)
{
  store(m, item, values);
  if (m->journalled && !journal_add(&m->journal, item, item_width(m, item), values))
    m->failed = true;
  show(m);
}

static void compute_all(struct map *m)
{
#pragma omp parallel num_threads(threads_for(0, item_count(m)))
  {
#pragma omp for schedule(dynamic)
    for (long item = 0; item < item_count(m); item++) {
      double values[JOURNAL_VALUES];
      bool left;
#ifdef _OPENMP
#pragma omp critical
#endif
      left = !m->done[item] && !m->failed;
      if (!left)
        continue;
      compute(m, item, values);
#ifdef _OPENMP
#pragma omp critical
#endif
      finish(m, item, values);
    }
    flint_cleanup();
  }
  if (m->shown_at >= 0)
    fprintf(stderr, "\r\033[K");
}

/* ---- the journal ---- */

static bool take(void *context, long item, int count, const double *values)
{
  struct map *m = context;
  if (item < 0 || item >= item_count(m) || count != item_width(m, item))
    return false;
  if (!m->done[item])
    store(m, item, values);
  return true;
}

/* All that the values depend on */
static void make_title(const struct map *m, char title[TITLE])
{
  const struct scallop_crawler *c = &m->options->point.crawler;
  int used = snprintf(title, TITLE, "scallop " SCALLOP_VERSION " journal of breakdown --map:");
  for (int i = 0; i < 2; i++) {
    const struct axis *a = &m->axes[i];
    used += snprintf(title + used, (size_t)(TITLE - used), " %s %a:%a:%ld:%s", axis_name(a->kind), a->from, a->to, a->count,
                     a->log ? "log" : "linear");
  }
  used += snprintf(title + used, (size_t)(TITLE - used),
                   " m1 %a m2 %a F1 %a F2 %a L %a T %a alpha %a gait %.200s (%08lx) %s", c->m1, c->m2, c->F1, c->F2, c->L,
                   c->T, c->alpha, c->gait->name, (unsigned long)gait_checksum(c->gait),
                   quantity_rows[m->series[0].quantity].name);
  for (int i = 0; i < m->series_count * (1 + m->tolerance_count); i++)
    used += snprintf(title + used, (size_t)(TITLE - used), " %s", m->names[i]);
  if (m->tolerance_count == 1)
    snprintf(title + used, (size_t)(TITLE - used), " %a", m->tolerances[0]);
}

static enum exit_code open_journal(struct map *m)
{
  char path[JOURNAL_PATH], title[TITLE];
  if ((size_t)snprintf(path, sizeof path, "%s.rows", m->options->output) >= sizeof path) {
    complain("breakdown", "cannot write beside %s: the name is too long", m->options->output);
    return EXIT_FILE;
  }
  make_title(m, title);
  switch (journal_open(&m->journal, path, title, take, m)) {
  case JOURNAL_OTHER:
    complain("breakdown",
             "%s is no journal of this map: it is of another map, of another version, or of a measured gait whose file has "
             "changed since; remove it, or write elsewhere",
             path);
    return EXIT_FILE;
  case JOURNAL_BUSY: complain("breakdown", "%s: another process is at work on this map", path); return EXIT_FILE;
  case JOURNAL_ERROR: complain("breakdown", "cannot write %s: %s", path, strerror(errno)); return EXIT_FILE;
  case JOURNAL_FOUND:
    if (!m->options->quiet)
      complain("breakdown", "going on from %s: %ld of %ld are done", path, m->done_count, item_count(m));
    break;
  case JOURNAL_NEW: break;
  }
  m->journalled = true;
  return EXIT_DONE;
}

/* ---- the table ---- */

static void note_axis(struct table *t, const char *which, const struct axis *a)
{
  char from[NUMBER_TEXT], to[NUMBER_TEXT];
  number_text(from, a->from, 0);
  number_text(to, a->to, 0);
  table_note(t, "%s: %s from %s to %s, %ld values, %s", which, axis_name(a->kind), from, to, a->count,
             a->log ? "log" : "linear");
}

void map_begin(struct table *t, const struct options *o, const struct axis axes[2], const char *about)
{
  table_note(t, "scallop " SCALLOP_VERSION);
  table_note(t, "command: breakdown --map %s %s%s", o->map[0], o->map[1], about);
  note_axis(t, "x", &axes[0]);
  note_axis(t, "y", &axes[1]);
  table_parameters(t, o, (const char *const[]){ axis_sets(axes[0].kind), axis_sets(axes[1].kind), NULL }, false);
}

/* What the axes set, and what may be wanted beside it; F1/F2 as an axis is not F1. */
static const char *const parameters[] = { "m1", "m2", "F1", "F2", "T", "alpha", "froude", NULL };

static bool is_axis(const struct map *m, const char *name)
{
  return strcmp(name, axis_name(m->axes[0].kind)) == 0 || strcmp(name, axis_name(m->axes[1].kind)) == 0;
}

static void begin_table(struct map *m, struct table *t)
{
  static const char *const state[] = { "modes", "regime", "v_start", "displacement", "mean_velocity", NULL };
  static const char *const last[] = { "status", NULL };
  const char *first[] = { axis_name(m->axes[0].kind), axis_name(m->axes[1].kind), NULL };
  const char *series[MOST_SERIES * (1 + MOST_TOLERANCES) + 1] = { NULL };
  for (int i = 0; i < m->series_count * (1 + m->tolerance_count); i++)
    series[i] = m->names[i];
  map_begin(t, m->options, m->axes, "");
  table_note(
      t, "series: of the %s; error: series/exact - 1 at this T; T: the largest up to which its size is below that number",
      quantity_rows[m->series[0].quantity].name);
  table_columns(t, first);
  for (const char *const *p = parameters; *p; p++)
    if (!is_axis(m, *p))
      table_columns(t, (const char *const[]){ *p, NULL });
  table_columns(t, state);
  table_columns(t, series);
  table_columns(t, last);
  table_begin_rows(t);
}

static void write_parameters(const struct map *m, struct table *t, const struct scallop_crawler *c, long row)
{
  table_number(t, axis_node(&m->axes[0], row % m->axes[0].count));
  table_number(t, axis_node(&m->axes[1], row / m->axes[0].count));
  for (const char *const *p = parameters; *p; p++)
    if (!is_axis(m, *p))
      table_number(t, strcmp(*p, "froude") == 0 ? (c->m1 + c->m2) * c->L / (c->T * c->T * (c->F1 + c->F2))
                                                : crawler_parameter(c, *p));
}

static void write_state(struct table *t, enum scallop_status status, const struct scallop_steady_result *r)
{
  char modes[PERIOD_MODES_TEXT];
  bool solved = status >= 0;
  if (solved)
    period_modes_text(modes, r->period.modes);
  table_text(t, solved ? modes : "-");
  table_text(t, solved ? scallop_regime_text(r->period.regime) : "-");
  table_number(t, solved ? r->period.v_start : NAN);
  table_number(t, solved ? r->period.displacement : NAN);
  table_number(t, solved ? r->mean_velocity : NAN);
}

static void write_row(struct map *m, struct table *t, long row)
{
  struct scallop_steady_result r;
  struct scallop_crawler c = crawler_of(m, row);
  enum scallop_status status = scallop_steady(&c, &r);
  const double *errors = item_values(m, m->reaches + row), *reaches = item_values(m, reach_of_row(m, row));
  write_parameters(m, t, &c, row);
  write_state(t, status, &r);
  for (int s = 0; s < m->series_count; s++)
    table_number(t, errors[s]);
  for (int i = 0; i < m->series_count * m->tolerance_count; i++)
    table_number(t, reaches[i]);
  table_text(t, scallop_status_text(status));
  m->unsolved += status < 0;
}

static enum exit_code run(struct map *m)
{
  struct table t;
  if (!table_open(&t, m->options))
    return EXIT_FILE;
  enum exit_code code = t.is_aside ? open_journal(m) : EXIT_DONE;
  if (code == EXIT_DONE)
    compute_all(m);
  if (m->failed) {
    complain("breakdown", "cannot write %s: %s", m->journal.path, strerror(m->journal.error));
    code = EXIT_FILE;
  }
  if (code == EXIT_DONE) {
    begin_table(m, &t);
    for (long row = 0; row < m->rows && !table_failed(&t); row++)
      write_row(m, &t, row);
    code = table_close(&t) ? EXIT_DONE : EXIT_FILE;
    if (code == EXIT_DONE && m->unsolved > 0) {
      complain("breakdown", "%ld of %ld points have no steady state: see the column status", m->unsolved, m->rows);
      code = EXIT_UNSOLVED;
    }
  } else {
    table_abandon(&t);
  }
  if (m->journalled)
    journal_close(&m->journal, code == EXIT_DONE || code == EXIT_UNSOLVED);
  return code;
}

enum exit_code breakdown_map(const struct options *options)
{
  struct map m = { .options = options, .shown_at = !options->quiet && isatty(STDERR_FILENO) ? 0 : -1 };
  if (!axes_read(m.axes, options) || !choose_series(&m))
    return EXIT_USAGE;
  m.rows = m.axes[0].count * m.axes[1].count;
  if (m.rows > MOST_ROWS) {
    complain("breakdown", "--map: %ld x %ld values are more than 10000000 rows", m.axes[0].count, m.axes[1].count);
    return EXIT_USAGE;
  }
  m.reaches = count_reaches(&m);
  size_t width = (size_t)m.series_count;
  m.values = calloc((size_t)m.reaches * width * (size_t)m.tolerance_count + (size_t)m.rows * width, sizeof *m.values);
  m.done = calloc((size_t)item_count(&m), sizeof *m.done);
  enum exit_code code = EXIT_UNSOLVED;
  if (m.values && m.done)
    code = run(&m);
  else
    complain("breakdown", "out of memory");
  free(m.values);
  free(m.done);
  return code;
}
