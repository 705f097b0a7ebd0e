/* Scenes from the command line, for the commands that run some. */
#ifndef SCALLOP_COMPARE_COMMAND_RUN_H
#define SCALLOP_COMPARE_COMMAND_RUN_H

#include "compare/command/want.h"

/* Reads all scenes, and only then runs them. */
enum exit_code run_scenes(const struct scene_options *options, const struct scene_source *sources, int count);

#endif
