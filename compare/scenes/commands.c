/* Tables of other commands, run at each point of a scene. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare/command/option_table.h"
#include "compare/scenes/running.h"

enum { MOST_ARGUMENTS = 128 };

void command_leads(const struct running *r, struct output *o)
{
  const struct scene_variable *v;
  for (int i = 0; (v = scene_variable(r->scene, i)); i++) {
    int place = quantity_find(&r->scene->quantities, v->name), k = 0;
    while (k < o->leads && o->lead_quantity[k] != place)
      k++;
    if (k < o->leads || o->leads == LEADS || place < 0)
      continue;
    o->lead_quantity[o->leads] = place;
    o->lead_name[o->leads++] = v->name;
  }
  if (o->leads > 0)
    table_lead(&o->table, o->lead_name, o->leads);
}

bool command_makes_map(const struct scene_want *w)
{
  for (int i = 0; i < w->argument_count; i++)
    if (strcmp(w->arguments[i], "--map") == 0)
      return true;
  return false;
}

enum exit_code command_at_point(const struct running *r, struct output *o)
{
  const struct scene_want *w = o->want;
  const struct options *at = &r->state->at;
  char *arguments[MOST_ARGUMENTS + 1], names[CRAWLER_NUMBERS + 1][16], digits[40];
  double numbers[LEADS];
  const char *texts[LEADS];
  struct options options;
  int count = 0, code = EXIT_DONE;
  for (; count < w->argument_count; count++)
    arguments[count] = w->arguments[count];
  for (int i = 0; i <= CRAWLER_NUMBERS; i++) {
    const char *name = crawler_parameters[i], *text = i < CRAWLER_NUMBERS  ? at->point.written[i]
                                                      : at->point.has_gait ? at->point.crawler.gait->name
                                                                           : NULL;
    bool idle = w->command == &command_breakdown && !command_makes_map(w) && strcmp(name, "T") == 0;
    if (!text || idle || !option_accepted(w->command, name))
      continue;
    snprintf(names[i], sizeof names[i], "--%s", name);
    arguments[count++] = names[i];
    arguments[count++] = (char *)text;
  }
  if (at->point.has_v0 && at->point.written_v0 && option_accepted(w->command, "v0")) {
    arguments[count++] = "--v0";
    arguments[count++] = (char *)at->point.written_v0;
  }
  if (r->options->quiet && option_accepted(w->command, "quiet"))
    arguments[count++] = "--quiet";
  if (r->options->digits > 0 && option_accepted(w->command, "digits")) {
    snprintf(digits, sizeof digits, "--digits=%ld", r->options->digits);
    arguments[count++] = digits;
  }
  arguments[count] = NULL;
  for (int i = 0; i < o->leads; i++) {
    bool is_text = quantity_is_text(&r->scene->quantities.item[o->lead_quantity[i]]);
    texts[i] = is_text ? state_text(r->state, o->lead_quantity[i], 0) : NULL;
    numbers[i] = is_text ? NAN : state_number(r->state, o->lead_quantity[i]);
  }
  if (o->leads > 0)
    table_lead_values(&o->table, numbers, texts);
  if (options_read(&options, w->command, count, arguments, &code)) {
    options.into = o->is_open ? &o->table : NULL;
    options.output = o->file;
    options.format = o->options.format;
    code = (int)w->command->run(&options);
  }
  options_free(&options);
  count_add(COUNT_COMMANDS, 1);
  return (enum exit_code)code;
}
