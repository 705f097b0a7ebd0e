/* The text of a file, before libconfig 1.5 reads it, which takes a whole number beyond 32 bits for another one, and
 * ends the program where a file to include is none. */
#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "compare/config/config.h"
#include "compare/text/file.h"

enum { MOST_INCLUDED = 10 };

static void complain_of_file(const char *command, const char *path, const struct shipped *shipped, int error)
{
  const char *near = strpbrk(path, "/.") || !shipped ? NULL : shipped_near(shipped, path);
  complain(command, "cannot read %s: %s%s", strcmp(path, "-") == 0 ? "standard input" : path, strerror(error),
           did_you_mean(near));
}

/* The whole file, as far as a NUL byte, which no text has; a byte order mark is no text. */
enum exit_code config_text(const char *command, const char *path, const struct shipped *shipped, char **text)
{
  size_t room = 0;
  errno = 0;
  FILE *file = file_read(path);
  *text = NULL;
  ssize_t length = file ? getdelim(text, &room, '\0', file) : -1;
  int error = length < 0 && !(file && feof(file)) ? errno : 0;
  if (file && file != stdin)
    fclose(file);
  if (length < 0 && error == 0) { /* an empty file */
    free(*text);
    *text = calloc(1, 1);
    length = 0;
    error = *text ? 0 : ENOMEM;
  }
  bool is_text = error == 0 && strlen(*text) == (size_t)length;
  if (is_text && strncmp(*text, "\xef\xbb\xbf", 3) == 0)
    memmove(*text, *text + 3, (size_t)length - 2);
  if (error != 0)
    complain_of_file(command, path, shipped, error);
  else if (!is_text)
    complain(command, "%s: this is not a text file", path);
  if (!is_text) {
    free(*text);
    *text = NULL;
  }
  return is_text ? EXIT_DONE : error != 0 ? EXIT_FILE : EXIT_USAGE;
}

struct scan {
  struct config *config;
  const char *path; /* of this file, or of one that it includes */
  int depth;
  long line;
};

static bool refuse(const struct scan *s, const char *text, size_t length, const char *what)
{
  complain(s->config->command, "%s:%ld: '%.*s': %s", s->path, s->line, length < 200 ? (int)length : 200, text, what);
  return false;
}

static bool check_number(const struct scan *s, const char *number, size_t length)
{
  bool is_hex = tolower((unsigned char)number[1]) == 'x', is_long = number[length - 1] == 'L';
  size_t whole = strcspn(number, is_hex ? "." : ".eE");
  return whole < length || strtod(number, NULL) <= (is_long ? 9223372036854775807.0 : 2147483647.0)
         || refuse(s, number, length,
                   is_long ? "a whole number beyond 9223372036854775807 is written with a point"
                           : "a whole number beyond 2147483647 is written with a point, or an L behind it");
}

static bool scan(struct scan *s, const char *text);

static bool check_included(const struct scan *s, const char *at)
{
  struct config *c = s->config;
  const char *open = at + strlen("@include");
  open += strspn(open, " \t");
  size_t length = *open == '"' ? strcspn(open + 1, "\"\\\n") : 0;
  if (*open != '"' || open[1 + length] != '"')
    return refuse(s, at, strcspn(at, "\n"), "@include takes the name of a file in quotes, without a backslash");
  const char *name = keep(c, "%.*s", (int)length, open + 1), *path = name ? path_beside(c, name) : NULL;
  struct stat there;
  char *text;
  if (!path)
    return false;
  if (stat(path, &there) != 0 || !S_ISREG(there.st_mode))
    return refuse(s, name, length, "there is no such file to include");
  if (s->depth == MOST_INCLUDED)
    return refuse(s, name, length, "files include each other more than 10 deep");
  if (config_text(c->command, path, NULL, &text) != EXIT_DONE)
    return false;
  struct scan inner = { c, path, s->depth + 1, 1 };
  bool good = scan(&inner, text);
  free(text);
  return good;
}

static size_t quoted_length(const char *at)
{
  const char *end = at + 1;
  while (*end != '\0' && *end != '"')
    end += *end == '\\' && end[1] != '\0' ? 2 : 1;
  return (size_t)(end - at) + (*end == '"');
}

static size_t comment_length(const char *at)
{
  bool is_block = at[0] == '/' && at[1] == '*';
  const char *end = is_block ? strstr(at + 2, "*/") : NULL;
  return end ? (size_t)(end + 2 - at) : is_block ? strlen(at) : strcspn(at, "\n");
}

static bool scan(struct scan *s, const char *text)
{
  static const char of_names[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-*";
  bool good = true;
  for (const char *at = text; good && *at != '\0';) {
    size_t length = 1;
    if (*at == '"')
      length = quoted_length(at);
    else if (*at == '#' || strncmp(at, "//", 2) == 0 || strncmp(at, "/*", 2) == 0)
      length = comment_length(at);
    else if (strncmp(at, "@include", 8) == 0)
      good = check_included(s, at);
    else if (isdigit((unsigned char)*at))
      good = check_number(s, at, length = strspn(at, "0123456789abcdefABCDEFxXL."));
    else if (isalpha((unsigned char)*at)) /* its digits are no number */
      length = strspn(at, of_names);
    for (; length > 0; length--)
      s->line += *at++ == '\n';
  }
  return good;
}

bool config_check_text(struct config *config, const char *text)
{
  struct scan s = { config, config->path, 0, 1 };
  return scan(&s, text);
}
