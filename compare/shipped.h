/* Scenes that are part of the program: those of data/scenes/, by their names without folder and .cfg. scripts/embed.sh writes them. */
#ifndef SCALLOP_SHIPPED_H
#define SCALLOP_SHIPPED_H

struct shipped {
  const char *name, *text;
};
/* The last has name NULL. */
extern const struct shipped shipped_scenes[];

/* The text of the scene called name ("figure4"), or NULL. */
const char *shipped_scene(const char *name);

/* The name of one that is near, or NULL. */
const char *shipped_near(const char *name);

#endif
