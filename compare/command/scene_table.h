/* Table of a scene: a request of a command, with members that the rows of the command's options read. */
#ifndef SCALLOP_COMPARE_COMMAND_SCENE_TABLE_H
#define SCALLOP_COMPARE_COMMAND_SCENE_TABLE_H

#include "compare/command/commands.h"
#include "compare/scenes/scene.h"

struct scene_options { /* of run and figure */
  struct request request;
  const char *folder; /* for all files, or NULL */
  bool check_only, no_plots;
};

struct scene_table {
  struct arguments arguments;
  struct rows *rows; /* of a command with rows for points (the tables of a scene share the points); else NULL */
  struct scene_files files;
};

struct planned_scene { /* a scene and its tables, scene.tables of them; initially zero */
  struct scene scene;
  struct scene_table table[SCENE_TABLES];
  struct rows rows[SCENE_TABLES];
  int tables; /* in rows */
};
/* Reads and plans a scene. Returns an exit code, after a message on stderr. Call planned_scene_free in either case. */
enum exit_code planned_scene_read(struct planned_scene *planned, const struct scene_source *source,
                                  const struct scene_options *options);
void planned_scene_free(struct planned_scene *planned);

#endif
