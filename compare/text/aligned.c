#include "compare/text/aligned.h"

#include <ctype.h>
#include <string.h>

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

void aligned_free(struct aligned *a)
{
  for (long i = 0; i < a->count + a->is_open; i++)
    free(a->cells[i]);
  free(a->cells);
  *a = (struct aligned){ .columns = a->columns };
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
      fprintf(file, "%*s  %s", widest_value - (int)(strlen(value) + strlen(unit)) + (*unit == '\0'), "", m->sentence);
    fputc('\n', file);
  }
}

/* Numbers are on the right of their columns */
static bool is_number(const char *text)
{
  return isdigit((unsigned char)*text) || (*text == '-' && text[1] != '\0') || strcmp(text, "nan") == 0
         || strcmp(text, "inf") == 0;
}

static void print_row(const struct aligned *a, FILE *file, const char *const *cells, const int *width, const bool *numbers)
{
  for (int i = 0; i < a->columns; i++) {
    bool last = i + 1 == a->columns;
    if (numbers[i])
      fprintf(file, "%*s%s", width[i], cells[i], last ? "" : "  ");
    else
      fprintf(file, "%-*s%s", last ? 0 : width[i], cells[i], last ? "" : "  ");
  }
  fputc('\n', file);
}

static void print_columns(const struct aligned *a, FILE *file, column_meaning *meaning, int *width, bool *numbers,
                          const char **units)
{
  bool has_units = false;
  for (int i = 0; i < a->columns; i++) {
    units[i] = unit_of(meaning, a->cells[i]);
    has_units = has_units || *units[i];
    width[i] = (int)strlen(units[i]);
    numbers[i] = a->count > a->columns;
    for (long k = i; k < a->count; k += a->columns) {
      int length = (int)strlen(a->cells[k]);
      width[i] = length > width[i] ? length : width[i];
      numbers[i] = numbers[i] && (k == i || is_number(a->cells[k]));
    }
  }
  for (long k = 0; k < a->count; k += a->columns) {
    print_row(a, file, (const char *const *)(a->cells + k), width, numbers);
    if (k == 0 && has_units)
      print_row(a, file, units, width, numbers);
  }
  for (int i = 0; i < a->columns; i++) {
    const struct column_meaning *m = meaning ? meaning(a->cells[i]) : NULL;
    if (m && m->has_symbols)
      fprintf(file, "%s: %s\n", a->cells[i], m->sentence);
  }
}

bool aligned_print(struct aligned *a, FILE *file, column_meaning *meaning)
{
  size_t columns = (size_t)(a->columns > 0 ? a->columns : 1);
  int *width = calloc(columns, sizeof *width);
  bool *numbers = calloc(columns, sizeof *numbers), lost = a->lost;
  const char **units = calloc(columns, sizeof *units);
  if (!lost && width && numbers && units) {
    if (a->columns > 2 && a->count == 2L * a->columns)
      print_upright(a, file, meaning);
    else
      print_columns(a, file, meaning, width, numbers, units);
  } else
    lost = true;
  free(width);
  free(numbers);
  free(units);
  aligned_free(a);
  return !lost;
}
