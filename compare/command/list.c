#include <stddef.h>
#include <string.h>

#include "compare/command/list.h"

#include "compare/command/commands.h"
#include "compare/text/message.h"

const struct command *const commands[] = { &command_phase,  &command_steady,    &command_trajectory, &command_series,
                                           &command_claims, &command_order,     &command_figure,     &command_workprec,
                                           &command_stress, &command_breakdown, &command_run,        NULL };

const struct command *command_named(const char *name)
{
  const struct command *const *c = commands;
  while (*c && strcmp(name, (*c)->name) != 0)
    c++;
  return *c;
}

const char *nearest_command(const char *word)
{
  const char *names[sizeof commands / sizeof *commands] = { NULL };
  for (size_t i = 0; commands[i]; i++)
    names[i] = commands[i]->name;
  return nearest(word, names);
}
