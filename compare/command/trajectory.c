#include <string.h>

#include "compare/command/compare.h"
#include "numerics/numerics.h"

static const char *const accepts[] = { "m1",    "m2",      "F1",      "F2",     "L",      "T",      "alpha", "gait",
                                       "start", "periods", "samples", "format", "digits", "output", "quiet", NULL };
static const char *const columns[] = { "t", "x1", "x2", "xC", "v1", "v2", "l", NULL };

struct output {
  const struct options *options;
  double v0;
  struct table table;
  bool begun, failed;
};

/* The table is opened with its first row: nothing is written if there is none. */
static bool begin(struct output *out)
{
  const struct options *o = out->options;
  char v0[NUMBER_TEXT];
  if (!table_open(&out->table, o))
    return false;
  table_note(&out->table, "scallop " SCALLOP_VERSION);
  table_note(&out->table, "command: trajectory");
  table_parameters(&out->table, o, NULL, false);
  number_text(v0, out->v0, 0);
  table_note(&out->table, "start: %s, velocity %s; periods: %ld; samples in a period: %ld", o->start, v0, o->periods,
             o->samples);
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
  return !ferror(table->file);
}

static enum exit_code run(const struct options *options)
{
  struct scallop_steady_result steady;
  struct output out = { .options = options, .v0 = options->start_velocity };
  enum scallop_status status = SCALLOP_OK;
  if (strcmp(options->start, "rest") == 0)
    out.v0 = 0;
  if (strcmp(options->start, "steady") == 0) {
    status = scallop_steady(&options->point.crawler, &steady);
    out.v0 = status < 0 ? 0 : steady.period.v_start;
  }
  if (status >= 0)
    status = scallop_trajectory(&options->point.crawler, out.v0, options->periods, options->samples, write_sample, &out);
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
  .accepts = accepts,
  .about = "Columns: time t; positions x1, x2 of the bodies and xC = (x1 + x2)/2 of the geometric centre, all 0 at t = 0;\n"
           "velocities v1, v2; separation l = x2 - x1. A body that is stuck has velocity exactly 0. Each sample is exact:\n"
           "errors do not grow with the number of periods.",
  .run = run,
};
