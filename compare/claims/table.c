/* Output of the table of claims, summaries, and rows of claims in words. */
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "compare/claims/decide.h"
#include "compare/points/point_flint.h"

/* Content of one row of output: a row of the table of claims, one of its errors, or all checks of a claim of the paper
 * under its conditions. For the last, `row` is the first refuted check, else the first undecided one, else the one with
 * the weakest evidence; then its verdict is the verdict on all. */
struct line {
  struct claim_row row;
  struct scallop_order_point point;
  int checks, count[CLAIM_REFUTED + 1]; /* by verdict */
};

/* Sets of tables that have a column */
enum { PAPER = 1, USER = 2, ROWS = PAPER | USER, SUMMARY = 4, ERRORS = 8, ALL = ROWS | SUMMARY | ERRORS };

struct claims_output {
  const struct claims_options *options;
  struct claim_table claims;
  struct table table;
  unsigned of;  /* the table that is requested */
  bool heading; /* names of columns are written, in place of cells */
};

/* Writes the name of a column, or its cell by `cell`. */
static void put_as(struct claims_output *r, unsigned tables, const char *name, const char *text,
                   void (*cell)(struct table *table, const char *text))
{
  if (!(tables & r->of))
    return;
  if (r->heading)
    table_columns(&r->table, (const char *const[]){ name, NULL });
  else
    cell(&r->table, text && *text ? text : "-");
}

static void put(struct claims_output *r, unsigned tables, const char *name, const char *text)
{
  put_as(r, tables, name, text, table_text);
}

static void put_number(struct claims_output *r, unsigned tables, const char *name, double x, const char *format)
{
  if (!(tables & r->of) || r->heading)
    put(r, tables, name, NULL);
  else if (format)
    table_rounded(&r->table, x, format);
  else
    table_number(&r->table, x);
}

static const char *evidence_text(const struct claim_row *row)
{
  static const char *const texts[] = { "-", "proven for all parameters", "certified for the crawler named", NULL,
                                       "measured in doubles" };
  return row->evidence == SAMPLED ? wrong_text("sampled: %d cases, no seed", row->sampled) : texts[row->evidence];
}

/* Truncates a long formula in a table for people. */
enum { SHORT_TEXT = 100, SHORT_FORMULA = 30 };
static const char *short_text(const struct claims_output *r, char text[SHORT_TEXT], const char *formula)
{
  if (!formula || strlen(formula) <= 64 || !table_is_aligned(&r->options->request.style))
    return formula;
  snprintf(text, SHORT_TEXT, "%.*s... (%zu characters: --format tsv)", SHORT_FORMULA, formula, strlen(formula));
  return text;
}

static void write_line(struct claims_output *r, const struct line *line)
{
  static const char *const sources[] = { "paper", "corrected", "user" };
  const struct claim_row *row = &line->row;
  char shortened[SHORT_TEXT];
  put(r, ALL, "claim", row->claim);
  put(r, ALL, "equation", row->equation);
  put(r, ALL, "quantity", row->quantity);
  put(r, ROWS | ERRORS, "gait", row->gait);
  put_number(r, ROWS | ERRORS, "claimed_order", row->claimed_order, NULL);
  put_number(r, ROWS, "order", row->fit.order, "%.6f");
  put_number(r, ROWS, "order_low", row->fit.low, "%.6f");
  put_number(r, ROWS, "order_high", row->fit.high, "%.6f");
  put_number(r, ROWS, "points", row->fit.used, "%.0f");
  put(r, ROWS | SUMMARY, "verdict", claim_verdict_text(row->verdict));
  put_number(r, SUMMARY, "checks", line->checks, "%.0f");
  put_number(r, SUMMARY, "failed", line->count[CLAIM_REFUTED], "%.0f");
  put(r, SUMMARY, "condition", row->conditions);
  /* "none": every coefficient that was computed vanishes */
  put_as(r, ROWS, "derived_order",
         !row->proven ? NULL
         : row->exact ? "none"
                      : wrong_text("%ld", row->derived_order),
         table_carried);
  put(r, ROWS, "coefficient", row->coefficient);
  put(r, ROWS, "corrected", row->corrected);
  put(r, ROWS | ERRORS, "conditions", row->conditions);
  put(r, ROWS | ERRORS, "paper_conditions", row->inside ? "yes" : "no");
  put(r, ROWS, "source", sources[row->source]);
  put(r, ROWS, "summary", row->summary);
  put(r, ROWS, "reason", row->reason);
  put(r, USER, "leading_error", short_text(r, shortened, row->leading_error));
  put(r, USER, "formula", row->formula);
  put_number(r, USER, "error_at_T", row->error_at_T, "%.3g");
  put_number(r, ERRORS, "h", line->point.h, NULL);
  put_number(r, ERRORS, "err", line->point.err, NULL);
  put_number(r, ERRORS, "pairwise", line->point.pairwise, "%.2f");
  put(r, ERRORS, "use", scallop_order_use_text(line->point.use));
  put(r, ROWS | SUMMARY, "evidence", evidence_text(row));
}

static bool is_of_user(const struct claims_options *o) { return o->request.formulas || o->formula; }

static bool is_worse(const struct claim_row *row, const struct claim_row *than)
{
  if (row->verdict > CLAIM_SHARPER || than->verdict > CLAIM_SHARPER)
    return row->verdict > than->verdict;
  return row->evidence > than->evidence;
}

/* Sums up the claim of the row at i; false unless this is the first of its rows that counts. */
static bool sum_up(struct line *sum, const struct claim_table *claims, int i)
{
  const struct claim_row *rows = claims->rows, *worst = &rows[i];
  *sum = (struct line){ .checks = 0 };
  for (int j = 0; j < claims->count; j++) {
    bool counts = rows[j].source != OF_CORRECTED && rows[j].inside;
    if (j == i && !counts)
      return false;
    if (!counts || strcmp(rows[j].claim, rows[i].claim) != 0)
      continue;
    if (j < i)
      return false;
    sum->checks++;
    sum->count[rows[j].verdict]++;
    if (is_worse(&rows[j], worst))
      worst = &rows[j];
  }
  sum->row = *worst;
  sum->row.quantity = rows[i].quantity;
  *sum->row.conditions = '\0';
  if (worst->verdict > CLAIM_SHARPER)
    append(sum->row.conditions, sizeof sum->row.conditions, "%s; %s", worst->gait, worst->conditions);
  else if (sum->count[CLAIM_HOLDS] > 0)
    sum->row.verdict = CLAIM_HOLDS;
  return true;
}

/* Prints counts of checks of remainders, and of verdicts on statements in words. */
static void summarise(const struct claim_table *claims)
{
  int asserted[2] = { 0 }, count[2][CLAIM_REFUTED + 1] = { { 0 } }, known[MEASURED + 1] = { 0 };
  struct line sum;
  for (int i = 0; i < claims->count; i++) {
    if (!sum_up(&sum, claims, i))
      continue;
    const bool in_words = sum.row.in_words;
    asserted[in_words]++;
    for (int v = 0; v <= CLAIM_REFUTED; v++)
      count[in_words][v] += in_words ? v == (int)sum.row.verdict : sum.count[v];
    known[sum.row.evidence] += in_words && sum.row.verdict <= CLAIM_SHARPER;
  }
  const int *n = count[0], *m = count[1];
  fprintf(stderr,
          "%d checks of %d formulas under the paper's conditions: %d hold, %d errors fall faster than claimed, %d are "
          "refuted, %d undecided\n",
          n[0] + n[1] + n[2] + n[3], asserted[0], n[CLAIM_HOLDS], n[CLAIM_SHARPER], n[CLAIM_REFUTED],
          n[CLAIM_UNDECIDED]);
  fprintf(
      stderr,
      "%d statements in words: %d fail under some condition, %d undecided, %d hold (%d proven, %d certified for one "
      "crawler, %d sampled, %d measured in doubles)\n",
      asserted[1], m[CLAIM_REFUTED], m[CLAIM_UNDECIDED], m[CLAIM_HOLDS], known[PROVEN_FOR_ALL],
      known[CERTIFIED_CRAWLER], known[SAMPLED], known[MEASURED]);
}

/* Prints counts. A crawler outside of a formula's conditions neither refutes nor proves it. */
static enum exit_code summarise_user(const struct claim_table *claims, bool quiet)
{
  int rows[2] = { 0 }, count[2][4] = { { 0 } }; /* outside and inside of the conditions of the formulas */
  for (const struct claim_row *row = claims->rows; row < claims->rows + claims->count; row++) {
    rows[row->inside] += row->source == OF_USER;
    count[row->inside][row->verdict] += row->source == OF_USER;
  }
  for (int inside = 1; inside >= 0 && !quiet; inside--)
    if (inside || rows[0] > 0)
      fprintf(stderr, "%s%d hold, %d are sharper than claimed, %d refuted, %d undecided\n",
              inside ? "" : "outside of the conditions of a formula: ", count[inside][CLAIM_HOLDS],
              count[inside][CLAIM_SHARPER], count[inside][CLAIM_REFUTED], count[inside][CLAIM_UNDECIDED]);
  return count[1][CLAIM_REFUTED] > 0               ? EXIT_CHECK_FAILED
         : rows[0] + count[1][CLAIM_UNDECIDED] > 0 ? EXIT_UNSOLVED
                                                   : EXIT_DONE;
}

/* Claims in words */

static void add_row(struct claim_table *claims, const struct statement *claim, const struct scallop_crawler *crawler,
                    bool of_the_paper)
{
  struct question q = { .claim = claim,
                        .crawler = *crawler,
                        .of_the_paper = of_the_paper,
                        .by = CERTIFIED_CRAWLER,
                        .solved = true,
                        .row = { .equation = claim->place,
                                 .quantity = claim->quantity,
                                 .gait = crawler->gait->name,
                                 .inside = of_the_paper && !claim->outside,
                                 .in_words = true,
                                 .claimed_order = NAN,
                                 .fit = { .order = NAN, .low = NAN, .high = NAN } } };
  append(q.row.claim, sizeof q.row.claim, "%s", claim->name);
  append(q.row.conditions, sizeof q.row.conditions, claim->conditions,
         of_the_paper ? "the paper's crawler" : "the default crawler of claims");
  set_conditions(&q.crawler, q.row.conditions);
  claim->test(&q, q.crawler);
  claim_table_add(claims, &q.row);
}

static void add_rows(struct claim_table *claims, const struct statement *claim, const struct scallop_crawler *crawler,
                     bool of_the_paper)
{
  for (; claim->name; claim++)
    if ((of_the_paper || !claim->only_paper_crawler)
        && (scallop_gait_named(crawler->gait->name) || !claim->only_paper_gaits) && !claim_table_expects(claims))
      add_row(claims, claim, crawler, of_the_paper);
}

void claim_table_add_words(struct claim_table *claims, const struct scallop_crawler *crawler)
{
  struct scallop_crawler paper = scallop_crawler_default(), own = *crawler;
  paper.gait = crawler->gait;
  own.T = 0.5 * sqrt((own.m1 + own.m2) / (own.F1 + own.F2) * own.L); /* Froude number 4 */
  add_rows(claims, statements_at_random, &paper, true);
  add_rows(claims, statements_by_example, &paper, true);
  add_rows(claims, statements_of_families, &paper, true);
  add_rows(claims, statements_of_figures, &paper, true);
  add_rows(claims, statements_of_families, &own, false);
  add_rows(claims, statements_of_figures, &own, false);
}

/* The rows */

/* Fills the table with all rows, or only the rows with requested errors, for the given gait or the paper's: first the
 * formulas of all gaits, then the statements. */
static void fill(struct claims_output *r)
{
  const struct claims_options *o = r->options;
  const struct point *p = &o->request.point;
  struct scallop_crawler c = p->crawler;
  bool has_crawler = false; /* given on the command line */
  SCOPED(scallop_rational, exact);
  rational_point(&exact, NULL, p);
  for (int i = 0; i < CRAWLER_NUMBERS; i++) /* claims do not depend on T */
    has_crawler = has_crawler || (p->written[i] && strcmp(crawler_parameters[i], "T") != 0);
  for (int words = 0; words < (o->errors || is_of_user(o) ? 1 : 2); words++)
    for (int g = 0; p->has_gait ? g == 0 : scallop_gait_name(g) != NULL; g++) {
      if (!p->has_gait)
        c.gait = exact.gait = scallop_gait_named(scallop_gait_name(g));
      if (words)
        claim_table_add_words(&r->claims, &c);
      else if (is_of_user(o))
        claim_table_add_user(&r->claims, &exact, has_crawler, o->errors);
      else
        claim_table_add_orders(&r->claims, &exact, o->errors);
    }
}

static void begin(struct claims_output *r)
{
  static const char *const varied[] = { "T", "gait", NULL };
  const struct claims_options *o = r->options;
  const struct scallop_crawler *c = &o->request.point.crawler;
  const double v0 = short_number(CLAIM_SPEED * sqrt(c->L * (c->F1 + c->F2) / (c->m1 + c->m2)), 2);
  table_command(&r->table, "claims%s%s%s%s%s", o->errors ? " --errors " : "", o->errors ? o->errors : "",
                o->summary ? " --summary" : "", o->verdict.given ? " --verdict " : "",
                o->verdict.given ? o->verdict.value : "");
  if (o->request.formulas)
    table_note(&r->table, "formulas: %s", o->request.formulas);
  if (o->formula)
    table_note(&r->table, "formula: %s", o->formula);
  note_parameters(&r->table, &o->request.point, varied, false);
  if (!is_of_user(o))
    table_note(&r->table, "v0, where it is fixed: %g or %g", v0, -v0);
  else if (o->request.point.written[crawler_place("T")])
    table_note(&r->table, "error_at_T: formula/exact - 1, certified, at the period T = %g", c->T);
  if (o->request.point.has_gait)
    table_note(&r->table, "gait: %s", c->gait->name);
  r->of = o->errors ? ERRORS : o->summary ? SUMMARY : is_of_user(o) ? USER : PAPER;
  r->heading = true;
  write_line(r, &(struct line){ .checks = 0 });
  r->heading = false;
  table_begin_rows(&r->table);
}

static void write_errors(struct claims_output *r, const struct claim_row *row)
{
  struct line line = { .row = *row };
  for (int i = 0; i < row->count; i++) {
    line.point = row->points[i];
    if (row->exact) { /* proven: err is rounding alone */
      line.point.err = 0;
      line.point.use = SCALLOP_ORDER_ZERO;
    }
    write_line(r, &line);
  }
}

static void write_rows(struct claims_output *r)
{
  const struct claims_options *o = r->options;
  for (int i = 0; i < r->claims.count; i++) {
    struct line line = { .row = r->claims.rows[i] };
    if (o->errors)
      write_errors(r, &line.row);
    else if (o->summary ? sum_up(&line, &r->claims, i)
                        : !o->verdict.given || strcmp(claim_verdict_text(line.row.verdict), o->verdict.value) == 0)
      write_line(r, &line);
  }
}

/* Reports that no row matches. */
static enum exit_code refuse(const struct claims_options *o)
{
  const char *instead = o->errors ? formula_hint(o->errors) : "";
  if (o->errors)
    complain("claims", "--errors: no claim about an order is called '%s'%s", o->errors,
             *instead ? instead : ": the first column of the table of claims has the names");
  else
    complain("claims", "%s: no formula of this formula file has a claim: claimed = 4; for + O(T^4)",
             o->request.formulas);
  return EXIT_USAGE;
}

static enum exit_code end(struct claims_output *r)
{
  const bool quiet = r->options->request.style.quiet || r->options->errors;
  if (!table_close(&r->table))
    return EXIT_FILE;
  if (*r->claims.contradiction) {
    complain("claims", "the table of claims contradicts itself: %s", r->claims.contradiction);
    return EXIT_UNSOLVED;
  }
  if (is_of_user(r->options))
    return summarise_user(&r->claims, quiet);
  if (!quiet)
    summarise(&r->claims);
  return EXIT_DONE;
}

enum exit_code claims_table(const struct claims_options *o)
{
  struct claims_output r = { .options = o };
  if (!table_open(&r.table, &o->request.style))
    return EXIT_FILE;
  r.claims.is_forecast = true;
  fill(&r);
  r.claims.is_forecast = false;
  fill(&r);
  if (r.claims.count == 0) {
    table_abandon(&r.table);
    return refuse(o);
  }
  begin(&r);
  write_rows(&r);
  enum exit_code code = end(&r);
  claim_table_free(&r.claims);
  return code;
}
