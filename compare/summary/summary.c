/* What summaries ask of a point, as columns of a table: a page tells the same. */
#include "compare/summary/summary.h"

static bool is_of_a_page(const void *context, const struct scallop_formula *f)
{
  const struct scallop_formula *shown[SUMMARY_FORMULAS];
  int i = page_formulas(shown);
  (void)context;
  while (i > 0 && shown[i - 1] != f)
    i--;
  return i > 0;
}

/* False: the book that was given has none of the page's formulas, and the message is on stderr. */
static bool serves(const struct request *request)
{
  return book_serves(request->style.command, request->book, is_of_a_page, NULL, "the steady v_start or displacement");
}

/* Columns of the point, or of a series what these names begin with */
static const char *add(struct rows *rows, const char *const *names, const char *series)
{
  const char *wrong = NULL;
  for (; *names && !wrong; names++)
    wrong = rows_own(rows, "%s%s", *names, series);
  return wrong;
}

/* What a row has of each formula: NAME, NAME_error, ... */
static const char *add_formula(struct rows *rows, const char *name)
{
  static const char *const columns[][2] = { { "", "value." },
                                            { "_error", "deviation." },
                                            { "_reach_1", "reach_0.01." },
                                            { "_reach_5", "reach_0.05." },
                                            { "_limit", "error_limit." },
                                            { "_verdict", "verdict." },
                                            { "_order", "order." } };
  const char *wrong = NULL;
  for (size_t i = 0; i < sizeof columns / sizeof *columns && !wrong; i++)
    wrong = rows_own(rows, "%s%s = %s%s", name, columns[i][0], columns[i][1], name);
  return wrong;
}

const char *summary_plan(struct rows *rows)
{
  static const char *const before[] = { "froude",     "v_start", "v_mid", "displacement", "mean_velocity",
                                        "multiplier", "regime",  "modes", "motion",       NULL };
  static const char *const behind[] = {
    "first_event", "first_event_T", "first_event_froude", "reversals", "best_order", "best_error", "status", NULL
  };
  const struct scallop_formula *formulas[SUMMARY_FORMULAS];
  int count = page_formulas(formulas);
  if (!serves(rows->request))
    return "";
  rows->has_parameters = true;
  rows->visit = page_of_crawler;
  const char *wrong = add(rows, before, "");
  for (int i = 0; i < count && !wrong; i++)
    wrong = add_formula(rows, formulas[i]->name);
  return wrong ? wrong : add(rows, behind, "");
}

const char *breakdown_page(struct rows *rows)
{
  static const char *const motion[] = { "v_start", NULL }, *const of_series[] = { "reach_0.01.", "reach_0.05.",
                                                                                  "error_limit.", NULL };
  const struct scallop_formula *formulas[SUMMARY_FORMULAS];
  int count = page_formulas(formulas);
  if (!serves(rows->request))
    return "";
  rows->visit = page_of_breakdown;
  const char *wrong = add(rows, motion, "");
  for (int i = 0; i < count + PAGE_QUANTITIES && !wrong; i++)
    wrong = add(rows, of_series, i < count ? formulas[i]->name : page_quantities[i - count].derived);
  return wrong;
}
