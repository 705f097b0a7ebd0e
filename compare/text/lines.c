#include "compare/text/lines.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { CHUNK = 1 << 16 }; /* bytes that are read at a time */

/* What some programs write at the head of a UTF-8 file */
static const char BYTE_ORDER_MARK[] = "\xef\xbb\xbf";

static bool fail(struct lines *l, int error)
{
  l->error = error;
  return false;
}

/* Moves what is left to the head of the buffer, and makes room behind it. */
static bool make_room(struct lines *l)
{
  if (l->begin > 0)
    memmove(l->buffer, l->buffer + l->begin, l->end - l->begin);
  l->end -= l->begin;
  l->begin = 0;
  if (l->end + CHUNK < l->size)
    return true;
  size_t size = 2 * (l->end + CHUNK);
  char *grown = realloc(l->buffer, size);
  if (!grown)
    return false;
  l->buffer = grown;
  l->size = size;
  return true;
}

/* Reads on: what there is, without waiting for more. False: there is no more, or error. */
static bool read_on(struct lines *l)
{
  ssize_t got;
  if (!l->file)
    return false;
  if (!make_room(l))
    return fail(l, ENOMEM);
  while ((got = read(fileno(l->file), l->buffer + l->end, CHUNK)) < 0 && errno == EINTR)
    ;
  if (got < 0)
    return fail(l, errno);
  l->end += (size_t)got;
  return got > 0;
}

/* The first LF or CR of size bytes, or NULL */
static char *line_end(char *text, size_t size)
{
  char *newline = memchr(text, '\n', size), *back = memchr(text, '\r', newline ? (size_t)(newline - text) : size);
  return back ? back : newline;
}

/* Of CRLF, only now, as a terminal may send CR alone and then wait. */
static void pass_newline(struct lines *l)
{
  if (l->ended_by_return && (l->begin < l->end || read_on(l)) && l->buffer[l->begin] == '\n')
    l->begin++;
  l->ended_by_return = false;
}

static void drop_mark(struct lines *l)
{
  const size_t mark = sizeof BYTE_ORDER_MARK - 1;
  if (strncmp(l->line, BYTE_ORDER_MARK, mark) != 0)
    return;
  l->line += mark;
  l->length -= (ssize_t)mark;
}

bool next_line(struct lines *l)
{
  char *end = NULL;
  size_t seen = 0;
  if (l->too_long)
    return fail(l, EFBIG);
  pass_newline(l);
  for (;;) {
    end = seen < l->end - l->begin ? line_end(l->buffer + l->begin + seen, l->end - l->begin - seen) : NULL;
    seen = l->end - l->begin;
    if (end || seen >= LONGEST_LINE || !read_on(l))
      break;
  }
  l->length = end ? end - (l->buffer + l->begin) : (ssize_t)seen;
  if (l->error || (!end && seen == 0))
    return false;
  l->too_long = l->length >= LONGEST_LINE;
  if (l->too_long)
    l->length = LONGEST_LINE;
  l->line = l->buffer + l->begin;
  l->ended_by_return = end && *end == '\r';
  l->begin += (size_t)l->length + (end != NULL);
  l->line[l->length] = '\0';
  if (l->number++ == 0)
    drop_mark(l);
  return true;
}

bool lines_of_text(struct lines *l, const char *text)
{
  size_t size = strlen(text) + 1;
  *l = (struct lines){ .buffer = malloc(size), .size = size, .end = size - 1 };
  if (l->buffer)
    memcpy(l->buffer, text, size);
  return l->buffer != NULL;
}

void lines_free(struct lines *l)
{
  free(l->buffer);
  l->buffer = l->line = NULL;
}

const char *lines_error_text(const struct lines *l)
{
  return l->error == EFBIG ? "a line has more than a million characters" : strerror(l->error);
}

const char *line_fault(const struct lines *l)
{
  if (memchr(l->line, '\0', (size_t)l->length) != NULL)
    return "this is not a text file";
  return l->too_long ? "this line is too long: more than a million characters" : NULL;
}

int lines_cells(char *line, char **cells, int most)
{
  int n = 0;
  for (char *cell = line; cell && n < most;) {
    char *tab = strchr(cell, '\t');
    if (tab)
      *tab = '\0';
    cells[n++] = cell;
    cell = tab ? tab + 1 : NULL;
  }
  return n;
}
