#include "compare/lines.h"

#include <errno.h>
#include <string.h>

/* What some programs write at the head of a UTF-8 file */
static const char BYTE_ORDER_MARK[] = "\xef\xbb\xbf";

bool next_line(struct lines *l)
{
  const size_t mark = sizeof BYTE_ORDER_MARK - 1;
  l->length = getline(&l->line, &l->size, l->file);
  if (l->length < 0) {
    l->error = errno;
    return false;
  }
  if (l->number++ == 0 && strncmp(l->line, BYTE_ORDER_MARK, mark) == 0) {
    l->length -= (ssize_t)mark;
    memmove(l->line, l->line + mark, (size_t)l->length + 1);
  }
  while (l->length > 0 && (l->line[l->length - 1] == '\n' || l->line[l->length - 1] == '\r'))
    l->line[--l->length] = '\0';
  return true;
}

bool is_binary(const struct lines *l) { return memchr(l->line, '\0', (size_t)l->length) != NULL; }

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
