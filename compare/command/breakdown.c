#include <stddef.h>

#include "compare/breakdown/breakdown.h"
#include "compare/maps/maps.h"
#include "compare/command/commands.h"
#include "compare/points/defaults.h"
#include "compare/answers/flint.h"
#include "compare/summary/summary.h"

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
  const struct flint_part *flint = flint_for("breakdown", "this command");
  if (!flint)
    return EXIT_UNSOLVED;
  if (o->map[0])
    return o->boundaries ? flint->breakdown_boundaries(o) : flint->breakdown_map(o);
  return given_option(arguments, NARROWS) ? flint->breakdown_table(o) : flint->summary_of_breakdown(&o->request);
}

const struct command command_breakdown = {
  .name = "breakdown",
  .summary = "where the expansion stops being valid: how far each series holds, what ends it, and maps",
  .example = "scallop breakdown --F1 10 --only event",
  .options = options_of_breakdown,
  .rules = rules,
  .size = sizeof(struct breakdown_options),
  .initial = &initial,
  .run = run,
};
