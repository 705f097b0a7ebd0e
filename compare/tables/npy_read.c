#include "compare/tables/npy.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "compare/text/digits.h"
#include "compare/text/message.h"

enum { FRONT_1 = 10, FRONT_2 = 12, LONGEST_HEAD = 1 << 20, ANY_SIZE = 1 << 20 };

/* Reads a Python string in place and moves *rest behind it. Returns NULL if it is not a string. */
static char *quoted(char **rest)
{
  char *from = *rest + strspn(*rest, " "), quote = *from, *text = from + 1, *to = text;
  if (quote != '\'' && quote != '"')
    return NULL;
  for (from = text; *from != quote && *from; from++)
    *to++ = *from == '\\' && from[1] ? *++from : *from;
  if (!*from)
    return NULL;
  *rest = from + 1;
  *to = '\0';
  return text;
}

static bool skip(char **rest, char expected)
{
  char *at = *rest + strspn(*rest, " ");
  const bool found = *at == expected;
  *rest = at + found;
  return found;
}

/* Returns the text behind 'NAME': in the dictionary, or NULL. */
static char *value_of(char *head, const char *name)
{
  char *at = strstr(head, name);
  return at ? at + strlen(name) : NULL;
}

/* Reads the type of a column. Returns NULL or the error. */
static const char *read_type(struct npy_column *c, const char *type)
{
  const bool has_order = *type && strchr("<>|=", *type);
  c->is_big = *type == '>' || (*type != '<' && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__);
  type += has_order;
  c->kind = *type;
  c->size = (int)strtol(*type ? type + 1 : type, NULL, 10);
  bool fine = c->kind == 'f' ? c->size == 4 || c->size == 8
              : c->kind == 'i' || c->kind == 'u'
                  ? c->size == 1 || c->size == 2 || c->size == 4 || c->size == 8
                  : c->kind && strchr("SUV", c->kind) && c->size >= 0 && c->size <= ANY_SIZE;
  c->size *= c->kind == 'U' ? 4 : 1;
  return fine ? NULL
         : c->kind == 'O'
             ? "holds pickled objects, which are not read"
             : "is of a type that is not read; allowed are floats of 4 or 8 bytes, integers, and texts (S, U)";
}

static const char *read_columns(struct npy_file *n, char *at)
{
  const char *wrong = NULL;
  if (!at || !skip(&at, '['))
    return "this array has no named columns: it must be a structured array with a name for each parameter";
  while (!wrong && skip(&at, '(')) {
    struct npy_column *c = &n->column[n->columns];
    c->name = quoted(&at);
    char *type = c->name && skip(&at, ',') ? quoted(&at) : NULL;
    if (n->columns == TABLE_COLUMNS - 1)
      return "there are too many columns";
    if (!type || !skip(&at, ')'))
      return wrong_text("column '%.80s' is neither a number nor a text: it is an array or has a title",
                        c->name ? c->name : "");
    wrong = read_type(c, type);
    if (wrong)
      return wrong_text("column '%.80s' %s", c->name, wrong);
    n->size += (size_t)c->size;
    n->columns++;
    skip(&at, ',');
  }
  return NULL;
}

static const char *read_head(struct npy_file *n)
{
  char *shape = value_of(n->head, "'shape':"), *end = shape, *descr = value_of(n->head, "'descr':");
  n->notes = strchr(n->head, '\n');
  n->rows = shape && skip(&end, '(') ? strtol(end, &end, 10) : -1;
  skip(&end, ',');
  if (n->rows < 0 || !skip(&end, ')'))
    return "this array does not have one dimension";
  const char *wrong = read_columns(n, descr);
  struct stat is;
  if (!wrong && fstat(fileno(n->file), &is) == 0 && S_ISREG(is.st_mode)
      && (double)is.st_size < (double)n->head_size + (double)n->rows * (double)n->size)
    wrong = wrong_text("the file is cut off: its head states %ld rows, too many for %.0f bytes", n->rows,
                       (double)is.st_size);
  return wrong;
}

const char *npy_open(struct npy_file *n, FILE *file, bool is_begun)
{
  unsigned char front[FRONT_2] = { 0x93 };
  *n = (struct npy_file){ .file = file };
  size_t got = is_begun + fread(front + is_begun, 1, FRONT_1 - (size_t)is_begun, file);
  const bool is_first = front[6] == 1;
  if (got < FRONT_1 || memcmp(front, "\x93NUMPY", 6) != 0 || front[6] < 1 || front[6] > 3)
    return "this is not a file of numpy.save, of format 1, 2 or 3";
  got += is_first ? 0 : fread(front + FRONT_1, 1, 2, file);
  unsigned long length = front[8] | (unsigned long)front[9] << 8;
  length |= is_first ? 0 : (unsigned long)front[10] << 16 | (unsigned long)front[11] << 24;
  n->head_size = (long)(got + length);
  n->head = length <= LONGEST_HEAD ? calloc(1, length + 1) : NULL;
  if (!n->head || fread(n->head, 1, length, file) != length)
    return "the file ends within its head, or the head is longer than a million characters";
  const char *wrong = read_head(n);
  n->record = wrong ? NULL : malloc(n->size + sizeof(double));
  return wrong || n->record ? wrong : "out of memory";
}

void npy_close(struct npy_file *n)
{
  free(n->head);
  free(n->record);
  n->head = n->record = NULL;
}

/* Writes a number of any type as text. */
static void number_of(char *to, const struct npy_column *c, const unsigned char *bytes)
{
  uint64_t bits = 0, sign = c->kind == 'i' ? UINT64_C(1) << (8 * c->size - 1) : 0;
  for (int i = 0; i < c->size; i++)
    bits |= (uint64_t)bytes[c->is_big ? c->size - 1 - i : i] << 8 * i;
  if (c->kind == 'f' && c->size == 8) {
    double x;
    memcpy(&x, &bits, sizeof x);
    number_text(to, x, 0);
  } else if (c->kind == 'f') {
    const uint32_t half = (uint32_t)bits;
    float x;
    memcpy(&x, &half, sizeof x);
    number_text(to, (double)x, 0);
  } else if (sign != 0)
    snprintf(to, NUMBER_TEXT, "%lld", (long long)((bits ^ sign) - sign));
  else
    snprintf(to, NUMBER_TEXT, "%llu", (unsigned long long)bits);
}

/* Writes a text of bytes, or of characters of 4 bytes, of which those beyond ASCII become question marks. */
static void text_of(char *to, const struct npy_column *c, const unsigned char *bytes)
{
  const int step = c->kind == 'U' ? 4 : 1;
  for (int i = 0; i < c->size; i += step) {
    const unsigned char *b = bytes + i + (step == 4 && c->is_big ? 3 : 0);
    bool is_one = step == 1 || (bytes[i + 1] | bytes[i + 2] | bytes[i + (c->is_big ? 0 : 3)] | (*b & 0x80)) == 0;
    *to++ = (char)(is_one ? *b : '?');
  }
  *to = '\0';
}

int npy_next(struct npy_file *n, char *space, size_t size, char **cells)
{
  const unsigned char *bytes = (const unsigned char *)n->record;
  const char *end = space + size;
  int count = 0;
  if (fread(n->record, 1, n->size, n->file) != n->size)
    return -1;
  for (const struct npy_column *c = n->column; c < n->column + n->columns; bytes += c++->size) {
    if (c->kind == 'V')
      continue;
    if (end - space < c->size + NUMBER_TEXT)
      return -1;
    cells[count++] = space;
    (c->kind == 'S' || c->kind == 'U' ? text_of : number_of)(space, c, bytes);
    space += strlen(space) + 1;
  }
  return count;
}
