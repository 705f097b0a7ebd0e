/* The points and the table of ways. */
#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "compare/answers/points.h"
#include "compare/answers/defaults.h"
#include "compare/workprec/workprec.h"

enum { MOST_POINTS = 40 };

static const char *const columns[] = {
  "method",      "setting",         "gait",    "T",       "quantity",    "error",
  "time_median", "time_min",        "time_q1", "time_q3", "repetitions", "gait_evaluations",
  "events",      "root_iterations", "periods", "pareto",  "status",      NULL
};
const char *const way_quantities[WAY_QUANTITIES + 1] = { "v_start", "displacement", NULL };

struct run {
  const struct workprec_options *options;
  struct trial points[MOST_POINTS];
  int count;
  double limit;
  struct stopwatch_clock clock;
  struct table table;
  const struct trial *at;
};

/* ---- points ---- */

static const char *add_point(struct run *r, const struct scallop_gait *gait, double T)
{
  struct scallop_crawler c = r->options->request.point.crawler;
  assert(r->count < MOST_POINTS);
  c.gait = gait;
  c.T = T;
  return point_init(&r->points[r->count++], &c);
}

/* All are solved before anything is written. */
static bool make_points(struct run *r)
{
  static const double all[] = { WORKPREC_T }, few[] = { WORKPREC_QUICK_T };
  const struct workprec_options *o = r->options;
  bool one = o->request.point.written[5] != NULL; /* T */
  const double *T = one ? &o->request.point.crawler.T : o->quick ? few : all;
  int times = (int)(one ? 1 : o->quick ? sizeof few / sizeof *few : sizeof all / sizeof *all);
  for (int g = 0; o->request.point.has_gait ? g == 0 : scallop_gait_name(g) != NULL; g++) {
    const struct scallop_gait *gait = o->request.point.has_gait ? o->request.point.crawler.gait
                                                                : scallop_gait_named(scallop_gait_name(g));
    for (int i = 0; i < times; i++) {
      const char *why = add_point(r, gait, T[i]);
      if (why)
        complain("workprec", "no certified steady state to compare with for the %s gait and T = %.17g: %s", gait->name, T[i],
                 why);
      if (why)
        return false;
    }
  }
  return true;
}

/* ---- the table ---- */

static double nothing(void *context) { return *(const double *)context; }

/* What a batch adds to each solve: the loop and a call */
static double call_cost(const struct stopwatch_clock *clock)
{
  double samples[WAY_SAMPLES], zero = 0;
  long passes = stopwatch_passes(nothing, &zero, stopwatch_long_enough(clock));
  for (int i = 0; i < WAY_SAMPLES; i++)
    samples[i] = stopwatch_batch(nothing, &zero, passes) / (double)passes;
  return stopwatch_spread(samples, WAY_SAMPLES).median;
}

static bool begin(struct run *r)
{
  const struct workprec_options *o = r->options;
  static const char *const columns_of_points[] = { "T", "gait", NULL };
  struct table *t = &r->table;
  if (!table_open(t, &o->request.style))
    return false;
  table_note(t, "scallop " SCALLOP_VERSION);
  table_note(t, "command: workprec%s%s --limit %g", o->quick ? " --quick" : "", o->summary ? " --summary" : "", r->limit);
  note_parameters(t, &o->request.point, columns_of_points, false);
  table_note(
      t, "error: |answer - certified| / |certified|, for these very doubles; over L/T or L where the certified value is 0");
  if (o->summary)
    table_note(t, "ratios: of median times of one run on one machine");
  else {
    table_note(t,
               "times: seconds for one solve, by the wall clock of one machine: only ratios within one table mean anything");
    table_note(t, "clock: a reading takes %.2g s, the smallest step is %.2g s; shortest batch %.2g s; an empty call %.2g s",
               r->clock.cost, r->clock.step, stopwatch_long_enough(&r->clock), call_cost(&r->clock));
  }
  table_columns(t, o->summary ? summary_columns : columns);
  table_begin_rows(t);
  return true;
}

static void write_way(struct table *t, const struct way *way, int quantity)
{
  const struct stopwatch_spread *time = &way->time;
  const struct way_answer *a = &way->answer;
  table_text(t, way->method);
  table_text(t, way->setting);
  table_text(t, way->point->crawler.gait->name);
  table_number(t, way->point->crawler.T);
  table_text(t, way_quantities[quantity]);
  if (isnan(way->error_log10[quantity]))
    table_number(t, NAN);
  else
    table_digits(t, way->error[quantity]);
  table_rounded(t, time->median, "%.4g");
  table_rounded(t, time->least, "%.4g");
  table_rounded(t, time->q1, "%.4g");
  table_rounded(t, time->q3, "%.4g");
  table_rounded(t, time->repetitions, "%.0f");
  table_number(t, a->gait_evaluations);
  table_number(t, a->events);
  table_number(t, a->root_iterations);
  table_number(t, a->periods);
  table_text(t, way->kind == WAY_ASIDE || !way->solved ? "-" : way->front[quantity] ? "yes" : "no");
  table_text(t, way->status);
}

static void write_ways(struct run *r, const struct ways *ways)
{
  for (int i = 0; i < ways->count; i++)
    for (int quantity = 0; quantity < WAY_QUANTITIES; quantity++)
      if (way_has(&ways->list[i], quantity))
        write_way(&r->table, &ways->list[i], quantity);
}

/* ---- the run ---- */

static void say(void *context, int done, int count, const struct way *way)
{
  const struct run *r = context;
  fprintf(stderr, "\r%s, T = %g: %d of %d: %s, %s\033[K", r->at->crawler.gait->name, r->at->crawler.T, done + 1, count,
          way->method, way->setting);
}

static void say_nothing(void *context, int done, int count, const struct way *way)
{
  (void)context, (void)done, (void)count, (void)way;
}

static void measure(struct run *r, struct ways *ways)
{
  bool shown = !r->options->request.style.quiet && isatty(STDERR_FILENO);
  const struct workprec_progress progress = { shown ? say : say_nothing, r };
  for (int i = 0; i < r->count; i++) {
    r->at = &r->points[i];
    ways_add_ours(ways, r->at, r->options->quick);
    ways_add_rivals(ways, r->at, r->options->quick);
    ways_measure(ways, &r->clock, r->limit, &progress);
    if (r->options->summary)
      summary_write(&r->table, ways);
    else
      write_ways(r, ways);
    ways_clear(ways);
  }
  if (shown)
    fprintf(stderr, "\r\033[K");
}

enum exit_code workprec_table(const struct workprec_options *options)
{
  struct run r = { .options = options,
                   .limit = options->limit.value > 0 ? options->limit.value
                            : options->quick         ? WORKPREC_QUICK_LIMIT
                                                     : WORKPREC_LIMIT };
  enum exit_code code = EXIT_UNSOLVED;
  struct ways *ways = calloc(1, sizeof *ways);
  if (!ways)
    complain("workprec", "out of memory");
  else if (make_points(&r)) {
    r.clock = stopwatch_clock();
    code = begin(&r) ? EXIT_DONE : EXIT_FILE;
  }
  if (code == EXIT_DONE) {
    measure(&r, ways);
    code = table_close(&r.table) ? EXIT_DONE : EXIT_FILE;
  }
  for (int i = 0; i < r.count; i++)
    point_clear(&r.points[i]);
  free(ways);
  return code;
}
