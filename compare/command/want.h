/* A want of a scene: a request of a command, whose members are read by the command's own option rows. */
#ifndef SCALLOP_COMPARE_COMMAND_WANT_H
#define SCALLOP_COMPARE_COMMAND_WANT_H

#include "compare/command/options.h"
#include "compare/scenes/scene.h"

struct scene_options { /* of run and figure */
  struct request request;
  const char *folder; /* below which all files go, or NULL */
  bool check_only, no_plots;
};

struct want {
  struct arguments arguments;
  struct rows rows; /* planned, where the command makes rows */
  bool has_rows;
  struct scene_files files;
};

/* False: the message is on stderr. To be freed in either case. */
bool want_read(struct want *want, struct scene *scene, const config_setting_t *at, const struct scene_options *options);
void want_free(struct want *want);

#endif
