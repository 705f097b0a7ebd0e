#define _GNU_SOURCE /* vasprintf */
#include "compare/text/message.h"

#include <ctype.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text/progress.h"
#include "compare/text/shipped.h"

char *printed_line(const char *format, va_list arguments, const char *kept)
{
  char *text;
  if (vasprintf(&text, format, arguments) < 0)
    return NULL;
  for (char *c = text; *c; c++)
    if (iscntrl((unsigned char)*c) && !strchr(kept, *c))
      *c = '?';
  return text;
}

bool complain(const char *command, const char *format, ...)
{
  va_list arguments;
  progress_clear();
  va_start(arguments, format);
  char *text = printed_line(format, arguments, "\n");
  va_end(arguments);
  fprintf(stderr, "scallop %s: %s\n", command, text ? text : "out of memory");
  free(text);
  return false;
}

const char *wrong_text(const char *format, ...)
{
  static _Thread_local char text[4][640];
  static _Thread_local unsigned turn;
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text[++turn % 4], sizeof *text, format, arguments);
  va_end(arguments);
  return text[turn % 4];
}

/* Returns the Levenshtein distance, ignoring case. */
static int distance(const char *a, const char *b)
{
  enum { LONGEST = 40 };
  int row[LONGEST + 1], length = (int)strlen(b);
  if (length > LONGEST || strlen(a) > LONGEST)
    return LONGEST;
  for (int j = 0; j <= length; j++)
    row[j] = j;
  for (int i = 1; *a; i++, a++) {
    int diagonal = row[0];
    row[0] = i;
    for (int j = 1; j <= length; j++) {
      int substitute = diagonal + (tolower((unsigned char)*a) != tolower((unsigned char)b[j - 1]));
      int insert = (row[j] < row[j - 1] ? row[j] : row[j - 1]) + 1;
      diagonal = row[j];
      row[j] = substitute < insert ? substitute : insert;
    }
  }
  return row[length];
}

int word_place(const char *word, const char *const *words)
{
  int i = 0;
  while (words[i] && strcmp(words[i], word) != 0)
    i++;
  return words[i] ? i : -1;
}

const char *joined(char *text, size_t size, const char *const *words, const char *last)
{
  size_t used = 0;
  *text = '\0';
  for (int i = 0; words[i] && used < size; i++)
    used += (size_t)snprintf(text + used, size - used, "%s%s", i == 0 ? "" : words[i + 1] ? ", " : last, words[i]);
  return text;
}

const char *nearest_in(const char *word, const void *list, size_t size)
{
  const char *best = NULL, *name;
  size_t length = strlen(word);
  int least = length > 0 ? (int)length / 3 + 1 : 0;
  for (const char *row = list; (name = *(const char *const *)(const void *)row); row += size) {
    int d = length > 2 && strncmp(word, name, length) == 0 ? 0 : distance(word, name);
    if (d <= least && (!best || d < least)) {
      best = name;
      least = d;
    }
  }
  return best;
}

const char *shipped_text(const struct shipped *list, const char *name)
{
  while (list->name && strcmp(list->name, name) != 0)
    list++;
  return list->text;
}

const char *nearest(const char *word, const char *const *names) { return nearest_in(word, names, sizeof *names); }

const char *did_you_mean(const char *near) { return near ? wrong_text(": did you mean '%.120s'?", near) : ""; }

const char *name_hint(const char *word, const char *const *names)
{
  char list[400];
  const char *near = nearest(word, names);
  return near ? did_you_mean(near) : wrong_text(": there are %s", joined(list, sizeof list, names, ", "));
}

size_t shown_character(const char *text)
{
  static const unsigned least[] = { 0, 0x20, 0xa0, 0x800, 0x10000 }; /* excludes controls and overlong forms */
  const unsigned char *c = (const unsigned char *)text;
  size_t length = *c < 0x80 ? 1 : *c < 0xc0 ? 0 : *c < 0xe0 ? 2 : *c < 0xf0 ? 3 : *c < 0xf8 ? 4 : 0;
  unsigned point = length > 1 ? *c & (0x7fU >> length) : *c;
  for (size_t i = 1; i < length; i++) {
    if ((c[i] & 0xc0) != 0x80)
      return 0;
    point = point << 6 | (c[i] & 0x3fU);
  }
  bool is_none = point < least[length] || point == 0x7f || (point >= 0xd800 && point < 0xe000)
                 || (point & 0xfffe) == 0xfffe || point > 0x10ffff;
  return is_none ? 0 : length;
}

bool is_shown(const char *text)
{
  for (size_t length; (length = shown_character(text)) > 0;)
    text += length;
  return *text == '\0';
}

const struct escapes in_plain = { "", { NULL } }, in_json = { "\"\\", { "\\\"", "\\\\" } },
                     in_csv = { "\"", { "\"\"" } }, in_xml = { "&<>\"", { "&amp;", "&lt;", "&gt;", "&quot;" } },
                     in_markdown = { "|\\<`*", { "\\|", "\\\\", "&lt;", "\\`", "\\*" } };

/* Returns the number of bytes that may be written unchanged; 0: the byte must be replaced. */
static size_t shown_bytes(const char *text, enum shown shown)
{
  bool ascii = *text >= 0x20 && *text <= 0x7e;
  return ascii || shown == SHOWS_BYTES ? 1 : shown == SHOWS_CHARACTERS ? shown_character(text) : 0;
}

void put_escaped(FILE *to, const char *text, const struct escapes *escapes, enum shown shown)
{
  while (*text) {
    const char *special = isalnum((unsigned char)*text) ? NULL : strchr(escapes->special, *text);
    size_t size = special ? 0 : shown_bytes(text, shown);
    if (size == 0) {
      fputs(special ? escapes->instead[special - escapes->special] : (unsigned char)*text < 0x20 ? " " : "?", to);
      text++;
    }
    for (; size > 0; size--)
      putc_unlocked(*text++, to);
  }
}
