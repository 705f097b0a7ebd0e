/* The list of commands. */
#ifndef SCALLOP_COMMAND_LIST_H
#define SCALLOP_COMMAND_LIST_H

#include "compare/command/options.h"

/* NULL-terminated */
extern const struct command *const commands[];

/* That of this name; NULL: there is none. */
const struct command *command_named(const char *name);

/* The name nearest to a mistyped one, or NULL if none is near. */
const char *nearest_command(const char *word);

#endif
