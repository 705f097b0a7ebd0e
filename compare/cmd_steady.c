#include <stdio.h>

#include "compare/points.h"
#include "compare/with_flint.h"

static const char *const accepts[] = { "m1",        "m2",     "F1",     "F2",     "L",      "T",     "alpha", "gait",
                                       "certified", "points", "format", "digits", "output", "quiet", NULL };
static const char *const none[] = { NULL };
static const char *const columns[] = { "froude",     "v_start", "v_mid", "displacement", "mean_velocity",
                                       "multiplier", "regime",  "modes", "status",       NULL };

static const char *row(struct table *table, const struct options *point, const char *refused)
{
  if (point->certified && !refused)
    return certified_steady_row(table, point);
  struct scallop_steady_result r;
  char modes[2][SCALLOP_MODES_TEXT], both[2 * SCALLOP_MODES_TEXT + 4], interval[160];
  char low[NUMBER_TEXT], high[NUMBER_TEXT];
  enum scallop_status solved = refused ? SCALLOP_EDOMAIN : scallop_steady(&point->crawler, &r);
  const char *why = refused ? refused : solved < 0 ? scallop_status_text(solved) : NULL;
  point_parameters(table, point, refused);
  if (why) {
    point_blank(table, 6);
    table_text(table, "-");
    table_text(table, "-");
    table_text(table, why);
    return why;
  }
  table_number(table, r.froude);
  table_number(table, r.period.v_start);
  table_number(table, r.period.v_mid);
  table_number(table, r.period.displacement);
  table_number(table, r.mean_velocity);
  table_number(table, r.period.multiplier);
  table_text(table, scallop_regime_text(r.period.regime));
  for (int phase = 0; phase < 2; phase++)
    scallop_modes_text(&r.period.modes[phase], modes[phase]);
  snprintf(both, sizeof both, "%s | %s", modes[0], modes[1]);
  table_text(table, both);
  number_text(low, r.v_low, 0);
  number_text(high, r.v_high, 0);
  snprintf(interval, sizeof interval, "interval of steady states: v_start from %s to %s", low, high);
  table_text(table, solved == SCALLOP_INTERVAL ? interval : "ok");
  return NULL;
}

static enum exit_code run(const struct options *options)
{
  if (options->certified && !has_flint(options, "--certified"))
    return EXIT_UNSOLVED;
  return for_each_point(options, none, columns, row);
}

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
      "--certified: the same in ball arithmetic, with --digits D digits (30) that are proven: the last one is right to a\n"
      "unit. The parameters are then exactly the numbers that are written (0.7 is 7/10), and status is certified; what\n"
      "touches a boundary exactly cannot be decided, which status says.",
  .run = run,
};
