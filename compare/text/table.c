#include "compare/text/table.h"

#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "compare/text/message.h"

static const char *where(const struct table *t) { return t->output ? t->output : "standard output"; }

bool table_open_at(struct table *t, const struct style *style, const char *output)
{
  *t = (struct table){ .style = style, .output = output };
  int error = file_open(&t->out, output);
  if (error != 0) {
    complain(style->command, "cannot write %s: %s", output, strerror(error));
    return false;
  }
  t->file = t->out.stream;
  t->watched = isatty(fileno(t->file));
  return true;
}

bool table_open(struct table *t, const struct style *style) { return table_open_at(t, style, style->output); }

/* The first error is the one to tell of. */
static void note_error(struct table *t, bool failed)
{
  if (failed && t->error == 0)
    t->error = errno;
}

static void flush_text(struct table *t)
{
  if (t->used > 0)
    note_error(t, fwrite(t->text, 1, t->used, t->file) < t->used);
  t->used = 0;
}

/* Where the next size <= TABLE_TEXT bytes go; what is written there is then counted in t->used. */
static char *room(struct table *t, size_t size)
{
  if (t->used + size > TABLE_TEXT)
    flush_text(t);
  return t->text + t->used;
}

static void put(struct table *t, const char *text, size_t length)
{
  while (length > 0) {
    size_t part = length < TABLE_TEXT ? length : TABLE_TEXT;
    memcpy(room(t, part), text, part);
    t->used += part;
    text += part;
    length -= part;
  }
}

static void put_char(struct table *t, char c)
{
  *room(t, 1) = c;
  t->used++;
}

static void put_text(struct table *t, const char *text) { put(t, text, strlen(text)); }

static void end_line(struct table *t)
{
  put_char(t, '\n');
  if (t->watched)
    flush_text(t);
}

void table_note(struct table *t, const char *format, ...)
{
  va_list arguments;
  if (t->style->format == FORMAT_JSON)
    return;
  put(t, "# ", 2);
  flush_text(t);
  va_start(arguments, format);
  note_error(t, vfprintf(t->file, format, arguments) < 0);
  va_end(arguments);
  end_line(t);
}

size_t number_text(char text[NUMBER_TEXT], double x, long digits)
{
  if (digits == 0 || isnan(x))
    return digits_write(text, x);
  return (size_t)snprintf(text, NUMBER_TEXT, "%.*g", (int)digits, x);
}

static void put_number(struct table *t, double x, long digits) { t->used += number_text(room(t, NUMBER_TEXT), x, digits); }

void table_columns(struct table *t, const char *const *names)
{
  while (*names && t->count < TABLE_COLUMNS)
    t->columns[t->count++] = *names++;
}

void table_begin_rows(struct table *t)
{
  if (t->style->format == FORMAT_JSON)
    return;
  for (int i = 0; i < t->count; i++) {
    if (i > 0)
      put_char(t, '\t');
    put_text(t, t->columns[i]);
  }
  end_line(t);
}

static void put_value(struct table *t, double value)
{
  if (t->style->format == FORMAT_JSON && !isfinite(value))
    put_text(t, isnan(value) ? "null" : value > 0 ? "1e999" : "-1e999");
  else
    put_number(t, value, t->style->digits > DBL_DECIMAL_DIG ? 0 : t->style->digits);
}

/* How many characters at the head of text stand for themselves */
static size_t plain_length(const char *text, bool json)
{
  size_t n = 0;
  while (text[n] >= 0x20 && text[n] <= 0x7e && !(json && (text[n] == '"' || text[n] == '\\')))
    n++;
  return n;
}

static void put_string(struct table *t, const char *text)
{
  bool json = t->style->format == FORMAT_JSON;
  if (json)
    put_char(t, '"');
  for (;;) {
    size_t plain = plain_length(text, json);
    put(t, text, plain);
    text += plain;
    if (*text == '\0')
      break;
    unsigned char c = (unsigned char)*text++;
    char quoted[] = { '\\', (char)c };
    if (c < 0x20)
      put_char(t, ' ');
    else if (c > 0x7e) /* somebody's bytes in a message: not to make the table unreadable */
      put_char(t, '?');
    else
      put(t, quoted, 2);
  }
  if (json)
    put_char(t, '"');
}

static void begin_cell(struct table *t)
{
  if (t->style->format == FORMAT_JSON) {
    put_text(t, t->at == 0 ? "{\"" : ", \"");
    put_text(t, t->columns[t->at]);
    put(t, "\": ", 3);
  } else if (t->at > 0)
    put_char(t, '\t');
}

static void end_cell(struct table *t)
{
  if (++t->at < t->count)
    return;
  if (t->style->format == FORMAT_JSON)
    put_char(t, '}');
  end_line(t);
  t->at = 0;
}

void table_number(struct table *t, double value)
{
  begin_cell(t);
  put_value(t, value);
  end_cell(t);
}

void table_digits(struct table *t, const char *number)
{
  begin_cell(t);
  put_text(t, number);
  end_cell(t);
}

void table_rounded(struct table *t, double value, const char *format)
{
  char text[40];
  snprintf(text, sizeof text, format, value);
  if (text[0] == '-' && text[1 + strspn(text + 1, "0.")] == '\0') /* -0.00 */
    memmove(text, text + 1, strlen(text));
  begin_cell(t);
  if (t->style->format == FORMAT_JSON && !isfinite(value))
    put_text(t, "null");
  else
    put_text(t, isnan(value) ? "nan" : text);
  end_cell(t);
}

void table_text(struct table *t, const char *text)
{
  begin_cell(t);
  put_string(t, text);
  end_cell(t);
}

bool table_failed(const struct table *t) { return t->error != 0; }

bool table_flush(struct table *t)
{
  flush_text(t);
  int error = file_flush(&t->out);
  t->error = t->error != 0 ? t->error : error;
  return !table_failed(t);
}

bool table_close(struct table *t)
{
  flush_text(t);
  int error = file_close(&t->out, t->error == 0);
  t->error = t->error != 0 ? t->error : error;
  if (t->error != 0)
    complain(t->style->command, "cannot write %s: %s", where(t), strerror(t->error));
  return t->error == 0;
}

void table_abandon(struct table *t)
{
  if (!t->out.target)
    flush_text(t);
  file_close(&t->out, false);
}
