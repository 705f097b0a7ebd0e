#include "compare/order/report.h"

#include <errno.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

const char *const report_formats[] = { "tsv", "json", "csv", "markdown", "table", "junit", NULL };

/* What a table is counted as: judged well, judged otherwise, or not read. Where no order was expected none passes:
 * well is measured. */
enum outcome { WELL, FAILED, UNREAD, OUTCOMES };

static bool expects(const struct report *r) { return !isnan(r->wanted->order); }

static enum outcome outcome_of(const struct report *r, const struct series *s)
{
  enum scallop_order_verdict well = expects(r) ? SCALLOP_ORDER_PASS : SCALLOP_ORDER_MEASURED;
  return s->unread ? UNREAD : s->result.verdict == well ? WELL : FAILED;
}

static bool has_failed(const struct report *r, const struct series *s) { return outcome_of(r, s) != WELL; }

static const char *verdict_of(const struct series *s)
{
  return s->unread ? "error" : scallop_order_verdict_text(s->result.verdict);
}

static int count_of(const struct report *r, enum outcome outcome)
{
  int count = 0;
  for (int i = 0; i < r->list->count; i++)
    count += outcome_of(r, &r->list->series[i]) == outcome;
  return count;
}

/* "1 passed, 0 failed", and how many could not be read */
static const char *counts_of(const struct report *r)
{
  static char text[100];
  int unread = count_of(r, UNREAD);
  int used = snprintf(text, sizeof text, "%d %s, %d failed", count_of(r, WELL), expects(r) ? "passed" : "measured",
                      count_of(r, FAILED));
  if (unread > 0)
    snprintf(text + used, sizeof text - (size_t)used, ", %d not read", unread);
  return text;
}

enum exit_code report_exit(const struct report *r)
{
  for (const struct series *s = r->list->series; r->style->output && s < r->list->series + r->list->count; s++)
    if (outcome_of(r, s) == FAILED)
      complain(r->style->command, "%s: %s%s%s: %s: %s", s->file, s->name, *s->name ? ": " : "", s->y, verdict_of(s),
               s->result.reason);
  return count_of(r, FAILED) == 0 ? EXIT_DONE : expects(r) ? EXIT_CHECK_FAILED : EXIT_UNSOLVED;
}

static const char *test_of(const struct report *r)
{
  return !expects(r) ? "none" : r->wanted->at_least ? "at-least" : "equal";
}

/* A row for each series */
struct verdict_row {
  struct series of;
  const char *interval, *test, *verdict, *reason;
  double expected, tolerance;
};
#define AT(member) offsetof(struct verdict_row, member)
static const struct table_column order_columns[] = {
  { TABLE_COLUMN("file", column_text, AT(of.file)) },
  { TABLE_COLUMN("series", column_text, AT(of.name)) },
  { TABLE_COLUMN("y", column_text, AT(of.y)) },
  { TABLE_COLUMN("order", column_rounded, AT(of.result.order)), .format = "%.4f" },
  { TABLE_COLUMN("low", column_rounded, AT(of.result.low)), .format = "%.4f" },
  { TABLE_COLUMN("high", column_rounded, AT(of.result.high)), .format = "%.4f" },
  { TABLE_COLUMN("interval", column_text, AT(interval)) },
  { TABLE_COLUMN("points", column_count, AT(of.result.used)) },
  { .name = NULL },
};
static const struct table_column grid_columns[] = {
  { TABLE_COLUMN("gci", column_number, AT(of.result.gci)) },
  { TABLE_COLUMN("asymptotic_ratio", column_number, AT(of.result.asymptotic_ratio)) },
  { .name = NULL },
};
static const struct table_column verdict_columns[] = {
  { TABLE_COLUMN("test", column_text, AT(test)) },
  { TABLE_COLUMN("expected", column_number, AT(expected)) },
  { TABLE_COLUMN("tolerance", column_number, AT(tolerance)) },
  { TABLE_COLUMN("verdict", column_text, AT(verdict)) },
  { TABLE_COLUMN("reason", column_text, AT(reason)) },
  { .name = NULL },
};
#undef AT

static void write_counts(struct table *t, const struct report *r)
{
  const char *const counts[] = { "tables", expects(r) ? "passed" : "measured", "failed", "errors", NULL };
  table_note(t, "%d %s: %s", r->list->count, r->list->count == 1 ? "table" : "tables", counts_of(r));
  if (!table_begin_anew(t))
    return;
  table_columns(t, counts);
  table_count(t, r->list->count);
  for (int outcome = 0; outcome < OUTCOMES; outcome++)
    table_count(t, count_of(r, (enum outcome)outcome));
}

static enum exit_code write_table(const struct report *r)
{
  struct table t;
  bool grids = false;
  for (int i = 0; i < r->list->count; i++)
    grids = grids || r->list->series[i].values;
  const struct table_column *const parts[] = { order_columns, grids ? grid_columns : &grid_columns[2],
                                               verdict_columns };
  if (!table_head(&t, r->style, "order"))
    return EXIT_FILE;
  for (int part = 0; part < 3; part++)
    table_add(&t, parts[part]);
  table_begin_rows(&t);
  for (const struct series *s = r->list->series; s < r->list->series + r->list->count; s++) {
    const struct verdict_row row = { *s,
                                     scallop_order_interval_text(s->result.interval),
                                     test_of(r),
                                     verdict_of(s),
                                     s->result.reason,
                                     r->wanted->order,
                                     r->wanted->tolerance };
    for (int part = 0; part < 3; part++)
      table_row(&t, parts[part], &row, true);
  }
  write_counts(&t, r);
  return table_close(&t) ? EXIT_DONE : EXIT_FILE;
}

/* A row for each of theirs */
struct point_row {
  struct series of;
  struct scallop_order_point point;
  const char *use;
};
#define AT(member) offsetof(struct point_row, member)
static const struct table_column point_columns[] = {
  { TABLE_COLUMN("file", column_text, AT(of.file)) },
  { TABLE_COLUMN("series", column_text, AT(of.name)) },
  { TABLE_COLUMN("y", column_text, AT(of.y)) },
  { TABLE_COLUMN("row", column_long, AT(point.row)) },
  { TABLE_COLUMN("h", column_number, AT(point.h)) },
  { TABLE_COLUMN("err", column_number, AT(point.err)) },
  { TABLE_COLUMN("pairwise", column_rounded, AT(point.pairwise)), .format = "%.4f" },
  { TABLE_COLUMN("use", column_text, AT(use)) },
  { .name = NULL },
};
#undef AT

static enum exit_code write_rows(const struct report *r, const char *output)
{
  struct style style = *r->style;
  struct table t;
  style.output = output;
  if (!table_head(&t, &style, "order"))
    return EXIT_FILE;
  table_add(&t, point_columns);
  table_begin_rows(&t);
  for (const struct series *s = r->list->series; s < r->list->series + r->list->count; s++)
    for (int i = 0; i < s->count; i++) {
      struct point_row row = { *s, s->points[i], scallop_order_use_text(s->points[i].use) };
      if (s->result.verdict == SCALLOP_ORDER_INVALID) {
        row.point.pairwise = NAN;
        row.use = "-";
      }
      table_row(&t, point_columns, &row, true);
    }
  return table_close(&t) ? EXIT_DONE : EXIT_FILE;
}

enum exit_code report_write_rows(const struct report *r) { return write_rows(r, r->style->output); }

enum exit_code report_draw(const struct report *r) { return write_rows(r, "/dev/null"); }

static void write_junit(FILE *out, const struct report *r)
{
  char counts[100];
  snprintf(counts, sizeof counts, "tests=\"%d\" failures=\"%d\" errors=\"%d\"", r->list->count, count_of(r, FAILED),
           count_of(r, UNREAD));
  fprintf(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites %s>\n", counts);
  fprintf(out, "<testsuite name=\"scallop order\" %s skipped=\"0\">\n", counts);
  for (const struct series *s = r->list->series; s < r->list->series + r->list->count; s++) {
    fputs("<testcase classname=\"", out);
    put_escaped(out, s->file, &in_xml, SHOWS_ASCII);
    fputs("\" name=\"", out);
    const char *const name[] = { s->file, s->name, s->y };
    for (int i = 0; i < 3; i++) {
      fputs(i > 0 && *name[i] ? ": " : "", out);
      put_escaped(out, name[i], &in_xml, SHOWS_ASCII);
    }
    fputs("\">", out);
    if (has_failed(r, s))
      fprintf(out, "<%s type=\"%s\" message=\"", s->unread ? "error" : "failure", verdict_of(s));
    else
      fputs("<system-out>", out);
    put_escaped(out, s->result.reason, &in_xml, SHOWS_ASCII);
    fputs(has_failed(r, s) ? "\"/></testcase>\n" : "</system-out></testcase>\n", out);
  }
  fputs("</testsuite>\n</testsuites>\n", out);
}

enum exit_code report_write(const struct report *r)
{
  struct file file;
  if (r->format != REPORT_JUNIT)
    return write_table(r);
  int error = file_open(&file, r->style->output);
  if (error == 0) {
    write_junit(file.stream, r);
    bool written = !ferror(file.stream);
    error = file_close(&file, written);
    error = error == 0 && !written ? EIO : error;
  }
  if (error != 0)
    complain(r->style->command, "cannot write %s: %s", r->style->output ? r->style->output : "standard output",
             file_error(error));
  return error == 0 ? EXIT_DONE : EXIT_FILE;
}
