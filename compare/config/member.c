/* Members of libconfig's groups, and messages about them. */
#define _GNU_SOURCE /* vasprintf */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/config/config.h"
#include "compare/text/table.h"

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
  enum { MOST = 32 };
  const char *names[MOST + 1] = { NULL };
  char known[400];
  for (int i = 0; i < MOST && members[i].name; i++)
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
  char *text = NULL;
  va_list arguments;
  va_start(arguments, format);
  bool is_made = vasprintf(&text, format, arguments) >= 0;
  va_end(arguments);
  config_setting_t *kept = config_setting_get_elem(config_root_setting(&c->kept), 0);
  kept = is_made ? config_setting_set_string_elem(kept, -1, text) : NULL;
  free(is_made ? text : NULL);
  return kept ? config_setting_get_string(kept) : (refuse_at(c, NULL, "out of memory"), NULL);
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
