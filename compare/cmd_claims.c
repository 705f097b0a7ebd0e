#include <stddef.h>
#include <string.h>

#include "compare/claims.h"
#include "compare/compare.h"

static const char *const accepts[] = { "m1",     "m2",     "F1",     "F2",     "L",     "alpha", "gait",
                                       "errors", "format", "digits", "output", "quiet", NULL };
static const char *const columns[] = { "claim",      "equation", "quantity", "gait",   "claimed_order",
                                       "order",      "order_lo", "order_hi", "points", "verdict",
                                       "conditions", "inside",   "measured", "reason", NULL };

static const char *const error_columns[] = { "claim",      "equation", "quantity", "gait", "claimed_order",
                                             "conditions", "inside",   "h",        "err",  "noise",
                                             "pairwise",   "use",      NULL };

/* Numbers without a coincidence: equal masses would make coefficients vanish that in general do not. */
static const struct scallop_crawler generic = { 1.3, 0.9, 3.7, 1.1, 9.7, 1, 0.7, &scallop_gait_quadratic };

struct ledger {
  struct table table;
  int verdicts[2][4];
  const char *errors; /* names of claims, separated by commas                               */
  int found;          /* rows of such names                                                 */
};

static bool is_listed(const char *list, const char *name)
{
  size_t length = strlen(name);
  if (strcmp(list, "all") == 0)
    return true;
  for (const char *at = strstr(list, name); at; at = strstr(at + 1, name))
    if ((at == list || at[-1] == ',') && (at[length] == ',' || at[length] == '\0'))
      return true;
  return false;
}

static void count_errors(void *context, const struct claim_row *row)
{
  struct ledger *ledger = context;
  ledger->found += is_listed(ledger->errors, row->claim);
}

static void write_errors(void *context, const struct claim_row *row)
{
  struct ledger *ledger = context;
  struct table *t = &ledger->table;
  for (int i = 0; is_listed(ledger->errors, row->claim) && i < row->count; i++) {
    const struct order_point *p = &row->points[i];
    table_text(t, row->claim);
    table_text(t, row->equation);
    table_text(t, row->quantity);
    table_text(t, row->gait);
    table_number(t, row->claimed_order);
    table_text(t, row->conditions);
    table_text(t, row->inside ? "yes" : "no");
    table_number(t, p->h);
    table_number(t, p->err);
    table_rounded(t, p->noise, "%.2g");
    table_rounded(t, p->pairwise, "%.2f");
    table_text(t, order_use_text(p->use));
  }
}

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
  table_rounded(t, row->fit.used, "%.0f");
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

static void fill(struct ledger *ledger, const struct options *o)
{
  const struct scallop_gait *gait = o->has_gait ? o->crawler.gait : NULL;
  table_columns(&ledger->table, o->errors ? error_columns : columns);
  table_begin_rows(&ledger->table);
  claims_of_order(&o->crawler, gait, o->errors ? write_errors : write_row, ledger);
  if (!o->errors)
    claims_in_words(&o->crawler, gait, write_row, ledger);
}

static enum exit_code run(const struct options *options)
{
  struct ledger ledger = { .errors = options->errors };
  const struct scallop_crawler *c = &options->crawler;
  if (!(c->F1 > c->F2) || !(c->alpha > 0.5)) {
    complain("claims",
             "a crawler with F1 > F2 and alpha > 1/2 is wanted (the rows exchange them where they say so): "
             "F1 = %g, F2 = %g, alpha = %g",
             c->F1, c->F2, c->alpha);
    return EXIT_USAGE;
  }
  struct scallop_scaled scaled;
  enum scallop_status status = scallop_scale(c, &scaled);
  if (status != SCALLOP_OK) {
    complain("claims", "%s", scallop_status_text(status));
    return EXIT_UNSOLVED;
  }
  if (options->errors)
    claims_of_order(c, &scallop_gait_quadratic, count_errors, &ledger);
  if (options->errors && ledger.found == 0) {
    complain("claims", "--errors: no claim about an order is called '%s': the first column of the ledger has the names",
             options->errors);
    return EXIT_USAGE;
  }
  if (!table_open(&ledger.table, options))
    return EXIT_FILE;
  table_note(&ledger.table, "scallop " SCALLOP_VERSION);
  table_note(&ledger.table, "command: claims%s%s", options->errors ? " --errors " : "",
             options->errors ? options->errors : "");
  table_note(&ledger.table, "parameters: m1=%.12g m2=%.12g F1=%.12g F2=%.12g L=%.12g alpha=%.12g", c->m1, c->m2, c->F1,
             c->F2, c->L, c->alpha);
  if (options->has_gait)
    table_note(&ledger.table, "gait: %s", c->gait->name);
  fill(&ledger, options);
  if (!table_close(&ledger.table))
    return EXIT_FILE;
  if (!options->quiet && !options->errors)
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
           "have the figure that decides in 'measured'. A summary goes to standard error.\n"
           "--gait restricts the ledger to one gait. --errors CLAIM prints what is behind a row: T (column h), the error,\n"
           "its rounding noise, the pairwise order, and whether the point was used; `scallop order` reads such a table.",
  .defaults = &generic,
  .run = run,
};
