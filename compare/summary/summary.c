/* Summaries as pages or as the rows of a table. */
#include <math.h>
#include <stdlib.h>

#include "compare/summary/summary.h"

enum { DIGITS = 6 };

static int digits_of(const struct request *request)
{
  return request->style.digits > 0 ? (int)request->style.digits : DIGITS;
}

static bool is_of_a_page(const void *page, const struct scallop_formula *f)
{
  const struct page *p = page;
  bool shown = false;
  for (int i = 0; i < p->count; i++)
    shown |= p->series[i].formula == f;
  return shown;
}

/* The page's series. False: the book that was given has none of them, and the message is on stderr. */
static bool begin(struct page *page, const struct request *request)
{
  page_init(page);
  return book_serves(request->style.command, request->book, is_of_a_page, page, "the steady v_start or displacement");
}

/* To people a page, else a row */
static void visit(struct rows *rows, struct at *at)
{
  struct page page = { .at = at, .asked = &rows->sheet.asked->quantities, .digits = digits_of(rows->request) };
  page.file = table_page(&rows->table);
  if (!page.file) {
    sheet_row(&rows->sheet, &rows->table, at);
    return;
  }
  page_init(&page);
  const char *why = at->is_outside ? at->why : page_begin(&page);
  if (why)
    fprintf(page.file, "\nThis crawler has no page: %s.\n", why);
  else
    page_of_crawler(&page);
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
  struct page page;
  const char *wrong = NULL;
  if (!begin(&page, rows->request))
    return "";
  rows->has_parameters = true;
  rows->visit = visit;
  for (int i = 0; before[i] && !wrong; i++)
    wrong = rows_own(rows, "%s", before[i]);
  for (int i = 0; i < page.count && !wrong; i++)
    wrong = page.series[i].formula ? add_formula(rows, page.series[i].name) : NULL;
  for (int i = 0; behind[i] && !wrong; i++)
    wrong = rows_own(rows, "%s", behind[i]);
  return wrong;
}

/* What its page tells of the series */
static void ask(struct quantities *all, const struct page *page)
{
  static const char *const of_series[] = { "reach_0.01.", "reach_0.05.", "error_limit." };
  char name[2 * QUANTITY_NAME];
  quantity_named(all, "v_start");
  for (int i = 0; i < 3 * page->count; i++) {
    snprintf(name, sizeof name, "%s%s", of_series[i % 3], page->series[i / 3].name);
    quantity_named(all, name);
  }
}

static enum exit_code write_breakdown(const struct request *request, struct page *page)
{
  struct table t;
  const char *why = page_begin(page);
  if (why)
    return complain(request->style.command, "%s", why), EXIT_UNSOLVED;
  if (!table_open(&t, &request->style))
    return EXIT_FILE;
  page->file = t.sink[0].out.stream;
  page_of_breakdown(page);
  return table_close(&t) ? EXIT_DONE : EXIT_FILE;
}

enum exit_code summary_of_breakdown(const struct request *request)
{
  struct page page = { .digits = digits_of(request) };
  enum exit_code code = EXIT_UNSOLVED;
  if (!begin(&page, request))
    return EXIT_USAGE;
  struct asked *asked = asked_nothing(request->style.command);
  if (!asked) {
    complain(request->style.command, "out of memory");
  } else {
    page.asked = &asked->quantities;
    ask(page.asked, &page);
    page.at = at_new(asked);
    if (page.at) {
      sweep_place_set(&page.at->place, &request->point);
      at_move(page.at);
      code = write_breakdown(request, &page);
    }
  }
  at_free(page.at);
  asked_free(asked);
  return code;
}
