/* `order FILE`: the first byte chooses what is expected and the format, the rest is the file. A verdict of pass needs
 * an order that lies where it is expected, inside its interval, from at least three points; or errors that are all 0 or
 * noise. Every verdict has a reason, the summary counts the verdicts, and the exit code follows from it. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/fuzz/target.h"

enum { MOST = 24 };

/* The cells of a line, which ends where it is split: order, y, ... */
static int split(char *line, char *cells[MOST])
{
  for (int count = 1;; count++) {
    cells[count - 1] = line;
    line += strcspn(line, "\t");
    if (*line == '\0' || count == MOST)
      return count;
    *line++ = '\0';
  }
}

static const char *cell_named(char *const names[], char *const cells[], int count, const char *name)
{
  for (int i = 0; i < count; i++)
    if (strcmp(names[i], name) == 0)
      return cells[i];
  fuzz_fail("no column %s", name);
}

static void judge_row(char *const names[], char *const cells[], int count, const char *expect)
{
  const char *verdict = cell_named(names, cells, count, "verdict"), *reason = cell_named(names, cells, count, "reason");
  double order = strtod(cell_named(names, cells, count, "order"), NULL),
         low = strtod(cell_named(names, cells, count, "order_low"), NULL),
         high = strtod(cell_named(names, cells, count, "order_high"), NULL);
  int points = atoi(cell_named(names, cells, count, "points"));
  bool pass = strcmp(verdict, "pass") == 0, measured = strcmp(verdict, "measured") == 0;
  if (*reason == '\0')
    fuzz_fail("no reason for %s", verdict);
  if ((pass && !expect) || (measured && expect))
    fuzz_fail("verdict %s where %s is expected", verdict, expect ? expect : "nothing");
  if (strncmp(reason, "exact", 5) == 0 ? pass || measured : !pass && !measured)
    return;
  if (!(points >= 3 && isfinite(low) && isfinite(high) && low - 1e-4 <= order && order <= high + 1e-4))
    fuzz_fail("%s: order %g, from %g to %g, from %d points", verdict, order, low, high, points);
  if (pass && fabs(order - strtod(expect, NULL)) > 0.1001)
    fuzz_fail("pass for order %g where %s is expected", order, expect);
}

static void judge(char *table, int code, const char *expect)
{
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
      columns = split(line, names);
      continue;
    }
    if (split(line, cells) != columns)
      fuzz_fail("a row of other than %d cells", columns);
    judge_row(names, cells, columns, expect);
    const char *verdict = cell_named(names, cells, columns, "verdict");
    verdicts++;
    well += strcmp(verdict, expect ? "pass" : "measured") == 0;
    unread += strcmp(verdict, "error") == 0;
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
