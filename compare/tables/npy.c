#include "compare/tables/npy.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "compare/text/message.h"
#include "compare/text/digits.h"
#include "compare/text/values.h"

enum { MIN_TEXT = 8, MIN_MIXED = 32, LONGEST_DOUBLE = 24, MOVED = 4096, ALIGNMENT = 64, WIDEST = 1 << 30 };

void npy_begin(struct npy *n, int columns)
{
  *n = (struct npy){ .columns = columns, .size = (size_t)columns * sizeof(double) };
  memset(n->width, -1, sizeof n->width);
}

void npy_free(struct npy *n)
{
  free(n->records);
  n->records = NULL;
}

static size_t bytes_of(int width) { return width > 0 ? (size_t)width : sizeof(double); }

/* Returns the width of a column for the cells of two others. */
static int joint(int a, int b)
{
  const int wider = a > b ? a : b;
  if (a == b || a < 0 || b < 0)
    return wider;
  return (a == 0 || b == 0) && wider < MIN_MIXED ? MIN_MIXED : wider;
}

static void put_double(char *to, int width, double x)
{
  char text[NUMBER_TEXT] = "";
  if (width > 0) {
    number_text(text, x, 0);
    for (const char *c = text; *c; c++)
      *to++ = *c;
  } else
    memcpy(to, &x, sizeof x);
}

/* Converts records to wider columns; `to` must be zero. */
static void recode(const struct npy *from, const char *records, long rows, const int *width, char *to)
{
  for (; rows > 0; rows--)
    for (int i = 0; i < from->columns; i++) {
      double x;
      memcpy(&x, records, from->width[i] <= 0 ? sizeof x : 0);
      if (from->width[i] <= 0)
        put_double(to, width[i], x);
      else
        memcpy(to, records, (size_t)from->width[i]);
      records += bytes_of(from->width[i]);
      to += bytes_of(width[i]);
    }
}

/* Computes the joint widths and the size of a record. Returns true if they differ from n. */
static bool widens(const struct npy *n, const int *other, int *width, size_t *size)
{
  bool differs = false;
  *size = 0;
  for (int i = 0; i < n->columns; i++) {
    width[i] = joint(n->width[i], other[i]);
    differs |= width[i] != n->width[i];
    *size += bytes_of(width[i]);
  }
  return differs;
}

static int widen(struct npy *n, const int *width, size_t size)
{
  char *wider = n->records ? calloc((size_t)n->room, size) : NULL;
  if (n->records && !wider)
    return ENOMEM;
  if (n->records)
    recode(n, n->records, n->rows, width, wider);
  free(n->records);
  n->records = wider;
  n->size = size;
  memcpy(n->width, width, (size_t)n->columns * sizeof *width);
  return 0;
}

static bool has_room(struct npy *n, long rows)
{
  if (n->rows + rows <= n->room)
    return true;
  const long room = 2 * (n->rows + rows);
  char *grown = realloc(n->records, (size_t)room * n->size);
  if (!grown)
    return false;
  n->room = room;
  n->records = grown;
  return true;
}

/* Returns true for a number; a cell of another table is a number if it fits a double. */
static bool is_number(const struct table_cell *c, double *x)
{
  *x = c->value;
  if (c->kind == CELL_NUMBER || c->kind == CELL_TEXT || !isnan(c->value) || strcmp(c->text, "nan") == 0)
    return c->kind != CELL_TEXT;
  return c->kind == CELL_CARRIED && strlen(c->text) <= LONGEST_DOUBLE && read_number(c->text, x);
}

static int width_of(const char *text)
{
  const size_t length = strlen(text);
  int width = MIN_TEXT;
  while (width < WIDEST && (size_t)width < length)
    width *= 2;
  return width;
}

int npy_row(struct npy *n, const struct table_cell *cells, long digits)
{
  int width[TABLE_COLUMNS], own[TABLE_COLUMNS] = { 0 };
  double x[TABLE_COLUMNS];
  size_t size;
  char text[NUMBER_TEXT];
  for (int i = 0; i < n->columns; i++) {
    own[i] = is_number(&cells[i], &x[i]) ? 0 : width_of(cells[i].text);
    if (own[i] == 0 && digits > 0) {
      number_text(text, x[i], digits);
      (void)read_number(text, &x[i]);
    }
  }
  int error = widens(n, own, width, &size) ? widen(n, width, size) : 0;
  if (error != 0 || !has_room(n, 1) || !n->records)
    return ENOMEM;
  char *to = n->records + (size_t)n->rows++ * n->size;
  memset(to, 0, n->size);
  for (int i = 0; i < n->columns; to += bytes_of(n->width[i++]))
    if (own[i] > 0)
      memcpy(to, cells[i].text, strlen(cells[i].text));
    else
      put_double(to, n->width[i], x[i]);
  return 0;
}

double *npy_doubles(struct npy *n, long rows)
{
  for (int i = 0; i < n->columns; i++) {
    if (n->width[i] > 0)
      return NULL;
    n->width[i] = 0;
  }
  if (!has_room(n, rows))
    return NULL;
  n->rows += rows;
  return (double *)(void *)(n->records + (size_t)(n->rows - rows) * n->size);
}

static int write_at(FILE *to, const char *bytes, size_t size, off_t at)
{
  for (ssize_t done; size > 0; bytes += done, size -= (size_t)done, at += done)
    if ((done = pwrite(fileno(to), bytes, size, at)) < 0)
      return errno;
  return 0;
}

/* Widens the records of a file, the last rows first, because rows move towards the end. */
static int widen_file(struct npy *file, FILE *to, long head, const int *width, size_t size)
{
  char *before = malloc(MOVED * file->size), *after = malloc(MOVED * size);
  int error = before && after ? 0 : ENOMEM;
  for (long left = file->rows, rows; left > 0 && error == 0; left -= rows) {
    rows = left < MOVED ? left : MOVED;
    const off_t was = head + (left - rows) * (off_t)file->size, is = head + (left - rows) * (off_t)size;
    const ssize_t expected = (ssize_t)((size_t)rows * file->size);
    memset(after, 0, (size_t)rows * size);
    if (pread(fileno(to), before, (size_t)expected, was) != expected)
      error = errno != 0 ? errno : EIO;
    recode(file, before, rows, width, after);
    error = error != 0 ? error : write_at(to, after, (size_t)rows * size, is);
  }
  free(before);
  free(after);
  return error != 0 ? error : widen(file, width, size);
}

int npy_move(struct npy *file, FILE *to, long head, struct npy *from)
{
  int width[TABLE_COLUMNS] = { 0 }, error = 0;
  size_t size;
  if (from->rows == 0)
    return 0;
  if (widens(file, from->width, width, &size))
    error = widen_file(file, to, head, width, size);
  if (error == 0 && widens(from, width, width, &size))
    error = widen(from, width, size);
  if (error == 0)
    error = write_at(to, from->records, (size_t)from->rows * size, head + file->rows * (off_t)size);
  file->rows += from->rows;
  from->rows = 0;
  return error;
}

/* Writes the dictionary and the '#' lines. */
static void put_head(FILE *to, const char *const *names, const int *width, int columns, long rows, const char *notes)
{
  static const struct escapes quoted = { "'\\", { "\\'", "\\\\" } };
  const char order = __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ ? '<' : '>';
  fputs("{'descr': [", to);
  for (int i = 0; i < columns; i++) {
    fputs(i == 0 ? "('" : ", ('", to);
    put_escaped(to, names[i], &quoted, SHOWS_CHARACTERS);
    if (width[i] > 0)
      fprintf(to, "', '|S%d')", width[i]);
    else
      fprintf(to, "', '%cf8')", order);
  }
  fprintf(to, "], 'fortran_order': False, 'shape': (%ld,), }\n%s", rows, notes ? notes : "");
}

static const unsigned char magic[] = { 0x93, 'N', 'U', 'M', 'P', 'Y', 3, 0 }; /* version 3: names in UTF-8 */
enum { FRONT = sizeof magic + 4 };                                            /* includes the length of the head */

long npy_head_size(const char *const *names, int columns, const char *notes)
{
  int widest[TABLE_COLUMNS];
  char *text = NULL;
  size_t size = 0;
  FILE *to = open_memstream(&text, &size);
  for (int i = 0; i < columns; i++)
    widest[i] = WIDEST;
  if (to) {
    put_head(to, names, widest, columns, LONG_MAX, notes);
    fclose(to);
  }
  free(text);
  return (long)(FRONT + size + ALIGNMENT) / ALIGNMENT * ALIGNMENT;
}

int npy_write_head(const struct npy *file, FILE *to, long head, const char *const *names, const char *notes)
{
  char *bytes = calloc(1, (size_t)head + 1);
  FILE *text = bytes ? fmemopen(bytes + FRONT, (size_t)head - FRONT + 1, "w") : NULL;
  const unsigned long length = (unsigned long)(head - FRONT);
  if (!text)
    return free(bytes), ENOMEM;
  put_head(text, names, file->width, file->columns, file->rows, notes);
  fclose(text);
  memcpy(bytes, magic, sizeof magic);
  for (int i = 0; i < 4; i++)
    bytes[sizeof magic + (size_t)i] = (char)(length >> 8 * i);
  for (long i = FRONT + (long)strlen(bytes + FRONT); i < head; i++)
    bytes[i] = (char)(i == head - 1 ? '\n' : ' ');
  int error = write_at(to, bytes, (size_t)head, 0);
  free(bytes);
  return error;
}
