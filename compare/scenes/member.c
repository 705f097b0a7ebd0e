/* Members of libconfig's groups, and messages about them: what every file that reads a part of a scene stands on. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text/values.h"
#include "compare/scenes/parts.h"

bool refuse_at(const struct reading *r, const config_setting_t *at, const char *format, ...)
{
  char text[600];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  const char *file = at ? config_setting_source_file(at) : NULL;
  unsigned line = at ? (unsigned)config_setting_source_line(at) : 0;
  if (line > 0)
    complain(r->options->request.style.command, "%s:%u: %s", file ? file : r->path, line, text);
  else
    complain(r->options->request.style.command, "%s: %s", r->path, text);
  return false;
}

bool is_among(const char *name, const char *const *names)
{
  while (*names && strcmp(name, *names) != 0)
    names++;
  return *names != NULL;
}

bool is_sequence(const config_setting_t *at)
{
  int type = config_setting_type(at);
  return type == CONFIG_TYPE_ARRAY || type == CONFIG_TYPE_LIST;
}

int element_count(const config_setting_t *at) { return is_sequence(at) ? config_setting_length(at) : 1; }

const config_setting_t *element_at(const config_setting_t *at, int i)
{
  return is_sequence(at) ? config_setting_get_elem(at, (unsigned)i) : at;
}

bool is_number(const config_setting_t *at, double *value, const char **text)
{
  *text = NULL;
  switch (config_setting_type(at)) {
  case CONFIG_TYPE_INT:
  case CONFIG_TYPE_INT64: *value = (double)config_setting_get_int64(at); return true;
  case CONFIG_TYPE_FLOAT: *value = config_setting_get_float(at); return true;
  case CONFIG_TYPE_STRING: *text = config_setting_get_string(at); return read_number(*text, value);
  default: return false;
  }
}

const char *joined(char *text, size_t size, const char *const *names, bool quoted)
{
  size_t used = 0;
  *text = '\0';
  for (int i = 0; names[i] && used < size; i++)
    used += (size_t)snprintf(text + used, size - used, quoted ? "%s\"%s\"" : "%s%s",
                             i == 0   ? ""
                             : quoted ? " or "
                                      : ", ",
                             names[i]);
  return text;
}

static const char *text_at(const config_setting_t *at)
{
  const char *text = config_setting_get_string(at);
  return text && *text != '\0' ? text : NULL;
}

static bool read_texts(const struct reading *r, const config_setting_t *at, const struct member *m)
{
  const char **values = m->value;
  int count = element_count(at);
  if (count < 1)
    return refuse_at(r, at, "%s is empty", m->name);
  if (count > m->high)
    return refuse_at(r, at, "%s has %d texts: %ld at most", m->name, count, m->high);
  for (int i = 0; i < count; i++)
    if (!(values[i] = text_at(element_at(at, i))))
      return refuse_at(r, element_at(at, i), "%s takes a text in quotes, or several as [\"...\", \"...\"]", m->name);
  *m->count = count;
  return true;
}

static bool read_word(const struct reading *r, const config_setting_t *at, const struct member *m)
{
  const char *text = text_at(at);
  char allowed[200];
  int i = 0;
  while (text && m->words[i] && strcmp(text, m->words[i]) != 0)
    i++;
  if (!text || !m->words[i])
    return refuse_at(r, at, "%s is %s", m->name, joined(allowed, sizeof allowed, m->words, true));
  *(int *)m->value = i;
  return true;
}

static bool read_count_at(const struct reading *r, const config_setting_t *at, const struct member *m)
{
  int type = config_setting_type(at);
  long long n = type == CONFIG_TYPE_INT || type == CONFIG_TYPE_INT64 ? config_setting_get_int64(at) : m->low - 1LL;
  if (n < m->low || n > m->high)
    return refuse_at(r, at, "%s is a whole number from %ld to %ld", m->name, m->low, m->high);
  *(long *)m->value = (long)n;
  return true;
}

static bool read_value(const struct reading *r, const config_setting_t *at, const struct member *m)
{
  const char *text;
  double x;
  switch (m->kind) {
  case MEMBER_OTHER:
  case MEMBER_REST: return true;
  case MEMBER_TEXTS: return read_texts(r, at, m);
  case MEMBER_WORD: return read_word(r, at, m);
  case MEMBER_COUNT: return read_count_at(r, at, m);
  case MEMBER_TEXT:
    text = text_at(at);
    if (text)
      *(const char **)m->value = text;
    return text || refuse_at(r, at, "%s takes a text in quotes", m->name);
  case MEMBER_FLAG:
    if (config_setting_type(at) == CONFIG_TYPE_BOOL)
      *(bool *)m->value = config_setting_get_bool(at) != 0;
    return config_setting_type(at) == CONFIG_TYPE_BOOL || refuse_at(r, at, "%s is true or false", m->name);
  case MEMBER_NUMBER:
    if (!is_number(at, &x, &text) || !isfinite(x))
      return refuse_at(r, at, "%s is a finite number", m->name);
    *(double *)m->value = x;
  }
  return true;
}

static bool refuse_member(const struct reading *r, const config_setting_t *at, const struct member *members,
                          const char *what)
{
  enum { MOST = 32 };
  const char *names[MOST + 1] = { NULL };
  char known[400];
  for (int i = 0; i < MOST && members[i].name; i++)
    names[i] = members[i].name;
  const char *near = nearest(config_setting_name(at), names);
  if (near)
    return refuse_at(r, at, "there is no '%s' in %s%s", config_setting_name(at), what, did_you_mean(near));
  return refuse_at(r, at, "there is no '%s' in %s: it can have %s", config_setting_name(at), what,
                   joined(known, sizeof known, names, false));
}

bool read_members(const struct reading *r, const config_setting_t *group, const struct member *members, const char *what)
{
  for (int i = 0; i < config_setting_length(group); i++) {
    const config_setting_t *at = config_setting_get_elem(group, (unsigned)i);
    const struct member *m = members;
    while (m->name && strcmp(m->name, config_setting_name(at)) != 0)
      m++;
    if (!m->name && m->kind != MEMBER_REST)
      return refuse_member(r, at, members, what);
    if (!read_value(r, at, m))
      return false;
  }
  return true;
}

const char *keep_text(const struct reading *r, const char *text, int length, const char *more)
{
  size_t head = (size_t)length, tail = strlen(more);
  struct kept *kept = malloc(sizeof *kept + head + tail + 1);
  if (!kept) {
    refuse_at(r, NULL, "out of memory");
    return NULL;
  }
  memcpy(kept->text, text, head);
  memcpy(kept->text + head, more, tail + 1);
  kept->next = r->scene->kept;
  r->scene->kept = kept;
  return kept->text;
}

const char *keep_number(const struct reading *r, double x)
{
  char text[NUMBER_TEXT];
  number_text(text, x, 0);
  return keep_text(r, text, 0, text);
}

const char *path_beside(const struct reading *r, const char *path)
{
  const char *slash = strrchr(r->path, '/');
  return *path == '/' || !slash ? path : keep_text(r, r->path, (int)(slash + 1 - r->path), path);
}

const char *gait_beside(const struct reading *r, const char *gait)
{
  static const char head[] = "measured:";
  enum { HEAD = sizeof head - 1 };
  if (strncmp(gait, head, HEAD) != 0)
    return gait;
  const char *path = path_beside(r, gait + HEAD);
  return path ? keep_text(r, head, HEAD, path) : NULL;
}
