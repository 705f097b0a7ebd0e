#define _GNU_SOURCE
#include "tests/fuzz/target.h"

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

/* ---- JSON ---- */

static const char *json_string(const char *at)
{
  if (*at++ != '"')
    return NULL;
  for (; *at != '"'; at++) {
    if (*at == '\\')
      at++;
    if (*at < 0x20 || *at > 0x7e)
      return NULL;
  }
  return at + 1;
}

static const char *json_digits(const char *at) { return at + strspn(at, "0123456789"); }

static const char *json_number(const char *at)
{
  at += *at == '-';
  const char *whole = at;
  at = json_digits(at);
  if (at == whole || (*whole == '0' && at > whole + 1))
    return NULL;
  if (*at == '.') {
    const char *places = ++at;
    at = json_digits(at);
    if (at == places)
      return NULL;
  }
  if (*at == 'e' || *at == 'E') {
    at += at[1] == '-' || at[1] == '+' ? 2 : 1;
    const char *exponent = at;
    at = json_digits(at);
    if (at == exponent)
      return NULL;
  }
  return at;
}

static const char *json_value(const char *at)
{
  return *at == '"' ? json_string(at) : strncmp(at, "null", 4) == 0 ? at + 4 : json_number(at);
}

/* One object of names and flat values, to the end of the line; returns what follows it, or NULL. */
static const char *json_line(const char *at)
{
  if (*at != '{')
    return NULL;
  do {
    at = json_string(at + 1 + (at[0] == ','));
    at = at && strncmp(at, ": ", 2) == 0 ? json_value(at + 2) : NULL;
  } while (at && strncmp(at, ", ", 2) == 0);
  return at && strncmp(at, "}\n", 2) == 0 ? at + 2 : NULL;
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

static long judge_json(const char *text)
{
  long rows = 0;
  for (const char *next; *text; text = next, rows++) {
    next = json_line(text);
    if (!next)
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
