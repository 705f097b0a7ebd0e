/* Summaries as pages or as the rows of a table. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/summary/summary.h"

enum { COLUMN = 96, PER_FORMULA = 7, MOST_COLUMNS = 32 + PER_FORMULA * SUMMARY_FORMULAS, DIGITS = 6 };

static const char *const of_motion[] = { "froude",     "v_start", "v_mid", "displacement", "mean_velocity",
                                         "multiplier", "regime",  "modes", "motion",       NULL };
static const char *const of_formula[PER_FORMULA] = { "",       "_error",   "_reach_1", "_reach_5",
                                                     "_limit", "_verdict", "_order" };
static const char *const of_expansion[] = {
  "first_event", "first_event_T", "first_event_froude", "reversals", "best_order", "best_error", "status", NULL
};

static void write_motion(struct table *t, const struct summary *s)
{
  char modes[MOTION_MODES_TEXT], words[MOTION_WORDS];
  for (int q = Q_FROUDE; q <= Q_MULTIPLIER; q++)
    table_number(t, s->answer.value[q].high);
  table_text(t, scallop_regime_text(s->answer.regime));
  table_text(t, motion_modes_text(modes, OF_STEADY, s->answer.modes));
  table_text(t, motion_in_words(words, &s->motion, &s->answer, DIGITS));
}

static void write_formula(struct table *t, const struct summary_series *f)
{
  table_number(t, f->value);
  table_number(t, f->error);
  for (int i = 0; i < SUMMARY_LEVELS; i++)
    table_number(t, f->reach[i]);
  table_number(t, f->limit);
  table_text(t, claim_verdict_text(f->claim.verdict));
  table_number(t, !f->claim.proven ? NAN : f->claim.exact ? INFINITY : (double)f->claim.derived_order);
}

/* The T at which the crawler turns back, separated by blanks; "-": none */
enum { REVERSALS_TEXT = 8 * NUMBER_TEXT };
static const char *reversals_text(char text[REVERSALS_TEXT], const struct summary *s)
{
  const struct events *e = &s->study.events;
  size_t used = (size_t)snprintf(text, REVERSALS_TEXT, "%s", e->reversals == 0 ? "-" : "");
  for (long i = 0; i < e->reversals && used < REVERSALS_TEXT - NUMBER_TEXT; i++) {
    char number[NUMBER_TEXT];
    number_text(number, e->reversal[i].T, 0);
    used += (size_t)snprintf(text + used, REVERSALS_TEXT - used, "%s%s", i > 0 ? " " : "", number);
  }
  return text;
}

static void write_expansion(struct table *t, const struct summary *s)
{
  const struct event *first = s->study.events.count > 0 ? s->study.events.event : NULL;
  char status[ANSWER_STATUS], reversals[REVERSALS_TEXT];
  table_text(t, first ? first->what : "-");
  table_number(t, first ? first->T : NAN);
  table_number(t, first ? motion_froude(&s->motion, first->T) : NAN);
  table_text(t, reversals_text(reversals, s));
  int last = s->series - 1; /* the displacement */
  table_number(t, last >= 0 && s->best_order[last] > 0 ? (double)s->best_order[last] : NAN);
  table_number(t, last >= 0 && s->best_order[last] > 0 ? s->best_error[last] : NAN);
  table_text(t, answer_status_text(status, &s->answer));
}

static void write_blank(struct table *t, int formulas, const char *why)
{
  for (int i = 0; of_motion[i]; i++)
    (i < Q_MULTIPLIER + 1 ? table_number(t, NAN) : table_text(t, "-"));
  for (int i = 0; i < formulas; i++)
    for (int k = 0; k < PER_FORMULA; k++)
      (strcmp(of_formula[k], "_verdict") == 0 ? table_text(t, "-") : table_number(t, NAN));
  for (int i = 0; of_expansion[i + 1]; i++)
    (i == 0 || strcmp(of_expansion[i], "reversals") == 0 ? table_text(t, "-") : table_number(t, NAN));
  table_text(t, why);
}

static void write_cells(struct table *t, const struct summary *s)
{
  write_motion(t, s);
  for (int i = 0; i < s->formulas; i++)
    write_formula(t, &s->formula[i]);
  write_expansion(t, s);
}

static void write_page(FILE *page, const struct point *point, const struct summary *s, int digits)
{
  char parameters[PARAMETERS_TEXT];
  parameters_text(parameters, point, NULL, true);
  fprintf(page, "\nCrawler:%s\n\n", parameters);
  page_of_motion(page, s, digits);
  page_of_formulas(page, s, digits);
  page_of_events(page, s, digits);
  page_of_reversals(page, s, digits);
  page_of_place(page, s, digits);
  fputs("\nMore: scallop steady --certified       proven digits\n"
        "      scallop claims                   the claims of the paper\n"
        "      scallop series --source derived  the expansion\n"
        "      scallop breakdown --all          every event and reach\n",
        page);
}

static void row(struct rows *rows, struct at *at)
{
  const struct request *request = rows->request;
  const struct scallop_formula *formulas[SUMMARY_FORMULAS];
  struct table *t = &rows->table;
  struct summary s;
  const char *refused = at->place.why[0] != '\0' ? at->place.why : NULL;
  const char *why = refused ? refused : summary_make(&s, &at->place.point, true);
  FILE *page = table_page(t);
  if (!page)
    sheet_row(&rows->sheet, t, at);
  if (why && page)
    fprintf(page, "\nThis crawler has no page: %s.\n", why);
  else if (why)
    write_blank(t, summary_formulas(formulas), why);
  else if (page)
    write_page(page, &at->place.point, &s, request->style.digits > 0 ? (int)request->style.digits : DIGITS);
  else
    write_cells(t, &s);
  if (!refused)
    summary_clear(&s);
  if (why && !refused)
    at_fail(at, why);
}

const char *summary_plan(struct rows *rows)
{
  const struct scallop_formula *formulas[SUMMARY_FORMULAS];
  static char names[SUMMARY_FORMULAS * PER_FORMULA][COLUMN];
  static const char *columns[MOST_COLUMNS];
  int n = 0, count = summary_formulas(formulas);
  if (!summary_serves(rows->request))
    return "";
  for (int i = 0; of_motion[i]; i++)
    columns[n++] = of_motion[i];
  for (int i = 0; i < count * PER_FORMULA; i++) {
    snprintf(names[i], COLUMN, "%s%s", formulas[i / PER_FORMULA]->name, of_formula[i % PER_FORMULA]);
    columns[n++] = names[i];
  }
  for (int i = 0; of_expansion[i]; i++)
    columns[n++] = of_expansion[i];
  rows->has_parameters = true;
  rows->behind = columns;
  rows->visit = row;
  return NULL;
}

static enum exit_code write_breakdown(const struct request *request, const struct summary *s)
{
  static const char *const of_T[] = { "T", NULL };
  int digits = request->style.digits > 0 ? (int)request->style.digits : DIGITS;
  char parameters[PARAMETERS_TEXT];
  struct table t;
  FILE *page = table_open(&t, &request->style) ? t.sink[0].file : NULL;
  if (!page)
    return EXIT_FILE;
  parameters_text(parameters, &request->point, of_T, true);
  fprintf(page, "Crawler:%s\n", parameters);
  page_of_events(page, s, digits);
  page_of_reversals(page, s, digits);
  page_of_reaches(page, s, digits);
  fputs("\nMore: --all, or --only event, reversal, reach, radius or best, gives the table with every row.\n", page);
  return table_close(&t) ? EXIT_DONE : EXIT_FILE;
}

enum exit_code summary_of_breakdown(const struct request *request)
{
  struct summary s;
  if (!summary_serves(request))
    return EXIT_USAGE;
  const char *why = summary_make(&s, &request->point, false);
  if (why)
    complain(request->style.command, "%s", why);
  enum exit_code code = why ? EXIT_UNSOLVED : write_breakdown(request, &s);
  summary_clear(&s);
  return code;
}
