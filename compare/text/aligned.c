#include "compare/text/aligned.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "compare/text/memory.h"

static bool begin_cell(struct aligned *a)
{
  char **cells = with_room(a->cells, a->count, sizeof *cells);
  if (cells)
    a->cells = cells;
  a->lost = a->lost || !cells || !(a->cells[a->count] = calloc(1, 1));
  return !a->lost;
}

void aligned_put(struct aligned *a, const char *text, size_t size)
{
  if (a->lost || (!a->is_open && !begin_cell(a)))
    return;
  a->is_open = true;
  size_t length = strlen(a->cells[a->count]);
  char *longer = realloc(a->cells[a->count], length + size + 1);
  if (longer) {
    a->cells[a->count] = longer;
    memcpy(longer + length, text, size);
    longer[length + size] = '\0';
  }
  a->lost = !longer;
}

void aligned_end_cell(struct aligned *a)
{
  aligned_put(a, "", 0);
  a->is_open = false;
  a->count += !a->lost;
}

bool aligned_is_full(const struct aligned *a) { return !a->is_open && a->count >= (ALIGNED_ROWS + 1L) * a->columns; }

void aligned_free(struct aligned *a)
{
  free(a->column);
  for (long i = 0; i < a->count + a->is_open; i++)
    free(a->cells[i]);
  free(a->cells);
  *a = (struct aligned){ .columns = a->columns };
}

int wrap_width(FILE *file)
{
  struct winsize size;
  int place = fileno(file);
  return place >= 0 && isatty(place) && ioctl(place, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

/* Where a line goes on */
static int below(const char *line, int length, int width)
{
  int first = (int)strspn(line, "# "), column = first;
  for (int i = first + 1; i < length - 1; i++)
    if (line[i] == ' ' && line[i - 1] == ' ' && line[i + 1] != ' ')
      column = i + 1;
  return 3 * column <= 2 * width ? column : first;
}

/* One line, whose words may be those of several of the text */
struct line {
  FILE *to;
  int width, at, column; /* where the next word stands, and the first of the next line */
};

/* Words of the text, with the blanks between them as they are; joined: behind others, from which one blank parts
 * them */
static void put_words(struct line *l, const char *text, int length, bool joined)
{
  for (int i = 0, next; i < length; i = next) {
    int blanks = (int)strspn(text + i, " "), word = (int)strcspn(text + i + blanks, " \n");
    next = i + blanks + word;
    blanks = joined && i == 0 ? 1 : blanks;
    if ((joined || i > 0) && l->width > 0 && l->at + blanks + word > l->width) {
      fprintf(l->to, "\n%*s", l->column, "");
      l->at = l->column;
      blanks = 0;
    }
    l->at += fprintf(l->to, "%*s%.*s", blanks, "", word, text + next - word);
  }
}

/* Is the line behind this one a part of it? */
static bool goes_on(const char *line, int length, int full)
{
  const char *next = line + length + (line[length] == '\n');
  int blanks = (int)strspn(next, " "), word = (int)strcspn(next + blanks, " \n");
  return full > 0 && length > 0 && word > 0 && length + 1 + word > full && blanks == below(line, length, full)
         && below(next, (int)strcspn(next, "\n"), full) == blanks;
}

bool wrap_lines(FILE *to, const char *text, int width, int full)
{
  while (*text) {
    int length = (int)strcspn(text, "\n");
    struct line l = { to, width, 0, below(text, length, width > 0 ? width : full) };
    put_words(&l, text, length, false);
    for (; width > 0 && goes_on(text, length, full); length = (int)strcspn(text, "\n")) {
      text += length + 1;
      put_words(&l, text, (int)strcspn(text, "\n"), true);
    }
    text += length;
    if (*text == '\n')
      fputc(*text++, to);
  }
  return !ferror(to);
}

FILE *wrap_begin(struct wrapped *w)
{
  *w = (struct wrapped){ .text = NULL };
  return w->file = open_memstream(&w->text, &w->size);
}

bool wrap_end(struct wrapped *w, FILE *to, int full)
{
  bool kept = w->file && fclose(w->file) == 0;
  int width = wrap_width(to);
  bool written = kept && wrap_lines(to, w->text, full > 0 && width > full ? 0 : width, full);
  free(w->text);
  return written;
}

bool wrap_note(FILE *to, const char *format, va_list arguments)
{
  struct wrapped kept;
  FILE *line = wrap_begin(&kept);
  bool made = line && fputs("# ", line) >= 0 && vfprintf(line, format, arguments) >= 0 && fputc('\n', line) >= 0;
  return wrap_end(&kept, to, 0) && made;
}

static const char *unit_of(column_meaning *meaning, const char *name)
{
  const struct column_meaning *m = meaning ? meaning(name) : NULL;
  return m ? m->unit : "";
}

/* A long text goes on in another line behind each "; " and " | ", from column `left` on. */
static void print_text(FILE *file, const char *text, int left)
{
  enum { LONGEST = 60 };
  bool is_long = strlen(text) > LONGEST;
  for (; *text; text++) {
    bool ends = is_long && text[1] == ' ' && (*text == ';' || *text == '|');
    fputc(*text, file);
    if (ends) {
      fprintf(file, "\n%*s", left, "");
      text++;
    }
  }
}

struct aligned_column {
  int width;
  bool numbers;   /* on the right             */
  bool has_parts; /* some text has several     */
};

static const char *between(const struct aligned_column *c, const struct column_meaning *m)
{
  return m->between && c->has_parts ? m->between : "";
}

/* One a line: name, value and unit, and what it is */
static void print_upright(const struct aligned *a, FILE *file, column_meaning *meaning)
{
  int widest = 0, widest_value = 0;
  for (int i = 0; i < a->columns; i++) {
    int width = (int)strlen(a->cells[i]),
        value = (int)(strlen(a->cells[i + a->columns]) + strlen(unit_of(meaning, a->cells[i])));
    widest = width > widest ? width : widest;
    widest_value = value > widest_value && value < 40 ? value : widest_value;
  }
  for (int i = 0; i < a->columns; i++) {
    const struct column_meaning *m = meaning ? meaning(a->cells[i]) : NULL;
    const char *value = a->cells[i + a->columns], *unit = m ? m->unit : "";
    fprintf(file, "%-*s  ", widest, a->cells[i]);
    print_text(file, value, widest + 2);
    fprintf(file, "%s%s", *unit ? " " : "", unit);
    if (m)
      fprintf(file, "%*s  %s%s%s", widest_value - (int)(strlen(value) + strlen(unit)) + (*unit == '\0'), "",
              m->sentence, *between(&a->column[i], m) ? "; " : "", between(&a->column[i], m));
    fputc('\n', file);
  }
}

static bool print_wrapped(const struct aligned *a, FILE *file, column_meaning *meaning)
{
  struct wrapped kept;
  FILE *lines = wrap_begin(&kept);
  if (lines)
    print_upright(a, lines, meaning);
  return wrap_end(&kept, file, 0);
}

/* Numbers are on the right of their columns */
static bool is_number(const char *text)
{
  return isdigit((unsigned char)*text) || (*text == '-' && text[1] != '\0') || strcmp(text, "nan") == 0
         || strcmp(text, "inf") == 0;
}

static void print_row(const struct aligned *a, FILE *file, const char *const *cells)
{
  for (int i = 0; i < a->columns; i++) {
    bool last = i + 1 == a->columns;
    if (a->column[i].numbers)
      fprintf(file, "%*s%s", a->column[i].width, cells[i], last ? "" : "  ");
    else
      fprintf(file, "%-*s%s", last ? 0 : a->column[i].width, cells[i], last ? "" : "  ");
  }
  fputc('\n', file);
}

/* Widens the columns to what is kept; of the first block also finds those of numbers. */
static void measure(struct aligned *a, column_meaning *meaning, bool first)
{
  for (int i = 0; i < a->columns; i++) {
    struct aligned_column *c = &a->column[i];
    const int least = (int)strlen(unit_of(meaning, a->cells[i]));
    c->width = least > c->width ? least : c->width;
    c->numbers = first ? a->count > a->columns : c->numbers;
    for (long k = i; k < a->count; k += a->columns) {
      int length = (int)strlen(a->cells[k]);
      c->width = length > c->width ? length : c->width;
      c->numbers = c->numbers && (!first || k == i || is_number(a->cells[k]));
      c->has_parts = c->has_parts || (k > i && strstr(a->cells[k], " | "));
    }
  }
}

static void print_rows(struct aligned *a, FILE *file, column_meaning *meaning, const char **units, bool first)
{
  bool has_units = false;
  for (int i = 0; i < a->columns; i++) {
    units[i] = unit_of(meaning, a->cells[i]);
    has_units = has_units || *units[i];
  }
  for (long k = first ? 0 : a->columns; k < a->count; k += a->columns) {
    print_row(a, file, (const char *const *)(a->cells + k));
    if (k == 0 && has_units)
      print_row(a, file, units);
  }
  for (; a->count > a->columns; a->count--)
    free(a->cells[a->count - 1]);
}

static void print_legend(const struct aligned *a, FILE *file, column_meaning *meaning)
{
  for (int i = 0; i < a->columns; i++) {
    const struct column_meaning *m = meaning ? meaning(a->cells[i]) : NULL;
    if (m && m->has_symbols)
      fprintf(file, "%s: %s%s%s\n", a->cells[i], m->sentence, *between(&a->column[i], m) ? "; " : "",
              between(&a->column[i], m));
  }
}

bool aligned_print(struct aligned *a, FILE *file, column_meaning *meaning, bool last)
{
  size_t columns = (size_t)(a->columns > 0 ? a->columns : 1);
  bool first = !a->column, lost = a->lost, upright = first && last && a->columns > 2 && a->count == 2L * a->columns;
  const char **units = calloc(columns, sizeof *units);
  a->column = first ? calloc(columns, sizeof *a->column) : a->column;
  if (!lost && a->column && units) {
    measure(a, meaning, first);
    if (upright)
      lost = !print_wrapped(a, file, meaning);
    else
      print_rows(a, file, meaning, units, first);
    if (!upright && last)
      print_legend(a, file, meaning);
  } else
    lost = true;
  free(units);
  if (last || lost)
    aligned_free(a);
  return !lost;
}
