/* The commands, each in a file of its name. */
#ifndef SCALLOP_COMPARE_COMMAND_COMMANDS_H
#define SCALLOP_COMPARE_COMMAND_COMMANDS_H

#include "compare/command/options.h"

extern const struct command command_phase, command_steady, command_trajectory, command_series, command_claims,
    command_order, command_figure, command_workprec, command_stress, command_breakdown, command_summary, command_run;

#endif
