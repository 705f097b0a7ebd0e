/* Options of `scallop claims`. */
#include <stddef.h>

#include "compare/command/commands.h"
#include "compare/claims/claims.h"
#include "compare/points/gaits.h"
#include "compare/answers/flint.h"

static const char *const verdicts[] = { "holds", "sharper", "refuted", "undecided", NULL };
static const struct option options_of_claims[] = {
  OPTIONS_CRAWLER,
  OPTION_TEXT("errors", claims_options, errors, "names of claims, separated by commas, or all"),
  OPTION_WORD("verdict", claims_options, verdict, verdicts),
  OPTION_FLAG("summary", claims_options, summary),
  OPTION_FORMULAS,
  OPTION_TEXT("formula", claims_options, formula, "a formula"),
  OPTION_WORD("of", claims_options, of, formula_quantities),
  OPTION_TEXT("claimed", claims_options, claimed, "a power of T, or equality"),
  OPTION_WORD("start", claims_options, start, formula_starts),
  OPTION_WORD("phase", claims_options, phase, phase_names),
  OPTIONS_OF_DOUBLES,
};
static const struct option_rule rules[] = {
  { "verdict", RULE_WITH, "errors", "is for the table of claims itself: leave --errors out" },
  { "summary", RULE_WITH, "errors verdict formulas formula", "sums up the whole table: leave the other option out" },
  { "formulas", RULE_WITH, "formula", "and --formula exclude each other" },
  { "T", RULE_WITHOUT, "formulas formula",
    "is of no claim: it is for --formula and --formulas, which print errors at T" },
  { "T", RULE_WITH, "errors", "is none of the T of --errors" },
  { "of claimed start phase", RULE_WITHOUT, "formula", NULL },
  { "formula", RULE_WITHOUT, "of", "takes --of QUANTITY: what the formula gives" },
  { "formula", RULE_WITHOUT, "claimed", "takes --claimed N: the power of T in the claim + O(T^N)" },
  { NULL, RULE_WITH, NULL, NULL },
};
/* Default crawler with arbitrary numbers: with equal masses, coefficients vanish that in general do not. */
static const struct scallop_crawler generic = { 1.3, 0.9, 3.7, 1.1, 9.7, 1, 0.7, &scallop_gait_quadratic };

/* Decides the claims of a formula file, or of --formula. */
static enum exit_code prove(const struct claims_options *o)
{
  const struct formula_option given = { o->formula, o->of.value, o->start.value, o->phase.value, o->claimed };
  const struct flint_part *flint = load_flint("claims", "the proof");
  if (!flint)
    return EXIT_UNSOLVED;
  enum exit_code code = o->formula ? user_formula_add("claims", &given) : EXIT_DONE;
  return code == EXIT_DONE ? flint->claims_table(o) : code;
}

static enum exit_code run(const struct arguments *arguments, const void *options)
{
  const struct claims_options *o = options;
  (void)arguments;
  const struct scallop_crawler *c = &o->request.point.crawler;
  if (o->formula || o->request.formulas)
    return prove(o);
  if (!(c->F1 > c->F2) || !(c->alpha > 0.5)) {
    complain("claims",
             "the crawler must have F1 > F2 and alpha > 1/2 (rows with other conditions exchange them): "
             "F1 = %.17g, F2 = %.17g, alpha = %.17g",
             c->F1, c->F2, c->alpha);
    return EXIT_USAGE;
  }
  if (!gait_has_ends(c->gait)) {
    complain("claims", "l'' = 0 where a phase of this gait begins or ends, and the paper's formulas divide by it: "
                       "there are no claims to decide");
    return EXIT_UNSOLVED;
  }
  struct scallop_scaled scaled;
  enum scallop_status status = scallop_scale(c, &scaled);
  if (status != SCALLOP_OK) {
    complain("claims", "%s", scallop_status_text(status));
    return EXIT_UNSOLVED;
  }
  const struct flint_part *flint = load_flint("claims", "the table of claims");
  return flint ? flint->claims_table(o) : EXIT_UNSOLVED;
}

/* Prints the few rows of --formula upright, to read one by one. */
static const char *complete(void *options)
{
  struct claims_options *o = options;
  o->request.style.upright = o->formula != NULL;
  return NULL;
}

const struct command command_claims = {
  .name = "claims",
  .options = options_of_claims,
  .rules = rules,
  .size = sizeof(struct claims_options),
  .defaults = &generic,
  .complete = complete,
  .run = run,
};
