#include "compare/command/completion.h"

#include <stdbool.h>
#include <string.h>

#include "compare/command/compare.h"
#include "compare/command/completion_bash.h"
#include "compare/command/help.h"
#include "compare/command/option_table.h"

/* The values of options, where there is a list of them, in the words of completion_bash.h. */
static const struct {
  const char *option, *values;
} known[] = {
  { "gait", "quadratic sinusoidal minimum-jerk trapezoidal: skewed: polynomial: measured:FILE" },
  { "phase", "extension contraction" },
  { "start", "rest steady" },
  { "format", "tsv json" },
  { "source", "published derived limit" },
  { "quantity", "v_start v_mid displacement mean_velocity t1 dT v_end dx1 dx2 dxC" },
  { "only", "event reach radius best" },
  { "map", "F1/F2 m1/m2 alpha T froude" },
  { "errors", "all" },
};

static const char *known_values(const char *option)
{
  for (size_t i = 0; i < sizeof known / sizeof *known; i++)
    if (strcmp(known[i].option, option) == 0)
      return known[i].values;
  return NULL;
}

/* What a placeholder says of the values: FILE, FOLDER, SCENE.cfg as "FILE.cfg", a choice "2|3|4|5" as its words; or nothing. */
static void write_placeholder(FILE *to, const char *placeholder)
{
  size_t length = strcspn(placeholder, "."), ending = 0;
  if (placeholder[length] == '.' && placeholder[length + 1] != '.')
    ending = 1 + strcspn(placeholder + length + 1, ".");
  bool is_file = length == 4 && strncmp(placeholder, "FILE", length) == 0;
  if (is_file || ending > 0)
    fprintf(to, "FILE%.*s", (int)ending, placeholder + length);
  else if (strcmp(placeholder, "FOLDER") == 0)
    fputs("DIR", to);
  else if (strchr(placeholder, '|'))
    for (const char *p = placeholder; *p; p++)
      putc(*p == '|' ? ' ' : *p, to);
}

static void write_options(FILE *to, const struct command *command)
{
  for (const char *const *name = command->accepts; *name; name++)
    fprintf(to, "--%s ", *name);
  fputs("--help", to);
}

static void write_command_names(FILE *to)
{
  for (const struct command *const *c = commands; *c; c++)
    fprintf(to, "%s%s", c == commands ? "" : " ", (*c)->name);
}

/* A case for each command: its options, what its operands are, and how many it takes. The case without a name is for what
 * stands in place of a command. */
static void write_commands(FILE *to)
{
  fputs("    '') options='", to);
  write_command_names(to);
  for (const struct request *r = requests; r->name; r++)
    fprintf(to, " --%s", r->name);
  fputs(" help' ;;\n", to);
  for (const struct command *const *c = commands; *c; c++) {
    fprintf(to, "    %s) options='", (*c)->name);
    write_options(to, *c);
    if ((*c)->operand) {
      fputs("' operand='", to);
      write_placeholder(to, (*c)->operand);
      fprintf(to, "' most=%s", many_operands(*c) ? "9999" : "1");
    } else {
      putc('\'', to);
    }
    fputs(" ;;\n", to);
  }
}

/* A case for each option that takes a value. */
static void write_option_values(FILE *to, const struct command *command)
{
  for (const char *const *name = command->accepts; *name; name++) {
    const struct option_description *option = describe_option(*name, command);
    if (!option->placeholder)
      continue;
    const char *values = known_values(*name);
    fprintf(to, "    '%s --%s') count=%d values='", command->name, *name, option_value_count(option));
    if (values)
      fputs(values, to);
    else
      write_placeholder(to, option->placeholder);
    fputs("' ;;\n", to);
  }
}

/* The same for what stands in place of a command. */
static void write_request_values(FILE *to)
{
  for (const struct request *r = requests; r->name; r++) {
    if (!r->placeholder)
      continue;
    bool help = strcmp(r->placeholder, "[COMMAND]") == 0, page = strcmp(r->placeholder, "PAGE") == 0;
    fprintf(to, "    ' --%s'%s) count=1 values='%s", r->name, help ? " | ' -h' | ' help'" : "", page ? "list scallop " : "");
    if (help || page)
      write_command_names(to);
    else
      fputs("bash", to);
    fputs("' ;;\n", to);
  }
}

void completion_script(FILE *to)
{
  fputs("# Completion of scallop " SCALLOP_VERSION " in bash, written by: scallop --completion bash\n", to);
  fputs(completion_usage, to);
  fputs(completion_of_command, to);
  write_commands(to);
  fputs(completion_of_option, to);
  write_request_values(to);
  for (const struct command *const *c = commands; *c; c++)
    write_option_values(to, *c);
  fputs(completion_of_words, to);
}
