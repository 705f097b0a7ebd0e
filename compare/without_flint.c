/* Stands in for the parts that need FLINT in a build that leaves it out (make WITH_FLINT=0). */
#include "compare/with_flint.h"

bool has_flint(const char *command, const char *what)
{
  complain(command, "%s needs FLINT, which this build leaves out (make WITH_FLINT=0): build with `make`", what);
  return false;
}

const char *certified_phase_row(struct table *table, const struct options *point, const char *refused)
{
  (void)table, (void)point;
  return refused;
}

const char *certified_steady_row(struct table *table, const struct options *point, const char *refused)
{
  (void)table, (void)point;
  return refused;
}

enum exit_code series_derived(const struct options *options)
{
  (void)has_flint("series", options->bound ? "--bound" : "--source derived or limit");
  return EXIT_UNSOLVED;
}

static enum exit_code run(const struct options *options)
{
  (void)options;
  (void)has_flint("claims", "the ledger");
  return EXIT_UNSOLVED;
}

static const char *const accepts[] = { "m1",    "m2",      "F1",     "F2",     "L",      "alpha", "gait", "errors",
                                       "check", "against", "format", "digits", "output", "quiet", NULL };

const struct command command_claims = {
  .name = "claims",
  .summary = "the ledger of the paper's claims (not in this build, which leaves FLINT out)",
  .example = "scallop claims",
  .accepts = accepts,
  .about = "The ledger is decided in exact and ball arithmetic, for which this build lacks FLINT.",
  .run = run,
};
