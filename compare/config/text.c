/* The text of a file, before libconfig 1.5 reads it, which takes a whole number beyond 32 bits for another one. */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "compare/config/config.h"

/* How much of what begins at this place is a comment, a text in quotes or a name, where digits are no number */
static size_t without_numbers(const char *at)
{
  static const char of_names[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-*";
  const char *end = at + 1;
  if (*at == '#' || strncmp(at, "//", 2) == 0)
    return strcspn(at, "\n");
  if (strncmp(at, "/*", 2) == 0)
    return (end = strstr(at + 2, "*/")) ? (size_t)(end + 2 - at) : strlen(at);
  if (*at != '"')
    return isalpha((unsigned char)*at) ? strspn(at, of_names) : 0;
  while (*end != '\0' && *end != '"')
    end += *end == '\\' && end[1] != '\0' ? 2 : 1;
  return (size_t)(end - at) + (*end == '"');
}

/* What is wrong with a number, or NULL */
static const char *wrong_with(const char *number, size_t length)
{
  bool is_hex = tolower((unsigned char)number[1]) == 'x', is_long = number[length - 1] == 'L';
  if (strcspn(number, is_hex ? "." : ".eE") < length
      || strtod(number, NULL) <= (is_long ? 9223372036854775807.0 : 2147483647.0))
    return NULL;
  return is_long ? "a whole number beyond 9223372036854775807 is written with a point"
                 : "a whole number beyond 2147483647 is written with a point, or an L behind it";
}

bool config_check_text(const struct config *c, const char *text)
{
  long line = 1;
  for (size_t length; *text != '\0';) {
    const char *wrong = NULL;
    if (*text == '@') {
      length = strcspn(text, "\n");
      wrong = "@include is no longer there: write what the file has in its place";
    } else if (isdigit((unsigned char)*text)) {
      length = strspn(text, "0123456789abcdefABCDEFxXL.");
      wrong = wrong_with(text, length);
    } else {
      length = without_numbers(text);
      length = length > 0 ? length : 1;
    }
    if (wrong)
      return complain(c->command, "%s:%ld: '%.*s': %s", c->path, line, length < 200 ? (int)length : 200, text, wrong);
    while (length-- > 0)
      line += *text++ == '\n';
  }
  return true;
}
