#include <math.h>
#include <stdio.h>

#include "compare/answers/counts.h"
#include "compare/answers/exact.h"
#include "compare/answers/points.h"
#include "compare/command/with_flint.h"
#include "numerics/wide.h"

static const char *const accepts[] = { "m1",        "m2",    "F1",     "F2",     "L",      "T",      "alpha", "gait",
                                       "certified", "error", "points", "format", "digits", "output", "quiet", NULL };
static const char *const none[] = { NULL };
static const char *const columns[] = { "froude",     "v_start", "v_mid", "displacement", "mean_velocity",
                                       "multiplier", "regime",  "modes", "status",       NULL };

static const char *const error_columns[] = { "froude",
                                             "v_start",
                                             "v_mid",
                                             "displacement",
                                             "mean_velocity",
                                             "multiplier",
                                             "froude_error",
                                             "v_start_error",
                                             "v_mid_error",
                                             "displacement_error",
                                             "mean_velocity_error",
                                             "multiplier_error",
                                             "regime",
                                             "modes",
                                             "status",
                                             NULL };

/* of an estimate, with three digits */
static const double rounded_up = 1.005;

/* refused as in points.h. Returns why, the reason. */
static const char *write_none(struct table *table, const struct scallop_crawler *crawler, const char *refused,
                              const char *why)
{
  point_crawler(table, crawler, refused);
  point_blank(table, table->options->error ? 12 : 6);
  table_text(table, "-");
  table_text(table, "-");
  table_text(table, why);
  return why;
}

/* Gaits of this command have exact laws: the only failure is that of the solve itself. */
static void write_errors(struct table *table, const struct scallop_crawler *crawler, const struct scallop_steady_result *r)
{
  struct scallop_steady_error e = { NAN, NAN, NAN, NAN, NAN, NAN };
  scallop_steady_error(crawler, r, &e);
  const double errors[] = { e.froude, e.v_start, e.v_mid, e.displacement, e.mean_velocity, e.multiplier };
  for (size_t i = 0; i < sizeof errors / sizeof *errors; i++)
    table_rounded(table, rounded_up * errors[i], "%.3g");
}

static const char *row(struct table *table, const struct options *point, const char *refused)
{
  const struct scallop_crawler *crawler = &point->point.crawler;
  struct scallop_steady_result r;
  char modes[PERIOD_MODES_TEXT], interval[STEADY_STATUS];
  if (refused)
    return write_none(table, crawler, refused, refused);
  if (point->certified)
    return certified_steady_row(table, point);
  enum scallop_status status = counted_steady(crawler, &r);
  if (status < 0)
    return write_none(table, crawler, NULL, scallop_status_text(status));
  point_crawler(table, crawler, NULL);
  const double numbers[] = { r.froude,        r.period.v_start,   r.period.v_mid, r.period.displacement,
                             r.mean_velocity, r.period.multiplier };
  for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
    table_number(table, numbers[i]);
  if (point->error)
    write_errors(table, crawler, &r);
  table_text(table, scallop_regime_text(r.period.regime));
  table_text(table, period_modes_text(modes, r.period.modes));
  table_text(table, steady_status_text(interval, status, r.v_low, r.v_high));
  return NULL;
}

static enum exit_code run(const struct options *options)
{
  if (options->certified && options->error) {
    complain("steady", "--error has nothing to do with --certified: every digit is proven");
    return EXIT_USAGE;
  }
  if (options->certified && !has_flint(options, "--certified"))
    return EXIT_UNSOLVED;
  return for_each_point(options, none, options->error ? error_columns : columns, row);
}

static const struct unless_given unless_given[] = {
  { "digits", "%s; with --certified " TEXT_OF(CERTIFIED_DIGITS) },
  { NULL, NULL },
};

const struct command command_steady = {
  .name = "steady",
  .summary = "the periodic steady state, exactly",
  .example = "scallop steady --F1 3 --T 0.5 --gait sinusoidal",
  .accepts = accepts,
  .about =
      "Columns: the parameters; froude = M L / (T^2 (F1 + F2)); v_start and v_mid, the velocity of both bodies\n"
      "at the start of the extension and of the contraction; displacement of the geometric centre over a period,\n"
      "and mean_velocity = displacement / T; multiplier, the derivative of the period map (how fast a deviation\n"
      "decays: its factor per period); regime: sliding, stick-slip or at-rest; modes: directions of body 1 and\n"
      "body 2 in turn, 0 stuck, | between extension and contraction; status: ok, or why there is no answer.\n"
      "--error: for each number an estimate of its error: what it is off by in 113 bits (numerics/wide.h). It is of the "
      "doubles\n"
      "nearest to the parameters as written; --certified takes the decimals themselves.\n"
      "--certified: the same in ball arithmetic, with --digits D digits that are proven: the last one is right to a\n"
      "unit. The parameters are then exactly the numbers that are written (0.7 is 7/10), those of a gait and a table too,\n"
      "and status is certified. What touches a boundary exactly cannot be decided, which status says. A polynomial\n"
      "whose l' changes its sign within a phase, or is not exactly 0 at its ends, is that of the doubles.",
  .unless_given = unless_given,
  .proven = "with --certified",
  .run = run,
};
