/* Reading of files and members, and messages about them. */
#define _GNU_SOURCE /* vasprintf */
#include "compare/config/config.h"

#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text/digits.h"
#include "compare/text/file.h"

/* Returns an explanation of a message of libconfig, or "". */
static const char *explanation(const char *error)
{
  static const struct {
    const char *error, *explanation;
  } known[] = {
    { "mismatched element type", ": within [ ] all elements have one type, [1.0, 2.5]; within ( ) types may differ" },
    { "syntax error", ": in this line or before it a ; , \" ) ] or } is missing or superfluous, or a text has no "
                      "quotes, or groups are within [ ] instead of ( )" },
    { "duplicate setting name", ": a group has each member only once" }
  };
  for (size_t i = 0; error && i < sizeof known / sizeof *known; i++)
    if (strstr(error, known[i].error))
      return known[i].explanation;
  return "";
}

/* Returns the length of the comment, text, name or number that begins here; 1 for another character. */
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

/* Returns NULL or the error of a token. */
static const char *token_error(const char *token, size_t length)
{
  bool is_hex = tolower((unsigned char)token[1]) == 'x', is_long = token[length - 1] == 'L';
  if (*token == '@')
    return "@include is not supported: insert the contents of the file";
  if (!isdigit((unsigned char)*token) || strcspn(token, is_hex ? "." : ".eE") < length
      || strtod(token, NULL) <= (is_long ? 9223372036854775807.0 : 2147483647.0))
    return NULL;
  return is_long ? "a whole number beyond 9223372036854775807 is written with a point"
                 : "a whole number beyond 2147483647 is written with a point, or an L behind it";
}

/* Refuses tokens that libconfig 1.5 misreads: a whole number beyond 32 bits becomes another number. */
static bool check_text(const struct config *c, const char *text)
{
  long line = 1;
  for (size_t length; *text != '\0';) {
    length = token_length(text);
    const char *wrong = token_error(text, length);
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
  const char *error = config_error_text(&c->file);
  complain(c->command, "%s:%d: %s%s", c->path, config_error_line(&c->file), error, explanation(error));
  return EXIT_USAGE;
}

/* Reads the whole file; refuses NUL bytes and skips a byte order mark. */
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

bool refuse_at(const struct config *c, const config_setting_t *at, const char *format, ...)
{
  char text[600], line[24] = "";
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  if (at && config_setting_source_line(at) > 0)
    snprintf(line, sizeof line, ":%u", (unsigned)config_setting_source_line(at));
  return complain(c->command, "%s%s: %s", c->path, line, text);
}

bool is_ascii(const char *text)
{
  while (*text >= ' ' && *text < 0x7f)
    text++;
  return *text == '\0';
}

static bool is_sequence(const config_setting_t *at)
{
  return config_setting_is_array(at) || config_setting_is_list(at);
}

int element_count(const config_setting_t *at) { return is_sequence(at) ? config_setting_length(at) : 1; }

const config_setting_t *element_at(const config_setting_t *at, int i)
{
  return is_sequence(at) ? config_setting_get_elem(at, (unsigned)i) : at;
}

const config_setting_t *member_at(const config_setting_t *at, int i)
{
  return config_setting_get_elem(at, (unsigned)i);
}

const char *text_of(struct config *c, const config_setting_t *at)
{
  char text[NUMBER_TEXT];
  if (!config_setting_is_number(at))
    return config_setting_get_string(at);
  bool is_whole = config_setting_type(at) != CONFIG_TYPE_FLOAT;
  number_text(text, is_whole ? (double)config_setting_get_int64(at) : config_setting_get_float(at), 0);
  return keep(c, "%s", text);
}

static const char *text_at(const config_setting_t *at)
{
  const char *text = config_setting_get_string(at);
  return text && *text != '\0' ? text : NULL;
}

static bool read_texts(struct config *c, const config_setting_t *at, const struct member *m, const char **texts)
{
  int count = element_count(at);
  if (count < 1)
    return refuse_at(c, at, "%s is empty", m->name);
  if (count > m->high)
    return refuse_at(c, at, "%s has %d texts: %ld at most", m->name, count, m->high);
  for (int i = 0; i < count; i++)
    if (!(texts[i] = text_at(element_at(at, i))))
      return refuse_at(c, element_at(at, i), "%s takes a text in quotes, or several as [\"...\", \"...\"]", m->name);
  return true;
}

static bool read_member(struct config *c, const config_setting_t *at, const struct member *m, void *into)
{
  void *field = (char *)into + m->field;
  const char *text = text_at(at);
  char allowed[200];
  int type = config_setting_type(at);
  long long n = type == CONFIG_TYPE_INT || type == CONFIG_TYPE_INT64 ? config_setting_get_int64(at) : m->low - 1LL;
  switch (m->kind) {
  case MEMBER_OTHER: return true;
  case MEMBER_TEXT:
    *(const char **)field = text;
    return text || refuse_at(c, at, "%s takes a text in quotes, which is not empty", m->name);
  case MEMBER_TEXTS: *(int *)(void *)((char *)into + m->count) = element_count(at); return read_texts(c, at, m, field);
  case MEMBER_WORD:
    joined(allowed, sizeof allowed, m->words, ", ");
    *(int *)field = text ? word_place(text, m->words) : -1;
    return *(int *)field >= 0 || refuse_at(c, at, "%s is a text in quotes, one of %s", m->name, allowed);
  case MEMBER_FLAG:
    *(bool *)field = config_setting_get_bool(at) != 0;
    return type == CONFIG_TYPE_BOOL || refuse_at(c, at, "%s is true or false", m->name);
  case MEMBER_COUNT:
    *(long *)field = (long)n;
    return (m->low <= n && n <= m->high)
           || refuse_at(c, at, "%s is a whole number from %ld to %ld", m->name, m->low, m->high);
  }
  return true;
}

static bool refuse_member(struct config *c, const config_setting_t *at, const struct member *members, const char *what)
{
  enum { MAX_NAMES = 32 };
  const char *names[MAX_NAMES + 1] = { NULL };
  char known[400];
  for (int i = 0; i < MAX_NAMES && members[i].name; i++)
    names[i] = members[i].name;
  const char *near = nearest(config_setting_name(at), names);
  return refuse_at(c, at, "there is no '%s' in %s%s%s", config_setting_name(at), what,
                   near ? did_you_mean(near) : ": it can have ", near ? "" : joined(known, sizeof known, names, ", "));
}

bool read_members(struct config *c, const config_setting_t *group, const struct member *members, void *into,
                  const char *what)
{
  bool good = true;
  for (int i = 0; i < config_setting_length(group) && good; i++) {
    const config_setting_t *at = member_at(group, i);
    const struct member *m = members;
    while (m->name && strcmp(m->name, config_setting_name(at)) != 0)
      m++;
    good = m->name ? read_member(c, at, m, into) : refuse_member(c, at, members, what);
  }
  return good;
}

const char *keep(struct config *c, const char *format, ...)
{
  char *text;
  va_list arguments;
  va_start(arguments, format);
  if (vasprintf(&text, format, arguments) < 0)
    text = NULL;
  va_end(arguments);
  config_setting_t *all = config_setting_get_elem(config_root_setting(&c->kept), 0);
  const config_setting_t *kept = text ? config_setting_set_string_elem(all, -1, text) : NULL;
  free(text);
  if (!kept)
    refuse_at(c, NULL, "out of memory");
  return kept ? config_setting_get_string(kept) : NULL;
}

const char *path_beside(struct config *c, const char *path)
{
  const char *slash = strrchr(c->path, '/');
  return *path == '/' || !slash ? path : keep(c, "%.*s%s", (int)(slash + 1 - c->path), c->path, path);
}

const char *gait_beside(struct config *c, const char *gait)
{
  static const char head[] = "measured:";
  enum { HEAD = sizeof head - 1 };
  if (strncmp(gait, head, HEAD) != 0)
    return gait;
  const char *path = path_beside(c, gait + HEAD);
  return path ? keep(c, "%s%s", head, path) : NULL;
}
