/* Does what a plan says. */
#ifndef SCALLOP_SCENE_RUN_H
#define SCALLOP_SCENE_RUN_H

#include "compare/command/compare.h"
#include "compare/scenes/plan.h"

/* Where a want's table goes: the file, or NULL for standard output. It lives as long as the scene and the options. */
struct scene_outputs {
  const char *file[SCENE_WANTS];
  const char *plot[SCENE_WANTS]; /* likewise; NULL: none                                                */
};

/* Runs a scene: opens its tables, goes over its points once, closes them and draws the plots. options: of the command line. */
enum exit_code scene_run(const struct scene *scene, const struct plan *plan, const struct scene_outputs *outputs,
                         const struct options *options);

/* command/run.c: reads all scenes, and only then runs them. to_output: their tables go to options->output or standard output, whatever
 * files they name, and nothing is drawn. */
enum exit_code run_scenes(const struct options *options, const struct scene_source *sources, int count, bool to_output);

#endif
