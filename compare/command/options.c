#include "compare/command/options.h"

#include <limits.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare/command/compare.h"
#include "compare/answers/gaits.h"
#include "compare/command/help.h"
#include "compare/command/option_table.h"
#include "compare/text/values.h"
#include "compare/text/message.h"

static bool refuse(int *code)
{
  *code = EXIT_USAGE;
  return false;
}

static const struct {
  const char *command, *option, *instead;
} dropped[] = {
  { "workprec", "from",
    "`awk -f cheapest.awk FILE` summarises a table; the script is in scripts/ of the sources, and installed in "
    "share/scallop/" },
  { "claims", "against", "`--check` compares with the ledger that comes with the tool; compare any two ledgers with diff" },
};

static bool refuse_option(const struct options *o, const char *argument, const char *name, int *code)
{
  const char *command = o->command->name, *near = nearest(name + strspn(name, "-"), o->command->accepts);
  char option[80];
  snprintf(option, sizeof option, "--%.70s", near ? near : "");
  for (size_t i = 0; i < sizeof dropped / sizeof *dropped; i++)
    if (strcmp(command, dropped[i].command) == 0 && strcmp(name, dropped[i].option) == 0) {
      complain(command, "the option '%s' is no longer there: %s", argument, dropped[i].instead);
      return refuse(code);
    }
  if (describe_option(name, o->command))
    complain(command, "this command does not take the option '%s' (see scallop %s --help)", argument, command);
  else
    complain(command, "unknown option '%s'%s (see scallop %s --help)", argument, did_you_mean(near ? option : NULL),
             command);
  return refuse(code);
}

/* The option called name, whose value is text, or the next argument. argument: as it was written. */
static bool take_option(struct options *o, int count, char **arguments, int *i, int *code, char *name, const char *text)
{
  const char *argument = arguments[*i];
  bool two_dashes = argument[0] == '-' && argument[1] == '-' && argument[2] != '-';
  const struct option_description *d = option_accepted(o->command, name) ? describe_option(name, o->command) : NULL;
  if (!d || (!two_dashes && strcmp(argument, "-o") != 0))
    return refuse_option(o, argument, name, code);
  if (d->placeholder && !text) {
    if (*i + 1 == count) {
      complain(o->command->name, "--%s needs a value: --%s %s", name, name, d->placeholder);
      return refuse(code);
    }
    text = arguments[++*i];
  }
  if (!d->placeholder && text) {
    complain(o->command->name, "--%s takes no value", name);
    return refuse(code);
  }
  const char *wrong = d->kind->set(o, name, text);
  if (!wrong && option_value_count(d) == 2) {
    if (*i + 1 == count) {
      complain(o->command->name, "--%s needs two values: --%s %s", name, name, d->placeholder);
      return refuse(code);
    }
    wrong = d->kind->set(o, name, arguments[++*i]);
  }
  if (wrong)
    complain(o->command->name, "--%s: %s", name, wrong);
  if (wrong && o->point.unreadable) {
    *code = EXIT_FILE;
    return false;
  }
  return wrong ? refuse(code) : true;
}

static bool read_option(struct options *o, int count, char **arguments, int *i, int *code)
{
  char *argument = arguments[*i];
  bool two_dashes = argument[0] == '-' && argument[1] == '-' && argument[2] != '-';
  char *name = strcmp(argument, "-o") == 0 ? "output" : argument + (two_dashes ? 2 : 0);
  char *equals = two_dashes ? strchr(name, '=') : NULL;
  if (equals)
    *equals = '\0';
  bool taken = take_option(o, count, arguments, i, code, name, equals ? equals + 1 : NULL);
  if (equals) /* the arguments may be handed on: with_flint.h */
    *equals = '=';
  return taken;
}

/* Is there room for one more? */
static bool take_operand(struct options *o, const char *text)
{
  if (o->operand_count == (many_operands(o->command) ? INT_MAX : o->command->operand ? 1 : 0))
    return false;
  o->operands[o->operand_count++] = text;
  o->operand = o->operands[0];
  return true;
}

/* False: *code is the exit code. */
static bool read_arguments(struct options *o, int count, char **arguments, int *code)
{
  const struct command *command = o->command;
  for (int i = 2; i < count; i++) {
    if (strcmp(arguments[i], "--help") == 0 || strcmp(arguments[i], "-h") == 0) {
      help_command(stdout, command);
      *code = EXIT_DONE;
      return false;
    }
    if (arguments[i][0] == '-' && arguments[i][1] != '\0') {
      if (!read_option(o, count, arguments, &i, code))
        return false;
    } else if (!take_operand(o, arguments[i])) {
      complain(command->name, "unexpected argument '%s' (see scallop %s --help)", arguments[i], command->name);
      return refuse(code);
    }
  }
  if (command->operand && !o->operand) {
    complain(command->name, "an argument is missing: scallop %s %s", command->name, command->operand);
    return refuse(code);
  }
  return true;
}

/* Of a scene that is known when it has been read. */
static bool digits_are_sound(const struct options *o)
{
  bool is_told = option_accepted(o->command, "certified") || option_accepted(o->command, "source");
  bool proven = o->certified || o->bound || strcmp(o->source, "published") != 0;
  char number[24];
  if (o->digits <= DOUBLE_DIGITS || proven || !is_told)
    return true;
  snprintf(number, sizeof number, "%ld", o->digits);
  complain(o->command->name, "--digits: %s", digits_refused(o->command, number));
  return false;
}

/* A measurement must not be lost to a slip of the keyboard. */
static bool output_is_sound(const struct options *o)
{
  bool lost = o->output && gait_is_from(o->output);
  if (lost)
    complain(o->command->name, "--output: %s is the file of the gait and is not replaced: name another file", o->output);
  return !lost;
}

void options_initial(struct options *o, const struct command *command)
{
  *o = (struct options){ .command = command,
                         .start = "rest",
                         .point = point_initial(command->defaults),
                         .periods = 10,
                         .samples = 40,
                         .source = "published",
                         .order = 8,
                         .seed = 1,
                         .tolerance = 0.1 };
}

bool options_read(struct options *o, const struct command *command, int count, char **arguments, int *code)
{
  options_initial(o, command);
  o->arguments = arguments;
  o->operands = calloc((size_t)count, sizeof *o->operands);
  if (!o->operands) {
    complain(command->name, "out of memory");
    *code = EXIT_UNSOLVED;
    return false;
  }
  if (!read_arguments(o, count, arguments, code))
    return false;
  point_complete(&o->point);
  return (digits_are_sound(o) && output_is_sound(o)) || refuse(code);
}

void options_free(struct options *o)
{
  free(o->operands);
  o->operands = NULL;
  o->operand_count = 0;
}
