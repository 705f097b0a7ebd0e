/* A configuration as a whole. */
#include "compare/config/config.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text/file.h"

/* What to look for where libconfig says no more than that */
static const char *meaning(const char *said)
{
  static const struct {
    const char *said, *meaning;
  } known[] = {
    { "mismatched element type", ": within [ ] all are written alike, [1.0, 2.5]; within ( ) they need not be" },
    { "syntax error", ": in this line or before it a ; , \" ) ] or } is missing or one too many, or a text has no "
                      "quotes, or [ ] stands around groups, which ( ) takes" },
    { "duplicate setting name", ": a group has each of its members once" }
  };
  for (size_t i = 0; said && i < sizeof known / sizeof *known; i++)
    if (strstr(said, known[i].said))
      return known[i].meaning;
  return "";
}

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

/* Refuses what libconfig 1.5 would misread: it takes a whole number beyond 32 bits for another one. */
static bool check_text(const struct config *c, const char *text)
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

static enum exit_code parse(struct config *c, const char *text)
{
  if (!check_text(c, text))
    return EXIT_USAGE;
  if (config_read_string(&c->file, text))
    return EXIT_DONE;
  const char *said = config_error_text(&c->file);
  complain(c->command, "%s:%d: %s%s", c->path, config_error_line(&c->file), said, meaning(said));
  return EXIT_USAGE;
}

/* The whole file, as far as a NUL byte, which no text has; a byte order mark is no text. */
static enum exit_code parse_file(struct config *c, const struct shipped *shipped)
{
  char *text = NULL;
  size_t room = 0;
  enum exit_code code = EXIT_USAGE;
  FILE *file = file_read(c->path);
  ssize_t length = file ? getdelim(&text, &room, '\0', file) : -1;
  if (!file || (length < 0 && !feof(file))) {
    const char *near = shipped && !strpbrk(c->path, "/.") ? nearest_in(c->path, shipped, sizeof *shipped) : NULL;
    complain(c->command, "cannot read %s: %s%s", strcmp(c->path, "-") == 0 ? "standard input" : c->path,
             strerror(errno), did_you_mean(near));
    code = EXIT_FILE;
  } else if (length > 0 && strlen(text) != (size_t)length) {
    complain(c->command, "%s: this is not a text file", c->path);
  } else {
    code = parse(c, length < 0 ? "" : strncmp(text, "\xef\xbb\xbf", 3) == 0 ? text + 3 : text);
  }
  if (file && file != stdin)
    fclose(file);
  free(text);
  return code;
}

enum exit_code config_open(struct config *c, const char *command, const char *path, const char *text,
                           const struct shipped *shipped)
{
  *c = (struct config){ .command = command, .path = path };
  config_init(&c->file);
  config_init(&c->kept);
  config_setting_add(config_root_setting(&c->kept), "texts", CONFIG_TYPE_LIST);
  return text ? parse(c, text) : parse_file(c, shipped);
}

void config_close(struct config *c)
{
  if (c->file.root) {
    config_destroy(&c->file);
    config_destroy(&c->kept);
  }
  *c = (struct config){ .path = NULL };
}

const config_setting_t *config_root(const struct config *c) { return config_root_setting(&c->file); }
