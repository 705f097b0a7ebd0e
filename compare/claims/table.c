/* The ledger as a table, and its verdicts against those of a ledger that was written before. */
#include <stdlib.h>
#include <string.h>

#include "compare/claims/claims.h"
#include "compare/command/compare.h"
#include "compare/answers/rational.h"
#include "compare/text/shipped.h"
#include "compare/text/grow.h"
#include "compare/text/tsv.h"

static const char *const columns[] = { "claim",         "equation",    "quantity",  "gait",       "claimed_order",
                                       "order",         "order_lo",    "order_hi",  "points",     "verdict",
                                       "derived_order", "coefficient", "corrected", "conditions", "inside",
                                       "source",        "measured",    "reason",    NULL };

static const char *const error_columns[] = { "claim",  "equation", "quantity", "gait",     "claimed_order", "conditions",
                                             "inside", "h",        "err",      "pairwise", "use",           NULL };

struct ledger {
  struct table table;
  int verdicts[2][4]; /* of the paper's claims, outside and inside of its conditions           */
  int ours[4];
};

static void write_errors(void *context, const struct claim_row *row)
{
  struct ledger *ledger = context;
  struct table *t = &ledger->table;
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

static void write_row(void *context, const struct claim_row *row)
{
  struct ledger *ledger = context;
  struct table *t = &ledger->table;
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
  (row->ours ? ledger->ours : ledger->verdicts[row->inside])[row->verdict]++;
}

static void summarise(const struct ledger *ledger)
{
  for (int inside = 1; inside >= 0; inside--) {
    const int *v = ledger->verdicts[inside];
    fprintf(stderr, "%s the paper's conditions: %d hold, %d are sharper than claimed, %d refuted, %d undecided\n",
            inside ? "inside " : "outside", v[CLAIM_HOLDS], v[CLAIM_SHARPER], v[CLAIM_REFUTED], v[CLAIM_UNDECIDED]);
  }
  fprintf(stderr, "formulas that take the place of refuted ones: %d hold, %d are sharper than claimed, %d do not hold\n",
          ledger->ours[CLAIM_HOLDS], ledger->ours[CLAIM_SHARPER],
          ledger->ours[CLAIM_REFUTED] + ledger->ours[CLAIM_UNDECIDED]);
}

/* NULL, or what contradicts itself */
static const char *each_row(const struct options *o, claim_sink *sink, void *context)
{
  const struct scallop_gait *gait = o->point.has_gait ? o->point.crawler.gait : NULL;
  struct scallop_rational_crawler exact;
  scallop_rational_init(&exact);
  rational_point(&exact, NULL, &o->point);
  const char *wrong = claims_of_order(&exact, gait ? exact.gait : NULL, o->errors, sink, context);
  scallop_rational_clear(&exact);
  if (!o->errors)
    claims_in_words(&o->point.crawler, gait, sink, context);
  return wrong;
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

static enum exit_code end(struct table *table, const char *wrong)
{
  if (!table_close(table))
    return EXIT_FILE;
  if (wrong)
    complain("claims", "the ledger contradicts itself: %s", wrong);
  return wrong ? EXIT_UNSOLVED : EXIT_DONE;
}

static enum exit_code write_ledger(const struct options *options)
{
  struct ledger ledger = { .verdicts = { { 0 } } };
  if (!begin(&ledger.table, options, options->errors ? error_columns : columns))
    return EXIT_FILE;
  const char *wrong = each_row(options, options->errors ? write_errors : write_row, &ledger);
  enum exit_code code = end(&ledger.table, wrong);
  if (code == EXIT_DONE && !options->quiet && !options->errors)
    summarise(&ledger);
  return code;
}

enum { KEYS = 5, VERDICT = KEYS, ORDER, KEPT };
static const char *const kept_columns[KEPT] = { "claim",      "equation", "quantity",     "gait",
                                                "conditions", "verdict",  "derived_order" };
static const char *const check_columns[] = { "claim",           "equation", "quantity",      "gait",
                                             "conditions",      "verdict",  "derived_order", "committed",
                                             "committed_order", NULL };

struct committed { /* a row of the earlier ledger */
  const char *cell[KEPT];
  bool met; /* some row of today's is this one */
};

struct check {
  struct table table;
  struct tsv tsv;
  struct committed *rows;
  int count, verdicts, differ;
};

/* NULL, or what is wrong. The cells are those of check->tsv. */
static const char *read_committed(struct check *check, const char *ledger)
{
  struct tsv *t = &check->tsv;
  int place[KEPT];
  if (!tsv_open_text(t, "the ledger that comes with the tool", ledger) || !tsv_next(t) || !tsv_take_header(t))
    return "out of memory";
  for (int k = 0; k < KEPT; k++)
    if ((place[k] = tsv_column(t, kept_columns[k])) < 0)
      return tsv_at(t, "there is no column '%s'", kept_columns[k]);
  while (tsv_next(t)) {
    struct committed *rows = with_room(check->rows, check->count, sizeof *rows);
    if (!rows)
      return "out of memory";
    check->rows = rows;
    if (t->count != t->columns)
      return tsv_at(t, "%d columns where the header has %d", t->count, t->columns);
    rows[check->count] = (struct committed){ .met = false };
    for (int k = 0; k < KEPT; k++)
      rows[check->count].cell[k] = t->cell[place[k]];
    check->count++;
  }
  return NULL;
}

/* The keys, and the verdict and order of both; NULL: there is no such row */
static void write_difference(struct check *check, const char *const *keys, const char *const *now, const char *const *then)
{
  struct table *t = &check->table;
  for (int i = 0; i < KEYS; i++)
    table_text(t, keys[i]);
  for (int i = 0; i < 2; i++)
    table_text(t, now ? now[i] : "-");
  for (int i = 0; i < 2; i++)
    table_text(t, then ? then[i] : "-");
  check->differ++;
}

static void check_row(void *context, const struct claim_row *row)
{
  struct check *check = context;
  const char *const keys[KEYS] = { row->claim, row->equation, row->quantity, row->gait, row->conditions };
  const char *const now[] = { claim_verdict_text(row->verdict), derived_text(row) };
  check->verdicts++;
  for (struct committed *c = check->rows, *end = c + check->count; c < end; c++) {
    bool same = !c->met;
    for (int k = 0; same && k < KEYS; k++)
      same = strcmp(keys[k], c->cell[k]) == 0;
    if (!same)
      continue;
    c->met = true;
    if (strcmp(now[0], c->cell[VERDICT]) != 0 || strcmp(now[1], c->cell[ORDER]) != 0)
      write_difference(check, keys, now, &c->cell[VERDICT]);
    return;
  }
  write_difference(check, keys, now, NULL);
}

enum exit_code claims_check(const struct options *o, const char *ledger)
{
  struct check check = { .count = 0 };
  const char *wrong = read_committed(&check, ledger);
  enum exit_code code = wrong ? EXIT_UNSOLVED : EXIT_DONE;
  if (wrong)
    complain("claims", "%s", wrong);
  else if (!begin(&check.table, o, check_columns))
    code = EXIT_FILE;
  if (code == EXIT_DONE) {
    wrong = each_row(o, check_row, &check);
    for (const struct committed *c = check.rows; c < check.rows + check.count; c++)
      if (!c->met && (!o->point.has_gait || strcmp(c->cell[3], o->point.crawler.gait->name) == 0))
        write_difference(&check, c->cell, NULL, &c->cell[VERDICT]);
    code = end(&check.table, wrong);
  }
  if (code == EXIT_DONE && !o->quiet)
    fprintf(stderr, "%d verdicts, %d differ from %s\n", check.verdicts, check.differ, check.tsv.name);
  free(check.rows);
  tsv_close(&check.tsv);
  return code == EXIT_DONE && check.differ > 0 ? EXIT_CHECK_FAILED : code;
}

enum exit_code claims_table(const struct options *options)
{
  if (options->errors && !claims_have_order(options->errors)) {
    complain("claims", "--errors: no claim about an order is called '%s': the first column of the ledger has the names",
             options->errors);
    return EXIT_USAGE;
  }
  return options->check ? claims_check(options, shipped_text(shipped_ledger, "claims")) : write_ledger(options);
}
