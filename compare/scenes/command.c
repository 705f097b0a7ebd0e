/* Wants that are the table of another command, run at each point. */
#include <stdlib.h>
#include <string.h>

#include "compare/command/option_table.h"
#include "compare/scenes/parts.h"

enum { MOST_ARGUMENTS = 64 };

static const struct {
  const char *what;
  const struct command *command;
  const char *first; /* an option that is always given, or NULL */
} commands_of[] = { { "terms", &command_series, "--source=derived" }, { "bounds", &command_series, "--bound" },
                    { "breakdown", &command_breakdown, NULL },        { "stability", &command_stress, NULL },
                    { "work-precision", &command_workprec, NULL },    { "claims", &command_claims, NULL } };
enum { COMMANDS_OF = sizeof commands_of / sizeof *commands_of };

bool is_command(const char *what)
{
  for (int i = 0; i < COMMANDS_OF; i++)
    if (strcmp(what, commands_of[i].what) == 0)
      return true;
  return false;
}

/* A member of the want as "--name value" */
static bool add_arguments(const struct reading *r, const config_setting_t *at, struct scene_want *w, int *count)
{
  const char *name = config_setting_name(at), *texts[2] = { NULL };
  int type = config_setting_type(at), values = is_sequence(at) ? config_setting_length(at) : 1;
  char number[NUMBER_TEXT];
  if (*count + 4 > MOST_ARGUMENTS)
    return refuse_at(r, at, "too many options");
  if (type == CONFIG_TYPE_BOOL && !config_setting_get_bool(at))
    return true;
  w->arguments[*count] = (char *)keep_text(r, "--", 2, name);
  if (!w->arguments[(*count)++])
    return false;
  for (int i = 0; i < values && type != CONFIG_TYPE_BOOL; i++) {
    const config_setting_t *element = is_sequence(at) ? config_setting_get_elem(at, (unsigned)i) : at;
    double x = 0;
    if (values > 2 || !(config_setting_get_string(element) || is_number(element, &x, &texts[0])))
      return refuse_at(r, at, "%s takes what it takes on the command line: a number, a text, or true", name);
    const char *text = config_setting_get_string(element);
    if (!text) {
      number_text(number, x, 0);
      text = keep_text(r, number, 0, number);
    }
    if (!text)
      return false;
    w->arguments[(*count)++] = (char *)text;
  }
  return true;
}

static bool is_parameter(const char *name) { return crawler_place(name) < CRAWLER_NUMBERS || strcmp(name, "gait") == 0; }

/* Parameters that vary must be ones that the command takes. */
static bool check_varied(const struct reading *r, const config_setting_t *at, const struct scene_want *w)
{
  bool no_T = w->command == &command_breakdown && !config_setting_get_member(at, "map");
  const struct scene_variable *v;
  for (int i = 0; (v = scene_variable(r->scene, i)); i++) {
    const char *name = scene_variable_sets(v);
    quantity_named(&r->scene->quantities, v->name); /* a cell in front of the rows */
    if (v->target != TARGET_LABEL && (!option_accepted(w->command, name) || (no_T && strcmp(name, "T") == 0)))
      return refuse_at(r, at, "%s varies, and %s does not take it%s", v->name, w->what, no_T ? " without a map" : "");
  }
  return true;
}

bool read_command(const struct reading *r, const config_setting_t *at, struct scene_want *w)
{
  static const char *const own[] = { "what", "file", "format", "plot", NULL };
  struct options trial;
  int kind = 0;
  int count = 0, code = EXIT_DONE;
  while (strcmp(w->what, commands_of[kind].what) != 0)
    kind++;
  w->kind = WANT_COMMAND;
  w->command = commands_of[kind].command;
  w->arguments = calloc(MOST_ARGUMENTS + 1, sizeof *w->arguments);
  if (!w->arguments)
    return refuse_at(r, at, "out of memory");
  w->arguments[count++] = "scallop";
  w->arguments[count++] = (char *)w->command->name;
  if (commands_of[kind].first && !config_setting_get_member(at, "source"))
    w->arguments[count++] = (char *)keep_text(r, commands_of[kind].first, (int)strlen(commands_of[kind].first), "");
  for (int i = 0; i < config_setting_length(at); i++) {
    const config_setting_t *member = config_setting_get_elem(at, (unsigned)i);
    int k = 0;
    while (own[k] && strcmp(config_setting_name(member), own[k]) != 0)
      k++;
    if (!own[k] && is_parameter(config_setting_name(member)))
      return refuse_at(r, member, "%s belongs into the crawler, or what varies", config_setting_name(member));
    if (!own[k] && !add_arguments(r, member, w, &count))
      return false;
  }
  w->argument_count = count;
  bool read = options_read(&trial, w->command, count, w->arguments, &code);
  options_free(&trial);
  if (!read)
    return refuse_at(r, at, "so these options of `scallop %s` cannot be wanted", w->command->name);
  return check_varied(r, at, w);
}
