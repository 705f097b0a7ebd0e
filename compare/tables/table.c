#define _GNU_SOURCE /* asprintf */
#include "compare/tables/table.h"

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

const char *const format_names[FORMATS + 1] = { "tsv", "json", "csv", "markdown", "table", "npy", NULL };

/* The marks of the formats: around the cells of a row; escapes of special characters; characters for which a text is
 * quoted (NULL: always); the bytes of cells of other tables that are written unchanged; whether notes are written */
static const struct {
  const char *begin, *between, *end;
  const struct escapes *escapes;
  const char *quoted;
  enum shown carried;
  bool has_notes;
} marks[FORMATS] = { [FORMAT_TSV] = { "", "\t", "\n", &in_plain, "", SHOWS_BYTES, true },
                     [FORMAT_JSON] = { "{", ", ", "}\n", &in_json, NULL, SHOWS_CHARACTERS, false },
                     [FORMAT_CSV] = { "", ",", "\n", &in_csv, ",\"", SHOWS_BYTES, false },
                     [FORMAT_MARKDOWN] = { "| ", " | ", " |\n", &in_markdown, "", SHOWS_CHARACTERS, false },
                     [FORMAT_TABLE] = { "", "", "", &in_plain, "", SHOWS_CHARACTERS, true },
                     [FORMAT_NPY] = { .has_notes = false } };

/* Returns the format: on a terminal FORMAT_TABLE, unless another one is given. */
static enum format format_of(const struct style *style)
{
  bool to_people = !style->output && !style->has_format && style->format == FORMAT_TSV && isatty(STDOUT_FILENO);
  return to_people ? FORMAT_TABLE : style->format;
}

bool table_is_aligned(const struct style *style) { return format_of(style) == FORMAT_TABLE; }

const char no_npy_to_pipe[] = "--format npy needs -o FILE, not a pipe or device: the head of the file is written last";

static const char *name_of(const char *output) { return output ? output : "standard output"; }

/* Stores an error if it is the first. */
static void note_error(struct sink *s, int error) { s->error = s->error != 0 ? s->error : error; }

static bool open_sink(struct table *t, const char *output)
{
  int error = file_open(&t->sink[t->sinks].out, output);
  if (error != 0)
    return complain(t->style->command, "cannot write %s: %s", name_of(output), file_error(error));
  t->sinks++;
  if (t->sink[t->sinks - 1].format == FORMAT_NPY && !t->sink[t->sinks - 1].out.target)
    return complain(t->style->command, "%s", no_npy_to_pipe);
  return true;
}

bool table_open(struct table *t, const struct style *style)
{
  *t = (struct table){ .style = style, .of = style->command };
  struct sink *s = t->sink;
  s->format = format_of(style);
  s->aligned.upright = style->upright;
  s->aligned.gathers = !style->chosen;
  s->digits = style->digits == 0 && s->format == FORMAT_TABLE ? ALIGNED_DIGITS
              : style->digits <= DBL_DECIMAL_DIG              ? style->digits
                                                              : 0;
  bool open = open_sink(t, style->output) && (!style->plot.file || open_sink(t, style->plot.file));
  if (!open)
    table_abandon(t);
  return open;
}

static void print_aligned(struct table *t, struct sink *s, bool last)
{
  progress_clear();
  if (!aligned_print(&s->aligned, t->names, s->out.stream, t->style->meaning, last))
    note_error(s, ENOMEM);
}

static void write_notes(struct table *t)
{
  for (struct sink *s = t->sink; s < t->sink + t->sinks && t->notes; s++) {
    if (!marks[s->format].has_notes || s->error != 0)
      continue;
    if (s->format == FORMAT_TABLE)
      print_aligned(t, s, true);
    progress_clear();
    if (fputs(t->notes, s->out.stream) < 0)
      note_error(s, errno);
  }
  free(t->notes);
  t->notes = NULL;
}

void table_note(struct table *t, const char *format, ...)
{
  va_list arguments;
  va_start(arguments, format);
  char *note = printed_line(format, arguments, ""), *notes; /* a line break in a name would begin a row */
  va_end(arguments);
  bool is_kept = note && asprintf(&notes, "%s# %s\n", t->notes ? t->notes : "", note) >= 0;
  free(note);
  if (!is_kept)
    return note_error(t->sink, ENOMEM);
  free(t->notes);
  t->notes = notes;
  if (t->names)
    write_notes(t);
}

void table_columns(struct table *t, const char *const *names)
{
  while (*names && t->count < TABLE_COLUMNS)
    t->columns[t->count++] = *names++;
}

/* Writes a text; faster than fputs for short texts. */
static void put(FILE *to, const char *text)
{
  for (; *text; text++)
    putc_unlocked(*text, to);
}

static void put_text(FILE *to, enum format format, const char *text, bool carried)
{
  const char *quoted = marks[format].quoted;
  const char *quote = !quoted || (*quoted && strpbrk(text, quoted)) ? "\"" : "";
  put(to, quote);
  put_escaped(to, text, marks[format].escapes, carried ? marks[format].carried : SHOWS_ASCII);
  put(to, quote);
}

/* Returns the text of a number, reused from the previous row if the number is the same. */
static const char *number_in(struct sink *s, int column, double x)
{
  if (!s->last[column].is_there || !(s->last[column].value == x) || signbit(s->last[column].value) != signbit(x))
    number_text(s->last[column].text, x, s->digits);
  s->last[column].is_there = true;
  s->last[column].value = x;
  return s->last[column].text;
}

static void put_cell(FILE *to, struct sink *s, const struct table_cell *c, int column)
{
  const bool json = s->format == FORMAT_JSON, is_number = c->kind == CELL_NUMBER, is_carried = c->kind == CELL_CARRIED;
  const char *text = is_number ? number_in(s, column, c->value) : c->text;
  if (json && c->kind != CELL_TEXT && (isinf(c->value) || strcmp(text, "nan") == 0))
    put(to, !is_number || isnan(c->value) ? "null" : c->value > 0 ? "1e999" : "-1e999");
  else if (c->kind == CELL_TEXT || (is_carried && !(json && json_takes_number(text))))
    put_text(to, s->format, text, is_carried);
  else
    put(to, text);
}

/* Moves the kept rows to the file. */
static void store(struct sink *s) { note_error(s, npy_move(&s->stored, s->out.stream, s->head, &s->kept)); }

static void keep_record(const struct table *t, struct sink *s, const struct table_cell *cells)
{
  enum { BLOCK = 4096 };
  note_error(s, npy_row(&s->kept, cells, s->digits));
  if (!t->is_part && s->kept.rows >= BLOCK)
    store(s);
}

/* Writes a row, or the names of the columns, to a sink. */
static void emit(struct table *t, struct sink *s, const struct table_cell *cells, int count)
{
  bool aligned = s->format == FORMAT_TABLE;
  count -= s == t->sink ? t->only_drawn : 0;
  if (s->format == FORMAT_NPY)
    return keep_record(t, s, cells);
  FILE *to = aligned && !t->is_part ? aligned_begin_row(&s->aligned, count) : s->out.stream;
  if (!to)
    return note_error(s, ENOMEM);
  if (!t->is_part)
    progress_clear();
  for (int i = 0; i < count; i++) {
    put(to, i == 0 ? marks[s->format].begin : marks[s->format].between);
    if (s->format == FORMAT_JSON) {
      put_text(to, s->format, t->names[i], true);
      put(to, ": ");
    }
    put_cell(to, s, &cells[i], i);
    if (aligned)
      putc('\0', to);
  }
  put(to, marks[s->format].end);
  note_error(s, ferror(to) ? errno : 0);
  if (aligned_is_full(&s->aligned))
    print_aligned(t, s, false);
}

static void begin_records(struct table *t, int count)
{
  struct sink *s = t->sink;
  s->notes = strdup(t->notes ? t->notes : "");
  s->head = npy_head_size(t->names, count, s->notes);
  npy_begin(&s->kept, count);
  npy_begin(&s->stored, count);
}

void table_begin_rows(struct table *t)
{
  struct table_choice *choice = t->style->choice;
  const char *wrong = choice ? choice->begin(choice, t->columns, t->count) : NULL;
  const int count = choice ? choice->count : t->count;
  struct table_cell names[TABLE_COLUMNS];
  if (wrong) {
    complain(t->style->command, "--columns: %s", wrong);
    choice->refused = true;
    return note_error(t->sink, EINVAL);
  }
  t->names = choice ? choice->names : t->columns;
  for (int i = 0; i < count; i++)
    names[i] = (struct table_cell){ .kind = CELL_CARRIED, .text = (char *)t->names[i] };
  if (t->sink->format == FORMAT_NPY)
    begin_records(t, count - t->only_drawn);
  write_notes(t);
  for (struct sink *s = t->sink; s < t->sink + t->sinks; s++) {
    if (s->format != FORMAT_JSON && s->format != FORMAT_NPY)
      emit(t, s, names, count);
    const int written = count - (s == t->sink ? t->only_drawn : 0);
    for (int i = 0; s->format == FORMAT_MARKDOWN && i < written; i++)
      fputs(i + 1 < written ? "| --- " : "| --- |\n", s->out.stream);
  }
}

static void end_row(struct table *t)
{
  struct table_choice *choice = t->style->choice;
  struct table_cell shown[TABLE_COLUMNS];
  t->at = 0;
  if (table_failed(t))
    return;
  if (choice)
    choice->show(choice, t->row, shown);
  for (struct sink *s = t->sink; s < t->sink + t->sinks; s++)
    emit(t, s, choice ? shown : t->row, choice ? choice->count : t->count);
}

/* Adds a cell to the row, with a copy of its text. */
static void keep(struct table *t, enum cell_kind kind, double value, const char *text)
{
  struct table_cell *c = &t->row[t->at];
  size_t size = text ? strlen(text) + 1 : 0;
  if (text && size > c->room) {
    char *longer = realloc(c->text, 2 * size);
    if (!longer)
      return note_error(t->sink, ENOMEM);
    c->text = longer;
    c->room = 2 * size;
  }
  if (text)
    memcpy(c->text, text, size);
  c->kind = kind;
  c->value = value;
  if (++t->at == t->count)
    end_row(t);
}

void table_number(struct table *t, double value) { keep(t, CELL_NUMBER, value, NULL); }
void table_digits(struct table *t, const char *number) { keep(t, CELL_DIGITS, NAN, number); }
void table_text(struct table *t, const char *text) { keep(t, CELL_TEXT, NAN, text); }
void table_carried(struct table *t, const char *text) { keep(t, CELL_CARRIED, NAN, text); }
void table_count(struct table *t, long count) { table_rounded(t, (double)count, "%.0f"); }

bool table_doubles(struct table *t, const double *const *columns, long rows)
{
  struct sink *s = t->sink;
  bool whole = t->sinks == 1 && s->format == FORMAT_NPY && s->digits == 0 && !t->style->choice;
  for (int i = 0; i < t->count; i++)
    whole = whole && columns[i];
  double *to = whole ? npy_doubles(&s->kept, rows) : NULL;
  for (int i = 0; i < t->count && to; i++)
    for (long k = 0; k < rows; k++)
      to[k * t->count + i] = columns[i][k];
  if (to && !t->is_part)
    store(s);
  return to != NULL;
}

bool table_part(struct table *part, const struct table *t)
{
  *part = (struct table){ .style = t->style, .count = t->count, .names = t->names, .is_part = true };
  for (int i = 0; i < t->sinks; i++) {
    const struct sink *of = &t->sink[i];
    struct sink *s = &part->sink[i];
    s->format = of->format;
    s->digits = of->digits;
    npy_begin(&s->kept, of->kept.columns);
    s->out.stream = open_memstream(&s->text, &s->size);
    part->sinks += s->out.stream != NULL;
  }
  return part->sinks == t->sinks;
}

/* Adds the cells of a part, each followed by a NUL, to the aligned rows. */
static void join_aligned(struct table *t, struct sink *s, const struct sink *part)
{
  const int count = t->style->choice ? t->style->choice->count : t->count;
  for (const char *cell = part->text; cell < part->text + part->size;) {
    FILE *to = aligned_begin_row(&s->aligned, count);
    for (int i = 0; i < count; i++, cell += strlen(cell) + 1)
      if (to)
        fwrite(cell, 1, strlen(cell) + 1, to);
    if (!to)
      return note_error(s, ENOMEM);
    if (aligned_is_full(&s->aligned))
      print_aligned(t, s, false);
  }
}

void table_join(struct table *t, struct table *part)
{
  progress_clear();
  for (int i = 0; i < t->sinks; i++) {
    struct sink *s = &t->sink[i], *p = &part->sink[i];
    note_error(s, p->error != 0 ? p->error : fflush(p->out.stream) != 0 ? errno : 0);
    if (s->error != 0)
      continue;
    if (s->format == FORMAT_NPY)
      note_error(s, npy_move(&s->stored, s->out.stream, s->head, &p->kept));
    else if (s->format == FORMAT_TABLE)
      join_aligned(t, s, p);
    else if (fwrite(p->text, 1, p->size, s->out.stream) != p->size)
      note_error(s, errno);
    rewind(p->out.stream);
  }
}

void table_rounded(struct table *t, double value, const char *format)
{
  char text[40];
  snprintf(text, sizeof text, format, value);
  bool is_minus_zero = text[0] == '-' && text[1 + strspn(text + 1, "0.")] == '\0'; /* -0.00 */
  keep(t, CELL_DIGITS, value, isnan(value) ? "nan" : text + is_minus_zero);
}

#define MEMBER(type) (*(type const *)(const void *)((const char *)row + c->at))
void column_number(struct table *t, const struct table_column *c, const void *row) { table_number(t, MEMBER(double)); }
void column_count(struct table *t, const struct table_column *c, const void *row) { table_count(t, MEMBER(int)); }
void column_long(struct table *t, const struct table_column *c, const void *row) { table_count(t, MEMBER(long)); }
void column_text(struct table *t, const struct table_column *c, const void *row) { table_text(t, MEMBER(char *)); }
void column_rounded(struct table *t, const struct table_column *c, const void *row)
{
  table_rounded(t, MEMBER(double), c->format);
}

void table_add(struct table *t, const struct table_column *c)
{
  for (; c->name && t->count < TABLE_COLUMNS; c++)
    t->columns[t->count++] = c->name;
}

void table_row(struct table *t, const struct table_column *c, const void *row, bool solved)
{
  for (; c->name; c++)
    if (solved || !c->blank)
      c->put(t, c, row);
    else if (strcmp(c->blank, "nan") == 0)
      table_number(t, NAN);
    else
      table_text(t, c->blank);
}

bool table_restart_columns(struct table *t)
{
  bool may = t->sink[0].format == FORMAT_JSON && !t->style->choice;
  t->count = may ? 0 : t->count;
  return may;
}

FILE *table_page(struct table *t)
{
  if (t->sink[0].format != FORMAT_TABLE || t->style->choice)
    return NULL;
  aligned_free(&t->sink[0].aligned);
  t->at = 0;
  return t->sink[0].out.stream;
}

bool table_failed(const struct table *t) { return t->sink[0].error != 0; }

/* Completes the file of a FORMAT_NPY. */
static void complete(struct table *t)
{
  struct sink *s = t->sink;
  if (s->format != FORMAT_NPY || s->error != 0)
    return;
  store(s);
  note_error(s, npy_write_head(&s->stored, s->out.stream, s->head, t->names, s->notes));
}

bool table_flush(struct table *t)
{
  complete(t);
  note_error(t->sink, file_flush(&t->sink[0].out));
  return !table_failed(t);
}

static bool draw(const struct table *t)
{
  struct plot plot = t->style->plot;
  plot.of = t->of;
  plot.table = t->sink[1].out.temporary;
  plot.meaning = t->style->meaning;
  if (!plot.table || t->sink[1].error != 0 || fflush(t->sink[1].out.stream) != 0)
    return complain(t->style->command, "cannot write the rows of the picture beside %s", plot.file);
  return plot_draw(&plot, t->style->command);
}

/* Closes the sinks from index `from` on without keeping them, and frees the memory. */
static void release(struct table *t, int from)
{
  free(t->notes);
  for (struct sink *s = t->sink + from; s < t->sink + t->sinks; s++) {
    aligned_free(&s->aligned);
    npy_free(&s->kept);
    free(s->notes);
    file_close(&s->out, false);
    free(s->text);
  }
  for (int i = 0; i < TABLE_COLUMNS; i++)
    free(t->row[i].text);
}

bool table_close(struct table *t)
{
  struct sink *s = t->sink;
  write_notes(t);
  if (s->format == FORMAT_TABLE)
    print_aligned(t, s, true);
  complete(t);
  note_error(s, file_close(&s->out, s->error == 0));
  if (s->error != 0 && !(t->style->choice && t->style->choice->refused))
    complain(t->style->command, "cannot write %s: %s", name_of(t->style->output), file_error(s->error));
  bool drawn = s->error == 0 && (t->sinks == 1 || draw(t));
  npy_free(&s->kept);
  free(s->notes);
  release(t, 1);
  return drawn;
}

void table_abandon(struct table *t) { release(t, 0); }
