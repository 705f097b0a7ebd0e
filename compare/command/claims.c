#include <stddef.h>

#include "compare/command/commands.h"
#include "compare/claims/claims.h"
#include "compare/points/gaits.h"
#include "compare/command/with_flint.h"

#pragma weak claims_table

static const char *const verdicts[] = { "holds", "sharper", "refuted", "undecided", NULL };
static const struct option options_of_claims[] = {
  OPTIONS_TO_L(NULL),
  OPTIONS_ALPHA_GAIT(NULL, "both of the paper: quadratic and sinusoidal"),
  OPTION_TEXT("errors", "CLAIM",
              "print the errors behind a claim instead: names or equations, \"(28)\", separated by commas, or all",
              NULL, claims_options, errors, "names of claims, separated by commas, or all"),
  OPTION_WORD("verdict", "VERDICT", "rows with this verdict only: holds, sharper, refuted or undecided", "all",
              claims_options, verdict, verdicts),
  OPTION_FLAG("summary",
              "one row for each claim of the paper: does it hold in every check under the paper's conditions?",
              claims_options, summary),
  OPTION_BOOK("decide the formulas of this book instead of the paper's: exit code 1 if one is refuted"),
  OPTION_TEXT("formula", "TEXT", "decide this formula instead: \"(F1 - F2)/M*T\"", NULL, claims_options, formula,
              "a formula"),
  OPTION_WORD("of", "QUANTITY",
              "what the formula gives: dxC, dT, v_end, displacement, v_start or another of docs/formulas.md",
              "--formula needs one", claims_options, of, book_quantities),
  OPTION_TEXT("claimed", "N", "its claim + O(T^N), or equality", "--formula needs one", claims_options, claimed,
              "a power of T, or equality"),
  OPTION_WORD("start", "START", "where its motion starts: rest, v0 or steady",
              "steady for quantities of the steady state, else rest", claims_options, start, book_starts),
  OPTION_WORD("phase", "PHASE", "of its motion from v0: extension, where none is given, or contraction", NULL,
              claims_options, phase, book_phases),
  OPTIONS_OF_DOUBLES,
};
static const struct option_rule rules[] = {
  { "verdict", RULE_WITH, "errors", "is for the ledger itself: leave --errors out" },
  { "summary", RULE_WITH, "errors verdict book formula", "sums up the whole ledger: leave the other option out" },
  { "book", RULE_WITH, "formula", "and --formula exclude each other" },
  { "of claimed start phase", RULE_WITHOUT, "formula", NULL },
  { "formula", RULE_WITHOUT, "of", "takes --of QUANTITY: what the formula gives" },
  { "formula", RULE_WITHOUT, "claimed", "takes --claimed N: the power of T in the claim + O(T^N)" },
  { NULL, RULE_WITH, NULL, NULL },
};
/* Numbers without a coincidence: equal masses would make coefficients vanish that in general do not. */
static const struct scallop_crawler generic = { 1.3, 0.9, 3.7, 1.1, 9.7, 1, 0.7, &scallop_gait_quadratic };

/* The claims of a book, or of --formula */
static enum exit_code prove(const struct arguments *arguments, const struct claims_options *o)
{
  const struct formula_given given = { o->formula, o->of.value, o->start.value, o->phase.value, o->claimed };
  if (!has_flint(arguments, "the proof"))
    return EXIT_UNSOLVED;
  enum exit_code code = o->formula ? book_add("claims", &given) : EXIT_DONE;
  return code == EXIT_DONE ? claims_table(o) : code;
}

static enum exit_code run(const struct arguments *arguments, const void *options)
{
  const struct claims_options *o = options;
  const struct scallop_crawler *c = &o->request.point.crawler;
  if (o->formula || o->request.book)
    return prove(arguments, o);
  if (!(c->F1 > c->F2) || !(c->alpha > 0.5)) {
    complain("claims",
             "a crawler with F1 > F2 and alpha > 1/2 is wanted (the rows exchange them where they say so): "
             "F1 = %.17g, F2 = %.17g, alpha = %.17g",
             c->F1, c->F2, c->alpha);
    return EXIT_USAGE;
  }
  if (!gait_has_ends(c->gait)) {
    complain(
        "claims",
        "l'' = 0 where a phase of this gait begins or ends, and the paper's formulas divide by it: there is no ledger");
    return EXIT_UNSOLVED;
  }
  struct scallop_scaled scaled;
  enum scallop_status status = scallop_scale(c, &scaled);
  if (status != SCALLOP_OK) {
    complain("claims", "%s", scallop_status_text(status));
    return EXIT_UNSOLVED;
  }
  return has_flint(arguments, "the ledger") ? claims_table(o) : EXIT_UNSOLVED;
}

const struct command command_claims = {
  .name = "claims",
  .summary = "the ledger: the paper's formulas and statements, with verdicts",
  .example = "scallop claims --format json",
  .options = options_of_claims,
  .rules = rules,
  .size = sizeof(struct claims_options),
  .about = "One row for each statement '... + O(T^n)', gait and set of conditions. derived_order is the first\n"
           "power of T that the formula leaves out of the derived expansion, coefficient what stands there\n"
           "(exact, or a ball that does not hold 0). 'none': no coefficient that was looked at differs from 0.\n"
           "order is fitted to certified errors at 12 T, down to below 1e-20. Where these errors are not the\n"
           "sum of what is left out, the exit code is 3.\n"
           "evidence: how the verdict is known. Proven for all parameters: for every crawler with the modes\n"
           "that this one has as T -> 0, by coefficients in names, or in docs/theory.md. Certified for the\n"
           "crawler named: by exact numbers or balls, for this crawler alone. Sampled: that many crawlers of\n"
           "Sobol's sequence, or values in 'conditions'; no seed. Measured in doubles: by a scan or a fit.\n"
           "verdict: holds; sharper (the error falls faster than claimed); refuted (slower, or not at all);\n"
           "undecided, with the reason. corrected: the row of the formula that holds where this one does not\n"
           "(source 'corrected'; ':mirrored' is a formula with the bodies exchanged and seen in a mirror,\n"
           "':contraction' with the bodies exchanged). conditions: what was assumed; inside: whether the paper\n"
           "assumes it too. Claims in words have the figure that decides in 'measured'. claimed_order inf: the\n"
           "formula is printed as an equality. --gait: the ledger for one gait, which need not be one of the\n"
           "paper's two; with others the rows that 'corrected' names may not hold, either: see their verdicts.\n"
           "What the paper says and no row decides is listed in docs/errata.md.\n"
           "--summary: one row for each claim of the paper: its verdict over all checks under the paper's\n"
           "conditions, how many of them failed, the first condition under which it fails, and the evidence:\n"
           "of a claim that holds, the weakest of its checks; else that of the check named. Two lines on\n"
           "standard error count the claims.\n"
           "--errors CLAIM: what is behind a row: T (column h), the error, the pairwise order, and whether the\n"
           "fit used it; `scallop order` reads such a table.\n"
           "--book, --formula: the same table for formulas of your own (source 'book'), one row for each formula\n"
           "with a claim and gait; docs/formulas.md describes both. A crawler that is not given is one for which\n"
           "the conditions of the formula hold; 'measured' has the numbers that were changed for that. inside:\n"
           "whether the conditions hold for a given crawler. Exit code 1 if a formula is refuted where its\n"
           "conditions hold, else 3 if one is undecided, or its conditions do not hold. leading_error: the term\n"
           "that coefficient belongs to, as a formula, or '-' where it is not known as one. A formula that holds\n"
           "for one crawler by coincidence is refuted, unless that crawler was given.",
  .defaults = &generic,
  .run = run,
};
