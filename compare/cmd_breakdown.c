#include <stddef.h>

#include "compare/compare.h"
#include "compare/with_flint.h"

static const char *const accepts[] = { "m1", "m2",     "F1",         "F2",       "L",      "alpha", "gait", "phase",
                                       "v0", "source", "order",      "quantity", "tol",    "only",  "map",  "x",
                                       "y",  "T",      "boundaries", "format",   "output", "quiet", NULL };

/* An option that has no use where a map is drawn, or where none is; NULL if there is none. */
static const char *useless(const struct options *o)
{
  if (o->map[0])
    return o->only ? "only" : o->has_phase ? "phase" : o->has_v0 ? "v0" : NULL;
  return o->range[0] ? "x" : o->range[1] ? "y" : o->boundaries ? "boundaries" : o->written[5] ? "T" : NULL;
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
  return !options->map[0]      ? breakdown_table(options)
         : options->boundaries ? breakdown_boundaries(options)
                               : breakdown_map(options);
}

const struct command command_breakdown = {
  .name = "breakdown",
  .summary = "where the expansion stops being valid: how far each series holds, what ends it, and maps",
  .example = "scallop breakdown --F1 10 --only event",
  .accepts = accepts,
  .about =
      "Of the steady state, T being the period; with --phase or --v0 of one phase from that velocity, T being its "
      "duration.\n"
      "Four kinds of rows (column what):\n"
      "  event   where the sequence of modes changes as T grows, or a body turns in another piece of l': T, note (what\n"
      "          happens), modes (from there on). The first row is the limit T -> 0, with the T up to which its modes are\n"
      "          proven. Above the first event the series is still computed, but is not about the motion any more.\n"
      "  reach   T: the largest up to which |series/exact - 1| stays below tolerance, for the paper's formulas (series: "
      "their\n"
      "          names), for the derived terms below T^order and for the limit; 0: for no T, inf: for every one. error: at\n"
      "          that T. The exact value passes 0: it reaches to there at most.\n"
      "  radius  T: the radius of convergence of the derived series, from the poles of the rational function that it is, "
      "or\n"
      "          estimated from its coefficients (series: poles, ratio, three-term, root); error: half of the interval "
      "that\n"
      "          holds it (poles), or by which estimates from fewer terms differ.\n"
      "  best    at this T the order of truncation, up to 96, with the least error: that order, and the error.\n"
      "froude: the Froude number at T. status: certified (events: the modes at 1 -+ 2^-47 of T are proven; reach: the "
      "error\n"
      "at 1 -+ 2^-50 of T is proven to be on either side of the tolerance), binary128, double (modes do not show it), "
      "exact,\n"
      "estimate, derived. The parameters are exactly the doubles that are read.\n\n"
      "--map X Y: the same quantities over a plane of two of F1/F2 (F2 stays), m1/m2 (m2 stays), alpha, T and froude. With\n"
      "--boundaries the curves between its regions.",
  .run = run,
};
