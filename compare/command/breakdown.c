#include <stddef.h>

#include "compare/breakdown/breakdown.h"
#include "compare/maps/axis.h"
#include "compare/maps/maps.h"
#include "compare/command/compare.h"
#include "compare/answers/defaults.h"
#include "compare/command/with_flint.h"

static const char *const accepts[] = { "m1", "m2",     "F1",         "F2",       "L",      "alpha",  "gait",  "phase",
                                       "v0", "source", "order",      "quantity", "tol",    "only",   "map",   "x",
                                       "y",  "T",      "boundaries", "format",   "digits", "output", "quiet", NULL };

/* An option that has no use where a map is drawn, or where none is; NULL if there is none. */
static const char *useless(const struct options *o)
{
  if (o->map[0])
    return o->only ? "only" : o->point.has_phase ? "phase" : o->point.has_v0 ? "v0" : NULL;
  return o->range[0] ? "x" : o->range[1] ? "y" : o->boundaries ? "boundaries" : o->point.written[5] ? "T" : NULL;
}

static enum exit_code run(const struct options *options)
{
  const char *idle = useless(options);
  if (idle) {
    complain("breakdown", "--%s has nothing to do %s --map", idle, options->map[0] ? "with" : "without");
    return EXIT_USAGE;
  }
  if (!has_flint(options, "this command"))
    return EXIT_UNSOLVED;
  return !options->map[0]      ? with_flint.breakdown(options)
         : options->boundaries ? with_flint.boundaries(options)
                               : with_flint.map(options);
}

static const struct unless_given unless_given[] = {
  { "T", "with --map %s" },
  { "phase", "with --v0 %s, else the steady state" },
  { "v0", "with --phase %s" },
  { "source only", "all" },
  { "quantity", "all; with --map displacement" },
  { "tol", TEXT_OF(BREAKDOWN_TOLERANCES) "; with --map " TEXT_OF(BREAKDOWN_MAP_TOLERANCES) },
  { "x y", AXIS_RANGE "; of alpha " AXIS_ALPHA_RANGE },
  { NULL, NULL },
};

const struct command command_breakdown = {
  .name = "breakdown",
  .summary = "where the expansion stops being valid: how far each series holds, what ends it, and maps",
  .example = "scallop breakdown --F1 10 --only event",
  .accepts = accepts,
  .about =
      "Of the steady state, T being the period; with --phase or --v0 of one phase from that velocity, T its duration.\n"
      "Four kinds of rows (column what):\n"
      "  event   where the sequence of modes changes as T grows, or a body turns in another piece of l': T, note (what\n"
      "          happens), modes (from there on). The first row is the limit T -> 0, with the T up to which its modes\n"
      "          are proven. Above the first event the series is still computed, but is not about the motion any more.\n"
      "  reach   T: the largest up to which |series/exact - 1| stays below tolerance, for the paper's formulas\n"
      "          (series: their names), the derived terms below T^order and the limit. inf: the error stays below the\n"
      "          tolerance at every T; 0: as T -> 0 the error tends to a limit (in note) not below the tolerance.\n"
      "          Where the exact value passes 0 no series reaches further. error: at that T.\n"
      "  radius  T: the radius of convergence of the derived series. series: poles (of the rational function that it is),\n"
      "          singularity (the branch point nearest to T = 0, which may be complex), or bound (the series converges\n"
      "          at least below this T). note: the place, and what is proven; error: how far the radius may be off.\n"
      "  best    the order of truncation, up to 96, with the least error at this T, and that error.\n"
      "froude: the Froude number at T. status: certified (event: the modes at T (1 -+ 2^-40) are proven; reach: the error\n"
      "at T (1 -+ 2^-50) is proven to be on either side of the tolerance; radius: the note is proven), binary128, double\n"
      "(where no mode shows it), exact, derived. The parameters are exactly the doubles that are read.\n"
      "\n"
      "--map X Y: a grid over two of F1/F2 (or F1_over_F2; F2 stays), m1/m2 (or m1_over_m2; m2 stays), alpha, T, froude\n"
      "(--x, --y FROM:TO:N, with :log or :linear). One row for each point, x running fastest: the crawler, its steady\n"
      "state, and for each series the relative error at this T and the T it reaches to for 1e-2 and 1e-6. With -o FILE the\n"
      "rows done are kept in FILE.rows; if the run is interrupted, the same command goes on from there.\n"
      "--boundaries: the curves between regions with the same modes instead, each point to 1e-12 of the axis (its\n"
      "logarithm, if it is a log axis), followed from where the grid of the map shows them; the regions on both sides, "
      "what\n"
      "changes, and at a junction which third region meets. Columns: curve, point along it, the two axes, region_1 (on the\n"
      "left), region_2, what, end (of the first and last point: open, closed, junction), meets, status.",
  .unless_given = unless_given,
  .run = run,
};
