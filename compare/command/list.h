/* The list of commands, and what --help prints, of the program as a whole and of one command. scripts/dev/man.awk makes
 * the manual from it, and scripts/dev/completion.bash finds commands and options there: two blanks, a name, two blanks
 * or more, what it is for. */
#ifndef SCALLOP_COMPARE_COMMAND_LIST_H
#define SCALLOP_COMPARE_COMMAND_LIST_H

#include <stdio.h>

#include "compare/command/options.h"

/* NULL-terminated */
extern const struct command *const commands[];

/* That of this name; NULL: there is none. */
const struct command *command_named(const char *name);

/* The name nearest to a mistyped one, or NULL if none is near. */
const char *nearest_command(const char *word);

/* The help of a command, or, for NULL, of the program: for a narrower terminal in its columns. */
void help_of(FILE *to, const struct command *command);

#endif
