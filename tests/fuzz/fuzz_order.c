/* `order FILE`: the first byte chooses what is expected and the format, the rest is the file. A verdict of pass needs an order that
 * lies where it is expected, with a finite interval around it, from at least three points, all of whose numbers are finite. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/fuzz/target.h"

struct fit {
  double order, lo, hi;
  int points;
  char state[24];
};

static struct fit read_fit(const char *table)
{
  struct fit fit = { .points = -1 };
  const char *line = strstr(table, "# order ");
  if (!line
      || sscanf(line, "# order %lf, 95 %% interval %lf to %lf, from %d points: %23s", &fit.order, &fit.lo, &fit.hi,
                &fit.points, fit.state)
             != 5)
    fuzz_fail("the table does not end with a fit: %s", table);
  return fit;
}

/* Rows that a fit has used, and whether every number that was read is finite */
static int used_rows(const char *table, bool *finite)
{
  int used = 0;
  double h, err;
  char pairwise[32], use[32];
  *finite = true;
  for (const char *line = table; *line; line = strchr(line, '\n') + 1) {
    if (sscanf(line, "%lf\t%lf\t%31s\t%31s", &h, &err, pairwise, use) != 4)
      continue;
    used += strcmp(use, "used") == 0;
    *finite = *finite && isfinite(h) && isfinite(err);
  }
  return used;
}

static void judge(const char *table, int code, bool expects, double expected)
{
  bool finite;
  struct fit fit = read_fit(table);
  int used = used_rows(table, &finite);
  bool fitted = strcmp(fit.state, "fitted") == 0, pass = expects && strstr(table, ": pass\n");
  if (fit.points != used && fit.points != 0)
    fuzz_fail("a fit from %d points where %d are used", fit.points, used);
  if (fitted
      && !(finite && fit.points >= 3 && isfinite(fit.lo) && isfinite(fit.hi) && fit.lo <= fit.order && fit.order <= fit.hi))
    fuzz_fail("order %g, from %g to %g, from %d points is called fitted", fit.order, fit.lo, fit.hi, fit.points);
  if (expects && pass != (code == EXIT_DONE))
    fuzz_fail("exit code %d with the verdict in\n%s", code, table);
  if (pass && !(fitted && fabs(fit.order - expected) <= 0.1001 && fit.hi - fit.lo <= 0.2002))
    fuzz_fail("pass for %s, order %g, from %g to %g, where %g is expected", fit.state, fit.order, fit.lo, fit.hi, expected);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
  static const char *const expected[] = { NULL, "1", "2", "4", "0", "-1" };
  if (size == 0)
    return 0;
  const char *expect = expected[data[0] % 6], *format = data[0] & 64 ? "tsv" : "json";
  bool json = *format == 'j';
  const char *const arguments[] = { fuzz_file(data + 1, size - 1), "--format", format,
                                    expect ? "--expect" : NULL,    expect,     NULL };
  struct written w;
  int code = fuzz_run(&command_order, arguments, &w);
  fuzz_judge_table(&w, code, json ? FORMAT_JSON : FORMAT_TSV);
  if (code == EXIT_FILE)
    fuzz_fail("exit code %d: %s", code, w.err);
  if (code != EXIT_USAGE && !json)
    judge(w.out, code, expect != NULL, expect ? strtod(expect, NULL) : 0);
  if (code != EXIT_USAGE && json && expect && (code == EXIT_DONE) != (strstr(w.out, "\"verdict\": \"pass\"") != NULL))
    fuzz_fail("exit code %d with the verdict in\n%s", code, w.out);
  written_free(&w);
  return 0;
}
