/* The verdicts on series, in the formats that people and CI servers read. */
#include <math.h>
#include <stddef.h>

#include "compare/order/order.h"

const char *const report_formats[] = { "tsv", "json", "csv", "markdown", "table", "npy", "junit", NULL };

#define AT(member) offsetof(struct series, member)
static const struct table_column of_series[] = {
  { TABLE_COLUMN("file", column_text, AT(file)) },
  { TABLE_COLUMN("series", column_text, AT(names[0])) },
  { TABLE_COLUMN("y", column_text, AT(names[1])) },
  { .name = NULL },
};
static const struct table_column of_order[] = {
  { TABLE_COLUMN("order", column_rounded, AT(result.order)), .format = "%.4f" },
  { TABLE_COLUMN("low", column_rounded, AT(result.low)), .format = "%.4f" },
  { TABLE_COLUMN("high", column_rounded, AT(result.high)), .format = "%.4f" },
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
  { TABLE_COLUMN("test", column_text, AT(test)) },
  { TABLE_COLUMN("expected", column_number, AT(wanted.order)) },
  { TABLE_COLUMN("tolerance", column_number, AT(wanted.tolerance)) },
  { TABLE_COLUMN("verdict", column_text, AT(verdict)) },
  { TABLE_COLUMN("reason", column_text, AT(reason)) },
  { .name = NULL },
};
#undef AT

/* "2 tables: 1 passed, 1 failed", and how many could not be read */
static void write_counts(struct table *t, const struct series_list *list)
{
  const char *const names[] = { "tables", list->expects ? "passed" : "measured", "failed", "errors", NULL };
  const int *counts = list->outcomes;
  char unread[40] = "";
  if (counts[UNREAD] > 0)
    snprintf(unread, sizeof unread, ", %d not read", counts[UNREAD]);
  table_note(t, "%d %s: %d %s, %d failed%s", list->count, list->count == 1 ? "table" : "tables", counts[WELL], names[1],
             counts[FAILED], unread);
  if (!table_begin_anew(t))
    return;
  table_columns(t, names);
  table_count(t, list->count);
  for (int outcome = 0; outcome < OUTCOMES; outcome++)
    table_count(t, counts[outcome]);
}

static enum exit_code write_table(const struct series_list *list, const struct style *style)
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
  for (const struct series *s = list->series; s < list->series + list->count; s++)
    for (int part = 0; part < PARTS; part++)
      table_row(&t, parts[part], s, true);
  write_counts(&t, list);
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
  table_begin_rows(&t);
  for (const struct series *s = list->series; s < list->series + list->count; s++)
    for (const struct scallop_order_point *p = s->points; p < s->points + s->count; p++) {
      table_row(&t, of_series, s, true);
      table_row(&t, of_point, p, s->result.verdict != SCALLOP_ORDER_INVALID);
    }
  return table_close(&t) ? EXIT_DONE : EXIT_FILE;
}

static void write_junit(FILE *out, const struct series_list *list)
{
  char counts[100];
  snprintf(counts, sizeof counts, "tests=\"%d\" failures=\"%d\" errors=\"%d\"", list->count, list->outcomes[FAILED],
           list->outcomes[UNREAD]);
  fprintf(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites %s>\n", counts);
  fprintf(out, "<testsuite name=\"scallop order\" %s skipped=\"0\">\n", counts);
  for (const struct series *s = list->series; s < list->series + list->count; s++) {
    const char *const name[] = { s->file, s->name, s->y };
    fputs("<testcase classname=\"", out);
    put_escaped(out, s->file, &in_xml, SHOWS_ASCII);
    fputs("\" name=\"", out);
    for (int i = 0; i < 3; i++) {
      fputs(i > 0 && *name[i] ? ": " : "", out);
      put_escaped(out, name[i], &in_xml, SHOWS_ASCII);
    }
    fputs("\">", out);
    if (s->outcome == WELL)
      fputs("<system-out>", out);
    else
      fprintf(out, "<%s type=\"%s\" message=\"", s->outcome == UNREAD ? "error" : "failure", s->verdict);
    put_escaped(out, s->reason, &in_xml, SHOWS_ASCII);
    fputs(s->outcome == WELL ? "</system-out></testcase>\n" : "\"/></testcase>\n", out);
  }
  fputs("</testsuite>\n</testsuites>\n", out);
}

enum exit_code report_write(const struct series_list *list, const struct style *style, int format)
{
  struct file file;
  if (format != REPORT_JUNIT)
    return write_table(list, style);
  int error = file_open(&file, style->output);
  if (error == 0) {
    write_junit(file.stream, list);
    error = file_close(&file, true);
  }
  if (error != 0)
    complain("order", "cannot write %s: %s", style->output ? style->output : "standard output", file_error(error));
  return error == 0 ? EXIT_DONE : EXIT_FILE;
}

enum exit_code report_exit(const struct series_list *list, bool to_file)
{
  for (const struct series *s = list->series; to_file && s < list->series + list->count; s++)
    if (s->outcome == FAILED)
      complain("order", "%s: %s%s%s: %s: %s", s->file, s->name, *s->name ? ": " : "", s->y, s->verdict, s->reason);
  return list->outcomes[FAILED] == 0 ? EXIT_DONE : list->expects ? EXIT_CHECK_FAILED : EXIT_UNSOLVED;
}
