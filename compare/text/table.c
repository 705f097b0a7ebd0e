#include "compare/text/table.h"

#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <string.h>
#include <unistd.h>

#include "compare/text/memory.h"
#include "compare/text/message.h"

enum { PEOPLE_DIGITS = 6 };

const char *const format_names[FORMATS + 1] = { "tsv", "json", "csv", "markdown", "table", NULL };

/* What stands around the cells of a row */
static const struct {
  const char *begin, *between, *end;
} marks[FORMATS] = { [FORMAT_TSV] = { "", "\t", "\n" },
                     [FORMAT_JSON] = { "{", ", ", "}\n" },
                     [FORMAT_CSV] = { "", ",", "\n" },
                     [FORMAT_MARKDOWN] = { "| ", " | ", " |\n" },
                     [FORMAT_TABLE] = { "", "", "" } };

static bool is_json(const struct table *t) { return t->format == FORMAT_JSON; }

/* People read what goes to a terminal. */
static enum format format_of(const struct style *style, const char *output)
{
  bool to_people = !output && !style->has_format && style->format == FORMAT_TSV && (style->pager || isatty(STDOUT_FILENO));
  return to_people ? FORMAT_TABLE : style->format;
}

/* The rows of a table that is drawn: a table that never takes its place, for gnuplot to read until the picture is there. */
struct pictured {
  struct style style;
  struct table copy;
};

static bool open_pictured(struct table *t)
{
  const struct style *of = t->style;
  struct pictured *p = t->pictured = calloc(1, sizeof *p);
  if (!p)
    return complain(of->command, "out of memory");
  p->style = (struct style){ .command = of->command, .has_format = true };
  return plot_may_replace(&of->plot, of->command) && table_open_at(&p->copy, &p->style, of->plot.file);
}

static bool draw_pictured(const struct table *t, struct pictured *p)
{
  struct plot plot = t->style->plot;
  plot.table = p->copy.out.temporary;
  plot.meaning = t->style->meaning;
  if (p->copy.error != 0 || fflush(p->copy.file) != 0)
    return complain(t->style->command, "cannot write beside %s: %s", plot.file,
                    strerror(p->copy.error != 0 ? p->copy.error : errno));
  return plot_choose(&plot, t->style->command) && plot_draw(&plot, t->style->command);
}

static void end_pictured(struct table *t)
{
  if (t->pictured && t->pictured->copy.file)
    table_abandon(&t->pictured->copy);
  free(t->pictured);
  t->pictured = NULL;
}

bool table_open_at(struct table *t, const struct style *style, const char *output)
{
  *t = (struct table){ .style = style, .output = output, .format = format_of(style, output) };
  int error = file_open(&t->out, output);
  if (error != 0)
    complain(style->command, "cannot write %s: %s", output, strerror(error));
  t->file = t->out.stream;
  if (error == 0 && style->plot.file && !open_pictured(t)) {
    table_abandon(t);
    return false;
  }
  return error == 0;
}

bool table_open(struct table *t, const struct style *style) { return table_open_at(t, style, style->output); }

bool table_open_picture(struct table *t, const struct style *style) { return table_open_at(t, style, "/dev/null"); }

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
  if (t->format == FORMAT_TABLE) {
    aligned_put(&t->aligned, text, size);
    return;
  }
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
  if (t->format == FORMAT_TABLE) {
    put(t, &c, 1);
    return;
  }
  if (t->used == TABLE_PART)
    hand_on(t);
  t->part[t->used++] = c;
}

static void print_aligned(struct table *t)
{
  if (t->aligned.count > 0 && !aligned_print(&t->aligned, t->file, t->style->meaning) && t->error == 0)
    t->error = ENOMEM;
}

static void put_note(struct table *t, const char *format, va_list arguments)
{
  if (t->format != FORMAT_TSV && t->format != FORMAT_TABLE)
    return;
  if (t->format == FORMAT_TABLE)
    print_aligned(t);
  hand_on(t);
  note_error(t, fputs("# ", t->file) < 0);
  note_error(t, vfprintf(t->file, format, arguments) < 0);
  note_error(t, fputc('\n', t->file) < 0);
}

void table_note(struct table *t, const char *format, ...)
{
  va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  put_note(t, format, arguments);
  if (t->pictured)
    put_note(&t->pictured->copy, format, again);
  va_end(again);
  va_end(arguments);
}

size_t number_text(char text[NUMBER_TEXT], double x, long digits)
{
  if (digits == 0 || isnan(x))
    return digits_write(text, x);
  return (size_t)snprintf(text, NUMBER_TEXT, "%.*g", (int)digits, x);
}

void table_columns(struct table *t, const char *const *names)
{
  if (t->pictured)
    table_columns(&t->pictured->copy, names);
  while (*names && t->count < TABLE_COLUMNS)
    t->columns[t->count++] = *names++;
}

static void begin_cell(struct table *t)
{
  if (t->format == FORMAT_TABLE)
    return;
  if (t->format == FORMAT_TSV && t->at > 0)
    put_char(t, '\t');
  else
    put_text(t, t->at == 0 ? marks[t->format].begin : marks[t->format].between);
  if (is_json(t)) {
    put_char(t, '"');
    put_text(t, t->columns[t->at]);
    put_text(t, "\": ");
  }
}

static void end_cell(struct table *t)
{
  if (t->format == FORMAT_TABLE)
    aligned_end_cell(&t->aligned);
  if (++t->at < t->count)
    return;
  t->at = 0;
  if (t->format == FORMAT_TABLE)
    return;
  put_text(t, marks[t->format].end);
  hand_on(t);
}

static void put_digits(struct table *t, const char *number)
{
  begin_cell(t);
  put_text(t, number);
  end_cell(t);
}

void table_digits(struct table *t, const char *number)
{
  if (t->pictured)
    put_digits(&t->pictured->copy, number);
  put_digits(t, number);
}

void table_begin_rows(struct table *t)
{
  if (t->pictured)
    table_begin_rows(&t->pictured->copy);
  t->aligned.columns = t->count;
  for (int i = 0; i < t->count && !is_json(t); i++)
    put_digits(t, t->columns[i]);
  for (int i = 0; i < t->count && t->format == FORMAT_MARKDOWN; i++)
    put_digits(t, "---");
}

void table_number(struct table *t, double value)
{
  char text[NUMBER_TEXT];
  long digits = t->style->digits > DBL_DECIMAL_DIG ? 0 : t->style->digits;
  if (t->pictured)
    table_number(&t->pictured->copy, value);
  number_text(text, value, digits == 0 && t->format == FORMAT_TABLE ? PEOPLE_DIGITS : digits);
  put_digits(t, isfinite(value) || !is_json(t) ? text : isnan(value) ? "null" : value > 0 ? "1e999" : "-1e999");
}

void table_rounded(struct table *t, double value, const char *format)
{
  char text[40];
  snprintf(text, sizeof text, format, value);
  if (text[0] == '-' && text[1 + strspn(text + 1, "0.")] == '\0') /* -0.00 */
    memmove(text, text + 1, strlen(text));
  if (t->pictured)
    table_rounded(&t->pictured->copy, value, format);
  put_digits(t, is_json(t) && !isfinite(value) ? "null" : isnan(value) ? "nan" : text);
}

/* Bytes that are no plain characters, in a message, must not make the table unreadable. */
void table_text(struct table *t, const char *text)
{
  /* characters that have a meaning in the format, and what stands in front of them then */
  static const char *const special[FORMATS] = { "", "\"\\", "\"", "|", "" };
  static const char before[FORMATS] = { [FORMAT_JSON] = '\\', [FORMAT_CSV] = '"', [FORMAT_MARKDOWN] = '\\' };
  if (t->pictured)
    table_text(&t->pictured->copy, text);
  const char *meant = special[t->format];
  bool quoted = is_json(t) || (t->format == FORMAT_CSV && strpbrk(text, ",\""));
  begin_cell(t);
  if (quoted)
    put_char(t, '"');
  while (*text) {
    size_t plain = 0;
    while (text[plain] >= 0x20 && text[plain] <= 0x7e && !strchr(meant, text[plain]))
      plain++;
    put(t, text, plain);
    text += plain;
    if (*text && strchr(meant, *text)) {
      put_char(t, before[t->format]);
      put_char(t, *text);
    } else if (*text)
      put_char(t, (unsigned char)*text < 0x20 ? ' ' : '?');
    text += *text != '\0';
  }
  if (quoted)
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
  if (t->format == FORMAT_TABLE)
    print_aligned(t);
  int error = file_close(&t->out, t->error == 0);
  t->error = t->error != 0 ? t->error : error;
  if (t->error != 0)
    complain(t->style->command, "cannot write %s: %s", t->output ? t->output : "standard output", strerror(t->error));
  bool drawn = t->error == 0 && (!t->pictured || draw_pictured(t, t->pictured));
  end_pictured(t);
  return drawn;
}

void table_abandon(struct table *t)
{
  end_pictured(t);
  aligned_free(&t->aligned);
  file_close(&t->out, false);
}
