/* `order FILE`: the first byte chooses what is expected and the format, the rest is the file. A verdict of pass needs an order that
 * lies where it is expected, with a finite interval around it, from at least three points, all of whose numbers are finite; or errors that
 * are all 0 or noise. Of several series each has to pass. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/fuzz/target.h"

struct fit {
  double order, lo, hi;
  int points;
  char state[24];
};

/* The fit of one series: line begins with "# order " */
static struct fit read_fit(const char *line)
{
  struct fit fit = { .points = -1 };
  if (sscanf(line, "# order %lf, 95 %% interval %lf to %lf, from %d points: %23s", &fit.order, &fit.lo, &fit.hi, &fit.points,
             fit.state)
      != 5)
    fuzz_fail("no fit: %s", line);
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

/* Of the only series: as many points as rows say that they are used; errors that are all 0, or noise, are exact and none is used. */
static void judge_rows(const char *table, const struct fit *fit, bool fitted)
{
  bool finite;
  int used = used_rows(table, &finite);
  if (fit->points != used && fit->points != 0)
    fuzz_fail("a fit from %d points where %d are used", fit->points, used);
  if (strcmp(fit->state, "exact") == 0 && used > 0)
    fuzz_fail("exact, with %d points used", used);
  if (fitted && !finite)
    fuzz_fail("order %g from numbers that are not finite", fit->order);
}

static void judge_fit(const struct fit *fit, bool fitted, bool pass, double expected)
{
  if (fitted
      && !(fit->points >= 3 && isfinite(fit->lo) && isfinite(fit->hi) && fit->lo <= fit->order && fit->order <= fit->hi))
    fuzz_fail("order %g, from %g to %g, from %d points is called fitted", fit->order, fit->lo, fit->hi, fit->points);
  bool met = fitted && fabs(fit->order - expected) <= 0.1001 && fit->hi - fit->lo <= 0.2002;
  if (pass && !met && strcmp(fit->state, "exact") != 0)
    fuzz_fail("pass for %s, order %g, from %g to %g, where %g is expected", fit->state, fit->order, fit->lo, fit->hi,
              expected);
}

static void judge(const char *table, int code, bool expects, double expected)
{
  int fits = 0, passes = 0;
  for (const char *line = table; (line = strstr(line, "\n# order ")); line++, fits++) {
    struct fit fit = read_fit(line + 1);
    const char *verdict = strchr(line + 1, '\n') + 1, *end = strchr(verdict, '\n');
    bool fitted = strcmp(fit.state, "fitted") == 0;
    bool pass = expects && end && end - verdict > 6 && strncmp(end - 6, ": pass", 6) == 0;
    judge_fit(&fit, fitted, pass, expected);
    if (!strstr(table, "\n# series: "))
      judge_rows(table, &fit, fitted);
    passes += pass;
  }
  if (fits == 0)
    fuzz_fail("the table does not end with a fit: %s", table);
  if (expects && (passes == fits) != (code == EXIT_DONE))
    fuzz_fail("exit code %d with %d of %d verdicts passed in\n%s", code, passes, fits, table);
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
  if (code == EXIT_DONE && json && expect && !strstr(w.out, "\"verdict\": \"pass\""))
    fuzz_fail("exit code %d with the verdict in\n%s", code, w.out);
  written_free(&w);
  return 0;
}
