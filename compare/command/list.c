#include "compare/command/commands.h"

#include <string.h>

#include "compare/points/gaits.h"
#include "compare/text/message.h"
#include "compare/text/shipped.h"

const struct command *const commands[] = { &command_phase,
                                           &command_steady,
                                           &command_trajectory,
                                           &command_series,
                                           &command_claims,
                                           &command_order,
                                           &command_figure,
                                           &command_workprec,
                                           &command_stress,
                                           &command_breakdown,
                                           &command_summary,
                                           &command_run,
                                           NULL };

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

enum { HELP_WIDTH = 100, HELP_ITEM = 320 };

/* An item of a list: a name, and from the column on a text in as many lines as it takes */
static void print_item(FILE *to, const char *name, int column, const char *text)
{
  int at = fprintf(to, "  %-*s  ", column - 4, name);
  bool begins = true;
  for (int word; *text; text += word + (text[word] == ' '), begins = false) {
    word = (int)strcspn(text, " ");
    if (!begins && at + 1 + word > HELP_WIDTH)
      at = fprintf(to, "\n%*s", column, "") - 1;
    else if (!begins)
      at += fprintf(to, " ");
    at += fprintf(to, "%.*s", word, text);
  }
  fputc('\n', to);
}

/* Those that are formulas stand behind the list of all. */
static void list_quantities(FILE *to, int first, int end)
{
  fputs("\nQuantities (with their units):\n", to);
  for (const struct quantity_row *row = quantity_rows + first;
       row < quantity_rows + end || (end == NAMED_QUANTITIES && row->formula); row++) {
    char text[HELP_ITEM];
    snprintf(text, sizeof text, "%s [%s]", row->sentence, row->unit);
    print_item(to, row->name, 22, text);
  }
}

static void list_gaits(FILE *to)
{
  const struct scallop_gait_family *family;
  fputs("\nGaits (with their usual numbers):\n", to);
  for (int i = 0; (family = gait_family(i)) != NULL; i++) {
    char name[40], text[HELP_ITEM];
    bool may = family->numbers && family->usual;
    snprintf(name, sizeof name, "%s%s%s%s%s", family->name, may ? "[" : "", family->numbers ? ":" : "",
             family->numbers ? family->numbers : "", may ? "]" : "");
    snprintf(text, sizeof text, "%s%s%s%s", family->sentence, may ? " (" : "", may ? family->usual : "",
             may ? ")" : "");
    print_item(to, name, 26, text);
  }
}

void help_of(FILE *to, const struct command *command)
{
  fputs(shipped_text(shipped_help, command ? command->name : "scallop"), to);
  if (command && command->quantities.end > 0)
    list_quantities(to, command->quantities.first, command->quantities.end);
  if (command && option_of(command, "gait"))
    list_gaits(to);
}
