/* The commands, each in a file of its name, and what --help prints, of the program as a whole and of one command.
 * scripts/dev/man.awk makes the manual from it, and scripts/dev/completion.bash finds commands and options there: two
 * blanks, a name, two blanks or more, what it is for. */
#ifndef SCALLOP_COMPARE_COMMAND_COMMANDS_H
#define SCALLOP_COMPARE_COMMAND_COMMANDS_H

#include <stdio.h>

#include "compare/command/options.h"

extern const struct command command_phase, command_steady, command_trajectory, command_series, command_claims,
    command_order, command_figure, command_workprec, command_stress, command_breakdown, command_summary, command_run;

/* NULL-terminated */
extern const struct command *const commands[];

/* That of this name; NULL: there is none. */
const struct command *command_named(const char *name);

/* The name nearest to a mistyped one, or NULL if none is near. */
const char *nearest_command(const char *word);

/* The help of a command, or, for NULL, of the program */
void help_of(FILE *to, const struct command *command);

#endif
