/* What --help tells, of the program as a whole and of one command. The manual and the completion tell the same
 * (compare/command/man.h, compare/command/completion.h). */
#ifndef SCALLOP_HELP_H
#define SCALLOP_HELP_H

#include <stdbool.h>
#include <stdio.h>

struct command;

/* What can stand in place of a command. */
struct request {
  const char *name;        /* without the dashes                                                               */
  const char *placeholder; /* of its value, in brackets where it may be left out; NULL: it takes none          */
  const char *help;
};
/* name = NULL ends them. */
extern const struct request requests[];

extern const char program_example[];
/* What the program is, in a clause without a full stop. */
extern const char program_purpose[];
/* What each exit code says, from 0 on; NULL ends them. */
extern const char *const exit_meanings[];
/* What else there is to know of exit codes. */
extern const char exit_notes[];

void help_program(FILE *to);
void help_command(FILE *to, const struct command *command);

/* What one of its options is for and, in brackets, what holds where it is not given. */
enum { HELP_OPTION = 320 };
void help_option(const struct command *command, const char *name, char text[HELP_OPTION]);

#endif
