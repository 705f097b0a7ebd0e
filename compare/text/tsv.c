#include "compare/text/tsv.h"

#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

bool tsv_open(struct tsv *tsv, const char *file, enum tsv_style style)
{
  bool standard = strcmp(file, "-") == 0;
  *tsv = (struct tsv){ .name = standard ? "standard input" : file, .style = style };
  tsv->lines.file = standard ? stdin : fopen(file, "r");
  tsv->lines.error = tsv->lines.file ? 0 : errno;
  return tsv->lines.file != NULL;
}

bool tsv_open_text(struct tsv *tsv, const char *name, const char *text)
{
  *tsv = (struct tsv){ .name = name, .style = TSV_TABS };
  return lines_of_text(&tsv->lines, text);
}

void tsv_close(struct tsv *tsv)
{
  if (tsv->lines.file && tsv->lines.file != stdin)
    fclose(tsv->lines.file);
  lines_free(&tsv->lines);
  free(tsv->header);
  tsv->header = NULL;
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
    if (runs && *(cell = trimmed(cell, " ")) == '\0')
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
  bool words = tsv->style == TSV_WORDS;
  struct lines *lines = &tsv->lines;
  while (next_line(lines)) {
    tsv->fault = line_fault(lines);
    char *text = words && !tsv->fault ? trimmed(lines->line, " \t") : lines->line;
    if (*text == '#' || (*text == '\0' && !tsv->fault))
      continue;
    tsv->count = 0;
    if (!tsv->fault)
      split(tsv, text, words && !strchr(text, '\t') ? " " : "\t", words);
    return true;
  }
  return false;
}

const char *tsv_error(struct tsv *tsv)
{
  if (!tsv->lines.error)
    return NULL;
  snprintf(tsv->message, TSV_MESSAGE, "cannot read %.300s: %s", tsv->name, lines_error_text(&tsv->lines));
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

const char *tsv_at(struct tsv *tsv, const char *format, ...)
{
  va_list arguments;
  va_start(arguments, format);
  int used = snprintf(tsv->message, TSV_MESSAGE, "%.200s:%ld: ", tsv->name, tsv->lines.number);
  vsnprintf(tsv->message + used, TSV_MESSAGE - (size_t)used, format, arguments);
  va_end(arguments);
  return tsv->message;
}
