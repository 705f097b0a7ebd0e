/* The text of a file, before libconfig 1.5 reads it, which takes a whole number beyond 32 bits for another one. */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "compare/config/config.h"

/* How long the comment, text, name or number is that begins here; of what else there is each character is by itself */
static size_t token_length(const char *at)
{
  static const char of_names[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-*";
  const char *end = at + 1;
  if (*at == '#' || *at == '@' || strncmp(at, "//", 2) == 0)
    return strcspn(at, "\n");
  if (strncmp(at, "/*", 2) == 0)
    return (end = strstr(at + 2, "*/")) ? (size_t)(end + 2 - at) : strlen(at);
  if (isdigit((unsigned char)*at) || isalpha((unsigned char)*at))
    return strspn(at, isdigit((unsigned char)*at) ? "0123456789abcdefABCDEFxXL." : of_names);
  while (*at == '"' && *end != '\0' && *end != '"')
    end += *end == '\\' && end[1] != '\0' ? 2 : 1;
  return (size_t)(end - at) + (*at == '"' && *end == '"');
}

/* NULL: nothing */
static const char *wrong_with(const char *token, size_t length)
{
  bool is_hex = tolower((unsigned char)token[1]) == 'x', is_long = token[length - 1] == 'L';
  if (*token == '@')
    return "@include is no longer there: write what the file has in its place";
  if (!isdigit((unsigned char)*token) || strcspn(token, is_hex ? "." : ".eE") < length
      || strtod(token, NULL) <= (is_long ? 9223372036854775807.0 : 2147483647.0))
    return NULL;
  return is_long ? "a whole number beyond 9223372036854775807 is written with a point"
                 : "a whole number beyond 2147483647 is written with a point, or an L behind it";
}

bool config_check_text(const struct config *c, const char *text)
{
  long line = 1;
  for (size_t length; *text != '\0';) {
    length = token_length(text);
    const char *wrong = wrong_with(text, length);
    if (wrong)
      return complain(c->command, "%s:%ld: '%.*s': %s", c->path, line, length < 200 ? (int)length : 200, text, wrong);
    while (length-- > 0)
      line += *text++ == '\n';
  }
  return true;
}
