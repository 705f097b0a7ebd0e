/* Where scenes read and write, by folder and file and not by how a path is spelled. */
#ifndef SCALLOP_SCENE_PLACES_H
#define SCALLOP_SCENE_PLACES_H

#include <stdbool.h>
#include <sys/types.h>

#include "compare/scenes/scene.h"

enum { SCENE_PLACES = 8192, PLACE_NAME = 256 };

struct scene_place {
  bool is_output; /* the file is there (device and number of its own), or not (those of its folder, and a name) */
  dev_t device;
  ino_t number;
  char name[PLACE_NAME];
};

struct scene_places {
  bool has_standard_output;
  int count;
  struct scene_place place[SCENE_PLACES];
};

/* Notes the files that a scene reads: itself, what it includes, measured gaits and scripts of plots; and standard
 * input, where that is a file. */
void places_reads(struct scene_places *places, const struct scene *scene);
/* Something goes there; NULL: standard output. False: something else does already, or is read there: the message is on stderr. Devices and
 * pipes take any number. */
bool places_writes(struct scene_places *places, const char *command, const char *path);

#endif
