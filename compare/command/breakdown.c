#include <stddef.h>

#include "compare/breakdown/breakdown.h"
#include "compare/maps/maps.h"
#include "compare/command/commands.h"
#include "compare/points/defaults.h"
#include "compare/command/with_flint.h"
#include "compare/summary/summary.h"

#pragma weak breakdown_table
#pragma weak breakdown_map
#pragma weak breakdown_boundaries
#pragma weak summary_of_breakdown

#define RANGES AXIS_RANGE "; of alpha " AXIS_ALPHA_RANGE
static const char *const sources[] = { "book", "published", "derived", "limit", NULL };
static const char *const quantities[] = { "v_start", "v_mid", "displacement", "mean_velocity", "t1", "dT",
                                          "v_end",   "dx1",   "dx2",          "dxC",           NULL };
static const char *const kinds[] = { "event", "reversal", "reach", "radius", "best", NULL };
static const struct option options_of_breakdown[] = {
  OPTIONS_TO_L(NULL),
  OPTIONS_ALPHA_GAIT(NULL, NULL),
  OPTION_PHASE("with --v0 %s, else the steady state"),
  OPTION_V0("with --phase %s"),
  OPTION_WORD("source", "SOURCE", "these series only: book, published, derived or limit", "all", breakdown_options,
              source, sources),
  OPTION_BOOK("the formulas of this book too: series are called by their names"),
  OPTION_COUNT("order", "N", "derive all terms below T^N, N from 1 to 1000", NULL, breakdown_options, order, 1, 1000),
  OPTION_WORD("quantity", "NAME", "this quantity only", "all; with --map displacement", breakdown_options, quantity,
              quantities),
  OPTION_NUMBER("tol", "D", "for this relative error only",
                TEXT_OF(BREAKDOWN_TOLERANCES) "; with --map " TEXT_OF(BREAKDOWN_MAP_TOLERANCES), breakdown_options,
                tolerance, FROM_TO(1e-20, DBL_MAX, "a number from 1e-20 on")), /* errors are known to some 1e-32 */
  OPTION_FLAG("all", "a table of all that is known, instead of a page about events and reach", breakdown_options, all),
  OPTION_WORD("only", "WHAT", "rows of this kind only: event, reversal, reach, radius or best", "all",
              breakdown_options, only, kinds),
  OPTION_TEXT("map", "X Y", "a map over two of F1/F2, m1/m2, alpha, T and froude", NULL, breakdown_options, map,
              "the name of what varies"),
  OPTION_TEXT("x", "FROM:TO:N", "N values of X, with :log or :linear for how they are spaced", RANGES,
              breakdown_options, range[0], "FROM:TO:COUNT"),
  OPTION_TEXT("y", "FROM:TO:N", "N values of Y", RANGES, breakdown_options, range[1], "FROM:TO:COUNT"),
  OPTION_T("with --map %s"),
  OPTION_FLAG("boundaries", "with --map: the boundaries between its regions instead", breakdown_options, boundaries),
  OPTIONS_PLOT,
  OPTIONS_OF_DOUBLES,
};
#define NARROWS "all only quantity source order tol phase v0 format columns plot"
static const struct option_rule rules[] = {
  { "all only phase v0", RULE_WITH, "map", NULL },
  { "x y boundaries T", RULE_WITHOUT, "map", NULL },
  { "source order quantity tol book", RULE_WITH, "boundaries", NULL },
  { "quantity=v_start quantity=v_mid quantity=displacement quantity=mean_velocity", RULE_WITH, "phase v0",
    "is of the steady state: a phase has t1, dT, v_end, dx1, dx2 and dxC" },
  { "quantity=t1 quantity=dT quantity=v_end quantity=dx1 quantity=dx2 quantity=dxC", RULE_WITHOUT, "phase v0",
    "is of a phase: it needs --phase or --v0" },
  { "order", RULE_WITH, "source=book source=published source=limit",
    "needs the derived series: leave --source out, or --source derived" },
  { "tol book", RULE_WITH, "only=event only=reversal only=radius only=best", "needs the rows of --only reach" },
  { "quantity source order", RULE_WITH, "only=event only=reversal", "needs rows about series: leave --only out" },
  { "order source=book source=published source=limit", RULE_WITH, "only=radius only=best",
    "needs the rows of --only reach" },
  { "book", RULE_WITH, "source=published source=derived source=limit",
    "needs its own series: leave --source out, or --source book" },
  { "source=book", RULE_WITHOUT, "book", "book needs --book FILE" },
  { NULL, RULE_WITH, NULL, NULL }
};
static const struct breakdown_options initial = { .source = { "published", false },
                                                  .quantity = { "displacement", false },
                                                  .order = { 8, false },
                                                  .tolerance = { 0.1, false } };

static enum exit_code run(const struct arguments *arguments, const void *options)
{
  const struct breakdown_options *o = options;
  if (!has_flint(arguments, "this command"))
    return EXIT_UNSOLVED;
  if (o->map[0])
    return o->boundaries ? breakdown_boundaries(o) : breakdown_map(o);
  return given_option(arguments, NARROWS) ? breakdown_table(o) : summary_of_breakdown(&o->request);
}

const struct command command_breakdown = {
  .name = "breakdown",
  .summary = "where the expansion stops being valid: how far each series holds, what ends it, and maps",
  .example = "scallop breakdown --F1 10 --only event",
  .options = options_of_breakdown,
  .rules = rules,
  .size = sizeof(struct breakdown_options),
  .initial = &initial,
  .about = "Of the steady state, T being the period; with --phase or --v0 of one phase from that velocity, T its\n"
           "duration. Without options other than the crawler's: a page of at most 25 lines, of the events and of\n"
           "the T up to which each formula, and the terms below T^8, are off by less than 1 % and 5 %. With\n"
           "--all, or where something is asked for (--only, --quantity, --source, --tol, --order, --phase, --v0,\n"
           "--format, --columns or --plot): a table of five kinds of rows (column what):\n"
           "  event   where the sequence of modes changes as T grows, or a body turns in another piece of l': T,\n"
           "          note (what happens), modes (from there on). The first row is the limit T -> 0, with the T\n"
           "          up to which its modes are proven. Above the first event the series is still computed, but\n"
           "          is not about the motion any more.\n"
           "  reversal  T: where the displacement changes its sign, so that the crawler turns back\n"
           "  reach   T: the largest up to which |series/exact - 1| stays below tolerance, for the paper's\n"
           "          formulas (series: their names), the derived terms below T^order and the limit. inf: the\n"
           "          error stays below the tolerance at every T; 0: as T -> 0 the error tends to a limit (in\n"
           "          note) not below the tolerance. Where the exact value passes 0 no series reaches further.\n"
           "          error: at that T.\n"
           "  radius  T: the radius of convergence of the derived series. series: poles (of the rational\n"
           "          function that it is), singularity (the branch point nearest to T = 0, which may be\n"
           "          complex), or bound (the series converges at least below this T). note: the place, and what\n"
           "          is proven; error: how far the radius may be off.\n"
           "  best    the order of truncation, up to 96, with the least error at this T, and that error.\n"
           "froude: the Froude number at T. status: certified (event: the modes at T (1 -+ 2^-40) are proven;\n"
           "reach: the error at T (1 -+ 2^-50) is proven to be on either side of the tolerance; radius: the note\n"
           "is proven), binary128, double (where no mode shows it), exact, derived. The parameters are exactly\n"
           "the doubles that are read.\n"
           "\n"
           "--map X Y: a grid over two of F1/F2 (or F1_over_F2; F2 stays), m1/m2 (or m1_over_m2; m2 stays),\n"
           "alpha, T, froude (--x, --y FROM:TO:N, with :log or :linear). One row for each point, x running\n"
           "fastest: the crawler, its steady state, and for each series (the formulas of the book by their\n"
           "names, the paper's (27) or (28), the derived one, the limit) the relative error at this T and the T\n"
           "it reaches to for 1e-2 and 1e-6. With --plot-y and without --columns the table has of the series only\n"
           "what is drawn. What no column needs is not computed: --columns F1/F2,alpha,modes,regime takes\n"
           "milliseconds. --boundaries: the parts of the boundaries between regions with the same modes that lie\n"
           "within the cells of the grid, cell by cell: from a place on an edge of the cell to another (columns\n"
           "to_X, to_Y), each found to 1e-12 of the axis (its logarithm, if it is a log axis). Columns: the two\n"
           "axes, to_X, to_Y, region_1 (on the left), region_2, what (happens from region_1 to region_2), status.\n"
           "Where boundaries meet in a cell, quarters of quarters of it are looked at, to a 32nd of the cell.",
  .run = run,
};
