#include <string.h>

#include "compare/compare.h"

static const char *const accepts[] = { "m1", "m2", "F1", "F2", "L", "T", "alpha", "gait", "start", "periods", "samples",
                                       "format", "digits", "output", "quiet", NULL };
static const char *const columns[] = { "t", "x1", "x2", "xC", "v1", "v2", "l", NULL };

static bool write_sample(void *context, const struct scallop_sample *s)
{
  struct table *table = context;
  const double numbers[] = { s->t, s->x1, s->x2, s->xC, s->v1, s->v2, s->l };
  for (int i = 0; i < 7; i++)
    table_number(table, numbers[i]);
  return !ferror(table->file);
}

static enum exit_code run(const struct options *options)
{
  double v0 = options->start_velocity;
  struct scallop_steady_result steady;
  struct table table;
  enum scallop_status status = SCALLOP_OK;
  if (strcmp(options->start, "rest") == 0)
    v0 = 0;
  if (strcmp(options->start, "steady") == 0) {
    status = scallop_steady(&options->crawler, &steady);
    v0 = steady.period.v_start;
  }
  if (status >= 0 && !table_open(&table, options))
    return EXIT_FILE;
  if (status >= 0) {
    table_note(&table, "scallop " SCALLOP_VERSION);
    table_note(&table, "command: trajectory");
    table_parameters(&table, options);
    table_note(&table, "start: %s, velocity %.17g; periods: %ld; samples in a period: %ld", options->start, v0,
               options->periods, options->samples);
    table_columns(&table, columns);
    table_begin_rows(&table);
    status = scallop_trajectory(&options->crawler, v0, options->periods, options->samples, write_sample, &table);
    if (status < 0)
      table_abandon(&table);
  }
  if (status < 0) {
    complain("trajectory", "%s", scallop_status_text(status));
    return EXIT_UNSOLVED;
  }
  return table_close(&table) ? EXIT_DONE : EXIT_FILE;
}

const struct command command_trajectory = {
  .name = "trajectory",
  .summary = "positions and velocities in time, from rest, from the steady state or from a velocity",
  .example = "scallop trajectory --start rest --periods 20 --samples 50",
  .accepts = accepts,
  .about =
    "Columns: time t; positions x1, x2 of the bodies and xC = (x1 + x2)/2 of the geometric centre, all 0 at t = 0;\n"
    "velocities v1, v2; separation l = x2 - x1. A body that is stuck has velocity exactly 0. Each sample is exact:\n"
    "errors do not grow with the number of periods.",
  .run = run,
};
