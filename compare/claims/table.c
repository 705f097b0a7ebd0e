/* The ledger as a table, and its verdicts against those of a ledger that was written before. */
#include <string.h>

#include "compare/claims/claims.h"
#include "compare/claims/read.h"
#include "compare/command/compare.h"
#include "compare/answers/rational.h"
#include "compare/command/with_flint.h"

static const char *const columns[] = { "claim",         "equation",    "quantity",  "gait",       "claimed_order",
                                       "order",         "order_lo",    "order_hi",  "points",     "verdict",
                                       "derived_order", "coefficient", "corrected", "conditions", "inside",
                                       "source",        "measured",    "reason",    NULL };

static const char *const error_columns[] = { "claim",  "equation", "quantity", "gait",     "claimed_order", "conditions",
                                             "inside", "h",        "err",      "pairwise", "use",           NULL };

static void write_errors(struct table *t, const struct claim_row *row)
{
  for (int i = 0; i < row->count; i++) {
    const struct order_point *p = &row->points[i];
    table_text(t, row->claim);
    table_text(t, row->equation);
    table_text(t, row->quantity);
    table_text(t, row->gait);
    table_number(t, row->claimed_order);
    table_text(t, row->conditions);
    table_text(t, row->inside ? "yes" : "no");
    table_number(t, p->h);
    table_number(t, row->exact ? 0 : p->err); /* proven: what is left of err is rounding */
    table_rounded(t, p->pairwise, "%.2f");
    table_text(t, order_use_text(row->exact ? ORDER_ZERO : p->use));
  }
}

/* "none": every coefficient that was looked at vanishes */
static const char *derived_text(const struct claim_row *row)
{
  static char text[24];
  snprintf(text, sizeof text, "%ld", row->derived_order);
  return !row->proven ? "-" : row->exact ? "none" : text;
}

static void write_row(struct table *t, const struct claim_row *row)
{
  table_text(t, row->claim);
  table_text(t, row->equation);
  table_text(t, row->quantity);
  table_text(t, row->gait);
  table_number(t, row->claimed_order);
  table_rounded(t, row->fit.order, "%.6f");
  table_rounded(t, row->fit.lo, "%.6f");
  table_rounded(t, row->fit.hi, "%.6f");
  table_rounded(t, row->fit.used, "%.0f");
  table_text(t, claim_verdict_text(row->verdict));
  table_text(t, derived_text(row));
  table_text(t, *row->coefficient ? row->coefficient : "-");
  table_text(t, *row->corrected ? row->corrected : "-");
  table_text(t, row->conditions);
  table_text(t, row->inside ? "yes" : "no");
  table_text(t, row->ours ? "corrected" : "paper");
  table_text(t, *row->measured ? row->measured : "-");
  table_text(t, *row->reason ? row->reason : "-");
}

static void summarise(const struct ledger *ledger)
{
  int verdicts[2][4] = { { 0 } }, ours[4] = { 0 }; /* of the paper's claims, outside and inside of its conditions */
  for (const struct claim_row *row = ledger->rows; row < ledger->rows + ledger->count; row++)
    (row->ours ? ours : verdicts[row->inside])[row->verdict]++;
  for (int inside = 1; inside >= 0; inside--) {
    const int *v = verdicts[inside];
    fprintf(stderr, "%s the paper's conditions: %d hold, %d are sharper than claimed, %d refuted, %d undecided\n",
            inside ? "inside " : "outside", v[CLAIM_HOLDS], v[CLAIM_SHARPER], v[CLAIM_REFUTED], v[CLAIM_UNDECIDED]);
  }
  fprintf(stderr, "formulas that take the place of refuted ones: %d hold, %d are sharper than claimed, %d do not hold\n",
          ours[CLAIM_HOLDS], ours[CLAIM_SHARPER], ours[CLAIM_REFUTED] + ours[CLAIM_UNDECIDED]);
}

/* All rows, or those about the requested errors */
static void fill(struct ledger *ledger, const struct options *o)
{
  struct scallop_rational_crawler exact;
  scallop_rational_init(&exact);
  rational_point(&exact, NULL, &o->point);
  ledger_add_orders(ledger, &exact, o->point.has_gait ? exact.gait : NULL, o->errors);
  scallop_rational_clear(&exact);
  if (!o->errors)
    ledger_add_words(ledger, &o->point.crawler, o->point.has_gait ? o->point.crawler.gait : NULL);
}

static bool begin(struct table *table, const struct options *o, const char *const *names)
{
  static const char *const varied[] = { "T", "gait", NULL };
  if (!table_open(table, o))
    return false;
  table_note(table, "scallop " SCALLOP_VERSION);
  table_note(table, "command: claims%s%s%s", o->errors ? " --errors " : "", o->errors ? o->errors : "",
             o->check ? " --check" : "");
  table_parameters(table, o, varied, false);
  if (o->point.has_gait)
    table_note(table, "gait: %s", o->point.crawler.gait->name);
  table_columns(table, names);
  table_begin_rows(table);
  return true;
}

/* Writes the rows of the ledger. */
static enum exit_code write_ledger(struct table *table, const struct ledger *ledger, const struct options *o)
{
  if (!begin(table, o, o->errors ? error_columns : columns))
    return EXIT_FILE;
  for (int i = 0; i < ledger->count; i++)
    (o->errors ? write_errors : write_row)(table, &ledger->rows[i]);
  if (!table_close(table))
    return EXIT_FILE;
  if (!o->quiet && !o->errors && !*ledger->contradiction)
    summarise(ledger);
  return EXIT_DONE;
}

/* --check: the verdicts against those of a ledger that was written before */

static const char *const check_columns[] = { "claim",           "equation", "quantity",      "gait",
                                             "conditions",      "verdict",  "derived_order", "committed",
                                             "committed_order", NULL };

static void write_difference(struct table *t, const char *const key[COMMITTED_KEYS], const char *now, const char *order,
                             const char *then, const char *order_then)
{
  for (int i = 0; i < COMMITTED_KEYS; i++)
    table_text(t, key[i]);
  table_text(t, now);
  table_text(t, order);
  table_text(t, then);
  table_text(t, order_then);
}

/* The committed row that the key names and no row was before; NULL: there is none */
static struct committed *find_committed(const struct committed_ledger *committed, const char *const key[COMMITTED_KEYS])
{
  for (struct committed *c = committed->rows; c < committed->rows + committed->count; c++) {
    bool same = !c->met;
    for (int k = 0; k < COMMITTED_KEYS; k++)
      same = same && strcmp(key[k], c->key[k]) == 0;
    if (same)
      return c;
  }
  return NULL;
}

/* Returns how many differ. */
static int write_differences(struct table *t, const struct ledger *ledger, const struct committed_ledger *committed,
                             const struct options *o)
{
  int differ = 0;
  for (const struct claim_row *row = ledger->rows; row < ledger->rows + ledger->count; row++) {
    const char *const key[COMMITTED_KEYS] = { row->claim, row->equation, row->quantity, row->gait, row->conditions };
    const char *verdict = claim_verdict_text(row->verdict), *order = derived_text(row);
    struct committed *c = find_committed(committed, key);
    if (c)
      c->met = true;
    if (c && strcmp(verdict, c->verdict) == 0 && strcmp(order, c->order) == 0)
      continue;
    write_difference(t, key, verdict, order, c ? c->verdict : "-", c ? c->order : "-");
    differ++;
  }
  for (const struct committed *c = committed->rows; c < committed->rows + committed->count; c++)
    if (!c->met && (!o->point.has_gait || strcmp(c->key[3], o->point.crawler.gait->name) == 0)) {
      write_difference(t, c->key, "-", "-", c->verdict, c->order);
      differ++;
    }
  return differ;
}

static enum exit_code check_ledger(struct table *table, const struct ledger *ledger,
                                   const struct committed_ledger *committed, const struct options *o)
{
  if (!begin(table, o, check_columns))
    return EXIT_FILE;
  int differ = write_differences(table, ledger, committed, o);
  if (!table_close(table))
    return EXIT_FILE;
  if (!o->quiet && !*ledger->contradiction)
    fprintf(stderr, "%d verdicts, %d differ from %s\n", ledger->count, differ, ledger_name(o->against));
  return differ > 0 ? EXIT_CHECK_FAILED : EXIT_DONE;
}

enum exit_code claims_table(const struct options *o)
{
  struct table table;
  struct ledger ledger = { .rows = NULL };
  struct committed_ledger committed = { .rows = NULL };
  enum exit_code code = o->check ? committed_read(&committed, o->against) : EXIT_DONE;
  if (code == EXIT_DONE) {
    fill(&ledger, o);
    if (o->errors && ledger.count == 0) {
      complain("claims", "--errors: no claim about an order is called '%s': the first column of the ledger has the names",
               o->errors);
      code = EXIT_USAGE;
    } else
      code = o->check ? check_ledger(&table, &ledger, &committed, o) : write_ledger(&table, &ledger, o);
  }
  if (*ledger.contradiction && code != EXIT_FILE) {
    complain("claims", "the ledger contradicts itself: %s", ledger.contradiction);
    code = EXIT_UNSOLVED;
  }
  committed_free(&committed);
  ledger_free(&ledger);
  return code;
}
