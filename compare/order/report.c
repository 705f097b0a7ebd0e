/* Reports of the verdicts on series, in formats of tables and as JUnit. */
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "compare/order/order.h"

const char *const report_formats[] = { "tsv", "json", "csv", "markdown", "table", "npy", "junit", NULL };

#define AT(member) offsetof(struct error_series, member)
static const struct table_column of_series[] = {
  { TABLE_COLUMN("file", column_text, AT(file)) },
  { TABLE_COLUMN("series", column_text, AT(names[0])) },
  { TABLE_COLUMN("y", column_text, AT(names[1])) },
  { .name = NULL },
};
static const struct table_column of_order[] = {
  { TABLE_COLUMN("order", column_rounded, AT(result.order)), .format = "%.4f" },
  { TABLE_COLUMN("order_low", column_rounded, AT(result.low)), .format = "%.4f" },
  { TABLE_COLUMN("order_high", column_rounded, AT(result.high)), .format = "%.4f" },
  { TABLE_COLUMN("interval", column_text, AT(interval)) },
  { TABLE_COLUMN("points", column_count, AT(result.used)) },
  { .name = NULL },
};
static const struct table_column of_grids[] = {
  { TABLE_COLUMN("gci", column_number, AT(result.gci)) },
  { TABLE_COLUMN("asymptotic_ratio", column_number, AT(result.asymptotic_ratio)) },
  { .name = NULL },
};
static const struct table_column of_verdict[] = {
  { TABLE_COLUMN("comparison", column_text, AT(test)) },
  { TABLE_COLUMN("expected", column_number, AT(expected.order)) },
  { TABLE_COLUMN("tolerance", column_number, AT(expected.tolerance)) },
  { TABLE_COLUMN("verdict", column_text, AT(verdict)) },
  { TABLE_COLUMN("reason", column_text, AT(reason)) },
  { .name = NULL },
};
#undef AT

/* Writes "2 tables: 1 passed, 1 failed", or counts of measured and unread ones. */
static void write_counts(struct table *t, const struct series_list *list, bool expects)
{
  static const char *const names[] = { "tables", "passed", "failed", "measured", "not_measured", "errors", NULL },
                           *const words[] = { "passed", "failed", "measured", "not measured", "not read" };
  char text[100];
  int used = 0;
  for (int outcome = 0; outcome < OUTCOMES; outcome++) {
    bool is_usual = expects ? outcome <= FAILED : outcome == MEASURED || outcome == NOT_MEASURED;
    if (is_usual || list->outcomes[outcome] > 0)
      used += snprintf(text + used, sizeof text - (size_t)used, "%s%d %s", used > 0 ? ", " : "",
                       list->outcomes[outcome], words[outcome]);
  }
  table_note(t, "%d %s: %s", list->count, list->count == 1 ? "table" : "tables", text);
  if (!table_restart_columns(t))
    return;
  table_columns(t, names);
  table_count(t, list->count);
  for (int outcome = 0; outcome < OUTCOMES; outcome++)
    table_count(t, list->outcomes[outcome]);
}

static enum exit_code write_table(const struct series_list *list, bool expects, const struct style *style)
{
  const struct table_column *const parts[] = { of_series, of_order, list->values ? of_grids : &of_grids[2],
                                               of_verdict };
  enum { PARTS = sizeof parts / sizeof *parts };
  struct table t;
  if (!table_head(&t, style, "order"))
    return EXIT_FILE;
  for (int part = 0; part < PARTS; part++)
    table_add(&t, parts[part]);
  table_begin_rows(&t);
  for (const struct error_series *s = list->series; s < list->series + list->count; s++)
    for (int part = 0; part < PARTS; part++)
      table_row(&t, parts[part], s, true);
  write_counts(&t, list, expects);
  return table_close(&t) ? EXIT_DONE : EXIT_FILE;
}

static void put_use(struct table *t, const struct table_column *c, const void *point)
{
  (void)c;
  table_text(t, scallop_order_use_text(((const struct scallop_order_point *)point)->use));
}
#define AT(member) offsetof(struct scallop_order_point, member)
static const struct table_column of_point[] = {
  { TABLE_COLUMN("row", column_long, AT(row)) },
  { TABLE_COLUMN("h", column_number, AT(h)) },
  { TABLE_COLUMN("err", column_number, AT(err)) },
  { TABLE_COLUMN("pairwise", column_rounded, AT(pairwise)), .format = "%.4f", .blank = "nan" },
  { TABLE_COLUMN("use", put_use, 0), .blank = "-" },
  { .name = NULL },
};
#undef AT

enum exit_code report_rows(const struct series_list *list, const struct style *style)
{
  struct table t;
  if (!table_head(&t, style, "order"))
    return EXIT_FILE;
  table_add(&t, of_series);
  table_add(&t, of_point);
  table_add(&t, of_order);
  table_add(&t, of_verdict);
  table_begin_rows(&t);
  for (const struct error_series *s = list->series; s < list->series + list->count; s++)
    for (const struct scallop_order_point *p = s->points; p < s->points + s->count; p++) {
      table_row(&t, of_series, s, true);
      table_row(&t, of_point, p, s->result.verdict != SCALLOP_ORDER_INVALID);
      table_row(&t, of_order, s, true);
      table_row(&t, of_verdict, s, true);
    }
  return table_close(&t) ? EXIT_DONE : EXIT_FILE;
}

/* Writes one case: an element with the reason of a failure, or a text. */
static void write_case(FILE *out, const struct error_series *s, bool required)
{
  static const char *const elements[OUTCOMES] = { NULL, "failure", NULL, "skipped", "error" };
  const char *const name[] = { s->file, s->name, s->y };
  const char *element = s->outcome == NOT_MEASURED && required ? "failure" : elements[s->outcome];
  fputs("<testcase classname=\"", out);
  put_escaped(out, s->file, &in_xml, SHOWS_ASCII);
  fputs("\" name=\"", out);
  for (int i = 0; i < 3; i++) {
    fputs(i > 0 && *name[i] ? ": " : "", out);
    put_escaped(out, name[i], &in_xml, SHOWS_ASCII);
  }
  fputs("\">", out);
  if (!element)
    fputs("<system-out>", out);
  else
    fprintf(out, strcmp(element, "skipped") == 0 ? "<%s message=\"" : "<%s type=\"%s\" message=\"", element,
            s->verdict);
  put_escaped(out, s->reason, &in_xml, SHOWS_ASCII);
  fputs(element ? "\"/></testcase>\n" : "</system-out></testcase>\n", out);
}

static void write_junit(FILE *out, const struct series_list *list, bool required)
{
  char counts[100];
  const int *of = list->outcomes;
  snprintf(counts, sizeof counts, "tests=\"%d\" failures=\"%d\" errors=\"%d\"", list->count,
           of[FAILED] + (required ? of[NOT_MEASURED] : 0), of[UNREAD]);
  fprintf(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites %s>\n", counts);
  fprintf(out, "<testsuite name=\"scallop order\" %s skipped=\"%d\">\n", counts, required ? 0 : of[NOT_MEASURED]);
  for (const struct error_series *s = list->series; s < list->series + list->count; s++)
    write_case(out, s, required);
  fputs("</testsuite>\n</testsuites>\n", out);
}

enum exit_code report_write(const struct series_list *list, const struct expected_orders *orders,
                            const struct style *style, int format)
{
  struct file file;
  if (format != REPORT_JUNIT)
    return write_table(list, orders->count > 0, style);
  int error = file_open(&file, style->output);
  if (error == 0) {
    write_junit(file.stream, list, orders->required);
    error = file_close(&file, true);
  }
  if (error != 0)
    complain("order", "cannot write %s: %s", style->output ? style->output : "standard output", file_error(error));
  return error == 0 ? EXIT_DONE : EXIT_FILE;
}

enum exit_code report_exit(const struct series_list *list, const struct expected_orders *orders, bool to_file)
{
  for (const struct error_series *s = list->series; to_file && s < list->series + list->count; s++)
    if (s->outcome != UNREAD)
      complain("order", "%s: %s%s%s: %s: %s", s->file, s->name, *s->name ? ": " : "", s->y, s->verdict, s->reason);
  bool fails = list->outcomes[FAILED] > 0 || (orders->required && list->outcomes[NOT_MEASURED] > 0);
  return fails ? EXIT_CHECK_FAILED : EXIT_DONE;
}
