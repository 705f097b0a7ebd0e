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

enum { HELP_WIDTH = 100 };

/* A text that begins at a place of a line, and goes on in as many lines as it takes, each from that column on. */
static void print_from(FILE *to, int at, int column, const char *text)
{
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

static void print_item(FILE *to, const char *name, int column, const char *text)
{
  print_from(to, fprintf(to, "  %-*s  ", column - 4, name), column, text);
}

/* An option, what it takes, and what for. */
static void option_line(FILE *to, const char *name, const char *placeholder, const char *help)
{
  char left[40];
  snprintf(left, sizeof left, "--%s %s", name, placeholder ? placeholder : "");
  print_item(to, left, 22, help);
}

static void write_program(FILE *to)
{
  fputs(shipped_text(shipped_help, "scallop"), to);
  for (const struct command *const *c = commands; *c; c++)
    print_item(to, (*c)->name, 16, (*c)->summary);
  fputs(shipped_text(shipped_help, "scallop-end"), to);
}

/* What an option is for and, in brackets, what holds where it is not given. */
enum { HELP_OPTION = 320 };
static void describe(const struct arguments *initial, const struct option *o, char text[HELP_OPTION])
{
  char value[OPTION_VALUE] = "";
  if (o->kind->show)
    o->kind->show(&initial->options, o, value);
  const char *otherwise = o->otherwise ? o->otherwise : *value ? "%s" : NULL;
  int used = snprintf(text, HELP_OPTION, "%s", o->help);
  if (!otherwise)
    return;
  const char *place = strstr(otherwise, "%s");
  int before = place ? (int)(place - otherwise) : (int)strlen(otherwise);
  snprintf(text + used, HELP_OPTION - (size_t)used, " (%.*s%s%s)", before, otherwise, place ? value : "",
           place ? place + 2 : "");
}

/* Those that are formulas stand behind the list of all. */
static void list_quantities(FILE *to, int first, int end)
{
  fputs("\nQuantities (with their units):\n", to);
  for (const struct quantity_row *row = quantity_rows + first;
       row < quantity_rows + end || (end == NAMED_QUANTITIES && row->formula); row++) {
    char text[HELP_OPTION];
    snprintf(text, sizeof text, "%s [%s]", row->sentence, row->unit);
    print_item(to, row->name, 22, text);
  }
}

/* What --gait takes, if the command has it */
static void list_gaits(FILE *to, const struct command *command)
{
  const struct option *o = command->options;
  const struct scallop_gait_family *family;
  while (o->name && strcmp(o->name, "gait") != 0)
    o++;
  if (o->name)
    fputs("\nGaits (with their usual numbers):\n", to);
  for (int i = 0; o->name && (family = gait_family(i)) != NULL; i++) {
    char name[40], text[HELP_OPTION];
    bool may = family->numbers && family->usual;
    snprintf(name, sizeof name, "%s%s%s%s%s", family->name, may ? "[" : "", family->numbers ? ":" : "",
             family->numbers ? family->numbers : "", may ? "]" : "");
    snprintf(text, sizeof text, "%s%s%s%s", family->sentence, may ? " (" : "", may ? family->usual : "",
             may ? ")" : "");
    print_item(to, name, 26, text);
  }
}

static void write_command(FILE *to, const struct command *command)
{
  char summary[HELP_OPTION];
  snprintf(summary, sizeof summary, "%s.", command->summary);
  fprintf(to, "Example: %s\n\n", command->example);
  print_from(to,
             fprintf(to, "scallop %s%s%s [options]: ", command->name, command->operand ? " " : "",
                     command->operand ? command->operand : ""),
             0, summary);
  fprintf(to, "\n%s", shipped_text(shipped_help, command->name));
  if (command->quantities.end > 0)
    list_quantities(to, command->quantities.first, command->quantities.end);
  list_gaits(to, command);
  fputs("\nOptions (defaults in brackets):\n", to);
  struct arguments initial;
  options_initial(&initial, command);
  for (const struct option *o = command->options; o->name; o++) {
    char text[HELP_OPTION];
    describe(&initial, o, text);
    option_line(to, o->name, o->argument, text);
  }
  option_line(to, "help", NULL, "this text");
}

void help_of(FILE *to, const struct command *command)
{
  if (command)
    write_command(to, command);
  else
    write_program(to);
}
