/* The readers of earlier tables: `workprec --from`, and the ledger of `claims --against`. The first byte chooses, the rest is the
 * file. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/claims/read.h"
#include "tests/fuzz/target.h"

/* Every ratio of a summary is a number > 0, or nan where somebody is missing. */
static void judge_ratios(const char *table)
{
  enum { RATIOS = 4 };
  static const int columns[RATIOS] = { 9, 12, 15, 18 };
  for (const char *line = table; *line; line = strchr(line, '\n') + 1) {
    const char *cell = line;
    if (*line == '#' || strncmp(line, "gait\tT\t", 7) == 0)
      continue;
    for (int column = 0, next = 0; next < RATIOS; column++, cell = strchr(cell, '\t') + 1)
      if (column == columns[next]) {
        next++;
        double ratio = strtod(cell, NULL);
        if (!isnan(ratio) && !(ratio > 0))
          fuzz_fail("the ratio in column %d is %g: %.200s", column + 1, ratio, line);
        if (next == RATIOS)
          break;
      }
  }
}

static void summarise(const uint8_t *data, size_t size, bool json)
{
  const char *const arguments[] = { "--from", fuzz_file(data, size), "--format", json ? "json" : "tsv", NULL };
  struct written w;
  int code = fuzz_run(&command_workprec, arguments, &w);
  fuzz_judge_table(&w, code, json ? FORMAT_JSON : FORMAT_TSV);
  if (code != EXIT_DONE && code != EXIT_USAGE)
    fuzz_fail("exit code %d: %s", code, w.err);
  if (code == EXIT_DONE && !json)
    judge_ratios(w.out);
  written_free(&w);
}

static void read_ledger(const uint8_t *data, size_t size)
{
  struct committed_ledger ledger;
  struct written w;
  written_begin(&w);
  enum exit_code code = committed_read(&ledger, fuzz_file(data, size));
  written_end(&w);
  if (code != EXIT_DONE && !(code == EXIT_USAGE && w.err_size > 0))
    fuzz_fail("exit code %d: %s", (int)code, w.err);
  for (int i = 0; code == EXIT_DONE && i < ledger.count; i++) {
    const struct committed *row = &ledger.rows[i];
    const char *cells[COMMITTED_KEYS + 2] = { row->verdict, row->order };
    memcpy(cells + 2, row->key, sizeof row->key);
    for (int k = 0; k < COMMITTED_KEYS + 2; k++)
      if (cells[k] < row->line || cells[k] > row->line + size || cells[k] + strlen(cells[k]) > row->line + size)
        fuzz_fail("cell %d of row %d is none of its line", k, i);
  }
  committed_free(&ledger);
  written_free(&w);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
  if (size == 0)
    return 0;
  if (data[0] % 3 == 0)
    read_ledger(data + 1, size - 1);
  else
    summarise(data + 1, size - 1, data[0] % 3 == 1);
  return 0;
}
