#include "compare/command/about.h"

#include <ctype.h>
#include <string.h>

static const char columns_word[] = "Columns:";

static bool starts_with(const char *text, const char *word) { return strncmp(text, word, strlen(word)) == 0; }

static size_t blanks(const char *line) { return strspn(line, " "); }

static const char *line_end(const char *line) { return line + strcspn(line, "\n"); }

/* The name that begins a line: up to a colon, or in a list up to two blanks. Empty where there is none. */
static struct span name_of(const char *line)
{
  enum { LONGEST = 70 };
  const struct span none = { line, 0 };
  size_t indent = blanks(line);
  const char *start = line + indent, *end = line_end(line);
  if (indent > 0) {
    const char *gap = strstr(start, "  ");
    return gap && gap < end ? (struct span){ start, (size_t)(gap - start) } : none;
  }
  if (!islower((unsigned char)*start) && !isdigit((unsigned char)*start) && !starts_with(start, "--"))
    return none;
  for (const char *p = start; p < end && p - start < LONGEST; p++) {
    if (*p == ':' && (p + 1 == end || p[1] == ' '))
      return (struct span){ start, (size_t)(p - start) };
    if (strchr(".;", *p) && p[1] == ' ')
      return none;
  }
  return none;
}

/* Does line begin a passage, after one that began at first? */
static bool begins(const char *first, const char *line)
{
  if (*line == '\n' || *line == '\0')
    return true;
  if (blanks(first) > 0)
    return blanks(line) <= blanks(first);
  if (blanks(line) > 0)
    return true;
  if (!strchr(".:", line[-2]))
    return false;
  bool named = name_of(first).length > 0;
  return name_of(line).length > 0 || starts_with(line, columns_word) || (named && isupper((unsigned char)*line));
}

/* Where within the lines from first to end a sentence is about a column: "... . name: ...". end: nowhere. */
static const char *next_column(const char *first, const char *end)
{
  for (const char *p = first + 2; p < end; p++) {
    size_t n = p[-2] == '.' && p[-1] == ' ' ? strspn(p, "abcdefghijklmnopqrstuvwxyz_0123456789") : 0;
    if (n > 0 && p[n] == ':')
      return p;
  }
  return end;
}

/* The end of the text of a list of columns: its full stop. */
static const char *columns_end(const char *start, const char *end)
{
  const char *p = start;
  while (p < end && !(*p == '.' && (p + 1 == end || isspace((unsigned char)p[1]))))
    p++;
  return p;
}

bool about_passage(const char **text, struct passage *passage)
{
  const char *first = *text + strspn(*text, "\n");
  if (*first == '\0')
    return false;
  const char *end = line_end(first);
  while (*end != '\0' && !begins(first, end + 1))
    end = line_end(end + 1);
  if (blanks(first) == 0)
    end = next_column(first, end);
  *text = end;
  passage->name = name_of(first);
  const char *body = first;
  if (passage->name.length > 0)
    body = passage->name.start + passage->name.length + (blanks(first) == 0);
  const char *columns = strstr(body, columns_word);
  if (!columns || columns >= end) {
    passage->before = (struct span){ body, (size_t)(end - body) };
    passage->columns = passage->after = (struct span){ end, 0 };
    return true;
  }
  const char *list = columns + strlen(columns_word), *stop = columns_end(list, end), *rest = stop < end ? stop + 1 : end;
  passage->before = (struct span){ body, (size_t)(columns - body) };
  passage->columns = (struct span){ list, (size_t)(stop - list) };
  passage->after = (struct span){ rest, (size_t)(end - rest) };
  return true;
}

bool about_column(struct span *columns, struct span *column)
{
  int depth = 0;
  size_t i = 0;
  if (columns->length == 0)
    return false;
  for (; i < columns->length && (depth > 0 || columns->start[i] != ';'); i++)
    depth += columns->start[i] == '(' ? 1 : columns->start[i] == ')' ? -1 : 0;
  *column = (struct span){ columns->start, i };
  i += i < columns->length;
  *columns = (struct span){ columns->start + i, columns->length - i };
  return true;
}
