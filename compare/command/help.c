#include "compare/command/help.h"

#include <string.h>

#include "compare/command/compare.h"
#include "compare/command/option_table.h"

static const char program_text[] =
    "\nscallop COMMAND --help prints what a command takes and what it returns. In place of a command:\n"
    "  --help [COMMAND]    this text, or that of a command; also -h, and help without dashes\n"
    "  --version           the version\n"
    "  --completion bash   a script by which bash completes commands, options and file names\n"
    "\nExit codes:\n"
    "  0  done\n"
    "  1  a check failed\n"
    "  2  bad usage or input\n"
    "  3  a computation could not be done\n"
    "  4  a file or standard output could not be read or written; a closed pipe is such a case: scallop ... | head\n"
    "If a signal ends a run, the exit code is that of the signal. -o FILE replaces FILE only when the new table is "
    "complete.\n";

/* An option, what it takes, and what for. */
static void option_line(FILE *to, const char *name, const char *placeholder, const char *help)
{
  char left[40];
  snprintf(left, sizeof left, "--%s %s", name, placeholder ? placeholder : "");
  fprintf(to, "  %-18s  %s\n", left, help);
}

void help_program(FILE *to)
{
  fputs("Example: scallop steady --F1 3 --T 0.5\n\n"
        "scallop COMMAND [options]: a two-body crawler on dry friction, its exact motion and the\n"
        "asymptotic series said to describe it, side by side.\n\n"
        "Commands:\n",
        to);
  for (const struct command *const *c = commands; *c; c++)
    fprintf(to, "  %-12s %s\n", (*c)->name, (*c)->summary);
  fputs(program_text, to);
}

/* Is name one of names, which blanks separate? */
static bool is_among(const char *names, const char *name)
{
  size_t length = strlen(name);
  for (const char *at = names; (at = strstr(at, name)); at += length)
    if ((at == names || at[-1] == ' ') && (at[length] == ' ' || at[length] == '\0'))
      return true;
  return false;
}

/* What the command does where the option is not given, in which %s stands for the value that it begins with. NULL: nothing. */
static const char *unless_given(const struct command *command, const char *name, bool has_value)
{
  for (const struct unless_given *u = command->unless_given; u && u->options; u++)
    if (is_among(u->options, name))
      return u->text;
  return has_value ? "%s" : NULL;
}

/* What one of its options is for and, in brackets, what holds where it is not given. */
enum { HELP_OPTION = 320 };
static void describe(const struct command *command, const char *name, char text[HELP_OPTION])
{
  const struct option_description *option = describe_option(name, command);
  const char *otherwise = unless_given(command, name, option->kind->show != NULL), *place;
  char value[OPTION_VALUE] = "", more[OPTION_RANGE] = "";
  struct options initial;
  options_initial(&initial, command);
  if (option->kind->show)
    option->kind->show(&initial, name, value);
  if (option->kind->add)
    option->kind->add(more, command);
  int used = snprintf(text, HELP_OPTION, "%s%s", option->help, more);
  if (!otherwise)
    return;
  place = strstr(otherwise, "%s");
  int before = place ? (int)(place - otherwise) : (int)strlen(otherwise);
  snprintf(text + used, HELP_OPTION - (size_t)used, " (%.*s%s%s)", before, otherwise, place ? value : "",
           place ? place + 2 : "");
}

void help_command(FILE *to, const struct command *command)
{
  fprintf(to, "Example: %s\n\nscallop %s%s%s [options]: %s.\n\n%s\n\nOptions (defaults in brackets):\n", command->example,
          command->name, command->operand ? " " : "", command->operand ? command->operand : "", command->summary,
          command->about);
  for (const char *const *name = command->accepts; *name; name++) {
    char text[HELP_OPTION];
    describe(command, *name, text);
    option_line(to, *name, describe_option(*name, command)->placeholder, text);
  }
  option_line(to, "help", NULL, "this text");
}
