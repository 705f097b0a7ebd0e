#include "compare/order/report.h"

#include <errno.h>
#include <math.h>
#include <string.h>

#include "model/version.h"

const char *const report_formats[] = { "tsv", "json", "csv", "markdown", "table", "tap", "junit", NULL };

static bool has_failed(const struct report *r, const struct series *s)
{
  return isnan(r->wanted->order) ? s->result.verdict == SCALLOP_ORDER_INVALID : s->result.verdict != SCALLOP_ORDER_PASS;
}

int report_failed(const struct report *r)
{
  int failed = 0;
  for (int i = 0; i < r->list->count; i++)
    failed += has_failed(r, &r->list->series[i]);
  return failed;
}

static const char *test_of(const struct report *r)
{
  return isnan(r->wanted->order) ? "none" : r->wanted->at_least ? "at-least" : "equal";
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
  table_text(t, scallop_order_verdict_text(v->verdict));
  table_text(t, v->reason);
}

static void write_counts(struct table *t, const struct report *r)
{
  static const char *const counts[] = { "tables", "passed", "failed", NULL };
  int failed = report_failed(r);
  if (t->format != FORMAT_JSON) {
    table_note(t, "%d %s: %d passed, %d failed", r->list->count, r->list->count == 1 ? "table" : "tables",
               r->list->count - failed, failed);
    return;
  }
  if (t->choice) /* of the columns of the verdicts */
    return;
  t->count = 0;
  table_columns(t, counts);
  table_rounded(t, r->list->count, "%.0f");
  table_rounded(t, r->list->count - failed, "%.0f");
  table_rounded(t, failed, "%.0f");
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

/* Text in which what means something to the format is written otherwise; what is no printable ASCII becomes '?' */
static void put(FILE *out, const char *text, const char *special, const char *const *instead)
{
  for (; *text; text++) {
    const char *found = strchr(special, *text);
    if (found)
      fputs(instead[found - special], out);
    else
      putc(*text >= 0x20 && *text <= 0x7e ? *text : '?', out);
  }
}

static void put_xml(FILE *out, const char *text)
{
  static const char *const entities[] = { "&amp;", "&lt;", "&gt;", "&quot;" };
  put(out, text, "&<>\"", entities);
}
static void put_tap(FILE *out, const char *text)
{
  static const char *const escaped[] = { "\\#", "\\\\" };
  put(out, text, "#\\", escaped);
}
static void put_quoted(FILE *out, const char *text)
{
  static const char *const escaped[] = { "\\\"", "\\\\" };
  put(out, text, "\"\\", escaped);
}
static void put_cell(FILE *out, const char *text)
{
  static const char *const escaped[] = { "\\|", "\\\\", "&lt;", "\\`", "\\*", "\\_" };
  put(out, text, "|\\<`*_", escaped);
}

/* "file: series: y" */
static void put_name(FILE *out, const struct series *s, void (*put_text)(FILE *, const char *))
{
  put_text(out, s->file);
  fputs(": ", out);
  if (*s->name) {
    put_text(out, s->name);
    fputs(": ", out);
  }
  put_text(out, s->y);
}

static void write_tap(FILE *out, const struct report *r)
{
  fprintf(out, "TAP version 13\n1..%d\n", r->list->count);
  for (int i = 0; i < r->list->count; i++) {
    const struct series *s = &r->list->series[i];
    fprintf(out, "%s %d - ", has_failed(r, s) ? "not ok" : "ok", i + 1);
    put_name(out, s, put_tap);
    fprintf(out, "\n  ---\n  verdict: %s\n  order: %.4f\n  low: %.4f\n  high: %.4f\n  interval: %s\n  reason: \"",
            scallop_order_verdict_text(s->result.verdict), s->result.order, s->result.low, s->result.high,
            scallop_order_interval_text(s->result.interval));
    put_quoted(out, s->result.reason);
    fputs("\"\n  ...\n", out);
  }
  fprintf(out, "# passed %d, failed %d\n", r->list->count - report_failed(r), report_failed(r));
}

static void write_junit(FILE *out, const struct report *r)
{
  fprintf(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites tests=\"%d\" failures=\"%d\" errors=\"0\">\n",
          r->list->count, report_failed(r));
  fprintf(out, "<testsuite name=\"scallop order\" tests=\"%d\" failures=\"%d\" errors=\"0\" skipped=\"0\">\n",
          r->list->count, report_failed(r));
  for (const struct series *s = r->list->series; s < r->list->series + r->list->count; s++) {
    fputs("<testcase classname=\"", out);
    put_xml(out, s->file);
    fputs("\" name=\"", out);
    put_name(out, s, put_xml);
    fputs("\">", out);
    if (has_failed(r, s))
      fprintf(out, "<failure type=\"%s\" message=\"", scallop_order_verdict_text(s->result.verdict));
    else
      fputs("<system-out>", out);
    put_xml(out, s->result.reason);
    fputs(has_failed(r, s) ? "\"/></testcase>\n" : "</system-out></testcase>\n", out);
  }
  fputs("</testsuite>\n</testsuites>\n", out);
}

static void write_markdown(FILE *out, const struct report *r)
{
  fputs("| verdict | table | order | from | to | interval | reason |\n|---|---|---|---|---|---|---|\n", out);
  for (const struct series *s = r->list->series; s < r->list->series + r->list->count; s++) {
    const struct scallop_order_result *v = &s->result;
    fprintf(out, has_failed(r, s) ? "| **%s** | " : "| %s | ", scallop_order_verdict_text(v->verdict));
    put_name(out, s, put_cell);
    fprintf(out, " | %.4f | %.4f | %.4f | %s | ", v->order, v->low, v->high, scallop_order_interval_text(v->interval));
    put_cell(out, v->reason);
    fputs(" |\n", out);
  }
  fprintf(out, "\n%d passed, %d failed.\n", r->list->count - report_failed(r), report_failed(r));
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
    complain(r->style->command, "cannot write %s: %s", name, strerror(error));
  return error == 0 ? EXIT_DONE : EXIT_FILE;
}
