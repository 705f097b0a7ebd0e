#define _GNU_SOURCE
#include "tests/fuzz/target.h"

#include <regex.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static FILE *real_out, *real_err; /* while the names stand for memory */

void fuzz_fail(const char *format, ...)
{
  FILE *to = real_err ? real_err : stderr;
  va_list arguments;
  va_start(arguments, format);
  fputs("fuzz: ", to);
  vfprintf(to, format, arguments);
  fputc('\n', to);
  va_end(arguments);
  abort();
}

char *fuzz_text(const uint8_t *data, size_t size)
{
  char *text = malloc(size + 1);
  if (!text)
    fuzz_fail("out of memory");
  if (size > 0)
    memcpy(text, data, size);
  text[size] = '\0';
  return text;
}

/* One file without a name serves all inputs; /dev/fd gives it one. */
const char *fuzz_file(const uint8_t *data, size_t size)
{
  static char name[32];
  static FILE *file;
  if (!file) {
    file = tmpfile();
    if (!file)
      fuzz_fail("no temporary file");
    snprintf(name, sizeof name, "/dev/fd/%d", fileno(file));
  }
  rewind(file);
  if (ftruncate(fileno(file), 0) != 0 || fwrite(data, 1, size, file) < size || fflush(file) != 0)
    fuzz_fail("cannot write a temporary file");
  return name;
}

/* glibc's stdout and stderr are variables: what the toolkit prints there is wanted, and reports of the sanitizers,
 * which write to the descriptor, are not to get lost. */
void written_begin(struct written *w)
{
  *w = (struct written){ 0 };
  real_out = stdout;
  real_err = stderr;
  FILE *out = open_memstream(&w->out, &w->out_size), *err = open_memstream(&w->err, &w->err_size);
  if (!out || !err)
    fuzz_fail("out of memory");
  stdout = out;
  stderr = err;
}

void written_end(struct written *w)
{
  (void)w;
  fclose(stdout);
  fclose(stderr);
  stdout = real_out;
  stderr = real_err;
  real_out = real_err = NULL;
}

void written_end_read(struct written *w, int code)
{
  written_end(w);
  if (w->out_size > 0 || (w->err_size > 0) != (code != EXIT_DONE) || (code != EXIT_DONE && code != EXIT_USAGE))
    fuzz_fail("exit code %d, on standard output '%s', on standard error '%s'", code, w->out, w->err);
  written_free(w);
}

void written_free(struct written *w)
{
  free(w->out);
  free(w->err);
}

int fuzz_run(const struct command *command, const char *const *arguments, struct written *written)
{
  enum { MOST = 24 };
  char *list[MOST] = { (char *)"scallop", (char *)command->name };
  struct arguments read;
  enum exit_code code = EXIT_USAGE;
  int count = 2;
  for (; *arguments && count < MOST - 1; arguments++)
    list[count++] = (char *)*arguments; /* none has a '=' that would be written to */
  written_begin(written);
  if (options_read(&read, command, commands, count, list, &code) == READ_RUN)
    code = command_make(&read);
  options_free(&read);
  written_end(written);
  return (int)code;
}

/* ---- tables ---- */

static long count_cells(const char *line)
{
  long cells = 1;
  for (; *line != '\n'; line++)
    cells += *line == '\t';
  return cells;
}

static long judge_tsv(const char *text)
{
  long rows = -1, columns = 0;
  for (const char *line = text; *line; line = strchr(line, '\n') + 1) {
    if (!strchr(line, '\n'))
      fuzz_fail("the last line of the table has no end: %s", line);
    if (*line == '#')
      continue;
    if (rows++ < 0)
      columns = count_cells(line);
    else if (count_cells(line) != columns)
      fuzz_fail("a row has %ld columns where the header has %ld: %.300s", count_cells(line), columns, line);
  }
  return rows;
}

#define JSON_STRING "\"([^\"\\[:cntrl:]]|\\\\[\"\\/bfnrtu])*\""
#define JSON_NUMBER "-?(0|[1-9][0-9]*)([.][0-9]+)?([eE][-+]?[0-9]+)?"
#define JSON_PAIR JSON_STRING ": (" JSON_STRING "|null|" JSON_NUMBER ")"

/* Each line is an object of names and flat values. */
static long judge_json(const char *text)
{
  static regex_t object;
  static bool is_compiled;
  long rows = 0;
  if (!is_compiled && regcomp(&object, "^[{]" JSON_PAIR "(, " JSON_PAIR ")*[}]$", REG_EXTENDED | REG_NOSUB) != 0)
    fuzz_fail("out of memory");
  is_compiled = true;
  for (regmatch_t line; *text; text += line.rm_eo + 1, rows++) {
    line = (regmatch_t){ 0, (regoff_t)strcspn(text, "\n") };
    if (text[line.rm_eo] != '\n' || regexec(&object, text, 1, &line, REG_STARTEND) != 0)
      fuzz_fail("not JSON: %.300s", text);
  }
  return rows;
}

long fuzz_judge_table(const struct written *w, int code, enum format format)
{
  bool refused = code == EXIT_USAGE || code == EXIT_FILE;
  if (code < EXIT_DONE || code > EXIT_FILE)
    fuzz_fail("exit code %d", code);
  if (refused && (w->out_size > 0 || w->err_size == 0))
    fuzz_fail("exit code %d with %zu bytes of output and the message '%s'", code, w->out_size, w->err);
  if (strlen(w->out) != w->out_size)
    fuzz_fail("a NUL byte in the output");
  for (const char *c = w->out; *c; c++)
    if ((*c < 0x20 || *c > 0x7e) && *c != '\n' && *c != '\t')
      fuzz_fail("byte 0x%02x in the output: %.80s", (unsigned char)*c, c);
  return format == FORMAT_JSON ? judge_json(w->out) : judge_tsv(w->out);
}
