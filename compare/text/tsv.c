#include "compare/text/tsv.h"

#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text/file.h"
#include "compare/text/message.h"
#include "compare/text/npy.h"

static bool begin(struct tsv *tsv, const char *name, enum tsv_style style, FILE *file)
{
  *tsv = (struct tsv){ .name = name, .style = style, .file = file, .error = file ? 0 : errno };
  tsv->buffer = file ? malloc(LONGEST_LINE + 1) : NULL;
  if (file && !tsv->buffer)
    tsv->error = ENOMEM;
  const int first = tsv->buffer ? getc(file) : EOF;
  if (first == 0x93 && (tsv->npy = malloc(sizeof *tsv->npy)))
    tsv->wrong = npy_open(tsv->npy, file, true);
  else if (first != EOF)
    ungetc(first, file);
  return tsv->buffer != NULL;
}

bool tsv_open(struct tsv *tsv, const char *file, enum tsv_style style)
{
  return begin(tsv, strcmp(file, "-") == 0 ? "standard input" : file, style, file_read(file));
}

bool tsv_open_text(struct tsv *tsv, const char *name, const char *text)
{
  const char *some = *text ? text : "\n"; /* a stream of nothing need not open */
  return begin(tsv, name, TSV_TABS, fmemopen((void *)some, strlen(some), "r"));
}

void tsv_close(struct tsv *tsv)
{
  if (tsv->file && tsv->file != stdin)
    fclose(tsv->file);
  if (tsv->npy)
    npy_close(tsv->npy);
  free(tsv->npy);
  free(tsv->buffer);
  free(tsv->header);
  tsv->buffer = tsv->header = NULL;
}

/* Reads a line into the buffer, without its end: LF, CR, or CRLF, whose LF ends another line, which is empty and does
 * not count, as a terminal may send CR alone and then wait. False: there is none. */
static bool read_line(struct tsv *tsv)
{
  const bool after_return = tsv->ended_by_return;
  int c = 0;
  char *to = tsv->buffer, *const stop = to + LONGEST_LINE;
  if (tsv->length == LONGEST_LINE) /* what comes is the rest of it */
    tsv->error = EFBIG;
  while (tsv->error == 0 && to < stop && (c = getc_unlocked(tsv->file)) != EOF && c != '\n' && c != '\r')
    *to++ = (char)c;
  if (c == EOF && ferror(tsv->file))
    tsv->error = errno;
  tsv->ended_by_return = c == '\r';
  tsv->length = (size_t)(to - tsv->buffer);
  *to = '\0';
  bool found = tsv->error == 0 && (c != EOF || tsv->length > 0);
  tsv->number += found && !(after_return && c == '\n' && tsv->length == 0);
  return found;
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

/* The names of the columns, and then the records */
static bool next_record(struct tsv *tsv)
{
  struct npy_file *n = tsv->npy;
  tsv->fault = tsv->wrong ? tsv->wrong : n->columns > TSV_CELLS ? "this array has more than 256 columns" : NULL;
  tsv->count = 0;
  tsv->length = n->size - 1;
  if (tsv->header && tsv->number == n->rows)
    return false;
  if (tsv->header && (tsv->count = npy_next(n, tsv->buffer, LONGEST_LINE, tsv->cell)) < 0)
    return tsv->error = EPIPE, false;
  for (int i = 0; i < n->columns && !tsv->header && !tsv->fault; i++)
    if (n->column[i].kind != 'V')
      tsv->cell[tsv->count++] = n->column[i].name;
  tsv->number += tsv->header != NULL;
  return true;
}

void tsv_skip(struct tsv *tsv, long rows)
{
  if (!tsv->npy || fseeko(tsv->file, (off_t)rows * (off_t)tsv->npy->size, SEEK_CUR) != 0)
    while (rows-- > 0 && tsv_next(tsv))
      ;
  else
    tsv->number += rows;
}

bool tsv_next(struct tsv *tsv)
{
  if (tsv->npy)
    return next_record(tsv);
  const bool words = tsv->style != TSV_TABS;
  while (read_line(tsv)) {
    char *text = tsv->buffer;
    if (tsv->number == 1 && strncmp(text, "\xef\xbb\xbf", 3) == 0) /* a mark that some programs write before UTF-8 */
      text += 3;
    tsv->fault = strlen(tsv->buffer) < tsv->length ? "this is not a text file"
                 : tsv->length == LONGEST_LINE     ? "this line is too long: more than a million characters"
                                                   : NULL;
    if (words && !tsv->fault)
      text = trimmed(text, " \t");
    if (*text == '#' || (*text == '\0' && !tsv->fault))
      continue;
    const bool commas = tsv->style == TSV_ANY && strchr(text, ',');
    tsv->count = 0;
    if (!tsv->fault)
      split(tsv, text, !words || strchr(text, '\t') ? "\t" : commas ? "," : " ", words);
    return true;
  }
  return false;
}

const char *tsv_error(struct tsv *tsv)
{
  if (!tsv->error)
    return NULL;
  return wrong_text("cannot read %.300s: %s", tsv->name,
                    tsv->error == EFBIG   ? "a line has more than a million characters"
                    : tsv->error == EPIPE ? "it ends before its last row"
                                          : strerror(tsv->error));
}

bool tsv_take_header(struct tsv *tsv)
{
  char *another = malloc(LONGEST_LINE + 1);
  if (!another)
    return false;
  tsv->header = tsv->buffer;
  tsv->buffer = another;
  for (tsv->columns = 0; tsv->columns < tsv->count; tsv->columns++)
    tsv->column[tsv->columns] = trimmed(tsv->cell[tsv->columns], " '\"");
  return true;
}

const char *tsv_at_line(struct tsv *tsv, long line, const char *format, ...)
{
  char text[TSV_MESSAGE];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return line > 0 ? wrong_text("%.200s:%ld: %s", tsv->name, line, text) : wrong_text("%.200s: %s", tsv->name, text);
}
