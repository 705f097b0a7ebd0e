#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/answers/counts.h"
#include "compare/answers/exact.h"
#include "compare/answers/points.h"
#include "compare/answers/defaults.h"
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

/* A steady state as it is written */
struct state {
  enum scallop_status status;
  double numbers[6]; /* froude to multiplier, in the order of the columns */
  double errors[6];  /* estimates; of none, where they are not asked for */
  int error_count;
  double v_low, v_high;
  enum scallop_regime regime;
  const struct scallop_modes *modes; /* of both phases */
};

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

/* Returns NULL, or why there is no steady state. */
static const char *write_row(struct table *table, const struct scallop_crawler *crawler, const struct state *s)
{
  if (s->status < 0)
    return write_none(table, crawler, NULL, scallop_status_text(s->status));
  point_crawler(table, crawler, NULL);
  for (int i = 0; i < 6; i++)
    table_number(table, s->numbers[i]);
  for (int i = 0; i < s->error_count; i++)
    table_rounded(table, rounded_up * s->errors[i], "%.3g");
  table_text(table, scallop_regime_text(s->regime));
  char modes[PERIOD_MODES_TEXT];
  table_text(table, period_modes_text(modes, s->modes));
  char interval[STEADY_STATUS];
  table_text(table, steady_status_text(interval, s->status, s->v_low, s->v_high));
  return NULL;
}

/* Gaits of this command have exact laws: the only failure is that of the solve itself. */
static void estimate(const struct scallop_crawler *crawler, const struct scallop_steady_result *r, struct state *s)
{
  struct scallop_steady_error e = { NAN, NAN, NAN, NAN, NAN, NAN };
  scallop_steady_error(crawler, r, &e);
  const double errors[] = { e.froude, e.v_start, e.v_mid, e.displacement, e.mean_velocity, e.multiplier };
  memcpy(s->errors, errors, sizeof errors);
  s->error_count = 6;
}

static const char *row(struct table *table, const struct options *point, const char *refused)
{
  if (refused)
    return write_none(table, &point->point.crawler, refused, refused);
  if (point->certified)
    return with_flint.steady_row(table, point);
  struct scallop_steady_result r;
  struct state s = { .status = counted_steady(&point->point.crawler, &r) };
  if (s.status >= 0)
    s = (struct state){ .status = s.status,
                        .numbers = { r.froude, r.period.v_start, r.period.v_mid, r.period.displacement, r.mean_velocity,
                                     r.period.multiplier },
                        .v_low = r.v_low,
                        .v_high = r.v_high,
                        .regime = r.period.regime,
                        .modes = r.period.modes };
  if (point->error && s.status >= 0)
    estimate(&point->point.crawler, &r, &s);
  return write_row(table, &point->point.crawler, &s);
}

/* The columns of a block of answers */
struct states {
  double numbers[6][POINT_BLOCK], v_low[POINT_BLOCK], v_high[POINT_BLOCK];
  enum scallop_regime regime[POINT_BLOCK];
  struct scallop_modes modes[POINT_BLOCK][2];
  enum scallop_status status[POINT_BLOCK];
};

static struct state state_at(const struct states *a, long i)
{
  struct state s = { .status = a->status[i], .v_low = a->v_low[i], .v_high = a->v_high[i], .modes = a->modes[i] };
  for (int k = 0; k < 6; k++)
    s.numbers[k] = a->numbers[k][i];
  if (s.status >= 0)
    s.regime = a->regime[i];
  return s;
}

static struct scallop_crawler crawler_at(const struct scallop_crawlers *c, long i)
{
  return (struct scallop_crawler){ c->m1[i], c->m2[i], c->F1[i], c->F2[i], c->L[i], c->T[i], c->alpha[i], c->gait[i] };
}

static long rows(struct table *table, const struct options *options, const struct point_block *block)
{
  struct states a;
  (void)options;
  double(*numbers)[POINT_BLOCK] = a.numbers;
  const struct scallop_steady_states wanted = { .froude = numbers[0],
                                                .v_start = numbers[1],
                                                .v_mid = numbers[2],
                                                .displacement = numbers[3],
                                                .mean_velocity = numbers[4],
                                                .multiplier = numbers[5],
                                                .v_low = a.v_low,
                                                .v_high = a.v_high,
                                                .regime = a.regime,
                                                .modes = a.modes,
                                                .status = a.status };
  long unsolved = 0;
  counted_steady_batch(&block->crawlers, &wanted, 1); /* text in and out is nearly all of the time */
  for (long i = 0; i < block->crawlers.count; i++) {
    const struct scallop_crawler crawler = crawler_at(&block->crawlers, i);
    const struct state state = state_at(&a, i);
    const char *refused = block->refused[i];
    if (*refused ? write_none(table, &crawler, refused, refused) : write_row(table, &crawler, &state))
      unsolved++;
  }
  return unsolved;
}

static enum exit_code run(const struct options *options)
{
  if (options->certified && options->error) {
    complain("steady", "--error has nothing to do with --certified: every digit is proven");
    return EXIT_USAGE;
  }
  if (options->certified && !has_flint(options, "--certified"))
    return EXIT_UNSOLVED;
  if (options->points && !options->certified && !options->error)
    return for_each_block(options, columns, rows);
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
