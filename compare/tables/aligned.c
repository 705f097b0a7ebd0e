#include "compare/tables/aligned.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

FILE *aligned_begin_row(struct aligned *a, int columns)
{
  a->columns = columns;
  if (!a->kept)
    a->kept = open_memstream(&a->text, &a->size);
  a->rows += a->kept != NULL;
  return a->kept;
}

void aligned_free(struct aligned *a)
{
  if (a->kept)
    fclose(a->kept);
  free(a->text);
  a->kept = NULL;
  a->text = NULL;
  a->rows = 0;
  a->has_begun = false;
}

static int longer(int width, const char *text)
{
  const int length = (int)strlen(text);
  return length > width ? length : width;
}

/* Returns true for a number; numbers are right-aligned. */
static bool is_number(const char *text)
{
  return isdigit((unsigned char)*text) || (*text == '-' && text[1] != '\0') || strcmp(text, "nan") == 0
         || strcmp(text, "inf") == 0;
}

/* Widens the columns to the kept cells. The first block, with the names, decides which columns are numbers. */
static void measure(struct aligned *a, const char *const *cells, column_meaning *meaning)
{
  const bool first = !a->has_begun;
  for (int i = 0; i < a->columns; i++) {
    struct aligned_column *c = &a->column[i];
    for (long k = 0; k < a->rows; k++) {
      const char *cell = cells[k * a->columns + i]; /* NOLINT(clang-analyzer-core.uninitialized.Assign): all are set */
      if (first && k == 0) {
        const struct column_meaning unknown = { .unit = "", .sentence = "" }, *known = meaning ? meaning(cell) : NULL;
        *c = (struct aligned_column){ .meaning = known ? *known : unknown, .is_number = a->rows > 1 };
        c->width = longer(longer(0, c->meaning.unit), cell);
        continue;
      }
      c->width = longer(c->width, cell);
      c->is_number = c->is_number && (!first || is_number(cell));
      c->has_parts = c->has_parts || strstr(cell, " | ");
    }
  }
}

/* Prints a text, a long one with a line break behind each "; " and " | ", indented to column `left`. */
static void print_text(FILE *file, const char *text, int left)
{
  enum { LONGEST = 60 };
  bool is_long = strlen(text) > LONGEST;
  for (; *text; text++) {
    fputc(*text, file);
    if (is_long && text[1] == ' ' && (*text == ';' || *text == '|')) {
      fprintf(file, "\n%*s", left, "");
      text++;
    }
  }
}

/* Prints the description of a column, and the meaning of " | " in it. */
static void print_meaning(FILE *file, const struct aligned_column *c)
{
  const char *between = c->meaning.between && c->has_parts ? c->meaning.between : "";
  fprintf(file, "%s%s%s\n", c->meaning.sentence, *between ? "; " : "", between);
}

/* Prints a row upright, a cell on each line: name, value, unit and description. */
static void print_upright(const struct aligned *a, const char *const *names, const char *const *values, FILE *file)
{
  enum { LONGEST = 40 }; /* longer values are not aligned with the descriptions */
  int name = 0, value = 0;
  for (int i = 0; i < a->columns; i++) {
    int length = (int)(strlen(values[i]) + strlen(a->column[i].meaning.unit));
    name = longer(name, names[i]);
    value = length > value && length < LONGEST ? length : value;
  }
  for (int i = 0; i < a->columns; i++) {
    const char *unit = a->column[i].meaning.unit;
    if (a->upright && strcmp(values[i], "-") == 0)
      continue;
    fprintf(file, "%-*s  ", name, names[i]);
    print_text(file, values[i], name + 2);
    fprintf(file, "%s%s", *unit ? " " : "", unit);
    if (!*a->column[i].meaning.sentence) {
      fputc('\n', file);
      continue;
    }
    fprintf(file, "%*s  ", value - (int)(strlen(values[i]) + strlen(unit)) + (*unit == '\0'), "");
    print_meaning(file, &a->column[i]);
  }
}

/* Prints a row; cells NULL: the units, below the names. */
static void print_row(const struct aligned *a, FILE *file, const char *const *cells)
{
  for (int i = 0; i < a->columns; i++) {
    const char *cell = cells ? cells[i] : a->column[i].meaning.unit;
    bool last = i + 1 == a->columns;
    int width = a->column[i].width;
    fprintf(file, "%*s%s", a->column[i].is_number ? width : last ? 0 : -width, cell, last ? "" : "  ");
  }
  fputc('\n', file);
}

static void print_rows(const struct aligned *a, const char *const *cells, FILE *file)
{
  bool has_units = false;
  for (int i = 0; !a->has_begun && i < a->columns; i++)
    has_units = has_units || *a->column[i].meaning.unit;
  for (long k = 0; k < a->rows; k++) {
    print_row(a, file, cells + k * a->columns);
    if (k == 0 && has_units)
      print_row(a, file, NULL);
  }
}

static void print_legend(const struct aligned *a, const char *const *names, FILE *file)
{
  for (int i = 0; i < a->columns; i++)
    if (a->column[i].meaning.has_symbols) {
      fprintf(file, "%s: ", names[i]);
      print_meaning(file, &a->column[i]);
    }
}

/* Prints the constant columns in lines of 80 columns, and the legend of their symbols. */
static void print_constants(const struct aligned *a, const char *const *cells, const bool *varies, FILE *file)
{
  enum { WIDE = 80 };
  int at = fprintf(file, "# in every row:");
  const char *comma = "";
  for (int i = 0; i < a->columns; i++) {
    const char *value = cells[a->columns + i], *unit = a->column[i].meaning.unit;
    if (varies[i])
      continue;
    at += fprintf(file, "%s", comma);
    if (at + (int)(strlen(cells[i]) + strlen(value) + strlen(unit)) + 6 > WIDE)
      at = fprintf(file, "\n#  ") - 1;
    at += fprintf(file, " %s = %s%s%s", cells[i], value, *unit ? " " : "", unit);
    comma = ",";
  }
  fputc('\n', file);
  for (int i = 0; i < a->columns; i++)
    if (!varies[i] && a->column[i].meaning.has_symbols) {
      fprintf(file, "# %s: ", cells[i]);
      print_meaning(file, &a->column[i]);
    }
}

/* Moves columns with equal cells in all rows to the head, and removes their cells. */
static void gather(struct aligned *a, const char **cells, FILE *file)
{
  const int columns = a->columns;
  bool varies[TABLE_COLUMNS] = { false };
  int kept = 0;
  for (int i = 0; i < columns; kept += varies[i++])
    for (long k = 2; k < a->rows; k++)
      varies[i] = varies[i] || strcmp(cells[k * columns + i], cells[columns + i]) != 0;
  if (kept == 0 || kept == columns)
    return;
  print_constants(a, cells, varies, file);
  for (long from = 0, to = 0; from < a->rows * columns; from++)
    if (varies[from % columns])
      cells[to++] = cells[from];
  a->columns = 0;
  for (int i = 0; i < columns; i++)
    if (varies[i])
      a->column[a->columns++] = a->column[i];
}

bool aligned_print(struct aligned *a, const char *const *names, FILE *file, column_meaning *meaning, bool last)
{
  const long count = a->rows * a->columns;
  const bool upright = a->upright || (!a->has_begun && last && a->columns > 2 && a->rows == 2);
  const char **cells = count > 0 && fflush(a->kept) == 0 ? malloc((size_t)count * sizeof *cells) : NULL;
  const char *cell = a->text;
  for (long i = 0; cells && i < count; i++, cell += strlen(cell) + 1)
    cells[i] = cell;
  if (cells) {
    measure(a, cells, meaning);
    if (a->gathers && !a->has_begun && last && a->rows > 2) {
      gather(a, cells, file);
      names = cells;
    }
    for (long k = 1; upright && k < a->rows; k++) {
      fputs(k > 1 ? "\n" : "", file);
      print_upright(a, cells, cells + k * a->columns, file);
    }
    if (!upright)
      print_rows(a, cells, file);
  }
  const bool whole = count == 0 || cells, has_begun = a->has_begun || cells;
  if (whole && last && !upright && has_begun)
    print_legend(a, names, file);
  free(cells);
  aligned_free(a);
  a->has_begun = has_begun && !last;
  return whole;
}
