/* --points: the first byte chooses the command and the format, the rest is the file. Every row gets its row of output,
 * whatever it holds, and the exit code says whether one was refused. */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "tests/fuzz/target.h"

/* The lines of a file that are neither empty nor comments, counted apart from tsv.c; a header is one of them. Lines
 * without a letter and a digit may be rows or not: those with one are counted in *sure. */
static long data_lines(const uint8_t *data, size_t size, long *sure)
{
  const uint8_t mark[] = { 0xef, 0xbb, 0xbf };
  long lines = 0;
  size_t begin = size >= 3 && memcmp(data, mark, 3) == 0 ? 3 : 0;
  *sure = 0;
  while (begin < size) {
    size_t end = begin;
    bool has_text = false;
    for (; end < size && data[end] != '\n' && data[end] != '\r'; end++)
      has_text |= isalnum(data[end]) != 0;
    size_t first = begin;
    while (first < end && (data[first] == ' ' || data[first] == '\t'))
      first++;
    lines += end > begin && data[begin] != '#' && data[begin] != '%';
    *sure += has_text && data[first] != '#' && data[first] != '%';
    begin = end + 1;
  }
  return lines;
}

static const char *last_cell(const char *line, char cell[16])
{
  const char *end = strchr(line, '\n'), *at = end;
  while (at > line && at[-1] != '\t')
    at--;
  snprintf(cell, 16, "%.*s", (int)(end - at < 15 ? end - at : 15), at);
  return end + 1;
}

/* Rows whose status, the last column, tells of no answer */
static long unsolved_rows(const char *table)
{
  long unsolved = 0, rows = 0;
  for (char status[16]; *table;) {
    bool comment = *table == '#';
    table = last_cell(table, status);
    if (!comment && rows++ > 0)
      unsolved += strcmp(status, "ok") != 0 && strncmp(status, "interval", 8) != 0;
  }
  return unsolved;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
  static const struct {
    uint8_t choice;
    const struct command *command;
    const char *format;
  } ways[] = { { 's', &command_steady, "tsv" },  { 'p', &command_phase, "tsv" },  { 'e', &command_series, "tsv" },
               { 'S', &command_steady, "json" }, { 'P', &command_phase, "json" }, { 'E', &command_series, "json" } };
  enum { WAYS = sizeof ways / sizeof *ways };
  if (size == 0)
    return 0;
  int way = 0;
  while (way < WAYS && ways[way].choice != data[0])
    way++;
  way = way < WAYS ? way : data[0] % WAYS;
  bool json = strcmp(ways[way].format, "json") == 0;
  const char *const arguments[] = { "--points", fuzz_file(data + 1, size - 1), "--format", ways[way].format, NULL };
  struct written w;
  int code = fuzz_run(ways[way].command, arguments, &w);
  for (char *c = w.out; !json && *c; c++) /* what is carried along goes out byte for byte */
    if ((*c < 0x20 || *c > 0x7e) && *c != '\t' && *c != '\n' && memchr(data, *c, size))
      *c = '?';
  long rows = fuzz_judge_table(&w, code, json ? FORMAT_JSON : FORMAT_TSV), sure,
       lines = data_lines(data + 1, size - 1, &sure);
  bool read = code == EXIT_DONE || code == EXIT_UNSOLVED;
  if (!read && code != EXIT_USAGE)
    fuzz_fail("exit code %d: %s", code, w.err);
  if (read && (rows < sure - 1 || rows > lines)) /* the first line is the header, as a rule */
    fuzz_fail("%ld rows for %ld lines, %ld of them with text", rows, lines, sure);
  if (read && !json && (unsolved_rows(w.out) > 0) != (code == EXIT_UNSOLVED))
    fuzz_fail("exit code %d with %ld rows without an answer", code, unsolved_rows(w.out));
  written_free(&w);
  return 0;
}
