#include <math.h>
#include <stddef.h>

#include "compare/claims.h"
#include "compare/compare.h"

static const char *const accepts[] = { "m1", "m2", "F1", "F2", "L", "alpha", "format", "digits", "output", "quiet", NULL };
static const char *const columns[] = { "claim",      "equation", "quantity", "gait",   "claimed_order",
                                       "order",      "order_lo", "order_hi", "points", "verdict",
                                       "conditions", "inside",   "measured", "reason", NULL };

/* Numbers without a coincidence: equal masses would make coefficients vanish that in general do not. */
static const struct scallop_crawler generic = { 1.3, 0.9, 3.7, 1.1, 9.7, 1, 0.7, &scallop_gait_quadratic };

struct ledger {
  struct table table;
  int verdicts[2][4];
};

static void write_row(void *context, const struct claim_row *row)
{
  struct ledger *ledger = context;
  struct table *t = &ledger->table;
  table_text(t, row->claim);
  table_text(t, row->equation);
  table_text(t, row->quantity);
  table_text(t, row->gait);
  table_number(t, row->claimed_order);
  table_rounded(t, row->fit.order, "%.2f");
  table_rounded(t, row->fit.lo, "%.2f");
  table_rounded(t, row->fit.hi, "%.2f");
  table_number(t, row->fit.used);
  table_text(t, claim_verdict_text(row->verdict));
  table_text(t, row->conditions);
  table_text(t, row->inside ? "yes" : "no");
  table_text(t, *row->measured ? row->measured : "-");
  table_text(t, *row->reason ? row->reason : "-");
  ledger->verdicts[row->inside][row->verdict]++;
}

static void summarise(const struct ledger *ledger)
{
  for (int inside = 1; inside >= 0; inside--) {
    const int *v = ledger->verdicts[inside];
    fprintf(stderr, "%s the paper's conditions: %d hold, %d are sharper than claimed, %d refuted, %d undecided\n",
            inside ? "inside " : "outside", v[CLAIM_HOLDS], v[CLAIM_SHARPER], v[CLAIM_REFUTED], v[CLAIM_UNDECIDED]);
  }
}

static enum exit_code run(const struct options *options)
{
  struct ledger ledger = { .verdicts = { { 0 } } };
  const struct scallop_crawler *c = &options->crawler;
  if (!(c->F1 > c->F2) || !(c->alpha > 0.5)) {
    complain("claims",
             "a crawler with F1 > F2 and alpha > 1/2 is wanted (the rows exchange them where they say so): "
             "F1 = %g, F2 = %g, alpha = %g",
             c->F1, c->F2, c->alpha);
    return EXIT_USAGE;
  }
  if (!table_open(&ledger.table, options))
    return EXIT_FILE;
  table_note(&ledger.table, "scallop " SCALLOP_VERSION);
  table_note(&ledger.table, "command: claims");
  table_note(&ledger.table, "parameters: m1=%.12g m2=%.12g F1=%.12g F2=%.12g L=%.12g alpha=%.12g", c->m1, c->m2, c->F1,
             c->F2, c->L, c->alpha);
  table_columns(&ledger.table, columns);
  table_begin_rows(&ledger.table);
  claims_of_order(c, write_row, &ledger);
  claims_in_words(c, write_row, &ledger);
  if (!table_close(&ledger.table))
    return EXIT_FILE;
  if (!options->quiet)
    summarise(&ledger);
  return EXIT_DONE;
}

const struct command command_claims = {
  .name = "claims",
  .summary = "the ledger: every asymptotic and qualitative claim of the paper, measured, with a verdict",
  .example = "scallop claims --format json",
  .accepts = accepts,
  .about = "One row for each statement '... + O(T^n)', gait and set of conditions: the order that the error of the\n"
           "published formula is measured to have against the exact motion as T falls, with its 95 % interval and the\n"
           "number of points behind it. Points where rounding could be seen are never used.\n"
           "verdict: holds; sharper (the error falls faster than claimed); refuted (slower, or not at all); undecided,\n"
           "with the reason. conditions: what was assumed; inside: whether the paper assumes it too. Claims in words\n"
           "have the figure that decides in 'measured'. A summary goes to standard error.",
  .defaults = &generic,
  .run = run,
};
