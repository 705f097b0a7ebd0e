#include "compare/order/report.h"

#include <errno.h>
#include <math.h>
#include <string.h>

#include "model/version.h"

const char *const report_formats[] = { "tsv", "json", "csv", "markdown", "table", "tap", "junit", NULL };

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

static void write_verdict(struct table *t, const struct report *r, const struct series *s, bool grids)
{
  const struct scallop_order_result *v = &s->result;
  const double interval[] = { v->order, v->low, v->high };
  table_text(t, s->file);
  table_text(t, s->name);
  table_text(t, s->y);
  for (int i = 0; i < 3; i++)
    table_rounded(t, interval[i], "%.4f");
  table_text(t, scallop_order_interval_text(v->interval));
  table_rounded(t, v->used, "%.0f");
  if (grids) {
    table_number(t, v->gci);
    table_number(t, v->asymptotic_ratio);
  }
  table_text(t, test_of(r));
  table_number(t, r->wanted->order);
  table_number(t, r->wanted->tolerance);
  table_text(t, verdict_of(s));
  table_text(t, v->reason);
}

static void write_counts(struct table *t, const struct report *r)
{
  const char *const counts[] = { "tables", expects(r) ? "passed" : "measured", "failed", "errors", NULL };
  if (t->format != FORMAT_JSON) {
    table_note(t, "%d %s: %s", r->list->count, r->list->count == 1 ? "table" : "tables", counts_of(r));
    return;
  }
  if (t->choice) /* of the columns of the verdicts */
    return;
  t->count = 0;
  table_columns(t, counts);
  table_rounded(t, r->list->count, "%.0f");
  for (int outcome = 0; outcome < OUTCOMES; outcome++)
    table_rounded(t, count_of(r, (enum outcome)outcome), "%.0f");
}

static enum exit_code write_table(const struct report *r)
{
  static const char *const first[] = { "file", "series", "y", "order", "low", "high", "interval", "points", NULL };
  static const char *const grid[] = { "gci", "asymptotic_ratio", NULL };
  static const char *const last[] = { "test", "expected", "tolerance", "verdict", "reason", NULL };
  struct table t;
  bool grids = false;
  for (int i = 0; i < r->list->count; i++)
    grids = grids || r->list->series[i].values;
  if (!table_open(&t, r->style))
    return EXIT_FILE;
  table_note(&t, "scallop " SCALLOP_VERSION);
  table_note(&t, "command: order");
  table_columns(&t, first);
  if (grids)
    table_columns(&t, grid);
  table_columns(&t, last);
  table_begin_rows(&t);
  for (int i = 0; i < r->list->count; i++)
    write_verdict(&t, r, &r->list->series[i], grids);
  write_counts(&t, r);
  return table_close(&t) ? EXIT_DONE : EXIT_FILE;
}

static enum exit_code write_rows(const struct report *r, const char *output)
{
  static const char *const columns[] = { "file", "series", "y", "row", "h", "err", "pairwise", "use", NULL };
  struct table t;
  if (!table_open_at(&t, r->style, output))
    return EXIT_FILE;
  table_note(&t, "scallop " SCALLOP_VERSION);
  table_note(&t, "command: order");
  table_columns(&t, columns);
  table_begin_rows(&t);
  for (const struct series *s = r->list->series; s < r->list->series + r->list->count; s++)
    for (const struct scallop_order_point *p = s->points; p < s->points + s->count; p++) {
      bool judged = s->result.verdict != SCALLOP_ORDER_INVALID;
      table_text(&t, s->file);
      table_text(&t, s->name);
      table_text(&t, s->y);
      table_rounded(&t, (double)p->row, "%.0f");
      table_number(&t, p->h);
      table_number(&t, p->err);
      table_rounded(&t, judged ? p->pairwise : NAN, "%.4f");
      table_text(&t, judged ? scallop_order_use_text(p->use) : "-");
    }
  return table_close(&t) ? EXIT_DONE : EXIT_FILE;
}

enum exit_code report_write_rows(const struct report *r) { return write_rows(r, r->style->output); }

enum exit_code report_draw(const struct report *r) { return write_rows(r, "/dev/null"); }

/* What means something to a format, and what is written instead */
struct escapes {
  const char *special, *instead[7];
};
static const struct escapes in_xml = { "&<>\"", { "&amp;", "&lt;", "&gt;", "&quot;" } },
                            in_tap = { "#\\", { "\\#", "\\\\" } }, in_quotes = { "\"\\", { "\\\"", "\\\\" } },
                            in_cell = { "|\\<`*_", { "\\|", "\\\\", "&lt;", "\\`", "\\*", "\\_" } };

/* What is no printable ASCII becomes '?'. */
static void put(FILE *out, const char *text, const struct escapes *escapes)
{
  for (; *text; text++) {
    const char *found = strchr(escapes->special, *text);
    if (found)
      fputs(escapes->instead[found - escapes->special], out);
    else
      putc(*text >= 0x20 && *text <= 0x7e ? *text : '?', out);
  }
}

/* "file: series: y" */
static void put_name(FILE *out, const struct series *s, const struct escapes *escapes)
{
  const char *const parts[] = { s->name, s->y };
  put(out, s->file, escapes);
  for (int i = 0; i < 2; i++)
    if (*parts[i]) {
      fputs(": ", out);
      put(out, parts[i], escapes);
    }
}

static void write_tap(FILE *out, const struct report *r)
{
  fprintf(out, "TAP version 13\n1..%d\n", r->list->count);
  for (int i = 0; i < r->list->count; i++) {
    const struct series *s = &r->list->series[i];
    fprintf(out, "%s %d - ", has_failed(r, s) ? "not ok" : "ok", i + 1);
    put_name(out, s, &in_tap);
    fprintf(out, "\n  ---\n  verdict: %s\n  order: %.4f\n  low: %.4f\n  high: %.4f\n  interval: %s\n  reason: \"",
            verdict_of(s), s->result.order, s->result.low, s->result.high,
            scallop_order_interval_text(s->result.interval));
    put(out, s->result.reason, &in_quotes);
    fputs("\"\n  ...\n", out);
  }
  fprintf(out, "# %s\n", counts_of(r));
}

static void write_junit(FILE *out, const struct report *r)
{
  char counts[100];
  snprintf(counts, sizeof counts, "tests=\"%d\" failures=\"%d\" errors=\"%d\"", r->list->count, count_of(r, FAILED),
           count_of(r, UNREAD));
  fprintf(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites %s>\n", counts);
  fprintf(out, "<testsuite name=\"scallop order\" %s skipped=\"0\">\n", counts);
  for (const struct series *s = r->list->series; s < r->list->series + r->list->count; s++) {
    fputs("<testcase classname=\"", out);
    put(out, s->file, &in_xml);
    fputs("\" name=\"", out);
    put_name(out, s, &in_xml);
    fputs("\">", out);
    if (has_failed(r, s))
      fprintf(out, "<%s type=\"%s\" message=\"", s->unread ? "error" : "failure", verdict_of(s));
    else
      fputs("<system-out>", out);
    put(out, s->result.reason, &in_xml);
    fputs(has_failed(r, s) ? "\"/></testcase>\n" : "</system-out></testcase>\n", out);
  }
  fputs("</testsuite>\n</testsuites>\n", out);
}

static void write_markdown(FILE *out, const struct report *r)
{
  fputs("| verdict | table | order | from | to | interval | reason |\n|---|---|---|---|---|---|---|\n", out);
  for (const struct series *s = r->list->series; s < r->list->series + r->list->count; s++) {
    const struct scallop_order_result *v = &s->result;
    fprintf(out, has_failed(r, s) ? "| **%s** | " : "| %s | ", verdict_of(s));
    put_name(out, s, &in_cell);
    fprintf(out, " | %.4f | %.4f | %.4f | %s | ", v->order, v->low, v->high, scallop_order_interval_text(v->interval));
    put(out, v->reason, &in_cell);
    fputs(" |\n", out);
  }
  fprintf(out, "\n%s.\n", counts_of(r));
}

enum exit_code report_write(const struct report *r)
{
  static void (*const writers[])(FILE *, const struct report *) = {
    [REPORT_TAP] = write_tap, [REPORT_JUNIT] = write_junit, [FORMAT_MARKDOWN] = write_markdown
  };
  if (r->format < FORMATS && r->format != FORMAT_MARKDOWN)
    return write_table(r);
  const char *output = r->style->output, *name = output ? output : "standard output";
  struct file file;
  int error = file_open(&file, output);
  if (error == 0) {
    writers[r->format](file.stream, r);
    bool written = !ferror(file.stream);
    error = file_close(&file, written);
    error = error == 0 && !written ? EIO : error;
  }
  if (error != 0)
    complain(r->style->command, "cannot write %s: %s", name, file_error(error));
  return error == 0 ? EXIT_DONE : EXIT_FILE;
}
