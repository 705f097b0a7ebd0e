/* The text of a scene, before libconfig reads it: what it would take in silence, or end the program for, is refused here. */
#ifndef SCALLOP_SCENE_TEXT_H
#define SCALLOP_SCENE_TEXT_H

#include <stdbool.h>

#include "compare/command/compare.h"

/* The whole file, to be freed; "-" is standard input. Not EXIT_DONE: the message is on stderr, and *text is NULL. */
enum exit_code scene_text_read(const char *command, const char *path, char **text);

/* Is told of each file that is included, by its path, which does not outlive the call. */
typedef void scene_text_included(void *context, const char *path);

/* No whole number beyond 32 bits without an L, which would be another; no byte that no scene has; files that are included are files.
 * False: the message, with path and line, is on stderr. folder: where included files are looked for. */
bool scene_text_check(const char *command, const char *path, const char *folder, const char *text,
                      scene_text_included *included, void *context);

#endif
