/* A table of a scene: a request of a command, whose members are read by the command's own option rows. */
#ifndef SCALLOP_COMPARE_COMMAND_SCENE_TABLE_H
#define SCALLOP_COMPARE_COMMAND_SCENE_TABLE_H

#include "compare/command/commands.h"
#include "compare/scenes/scene.h"

struct scene_options { /* of run and figure */
  struct request request;
  const char *folder; /* below which all files go, or NULL */
  bool check_only, no_plots;
};

struct scene_table {
  struct arguments arguments;
  struct rows *rows; /* planned, where the command makes rows: those of a scene share their points; else NULL */
  struct scene_files files;
};

struct wanted { /* a scene and its tables, scene.tables of them; begins with zeros */
  struct scene scene;
  struct scene_table table[SCENE_TABLES];
  struct rows rows[SCENE_TABLES];
  int tables; /* of these rows */
};
/* The exit code, the message being on stderr. To be freed in either case. */
enum exit_code wanted_read(struct wanted *wanted, const struct scene_source *source,
                           const struct scene_options *options);
void wanted_free(struct wanted *wanted);

#endif
