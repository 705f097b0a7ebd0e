#include <math.h>

#include "compare/answers/counts.h"
#include "compare/answers/points.h"
#include "compare/answers/defaults.h"
#include "compare/command/with_flint.h"
#include "numerics/wide.h"

static const char *const accepts[] = { "m1", "m2",        "F1",    "F2",     "L",      "T",      "alpha",  "gait",  "phase",
                                       "v0", "certified", "error", "points", "format", "digits", "output", "quiet", NULL };
static const char *const extra[] = { "phase", "v0", NULL };
static const char *const columns[] = { "t1", "dT", "v_end", "dx1", "dx2", "dxC", "regime", "modes", "status", NULL };

static const char *const error_columns[] = { "t1",       "dT",       "v_end",       "dx1",       "dx2",       "dxC",
                                             "t1_error", "dT_error", "v_end_error", "dx1_error", "dx2_error", "dxC_error",
                                             "regime",   "modes",    "status",      NULL };

/* of an estimate, with three digits */
static const double rounded_up = 1.005;

/* Gaits of this command have exact laws: the only failure is that of the solve itself. */
static void write_errors(struct table *table, const struct options *point, const struct scallop_phase_result *r)
{
  struct scallop_phase_error e = { NAN, NAN, NAN, NAN, NAN, NAN };
  scallop_phase_error(&point->point.crawler, point->point.phase, point->point.v0, r, &e);
  const double errors[] = { e.t1, e.dT, e.v_end, e.dx1, e.dx2, e.dxC };
  for (int i = 0; i < 6; i++)
    table_rounded(table, rounded_up * errors[i], "%.3g");
}

static const char *row(struct table *table, const struct options *point, const char *refused)
{
  if (point->certified && !refused)
    return with_flint.phase_row(table, point);
  struct scallop_phase_result r;
  char modes[SCALLOP_MODES_TEXT];
  enum scallop_status solved = refused ? SCALLOP_EDOMAIN
                                       : counted_phase(&point->point.crawler, point->point.phase, point->point.v0, &r);
  const char *why = refused ? refused : solved < 0 ? scallop_status_text(solved) : NULL;
  point_parameters(table, point, refused);
  table_text(table, refused ? "-" : point->point.phase == SCALLOP_EXTENSION ? "extension" : "contraction");
  table_number(table, refused ? NAN : point->point.v0);
  if (why) {
    point_blank(table, point->error ? 12 : 6);
    table_text(table, "-");
    table_text(table, "-");
    table_text(table, why);
    return why;
  }
  const double numbers[] = { r.t1, r.dT, r.v_end, r.dx1, r.dx2, r.dxC };
  for (int i = 0; i < 6; i++)
    table_number(table, numbers[i]);
  if (point->error)
    write_errors(table, point, &r);
  table_text(table, scallop_regime_text(r.regime));
  scallop_modes_text(&r.modes, modes);
  table_text(table, modes);
  table_text(table, "ok");
  return NULL;
}

static enum exit_code run(const struct options *options)
{
  if (options->certified && options->error) {
    complain("phase", "--error has nothing to do with --certified: every digit is proven");
    return EXIT_USAGE;
  }
  if (options->certified && !has_flint(options, "--certified"))
    return EXIT_UNSOLVED;
  return for_each_point(options, extra, options->error ? error_columns : columns, row);
}

static const struct unless_given unless_given[] = {
  { "digits", "%s; with --certified " TEXT_OF(CERTIFIED_DIGITS) },
  { NULL, NULL },
};

const struct command command_phase = {
  .name = "phase",
  .summary = "one extension or contraction phase from a start velocity, exactly",
  .example = "scallop phase --phase extension --v0 2.5",
  .accepts = accepts,
  .about =
      "T is the period: the phase lasts alpha T (extension) or (1 - alpha) T (contraction).\n"
      "Columns: the parameters, phase and v0; t1, the first change of mode after the start; dT, from the last\n"
      "change of mode to the end of the phase (nan: the mode does not change); v_end, the velocity of both bodies\n"
      "at the end; dx1 dx2 dxC, displacements of body 1, body 2 and the geometric centre (x1 + x2)/2; regime;\n"
      "modes: directions of body 1 and body 2 in turn, 0 stuck; status: ok, or why there is no answer.\n"
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
