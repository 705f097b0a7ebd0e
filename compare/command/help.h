/* What --help prints, of the program as a whole and of one command. scripts/dev/man.awk makes the manual from it, and
 * scripts/dev/completion.bash finds commands and options there: two blanks, a name, two blanks or more, what it is for. */
#ifndef SCALLOP_HELP_H
#define SCALLOP_HELP_H

#include <stdio.h>

struct command;

void help_program(FILE *to, const struct command *const *commands);
void help_command(FILE *to, const struct command *command);

#endif
