#include "compare/scenes/text.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "compare/scenes/shipped.h"

enum { MOST_INCLUDED = 10, NAME = 4096 };
static const size_t MOST_BYTES = 1 << 24;
static const double MOST_32_BITS = 2147483647, MOST_64_BITS = 9223372036854775807.0;

/* ---- the file ---- */

static char *read_all(FILE *file, size_t *size)
{
  size_t room = 1 << 14;
  char *text = malloc(room);
  *size = 0;
  for (size_t got = 1; text && got > 0 && *size <= MOST_BYTES; *size += got) {
    if (room - *size < 2) {
      char *grown = realloc(text, room *= 2);
      if (!grown)
        free(text);
      text = grown;
    }
    got = text ? fread(text + *size, 1, room - *size - 1, file) : 0;
  }
  if (text)
    text[*size] = '\0';
  return text;
}

static void complain_of_file(const char *command, const char *path, int error)
{
  const char *near = strpbrk(path, "/.") ? NULL : shipped_near(shipped_scenes, path);
  complain(command, "cannot read %s: %s%s%s%s", strcmp(path, "-") == 0 ? "standard input" : path, strerror(error),
           near ? "; did you mean '" : "", near ? near : "", near ? "', which comes with the tool?" : "");
}

/* A byte order mark is no text. */
static void drop_mark(char *text)
{
  if (strncmp(text, "\xef\xbb\xbf", 3) == 0)
    memmove(text, text + 3, strlen(text + 3) + 1);
}

enum exit_code scene_text_read(const char *command, const char *path, char **text)
{
  errno = 0;
  FILE *file = strcmp(path, "-") == 0 ? stdin : fopen(path, "r");
  size_t size = 0;
  *text = file ? read_all(file, &size) : NULL;
  int error = errno;
  bool failed = !file || ferror(file);
  if (file && file != stdin)
    fclose(file);
  if (!failed && *text && strlen(*text) == size && size <= MOST_BYTES) {
    drop_mark(*text);
    return EXIT_DONE;
  }
  if (failed)
    complain_of_file(command, path, error);
  else
    complain(command, "%s: %s", path,
             !*text              ? "out of memory"
             : size > MOST_BYTES ? "too large for a scene"
                                 : "this is not a text file");
  bool has_text = *text != NULL;
  free(*text);
  *text = NULL;
  return failed ? EXIT_FILE : has_text ? EXIT_USAGE : EXIT_UNSOLVED;
}

/* ---- what stands in it ---- */

struct scan {
  const char *command, *path, *folder;
  scene_text_included *included;
  void *context;
  int depth;
  const char *at;
  long line;
};

static bool refuse(const struct scan *s, const char *what, const char *text, int length)
{
  complain(s->command, "%s:%ld: '%.*s': %s", s->path, s->line, length < 200 ? length : 200, text, what);
  return false;
}

static void skip_to(struct scan *s, const char *end)
{
  for (; s->at < end; s->at++)
    s->line += *s->at == '\n';
}

/* A text in quotes; *begin is behind the first of them. */
static void skip_quoted(struct scan *s)
{
  const char *end = s->at + 1;
  while (*end != '\0' && *end != '"')
    end += *end == '\\' && end[1] != '\0' ? 2 : 1;
  skip_to(s, *end == '"' ? end + 1 : end);
}

static void skip_comment(struct scan *s)
{
  bool block = s->at[0] == '/' && s->at[1] == '*';
  const char *end = block ? strstr(s->at + 2, "*/") : strchr(s->at, '\n');
  skip_to(s, !end ? s->at + strlen(s->at) : block ? end + 2 : end);
}

static bool check_number(struct scan *s)
{
  const char *begin = s->at;
  bool is_hex = begin[0] == '0' && tolower((unsigned char)begin[1]) == 'x';
  size_t digits = is_hex ? 2 + strspn(begin + 2, "0123456789abcdefABCDEF") : strspn(begin, "0123456789");
  const char *end = begin + digits;
  bool whole = is_hex || !strchr(".eE", *end) || *end == '\0', is_long = *end == 'L';
  if (whole && strtod(begin, NULL) > (is_long ? MOST_64_BITS : MOST_32_BITS))
    return refuse(s,
                  is_long ? "a whole number beyond 9223372036854775807 is written with a point"
                          : "a whole number beyond 2147483647 is written with a point, or an L behind it",
                  begin, (int)digits);
  while (isalnum((unsigned char)*end) || *end == '.' || *end == '_'
         || (strchr("+-", *end) && *end != '\0' && strchr("eE", end[-1])))
    end++;
  skip_to(s, end);
  return true;
}

static bool check(struct scan *s);

/* libconfig ends the program where one is no file, and has rules of its own for a backslash. */
static bool check_included(struct scan *s)
{
  const char *open = s->at + strlen("@include");
  open += strspn(open, " \t");
  const char *close = *open == '"' ? strchr(open + 1, '"') : NULL;
  char path[NAME];
  struct stat there;
  if (!close)
    return refuse(s, "@include \"FILE\" is meant", s->at, (int)strcspn(s->at, "\n"));
  int length = (int)(close - open - 1);
  if (memchr(open, '\\', (size_t)length + 1))
    return refuse(s, "the name of a file to include has no backslash", open + 1, length);
  bool rooted = open[1] == '/';
  snprintf(path, sizeof path, "%s%s%.*s", rooted ? "" : s->folder, rooted ? "" : "/", length, open + 1);
  if (stat(path, &there) != 0 || !S_ISREG(there.st_mode))
    return refuse(s, "there is no such file to include", open + 1, length);
  if (s->depth == MOST_INCLUDED)
    return refuse(s, "files include each other more than 10 deep", open + 1, length);
  char *text;
  if (scene_text_read(s->command, path, &text) != EXIT_DONE)
    return false;
  struct scan inner = { s->command, path, s->folder, s->included, s->context, s->depth + 1, text, 1 };
  s->included(s->context, path);
  bool good = check(&inner);
  free(text);
  skip_to(s, close + 1);
  return good;
}

static bool check(struct scan *s)
{
  bool good = true;
  while (good && *s->at != '\0') {
    const char *at = s->at;
    if (*at == '"')
      skip_quoted(s);
    else if (*at == '#' || (*at == '/' && (at[1] == '/' || at[1] == '*')))
      skip_comment(s);
    else if (strncmp(at, "@include", 8) == 0)
      good = check_included(s);
    else if (isdigit((unsigned char)*at))
      good = check_number(s);
    else if (isalpha((unsigned char)*at)) /* a name, whose digits are no number */
      skip_to(s, at + strcspn(at, " \t\r\n=:;,(){}[]\"#/"));
    else
      skip_to(s, at + 1);
  }
  return good;
}

bool scene_text_check(const char *command, const char *path, const char *folder, const char *text,
                      scene_text_included *included, void *context)
{
  struct scan s = { command, path, *folder ? folder : ".", included, context, 0, text, 1 };
  return check(&s);
}
