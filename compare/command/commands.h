/* Commands by their names. */
#ifndef SCALLOP_COMMANDS_H
#define SCALLOP_COMMANDS_H

struct command;

/* NULL: there is none. */
const struct command *command_named(const char *name);

/* The name nearest to a mistyped one, or NULL if none is near. */
const char *nearest_command(const char *word);

#endif
