/* Summaries as pages or as the rows of a table. */
#include <math.h>
#include <stdio.h>

#include "compare/summary/summary.h"

enum { DIGITS = 6 };

/* What a row has of each formula: NAME and NAME_error, ... */
static const char *const of_formula[][2] = { { "", "value." },
                                             { "_error", "deviation." },
                                             { "_reach_1", "reach_0.01." },
                                             { "_reach_5", "reach_0.05." },
                                             { "_limit", "error_limit." },
                                             { "_verdict", "verdict." },
                                             { "_order", "order." } };
enum { PER_FORMULA = sizeof of_formula / sizeof *of_formula };

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

/* To people a page, else a row */
static void visit(struct rows *rows, struct at *at)
{
  const struct style *style = &rows->request->style;
  FILE *page = table_page(&rows->table);
  struct summary s;
  if (!page) {
    sheet_row(&rows->sheet, &rows->table, at);
    return;
  }
  const char *refused = at->place.why[0] != '\0' ? at->place.why : NULL;
  const char *why = refused ? refused : summary_make(&s, &at->place.point, true);
  if (why)
    fprintf(page, "\nThis crawler has no page: %s.\n", why);
  else
    write_page(page, &at->place.point, &s, style->digits > 0 ? (int)style->digits : DIGITS);
  if (!refused)
    summary_clear(&s);
  if (why && !refused)
    at_fail(at, why);
}

const char *summary_plan(struct rows *rows)
{
  static const char *const before[] = { "froude",     "v_start", "v_mid", "displacement", "mean_velocity",
                                        "multiplier", "regime",  "modes", "motion",       NULL };
  static const char *const behind[] = {
    "first_event", "first_event_T", "first_event_froude", "reversals", "best_order", "best_error", "status", NULL
  };
  const struct scallop_formula *formulas[SUMMARY_FORMULAS];
  const char *wrong = NULL;
  if (!summary_serves(rows->request))
    return "";
  rows->has_parameters = true;
  rows->visit = visit;
  for (int i = 0; before[i] && !wrong; i++)
    wrong = rows_own(rows, "%s", before[i]);
  for (int i = 0, count = PER_FORMULA * summary_formulas(formulas); i < count && !wrong; i++) {
    const char *name = formulas[i / PER_FORMULA]->name, *const *part = of_formula[i % PER_FORMULA];
    wrong = rows_own(rows, "%s%s = %s%s", name, part[0], part[1], name);
  }
  for (int i = 0; behind[i] && !wrong; i++)
    wrong = rows_own(rows, "%s", behind[i]);
  return wrong;
}

static enum exit_code write_breakdown(const struct request *request, const struct summary *s)
{
  static const char *const of_T[] = { "T", NULL };
  int digits = request->style.digits > 0 ? (int)request->style.digits : DIGITS;
  char parameters[PARAMETERS_TEXT];
  struct table t;
  FILE *page = table_open(&t, &request->style) ? t.sink[0].out.stream : NULL;
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
