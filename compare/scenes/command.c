/* Wants that are the table of another command: its long options, by name. */
#include <stdlib.h>
#include <string.h>

#include "compare/scenes/parts.h"

enum { MOST_ARGUMENTS = 64 };

/* A member of the want as "--name value" */
static bool add_option(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  const char *name = config_setting_name(at);
  bool is_flag = config_setting_type(at) == CONFIG_TYPE_BOOL;
  int values = is_flag ? 0 : element_count(at);
  if (values > 2 || w->argument_count + 3 > MOST_ARGUMENTS)
    return refuse_at(r->config, at, "%s has too many values, or the want too many options", name);
  if (is_flag && !config_setting_get_bool(at))
    return true;
  w->arguments[w->argument_count] = (char *)keep(r->config, "--%s", name);
  if (!w->arguments[w->argument_count++])
    return false;
  for (int i = 0; i < values; i++) {
    const char *text = text_of(r->config, element_at(at, i));
    if (!text)
      return refuse_at(r->config, at, "%s takes what it takes on the command line: a number, a text, or true", name);
    w->arguments[w->argument_count++] = (char *)text;
  }
  return true;
}

bool read_command(const struct reading *r, const config_setting_t *at, struct scene_want *w,
                  const struct member *members)
{
  const struct sweep_variable *varied = sweep_variable(&r->scene->sweep, 0);
  if (varied)
    return refuse_at(
        r->config, at,
        "%s varies, and what = \"%s\" is the whole table of a command, for one crawler: leave out 'vary', and "
        "run the command once for each value",
        varied->name, w->what);
  w->arguments = calloc(MOST_ARGUMENTS, sizeof *w->arguments);
  if (!w->arguments)
    return refuse_at(r->config, at, "out of memory");
  for (int i = 0; i < config_setting_length(at); i++) {
    const config_setting_t *option = member_at(at, i);
    const char *name = config_setting_name(option);
    const struct member *own = find_member(members, name);
    if (name_among(crawler_parameters, name))
      return refuse_at(r->config, option, "%s belongs into the crawler", name);
    if (!(own && !own->only ? read_member(r->config, option, own, w) : add_option(r, option, w)))
      return false;
  }
  return r->scene->run_command(r->scene, w, r->options, true) == EXIT_DONE
         || refuse_at(r->config, at, "the command behind what = \"%s\" refuses these options", w->what);
}
