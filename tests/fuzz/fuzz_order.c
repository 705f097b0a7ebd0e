/* `order FILE`: the first byte chooses what is expected and the format, the rest is the file. A verdict of pass needs
 * an order that lies where it is expected, inside its interval, from at least three points; or errors that are all 0 or
 * noise. Every verdict has a reason, the summary counts the verdicts, and the exit code follows from it. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/fuzz/target.h"

struct row {
  double order, low, high;
  int points;
  char verdict[24];
};

/* The cells of a line, split in place: name, y, ... */
static int split(char *line, char *cells[], int most)
{
  int count = 0;
  for (char *cell = line; cell && count < most; count++) {
    cells[count] = cell;
    cell = strchr(cell, '\t');
    if (cell)
      *cell++ = '\0';
  }
  return count;
}

static int column(char *const cells[], int count, const char *name)
{
  for (int i = 0; i < count; i++)
    if (strcmp(cells[i], name) == 0)
      return i;
  fuzz_fail("no column %s", name);
}

static void judge_row(const struct row *r, const char *reason, const char *expect)
{
  bool pass = strcmp(r->verdict, "pass") == 0, measured = strcmp(r->verdict, "measured") == 0;
  if (*reason == '\0')
    fuzz_fail("no reason for %s", r->verdict);
  if ((pass && !expect) || (measured && expect))
    fuzz_fail("verdict %s where %s is expected", r->verdict, expect ? expect : "nothing");
  if (strncmp(reason, "exact", 5) == 0 ? pass || measured : !pass && !measured)
    return;
  if (!(r->points >= 3 && isfinite(r->low) && isfinite(r->high) && r->low - 1e-4 <= r->order
        && r->order <= r->high + 1e-4))
    fuzz_fail("%s: order %g, from %g to %g, from %d points", r->verdict, r->order, r->low, r->high, r->points);
  if (pass && fabs(r->order - strtod(expect, NULL)) > 0.1001)
    fuzz_fail("pass for order %g where %s is expected", r->order, expect);
}

static void judge(char *table, int code, const char *expect)
{
  enum { MOST = 24 };
  char *cells[MOST], *names[MOST], *next = NULL;
  int columns = 0, verdicts = 0, well = 0, unread = 0, counted[3];
  for (char *line = table; line && *line; line = next) {
    next = strchr(line, '\n');
    if (next)
      *next++ = '\0';
    const char *counts = expect ? "# %d table%*1[s:]%*[: ]%d passed, %d failed"
                                : "# %d table%*1[s:]%*[: ]%d measured, %d not";
    if (sscanf(line, counts, &counted[0], &counted[1], &counted[2]) == 3) {
      if (counted[0] != verdicts || counted[1] != well || counted[1] + counted[2] + unread != verdicts)
        fuzz_fail("%d verdicts, %d as they should be, %d not read, and: %s", verdicts, well, unread, line);
      if ((code == EXIT_DONE) != ((expect ? counted[2] : 0) + unread == 0))
        fuzz_fail("exit code %d, and: %s", code, line);
      return;
    }
    if (*line == '#')
      continue;
    if (columns == 0) {
      columns = split(line, names, MOST);
      continue;
    }
    if (split(line, cells, MOST) != columns)
      fuzz_fail("a row of other than %d cells", columns);
    struct row r = { strtod(cells[column(names, columns, "order")], NULL),
                     strtod(cells[column(names, columns, "order_low")], NULL),
                     strtod(cells[column(names, columns, "order_high")], NULL), atoi(cells[column(names, columns, "points")]),
                     "" };
    snprintf(r.verdict, sizeof r.verdict, "%s", cells[column(names, columns, "verdict")]);
    judge_row(&r, cells[column(names, columns, "reason")], expect);
    verdicts++;
    well += strcmp(r.verdict, expect ? "pass" : "measured") == 0;
    unread += strcmp(r.verdict, "error") == 0;
  }
  fuzz_fail("the table does not end with a summary");
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
  static const char *const expected[] = { NULL, "1", "2", "4", "0", "-1" };
  static const char *const formats[] = { "json", "tsv", "tap", "junit", "markdown", "rows" };
  if (size == 0)
    return 0;
  const char *expect = expected[data[0] % 6],
             *format = data[0] & 64 ? "tsv" : formats[data[0] / 128 * (data[0] / 6 % 6)];
  bool json = strcmp(format, "json") == 0, tsv = strcmp(format, "tsv") == 0, rows = strcmp(format, "rows") == 0;
  const char *arguments[8] = { fuzz_file(data + 1, size - 1) };
  int count = 1;
  if (expect) {
    arguments[count++] = "--expect";
    arguments[count++] = expect;
  }
  arguments[count++] = rows ? "--rows" : "--format";
  if (!rows)
    arguments[count++] = format;
  struct written w;
  int code = fuzz_run(&command_order, arguments, &w);
  if (code == EXIT_USAGE && w.err_size == 0)
    fuzz_fail("exit code %d without a message", code);
  if (json || tsv || rows) /* a file that is no table is a row of a good one */
    fuzz_judge_table(&w, code == EXIT_USAGE ? EXIT_UNSOLVED : code, json ? FORMAT_JSON : FORMAT_TSV);
  if (code == EXIT_FILE)
    fuzz_fail("exit code %d: %s", code, w.err);
  if (tsv)
    judge(w.out, code, expect);
  if (code == EXIT_DONE && json && expect && !strstr(w.out, "\"verdict\": \"pass\""))
    fuzz_fail("exit code %d with the verdict in\n%s", code, w.out);
  if (code == EXIT_CHECK_FAILED && strcmp(format, "junit") == 0 && !strstr(w.out, "<failure "))
    fuzz_fail("exit code %d without a failure in\n%s", code, w.out);
  written_free(&w);
  return 0;
}
