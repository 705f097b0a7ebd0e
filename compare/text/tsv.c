#include "compare/text/tsv.h"

#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text/file.h"

bool tsv_open(struct tsv *tsv, const char *file, enum tsv_style style)
{
  *tsv = (struct tsv){ .name = strcmp(file, "-") == 0 ? "standard input" : file, .style = style };
  tsv->file = file_read(file);
  tsv->error = tsv->file ? 0 : errno;
  return tsv->file != NULL;
}

bool tsv_open_text(struct tsv *tsv, const char *name, const char *text)
{
  size_t size = strlen(text) + 3;
  *tsv = (struct tsv){ .name = name, .style = TSV_TABS, .keeps_all = true, .buffer = malloc(size), .size = size };
  tsv->file = tsv->buffer ? fmemopen((void *)text, size - 3, "r") : NULL;
  tsv->error = tsv->file ? 0 : errno;
  return tsv->file != NULL;
}

void tsv_close(struct tsv *tsv)
{
  if (tsv->file && tsv->file != stdin)
    fclose(tsv->file);
  free(tsv->buffer);
  free(tsv->header);
  tsv->buffer = tsv->header = NULL;
}

static bool fail(struct tsv *tsv, int error)
{
  tsv->error = error;
  return false;
}

/* Room for one character more and a NUL */
static bool make_room(struct tsv *tsv)
{
  if (tsv->end + 1 < tsv->size)
    return true;
  size_t size = 2 * (tsv->end + 128);
  char *grown = realloc(tsv->buffer, size);
  if (!grown)
    return false;
  tsv->buffer = grown;
  tsv->size = size;
  return true;
}

/* Reads a line into the buffer, without its end. The LF of CRLF is left to the next one, as a terminal may send CR
 * alone and then wait. False: there is none. */
static bool read_line(struct tsv *tsv)
{
  int c = tsv->ended_by_return ? getc_unlocked(tsv->file) : '\n';
  if (c != '\n')
    ungetc(c, tsv->file);
  if (tsv->too_long)
    return fail(tsv, EFBIG);
  tsv->begin = tsv->end = tsv->keeps_all && tsv->number > 0 ? tsv->end + 1 : 0;
  for (bool more = true; more;) {
    if (!make_room(tsv))
      return fail(tsv, ENOMEM);
    size_t room = tsv->size - 1 - tsv->end, left = tsv->begin + LONGEST_LINE - tsv->end;
    char *to = tsv->buffer + tsv->end, *stop = to + (room < left ? room : left);
    while (to < stop && (c = getc_unlocked(tsv->file)) != EOF && c != '\n' && c != '\r')
      *to++ = (char)c;
    tsv->end = (size_t)(to - tsv->buffer);
    tsv->too_long = to == stop && left <= room;
    more = to == stop && !tsv->too_long;
  }
  tsv->ended_by_return = c == '\r';
  if (c == EOF && ferror(tsv->file))
    return fail(tsv, errno);
  tsv->buffer[tsv->end] = '\0';
  bool found = c != EOF || tsv->end > tsv->begin;
  tsv->number += found;
  return found;
}

/* The line without a byte order mark, which some programs write at the head of a UTF-8 file; and what is wrong with
 * it */
static char *judged_line(struct tsv *tsv)
{
  static const char mark[] = "\xef\xbb\xbf";
  const size_t size = sizeof mark - 1;
  char *line = tsv->buffer + tsv->begin;
  tsv->fault = tsv->too_long ? "this line is too long: more than a million characters" : NULL;
  if (strlen(line) < tsv->end - tsv->begin)
    tsv->fault = "this is not a text file";
  return tsv->number == 1 && strncmp(line, mark, size) == 0 ? line + size : line;
}

static char *trimmed(char *text, const char *around)
{
  text += strspn(text, around);
  for (size_t n = strlen(text); n > 0 && strchr(around, text[n - 1]);)
    text[--n] = '\0';
  return text;
}

/* Splits at each of the separators, or at runs of them. */
static void split(struct tsv *tsv, char *rest, const char *separators, bool runs)
{
  tsv->count = 0;
  while (rest) {
    char *cell = rest;
    rest += strcspn(rest, separators);
    rest = *rest ? rest : NULL;
    if (rest)
      *rest++ = '\0';
    if (runs && *(cell = trimmed(cell, " ")) == '\0' && (*separators != ',' || !rest))
      continue;
    if (tsv->count == TSV_CELLS) {
      tsv->fault = "this line has more than 256 columns";
      return;
    }
    tsv->cell[tsv->count++] = cell;
  }
}

bool tsv_next(struct tsv *tsv)
{
  bool words = tsv->style != TSV_TABS;
  while (read_line(tsv)) {
    char *text = judged_line(tsv);
    if (words && !tsv->fault)
      text = trimmed(text, " \t");
    if (*text == '#' || (*text == '\0' && !tsv->fault))
      continue;
    tsv->count = 0;
    if (!tsv->fault)
      split(tsv, text,
            !words || strchr(text, '\t')                 ? "\t"
            : tsv->style == TSV_ANY && strchr(text, ',') ? ","
                                                         : " ",
            words);
    return true;
  }
  return false;
}

const char *tsv_error(struct tsv *tsv)
{
  if (!tsv->error)
    return NULL;
  snprintf(tsv->message, TSV_MESSAGE, "cannot read %.300s: %s", tsv->name,
           tsv->error == EFBIG ? "a line has more than a million characters" : strerror(tsv->error));
  return tsv->message;
}

bool tsv_take_header(struct tsv *tsv)
{
  size_t size = 0;
  for (int i = 0; i < tsv->count; i++)
    size += strlen(tsv->cell[i]) + 1;
  char *end = tsv->header = malloc(size + 1);
  tsv->columns = tsv->header ? tsv->count : 0;
  for (int i = 0; i < tsv->columns; i++) {
    size = strlen(tsv->cell[i]) + 1;
    tsv->column[i] = trimmed(memcpy(end, tsv->cell[i], size), " '\"");
    end += size;
  }
  return tsv->header != NULL;
}

int tsv_column(const struct tsv *tsv, const char *name)
{
  for (int i = 0; i < tsv->columns; i++)
    if (strcmp(tsv->column[i], name) == 0)
      return i;
  return -1;
}

const char *tsv_at_line(struct tsv *tsv, long line, const char *format, ...)
{
  va_list arguments;
  va_start(arguments, format);
  int used = snprintf(tsv->message, TSV_MESSAGE, line > 0 ? "%.200s:%ld: " : "%.200s: ", tsv->name, line);
  vsnprintf(tsv->message + used, TSV_MESSAGE - (size_t)used, format, arguments);
  va_end(arguments);
  return tsv->message;
}
