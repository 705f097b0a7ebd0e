#include "compare/text/table.h"

#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <string.h>

#include "compare/text/message.h"

static bool is_json(const struct table *t) { return t->style->format == FORMAT_JSON; }

bool table_open_at(struct table *t, const struct style *style, const char *output)
{
  *t = (struct table){ .style = style, .output = output };
  int error = file_open(&t->out, output);
  if (error != 0)
    complain(style->command, "cannot write %s: %s", output, strerror(error));
  t->file = t->out.stream;
  return error == 0;
}

bool table_open(struct table *t, const struct style *style) { return table_open_at(t, style, style->output); }

/* The first error is the one to tell of. */
static void note_error(struct table *t, bool failed)
{
  if (failed && t->error == 0)
    t->error = errno;
}

static void hand_on(struct table *t)
{
  note_error(t, fwrite(t->part, 1, t->used, t->file) < t->used);
  t->used = 0;
}

static void put(struct table *t, const char *text, size_t size)
{
  for (size_t now; size > 0; text += now, size -= now) {
    if (t->used == TABLE_PART)
      hand_on(t);
    now = size < TABLE_PART - t->used ? size : TABLE_PART - t->used;
    memcpy(t->part + t->used, text, now);
    t->used += now;
  }
}

static void put_text(struct table *t, const char *text) { put(t, text, strlen(text)); }
static void put_char(struct table *t, char c)
{
  if (t->used == TABLE_PART)
    hand_on(t);
  t->part[t->used++] = c;
}

void table_note(struct table *t, const char *format, ...)
{
  va_list arguments;
  if (is_json(t))
    return;
  put_text(t, "# ");
  hand_on(t);
  va_start(arguments, format);
  note_error(t, vfprintf(t->file, format, arguments) < 0);
  va_end(arguments);
  put_char(t, '\n');
  hand_on(t);
}

size_t number_text(char text[NUMBER_TEXT], double x, long digits)
{
  if (digits == 0 || isnan(x))
    return digits_write(text, x);
  return (size_t)snprintf(text, NUMBER_TEXT, "%.*g", (int)digits, x);
}

void table_columns(struct table *t, const char *const *names)
{
  while (*names && t->count < TABLE_COLUMNS)
    t->columns[t->count++] = *names++;
}

static void begin_cell(struct table *t)
{
  if (is_json(t)) {
    put_text(t, t->at == 0 ? "{\"" : ", \"");
    put_text(t, t->columns[t->at]);
    put_text(t, "\": ");
  } else if (t->at > 0)
    put_char(t, '\t');
}

static void end_cell(struct table *t)
{
  if (++t->at < t->count)
    return;
  put_text(t, is_json(t) ? "}\n" : "\n");
  hand_on(t);
  t->at = 0;
}

void table_digits(struct table *t, const char *number)
{
  begin_cell(t);
  put_text(t, number);
  end_cell(t);
}

void table_begin_rows(struct table *t)
{
  for (int i = 0; i < t->count && !is_json(t); i++)
    table_digits(t, t->columns[i]);
}

void table_number(struct table *t, double value)
{
  char text[NUMBER_TEXT];
  number_text(text, value, t->style->digits > DBL_DECIMAL_DIG ? 0 : t->style->digits);
  table_digits(t, isfinite(value) || !is_json(t) ? text : isnan(value) ? "null" : value > 0 ? "1e999" : "-1e999");
}

void table_rounded(struct table *t, double value, const char *format)
{
  char text[40];
  snprintf(text, sizeof text, format, value);
  if (text[0] == '-' && text[1 + strspn(text + 1, "0.")] == '\0') /* -0.00 */
    memmove(text, text + 1, strlen(text));
  table_digits(t, is_json(t) && !isfinite(value) ? "null" : isnan(value) ? "nan" : text);
}

/* Bytes that are no plain characters, in a message, must not make the table unreadable. */
void table_text(struct table *t, const char *text)
{
  const bool json = is_json(t);
  begin_cell(t);
  if (json)
    put_char(t, '"');
  while (*text) {
    size_t plain = 0;
    while (text[plain] >= 0x20 && text[plain] <= 0x7e && !(json && (text[plain] == '"' || text[plain] == '\\')))
      plain++;
    put(t, text, plain);
    text += plain;
    if (*text == '"' || *text == '\\')
      put_char(t, '\\');
    if (*text)
      put_char(t, *text == '"' || *text == '\\' ? *text : (unsigned char)*text < 0x20 ? ' ' : '?');
    text += *text != '\0';
  }
  if (json)
    put_char(t, '"');
  end_cell(t);
}

bool table_failed(const struct table *t) { return t->error != 0; }

bool table_flush(struct table *t)
{
  int error = file_flush(&t->out);
  t->error = t->error != 0 ? t->error : error;
  return !table_failed(t);
}

bool table_close(struct table *t)
{
  int error = file_close(&t->out, t->error == 0);
  t->error = t->error != 0 ? t->error : error;
  if (t->error != 0)
    complain(t->style->command, "cannot write %s: %s", t->output ? t->output : "standard output", strerror(t->error));
  return t->error == 0;
}

void table_abandon(struct table *t) { file_close(&t->out, false); }
