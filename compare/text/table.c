#include "compare/text/table.h"

#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "compare/text/message.h"
#include "compare/text/progress.h"
#include "compare/text/values.h"

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
  bool to_people = !output && !style->has_format && style->format == FORMAT_TSV
                   && (style->pager || isatty(STDOUT_FILENO));
  return to_people ? FORMAT_TABLE : style->format;
}

/* The rows of a table that is drawn: a table that never takes its place, for gnuplot to read until the picture is
 * there. */
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
  plot.of = t->of;
  plot.table = p->copy.out.temporary;
  plot.meaning = t->style->meaning;
  if (p->copy.error != 0 || fflush(p->copy.file) != 0)
    return complain(t->style->command, "cannot write the rows of the picture beside %s", plot.file);
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
  *t = (struct table){ .style = style, .output = output, .format = format_of(style, output), .of = style->command };
  int error = file_open(&t->out, output);
  if (error != 0)
    complain(style->command, "cannot write %s: %s", output ? output : "standard output", file_error(error));
  t->file = t->out.stream;
  if (error == 0 && style->choice)
    t->file = t->head = open_memstream(&t->head_text, &t->head_size);
  if (error == 0 && !t->file) {
    complain(style->command, "out of memory");
    file_close(&t->out, false);
  }
  if (error != 0 || !t->file)
    return false;
  if (style->plot.file && !open_pictured(t)) {
    table_abandon(t);
    return false;
  }
  return true;
}

bool table_open(struct table *t, const struct style *style) { return table_open_at(t, style, style->output); }
bool table_is_for_people(const struct style *style) { return format_of(style, style->output) == FORMAT_TABLE; }

/* The first error is the one to tell of. */
static void note_error(struct table *t, bool failed)
{
  if (failed && t->error == 0)
    t->error = errno;
}

/* Ends keeping '#' lines back; keep: writes them. */
static void end_head(struct table *t, bool keep)
{
  if (!t->head)
    return;
  fclose(t->head);
  t->head = NULL;
  t->file = t->out.stream;
  note_error(t, keep && fwrite(t->head_text, 1, t->head_size, t->file) < t->head_size);
  free(t->head_text);
}

static void hand_on(struct table *t)
{
  progress_clear();
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
static void put_char(struct table *t, char c) { put(t, &c, 1); }

static void print_aligned(struct table *t, bool last)
{
  progress_clear();
  if (t->aligned.count > 0 && !aligned_print(&t->aligned, t->file, t->style->meaning, last) && t->error == 0)
    t->error = ENOMEM;
}

static void put_note(struct table *t, const char *format, va_list arguments)
{
  if ((t->format != FORMAT_TSV && t->format != FORMAT_TABLE) || table_failed(t))
    return;
  if (t->format == FORMAT_TABLE)
    print_aligned(t, true);
  hand_on(t);
  note_error(t, !wrap_note(t->file, format, arguments));
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

void table_columns(struct table *t, const char *const *names)
{
  while (*names && t->count < TABLE_COLUMNS)
    t->columns[t->count++] = *names++;
}

/* Of text the first bytes that go out as they are, in front of one of special. What is given is plain ASCII, or, where
 * it is carried, any bytes that do no harm: in columns for people and in JSON only characters. */
static size_t plain_bytes(const struct table *t, const char *text, const char *special, bool carried)
{
  size_t plain = 0;
  bool any = carried && (t->format == FORMAT_TSV || t->format == FORMAT_CSV);
  for (size_t size = 1; text[plain] && size > 0; plain += size) {
    bool ascii = text[plain] >= 0x20 && text[plain] <= 0x7e;
    size = ascii || any ? 1 : carried ? shown_character(text + plain) : 0;
    if (*special && strchr(special, text[plain]))
      break;
  }
  return plain;
}

/* A text as the format has it. Bytes that are no plain characters, in a message, must not make the table unreadable. */
static void put_written(struct table *t, const char *text, bool carried)
{
  /* characters that have a meaning in the format, and what stands in front of them then */
  static const char *const special[FORMATS] = { "", "\"\\", "\"", "|", "" };
  static const char before[FORMATS] = { [FORMAT_JSON] = '\\', [FORMAT_CSV] = '"', [FORMAT_MARKDOWN] = '\\' };
  const char *meant = special[t->format];
  while (*text) {
    size_t plain = plain_bytes(t, text, meant, carried);
    put(t, text, plain);
    text += plain;
    if (*text && strchr(meant, *text)) {
      put_char(t, before[t->format]);
      put_char(t, *text);
    } else if (*text)
      put_char(t, (unsigned char)*text < 0x20 ? ' ' : '?');
    text += *text != '\0';
  }
}

static void put_quoted(struct table *t, const char *text, bool carried)
{
  bool quoted = is_json(t) || (t->format == FORMAT_CSV && strpbrk(text, ",\""));
  if (quoted)
    put_char(t, '"');
  put_written(t, text, carried);
  if (quoted)
    put_char(t, '"');
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
    put_quoted(t, t->names[t->at], true);
    put_text(t, ": ");
  }
}

static void end_cell(struct table *t)
{
  if (t->format == FORMAT_TABLE)
    aligned_end_cell(&t->aligned);
  if (++t->at < t->count)
    return;
  t->at = 0;
  if (t->format == FORMAT_TABLE) {
    if (aligned_is_full(&t->aligned))
      print_aligned(t, false);
    return;
  }
  put_text(t, marks[t->format].end);
  hand_on(t);
}

static void put_digits(struct table *t, const char *number)
{
  begin_cell(t);
  put_text(t, number);
  end_cell(t);
}

static void put_cell(struct table *t, const char *text, bool carried)
{
  begin_cell(t);
  put_quoted(t, text, carried);
  end_cell(t);
}

static void write_heads(struct table *t)
{
  if (t->pictured) {
    t->pictured->copy.names = t->names;
    t->pictured->copy.count = t->count;
    write_heads(&t->pictured->copy);
  }
  t->aligned.columns = t->count;
  for (int i = 0; i < t->count && !is_json(t); i++)
    put_cell(t, t->names[i], true);
  for (int i = 0; i < t->count && t->format == FORMAT_MARKDOWN; i++)
    put_digits(t, "---");
}

static void write_chosen(struct table *t) { t->style->choice->write(t->style->choice, t); }

/* Writes cells of the columns that the choice shows. */
static void show(struct table *t, void (*write)(struct table *))
{
  int count = t->count;
  t->choice = NULL;
  t->names = t->style->choice->names;
  t->count = t->style->choice->count;
  t->at = 0;
  write(t);
  t->names = t->columns;
  t->count = count;
  t->choice = t->style->choice;
}

static void hand_over(struct table *t, enum cell_kind kind, double value, const char *text)
{
  const struct table_cell cell = { kind, value, text };
  if (t->error == 0 && !t->choice->keep(t->choice, t->at, &cell))
    t->error = ENOMEM;
  if (++t->at == t->count) {
    t->at = 0;
    if (t->error == 0)
      show(t, write_chosen);
  }
}

/* Does the choice of columns take the cell? */
static inline bool is_taken(struct table *t, enum cell_kind kind, double value, const char *text)
{
  if (t->choice)
    hand_over(t, kind, value, text);
  return t->choice != NULL;
}

void table_begin_rows(struct table *t)
{
  struct table_choice *choice = t->style->choice;
  const char *wrong = choice ? choice->begin(choice, t->columns, t->count) : NULL;
  t->names = t->columns;
  end_head(t, !wrong);
  t->choice = choice;
  if (wrong) {
    complain(t->style->command, "--columns: %s", wrong);
    choice->refused = true;
    t->error = EINVAL;
  } else if (choice)
    show(t, write_heads);
  else
    write_heads(t);
}

bool table_uses(const struct table *t, const char *column)
{
  int i = 0;
  while (i < t->count - 1 && strcmp(t->columns[i], column) != 0)
    i++;
  return !t->choice || t->choice->used[i];
}

void table_digits(struct table *t, const char *number)
{
  if (is_taken(t, CELL_DIGITS, 0, number))
    return;
  if (t->pictured)
    put_digits(&t->pictured->copy, number);
  put_digits(t, number);
}

void table_number(struct table *t, double value)
{
  char text[NUMBER_TEXT];
  if (is_taken(t, CELL_NUMBER, value, NULL))
    return;
  if (t->pictured)
    table_number(&t->pictured->copy, value);
  long digits = t->style->digits > DBL_DECIMAL_DIG ? 0 : t->style->digits;
  number_text(text, value, digits == 0 && t->format == FORMAT_TABLE ? PEOPLE_DIGITS : digits);
  put_digits(t, isfinite(value) || !is_json(t) ? text : isnan(value) ? "null" : value > 0 ? "1e999" : "-1e999");
}

void table_rounded(struct table *t, double value, const char *format)
{
  char text[40];
  if (is_taken(t, CELL_ROUNDED, value, format))
    return;
  if (t->pictured)
    table_rounded(&t->pictured->copy, value, format);
  snprintf(text, sizeof text, format, value);
  if (text[0] == '-' && text[1 + strspn(text + 1, "0.")] == '\0') /* -0.00 */
    memmove(text, text + 1, strlen(text));
  put_digits(t, is_json(t) && !isfinite(value) ? "null" : isnan(value) ? "nan" : text);
}

void table_text(struct table *t, const char *text)
{
  if (is_taken(t, CELL_TEXT, 0, text))
    return;
  if (t->pictured)
    put_cell(&t->pictured->copy, text, false);
  put_cell(t, text, false);
}

void table_carried(struct table *t, const char *text)
{
  if (is_taken(t, CELL_CARRIED, 0, text))
    return;
  if (t->pictured)
    put_cell(&t->pictured->copy, text, true);
  if (is_json(t) && json_takes_number(text))
    put_digits(t, text);
  else if (is_json(t) && strcmp(text, "nan") == 0)
    put_digits(t, "null");
  else
    put_cell(t, text, true);
}

void table_cell(struct table *t, const struct table_cell *cell)
{
  switch (cell->kind) {
  case CELL_NUMBER: table_number(t, cell->value); break;
  case CELL_ROUNDED: table_rounded(t, cell->value, cell->text); break;
  case CELL_DIGITS: table_digits(t, cell->text); break;
  case CELL_TEXT: table_text(t, cell->text); break;
  case CELL_CARRIED: table_carried(t, cell->text); break;
  }
}

FILE *table_page(struct table *t)
{
  if (t->format != FORMAT_TABLE || t->style->choice)
    return NULL;
  aligned_free(&t->aligned);
  t->at = 0;
  hand_on(t);
  return t->file;
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
  end_head(t, true);
  if (t->format == FORMAT_TABLE)
    print_aligned(t, true);
  int error = file_close(&t->out, t->error == 0);
  t->error = t->error != 0 ? t->error : error;
  if (t->error != 0 && !(t->style->choice && t->style->choice->refused))
    complain(t->style->command, "cannot write %s: %s", t->output ? t->output : "standard output", file_error(t->error));
  bool drawn = t->error == 0 && (!t->pictured || draw_pictured(t, t->pictured));
  end_pictured(t);
  return drawn;
}

void table_abandon(struct table *t)
{
  end_pictured(t);
  aligned_free(&t->aligned);
  end_head(t, false);
  file_close(&t->out, false);
}
