/* The ledger as a table. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/points/point_flint.h"
#include "compare/claims/claims.h"
#include "compare/claims/evidence.h"
#include "compare/answers/points.h"
#include "compare/book/book.h"

static const char *const columns[] = { "claim",         "equation",    "quantity",  "gait",       "claimed_order",
                                       "order",         "order_lo",    "order_hi",  "points",     "verdict",
                                       "derived_order", "coefficient", "corrected", "conditions", "inside",
                                       "source",        "measured",    "reason",    NULL };
/* Behind those; of the ledger, from the second on */
static const char *const last_columns[] = { "leading_error", "evidence", NULL };

static const char *const error_columns[] = { "claim",         "equation",   "quantity", "gait",
                                             "claimed_order", "conditions", "inside",   "h",
                                             "err",           "pairwise",   "use",      NULL };

static void write_texts(struct table *t, const char *const *texts, int count)
{
  for (int i = 0; i < count; i++)
    table_text(t, *texts[i] ? texts[i] : "-");
}

/* What the rows of both tables begin with */
static void write_claim(struct table *t, const struct claim_row *row)
{
  write_texts(t, (const char *const[]){ row->claim, row->equation, row->quantity, row->gait }, 4);
  table_number(t, row->claimed_order);
}

static void write_errors(struct table *t, const struct claim_row *row)
{
  for (int i = 0; i < row->count; i++) {
    const struct scallop_order_point *p = &row->points[i];
    write_claim(t, row);
    write_texts(t, (const char *const[]){ row->conditions, row->inside ? "yes" : "no" }, 2);
    table_number(t, p->h);
    table_number(t, row->exact ? 0 : p->err); /* proven: what is left of err is rounding */
    table_rounded(t, p->pairwise, "%.2f");
    table_text(t, scallop_order_use_text(row->exact ? SCALLOP_ORDER_ZERO : p->use));
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
  static const char *const source_text[] = { "paper", "corrected", "book" };
  const char *const texts[] = {
    claim_verdict_text(row->verdict), derived_text(row),        row->coefficient, row->corrected, row->conditions,
    row->inside ? "yes" : "no",       source_text[row->source], row->measured,    row->reason,
  };
  write_claim(t, row);
  table_rounded(t, row->fit.order, "%.6f");
  table_rounded(t, row->fit.low, "%.6f");
  table_rounded(t, row->fit.high, "%.6f");
  table_rounded(t, row->fit.used, "%.0f");
  write_texts(t, texts, sizeof texts / sizeof *texts);
  if (row->source == OF_BOOK)
    table_text(t, row->leading_error ? row->leading_error : "-");
  table_text(t, claim_evidence_text(row));
}

/* One claim of the paper: its rows under the paper's conditions */
struct summed {
  const struct claim_row *first, *worst; /* worst: the first one that is refuted or else undecided, or that with
                                          the weakest evidence                                         */
  int checks, count[4];
};

/* Sums up the claim of the row at i, if that is the first of its rows that counts. */
static bool sum_up(struct summed *sum, const struct ledger *ledger, int i)
{
  const struct claim_row *rows = ledger->rows;
  *sum = (struct summed){ .first = &rows[i], .worst = &rows[i] };
  if (rows[i].source == OF_CORRECTED || !rows[i].inside)
    return false;
  for (int j = 0; j < ledger->count; j++) {
    if (rows[j].source == OF_CORRECTED || !rows[j].inside || strcmp(rows[j].claim, rows[i].claim) != 0)
      continue;
    if (j < i)
      return false;
    sum->checks++;
    sum->count[rows[j].verdict]++;
    static const int weight[] = { [CLAIM_HOLDS] = 0, [CLAIM_SHARPER] = 0, [CLAIM_UNDECIDED] = 1, [CLAIM_REFUTED] = 2 };
    int more = weight[rows[j].verdict] - weight[sum->worst->verdict];
    if (more > 0 || (more == 0 && weight[rows[j].verdict] == 0 && rows[j].evidence > sum->worst->evidence))
      sum->worst = &rows[j];
  }
  return sum->checks > 0;
}

/* Of all its checks: a claim that fails in one is refuted. */
static enum claim_verdict verdict_of(const struct summed *sum)
{
  const int *n = sum->count;
  return n[CLAIM_REFUTED]     ? CLAIM_REFUTED
         : n[CLAIM_UNDECIDED] ? CLAIM_UNDECIDED
         : n[CLAIM_HOLDS]     ? CLAIM_HOLDS
                              : CLAIM_SHARPER;
}

static const char *const summary_columns[] = { "claim",  "equation",  "quantity", "verdict", "checks",
                                               "failed", "condition", "evidence", NULL };

static void write_summed(struct table *t, const struct summed *sum)
{
  const struct claim_row *row = sum->worst;
  const bool fails = verdict_of(sum) > CLAIM_SHARPER;
  char condition[240] = "";
  if (fails)
    snprintf(condition, sizeof condition, "%s; %s", row->gait, row->conditions);
  write_texts(
      t, (const char *const[]){ row->claim, row->equation, sum->first->quantity, claim_verdict_text(verdict_of(sum)) },
      4);
  table_rounded(t, sum->checks, "%.0f");
  table_rounded(t, sum->count[CLAIM_REFUTED], "%.0f");
  write_texts(t, (const char *const[]){ condition, claim_evidence_text(row) }, 2);
}

/* Checks of remainders, and one verdict for each statement in words */
static void summarise(const struct ledger *ledger)
{
  int formulas = 0, statements = 0, checks[4] = { 0 }, words[4] = { 0 }, known[MEASURED + 1] = { 0 };
  for (int i = 0; i < ledger->count; i++) {
    struct summed sum;
    if (!sum_up(&sum, ledger, i))
      continue;
    if (sum.first->in_words) {
      statements++;
      words[verdict_of(&sum)]++;
      known[sum.worst->evidence] += verdict_of(&sum) <= CLAIM_SHARPER;
    } else
      formulas++;
    for (int v = 0; v < 4 && !sum.first->in_words; v++)
      checks[v] += sum.count[v];
  }
  fprintf(stderr,
          "%d checks of %d formulas under the paper's conditions: %d hold, %d errors fall faster than claimed, %d are "
          "refuted, %d undecided\n",
          checks[0] + checks[1] + checks[2] + checks[3], formulas, checks[CLAIM_HOLDS], checks[CLAIM_SHARPER],
          checks[CLAIM_REFUTED], checks[CLAIM_UNDECIDED]);
  fprintf(
      stderr,
      "%d statements in words: %d fail under some condition, %d undecided, %d hold (%d proven, %d certified for one "
      "crawler, %d sampled, %d measured in doubles)\n",
      statements, words[CLAIM_REFUTED], words[CLAIM_UNDECIDED], words[CLAIM_HOLDS], known[PROVEN_FOR_ALL],
      known[CERTIFIED_CRAWLER], known[SAMPLED], known[MEASURED]);
}

/* inside or outside of the conditions of the formulas */
static int count_verdict(const struct ledger *ledger, enum claim_verdict verdict, bool inside)
{
  int count = 0;
  for (int i = 0; i < ledger->count; i++)
    count += ledger->rows[i].verdict == verdict && ledger->rows[i].inside == inside;
  return count;
}

static void summarise_book(const struct ledger *ledger)
{
  for (int inside = 1; inside >= 0; inside--) {
    int v[4], all = 0;
    for (int i = 0; i < 4; i++)
      all += v[i] = count_verdict(ledger, (enum claim_verdict)i, inside);
    if (inside || all > 0)
      fprintf(stderr, "%s%d hold, %d are sharper than claimed, %d refuted, %d undecided\n",
              inside ? "" : "where the conditions of a formula are not met: ", v[CLAIM_HOLDS], v[CLAIM_SHARPER],
              v[CLAIM_REFUTED], v[CLAIM_UNDECIDED]);
  }
}

/* A formula is not refuted by a crawler that it is not for; but then it is not proven, either. */
static enum exit_code code_of_book(const struct ledger *ledger)
{
  int outside = 0;
  for (int i = 0; i < ledger->count; i++)
    outside += !ledger->rows[i].inside;
  return count_verdict(ledger, CLAIM_REFUTED, true) > 0               ? EXIT_CHECK_FAILED
         : outside + count_verdict(ledger, CLAIM_UNDECIDED, true) > 0 ? EXIT_UNSOLVED
                                                                      : EXIT_DONE;
}

static bool is_of_book(const struct claims_options *o) { return o->request.book || o->formula; }

/* Is a number of the crawler given on the command line? */
static bool has_crawler(const struct point *p)
{
  bool has = false;
  for (int i = 0; i < CRAWLER_NUMBERS; i++)
    has = has || p->written[i];
  return has;
}

/* All rows, or those about the requested errors */
static void fill(struct ledger *ledger, const struct claims_options *o)
{
  const struct point *p = &o->request.point;
  struct scallop_rational_crawler exact;
  scallop_rational_init(&exact);
  rational_point(&exact, NULL, p);
  if (is_of_book(o))
    ledger_add_book(ledger, &exact, has_crawler(p), p->has_gait ? exact.gait : NULL, o->errors);
  else
    ledger_add_orders(ledger, &exact, p->has_gait ? exact.gait : NULL, o->errors);
  scallop_rational_clear(&exact);
  if (!o->errors && !is_of_book(o))
    ledger_add_words(ledger, &p->crawler, p->has_gait ? p->crawler.gait : NULL);
}

static void begin(struct table *table, const struct claims_options *o, const char *const *names)
{
  static const char *const varied[] = { "T", "gait", NULL };
  table_command(table, "claims%s%s%s%s%s", o->errors ? " --errors " : "", o->errors ? o->errors : "",
                o->summary ? " --summary" : "", o->verdict.given ? " --verdict " : "",
                o->verdict.given ? o->verdict.value : "");
  if (o->request.book)
    table_note(table, "book: %s", o->request.book);
  if (o->formula)
    table_note(table, "formula: %s", o->formula);
  note_parameters(table, &o->request.point, varied, false);
  const struct scallop_crawler *c = &o->request.point.crawler;
  const double v0 = short_number(CLAIM_SPEED * sqrt(c->L * (c->F1 + c->F2) / (c->m1 + c->m2)), 2);
  if (!is_of_book(o))
    table_note(table, "v0, where it is fixed: %g or %g", v0, -v0);
  if (o->request.point.has_gait)
    table_note(table, "gait: %s", o->request.point.crawler.gait->name);
  table_columns(table, names);
  if (names == columns)
    table_columns(table, last_columns + !is_of_book(o));
  table_begin_rows(table);
}

static enum exit_code end(struct table *table, const struct ledger *ledger)
{
  if (!table_close(table))
    return EXIT_FILE;
  if (*ledger->contradiction)
    complain("claims", "the ledger contradicts itself: %s", ledger->contradiction);
  return *ledger->contradiction ? EXIT_UNSOLVED : EXIT_DONE;
}

static bool is_wanted(const struct claim_row *row, const struct claims_options *o)
{
  return !o->verdict.given || strcmp(claim_verdict_text(row->verdict), o->verdict.value) == 0;
}

enum exit_code claims_table(const struct claims_options *o)
{
  struct table table;
  struct ledger ledger = { .is_forecast = true };
  enum exit_code code = EXIT_USAGE;
  if (!table_open(&table, &o->request.style))
    return EXIT_FILE;
  fill(&ledger, o);
  ledger.is_forecast = false;
  fill(&ledger, o);
  if (o->errors && ledger.count == 0) {
    const char *instead = formula_instead(o->errors);
    complain("claims", "--errors: no claim about an order is called '%s'%s", o->errors,
             *instead ? instead : ": the first column of the ledger has the names");
  } else if (is_of_book(o) && ledger.count == 0) {
    complain("claims", "%s: no formula of this book has a claim: claimed = 4; for + O(T^4)", o->request.book);
  } else {
    begin(&table, o, o->errors ? error_columns : o->summary ? summary_columns : columns);
    struct summed sum;
    for (int i = 0; i < ledger.count; i++)
      if (o->summary && sum_up(&sum, &ledger, i))
        write_summed(&table, &sum);
      else if (!o->summary && is_wanted(&ledger.rows[i], o))
        (o->errors ? write_errors : write_row)(&table, &ledger.rows[i]);
    code = end(&table, &ledger);
  }
  if (code == EXIT_USAGE)
    table_abandon(&table);
  if (code == EXIT_DONE && !o->request.style.quiet && !o->errors)
    (is_of_book(o) ? summarise_book : summarise)(&ledger);
  if (code == EXIT_DONE && is_of_book(o))
    code = code_of_book(&ledger);
  ledger_free(&ledger);
  return code;
}
