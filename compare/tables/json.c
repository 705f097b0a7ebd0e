#include "compare/tables/json.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static const char no_object[] = "this line is not a JSON object of texts and numbers";

static char *skip_blanks(char *at) { return at + strspn(at, " \t"); }

/* Writes the character of \uXXXX in UTF-8, a question mark for half of a surrogate pair. Returns the end of the output,
 * or NULL if digits are not hexadecimal. */
static char *put_character(char *to, const char *digits)
{
  char four[5] = "", *end;
  strncat(four, digits, 4);
  unsigned long c = strtoul(four, &end, 16);
  if (strspn(four, "0123456789abcdefABCDEF") != 4)
    return NULL;
  c = c >= 0xd800 && c < 0xe000 ? '?' : c;
  if (c >= 0x800)
    *to++ = (char)(0xe0 | c >> 12);
  if (c >= 0x80)
    *to++ = (char)(c >= 0x800 ? 0x80 | (c >> 6 & 0x3f) : 0xc0 | c >> 6);
  *to++ = (char)(c >= 0x80 ? 0x80 | (c & 0x3f) : c);
  return to;
}

/* Reads a text in quotes in place and moves *at behind it. Returns NULL if it is not a text. */
static char *read_text(char **at)
{
  static const char escaped[] = "\"\\/bfnrt", meant[] = "\"\\/\b\f\n\r\t";
  char *const text = *at + 1, *from = text, *to = text;
  if (**at != '"')
    return NULL;
  while (*from && *from != '"') {
    const char *escape = *from == '\\' && from[1] ? strchr(escaped, from[1]) : NULL;
    if (*from != '\\')
      *to++ = *from++;
    else if (escape) {
      *to++ = meant[escape - escaped];
      from += 2;
    } else if (from[1] == 'u' && (to = put_character(to, from + 2)))
      from += 6;
    else
      return NULL;
  }
  *at = from + 1;
  return *from == '"' ? (*to = '\0', text) : NULL;
}

/* Reads any value in place and moves *at behind *stop, the character that follows it. Returns NULL for other values. */
static char *read_value(char **at, char *stop)
{
  static char nothing[] = "";
  const bool is_text = **at == '"';
  char *value = is_text ? read_text(at) : *at;
  if (!value || (!is_text && strchr("[{", *value)))
    return NULL;
  *at += is_text ? 0 : strcspn(*at, ",} \t");
  char *end = *at;
  *at = skip_blanks(end);
  *stop = **at;
  *at += **at != '\0';
  if (!is_text)
    *end = '\0';
  return !is_text && strcmp(value, "null") == 0 ? nothing : value;
}

const char *json_split(char *line, struct json_member *members, int *count, int max)
{
  char *at = line + (*line == '{'), stop = ',';
  if (*line != '{')
    return no_object;
  for (*count = 0; stop == ','; ++*count) {
    if (*count == max)
      return "this object has more than 256 members";
    struct json_member *m = &members[*count];
    at = skip_blanks(at);
    m->name = read_text(&at);
    at = m->name ? skip_blanks(at) : at;
    if (!m->name || *at != ':')
      return no_object;
    at = skip_blanks(at + 1);
    m->value = read_value(&at, &stop);
    if (!m->value)
      return no_object;
  }
  return stop == '}' && *skip_blanks(at) == '\0' ? NULL : no_object;
}
