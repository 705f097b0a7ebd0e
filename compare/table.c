#include "compare/table.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "compare/compare.h"

static const char *where(const struct table *t)
{
  return t->aside ? t->options->output : "standard output";
}

bool table_open(struct table *t, const struct options *options)
{
  *t = (struct table){ .file = stdout, .options = options };
  if (!options->output)
    return true;
  size_t size = strlen(options->output) + 32;
  t->aside = malloc(size);
  if (t->aside) {
    snprintf(t->aside, size, "%s.%ld.part", options->output, (long)getpid());
    t->file = fopen(t->aside, "w");
  }
  if (!t->aside || !t->file) {
    complain(options->command->name, "cannot write %s: %s", options->output, strerror(errno));
    free(t->aside);
    return false;
  }
  return true;
}

void table_note(struct table *t, const char *format, ...)
{
  va_list arguments;
  if (t->options->format == FORMAT_JSON)
    return;
  va_start(arguments, format);
  fputs("# ", t->file);
  vfprintf(t->file, format, arguments);
  fputc('\n', t->file);
  va_end(arguments);
}

/* Shortest of 15, 16 or 17 digits that reads back to the same double. */
static void print_number(FILE *file, double x, long digits)
{
  char text[40];
  for (int precision = digits > 0 ? (int)digits : 15;; precision++) {
    snprintf(text, sizeof text, "%.*g", precision, x);
    if (digits > 0 || precision == 17 || strtod(text, NULL) == x || isnan(x))
      break;
  }
  fputs(isnan(x) ? "nan" : text, file);
}

void table_parameters(struct table *t, const struct options *o)
{
  if (o->format == FORMAT_JSON)
    return;
  fputs("# parameters:", t->file);
  for (const char *const *name = crawler_parameters; *name; name++) {
    fprintf(t->file, " %s=", *name);
    if (strcmp(*name, "gait") == 0)
      fputs(o->crawler.gait->name, t->file);
    else
      print_number(t->file, crawler_parameter(&o->crawler, *name), 0);
  }
  fputc('\n', t->file);
}

void table_columns(struct table *t, const char *const *names)
{
  while (*names && t->count < TABLE_COLUMNS)
    t->columns[t->count++] = *names++;
}

void table_begin_rows(struct table *t)
{
  if (t->options->format == FORMAT_JSON)
    return;
  for (int i = 0; i < t->count; i++)
    fprintf(t->file, "%s%s", i > 0 ? "\t" : "", t->columns[i]);
  fputc('\n', t->file);
}

static void begin_cell(struct table *t)
{
  if (t->options->format == FORMAT_JSON)
    fprintf(t->file, "%s\"%s\": ", t->at == 0 ? "{" : ", ", t->columns[t->at]);
  else if (t->at > 0)
    fputc('\t', t->file);
}

static void end_cell(struct table *t)
{
  if (++t->at < t->count)
    return;
  fputs(t->options->format == FORMAT_JSON ? "}\n" : "\n", t->file);
  t->at = 0;
}

void table_number(struct table *t, double value)
{
  begin_cell(t);
  if (t->options->format == FORMAT_JSON && !isfinite(value))
    fputs(isnan(value) ? "null" : value > 0 ? "1e999" : "-1e999", t->file);
  else
    print_number(t->file, value, t->options->digits);
  end_cell(t);
}

void table_rounded(struct table *t, double value, const char *format)
{
  char text[40];
  snprintf(text, sizeof text, format, value);
  if (text[0] == '-' && text[1 + strspn(text + 1, "0.")] == '\0') /* -0.00 */
    memmove(text, text + 1, strlen(text));
  begin_cell(t);
  if (t->options->format == FORMAT_JSON && !isfinite(value))
    fputs("null", t->file);
  else
    fputs(isnan(value) ? "nan" : text, t->file);
  end_cell(t);
}

void table_text(struct table *t, const char *text)
{
  begin_cell(t);
  bool json = t->options->format == FORMAT_JSON;
  if (json)
    fputc('"', t->file);
  for (; *text; text++) {
    unsigned char c = (unsigned char)*text;
    if (json && (c == '"' || c == '\\'))
      fprintf(t->file, "\\%c", c);
    else if (c < 0x20)
      fputc(' ', t->file);
    else
      fputc(c, t->file);
  }
  if (json)
    fputc('"', t->file);
  end_cell(t);
}

bool table_close(struct table *t)
{
  bool written = fflush(t->file) == 0 && !ferror(t->file);
  int error = errno;
  if (t->aside) {
    if (fclose(t->file) != 0 && written) {
      written = false;
      error = errno;
    }
    if (written && rename(t->aside, t->options->output) != 0) {
      written = false;
      error = errno;
    }
    if (!written)
      remove(t->aside);
  }
  if (!written)
    complain(t->options->command->name, "cannot write %s: %s", where(t), strerror(error));
  free(t->aside);
  t->aside = NULL;
  return written;
}

void table_abandon(struct table *t)
{
  if (t->aside) {
    fclose(t->file);
    remove(t->aside);
    free(t->aside);
    t->aside = NULL;
  }
}
