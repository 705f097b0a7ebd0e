#include <stdio.h>
#include <string.h>

#include "compare/command/commands.h"
#include "numerics/numerics.h"

struct trajectory_options {
  struct request request;
  const char *start; /* "rest", "steady" or a number */
  double velocity;   /* that number */
  struct given_count periods, samples;
};

static const char *read_start(void *options, const struct option *option, const char *text)
{
  struct trajectory_options *o = options;
  (void)option;
  o->start = text;
  if (strcmp(text, "rest") == 0 || strcmp(text, "steady") == 0 || read_number(text, &o->velocity))
    return NULL;
  return no_number(text, "rest, steady or a velocity");
}

static const struct option_kind start_option = { read_start, NULL };
enum { MOST_PERIODS = 1000000000 };

static const struct option options_of_trajectory[] = {
  OPTIONS_CRAWLER(NULL, NULL),
  OPTION("start", "WHAT", "rest, steady, or a velocity", "rest", .kind = &start_option),
  OPTION_COUNT("periods", "N", "number of periods", NULL, trajectory_options, periods, 1, MOST_PERIODS),
  OPTION_COUNT("samples", "N", "samples in a period", NULL, trajectory_options, samples, 1, MOST_PERIODS),
  OPTIONS_PLOT,
  OPTIONS_OF_DOUBLES,
};
static const struct trajectory_options initial = { .start = "rest",
                                                   .periods = { 10, false },
                                                   .samples = { 40, false } };

static const char *const columns[] = { "t", "x1", "x2", "xC", "v1", "v2", "l", NULL };

struct output {
  const struct trajectory_options *options;
  double v0;
  struct table table;
  bool begun, failed;
};

/* The table is opened with its first row: nothing is written if there is none. */
static bool begin(struct output *out)
{
  const struct trajectory_options *o = out->options;
  char v0[NUMBER_TEXT];
  if (!table_head(&out->table, &o->request.style, "trajectory"))
    return false;
  note_parameters(&out->table, &o->request.point, NULL, false);
  number_text(v0, out->v0, 0);
  table_note(&out->table, "start: %s, velocity %s; periods: %ld; samples in a period: %ld", o->start, v0,
             o->periods.value, o->samples.value);
  table_columns(&out->table, columns);
  table_begin_rows(&out->table);
  return true;
}

static bool write_sample(void *context, const struct scallop_sample *s)
{
  struct output *out = context;
  struct table *table = &out->table;
  if (!out->begun) {
    out->failed = !begin(out);
    out->begun = true;
  }
  if (out->failed)
    return false;
  const double numbers[] = { s->t, s->x1, s->x2, s->xC, s->v1, s->v2, s->l };
  for (int i = 0; i < 7; i++)
    table_number(table, numbers[i]);
  return !table_failed(table);
}

static enum exit_code run(const struct arguments *arguments, const void *options)
{
  const struct trajectory_options *o = options;
  const struct scallop_crawler *crawler = &o->request.point.crawler;
  struct scallop_steady_result steady;
  struct output out = { .options = o, .v0 = o->velocity };
  enum scallop_status status = SCALLOP_OK;
  (void)arguments;
  if (strcmp(o->start, "rest") == 0)
    out.v0 = 0;
  if (strcmp(o->start, "steady") == 0) {
    status = scallop_steady(crawler, &steady);
    out.v0 = status < 0 ? 0 : steady.period.v_start;
  }
  if (status >= 0)
    status = scallop_trajectory(crawler, out.v0, o->periods.value, o->samples.value, write_sample, &out);
  if (out.failed)
    return EXIT_FILE;
  if (status < 0) {
    complain("trajectory", "%s", scallop_status_text(status));
    if (out.begun) {
      table_note(&out.table, "incomplete: %s", scallop_status_text(status));
      table_abandon(&out.table);
    }
    return EXIT_UNSOLVED;
  }
  return table_close(&out.table) ? EXIT_DONE : EXIT_FILE;
}

const struct command command_trajectory = {
  .name = "trajectory",
  .summary = "positions and velocities in time, from rest, from the steady state or from a velocity",
  .example = "scallop trajectory --start rest --periods 20 --samples 50",
  .options = options_of_trajectory,
  .size = sizeof(struct trajectory_options),
  .initial = &initial,
  .run = run,
};
