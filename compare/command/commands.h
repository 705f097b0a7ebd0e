/* The commands. */
#ifndef SCALLOP_COMMANDS_H
#define SCALLOP_COMMANDS_H

#include "compare/command/options.h"

extern const struct command command_phase, command_steady, command_trajectory, command_series, command_claims, command_order,
    command_figure, command_workprec, command_stress, command_breakdown, command_run;
/* All of them, NULL-terminated. */
extern const struct command *const commands[];

/* That of this name; NULL: there is none. */
const struct command *command_named(const char *name);

/* The name nearest to a mistyped one, or NULL if none is near. */
const char *nearest_command(const char *word);

#endif
