/* Scenes: files that state a crawler, its gait, the variables and the requested tables, in the language of
 * docs/reference/scenes.md. The points of a scene become a request; each table is the table of a command, and its
 * members are read as options of that command (compare/command/scene_table.c). */
#ifndef SCALLOP_COMPARE_SCENES_SCENE_H
#define SCALLOP_COMPARE_SCENES_SCENE_H

#include "compare/answers/rows.h"
#include "compare/config/config.h"
#include "compare/tables/plot.h"

enum { SCENE_TABLES = 32 };

struct scene {
  struct config config; /* owns the texts of all others */
  char *name;           /* of the file, without folder and .cfg */
  struct scene_head head;
  const char *formulas;   /* a formula file, or NULL */
  struct request request; /* the points of all tables */
  int tables;
  const config_setting_t *table[SCENE_TABLES];
};

/* The source of a scene: a file, or a text */
struct scene_source {
  const char *path; /* for messages, and to read if text is NULL */
  const char *text;
};

/* Reads a scene except its tables. given: from the command line; its parameters override the scene's, also those that
 * vary. Returns EXIT_DONE, or the exit code after a message on stderr; the scene must be freed in either case. */
enum exit_code scene_read(struct scene *scene, const struct scene_source *source, const struct request *given);
void scene_free(struct scene *scene);

/* The output files of a table and its plot */
struct scene_files {
  const char *table; /* NULL: standard output */
  bool has_plot;
  struct plot plot;
};
/* Reads the output files; style: of the table. Returns false after a message on stderr. */
bool scene_read_files(struct scene_files *files, struct scene *scene, const config_setting_t *table,
                      const struct style *style);
/* Returns the texts of a list with commas between, as on the command line; NULL if one is not a text. */
const char *scene_text_of_list(struct scene *scene, const config_setting_t *at);

/* Reads the variables (vary.c). Returns false after a message on stderr. */
bool scene_read_vary(struct scene *scene, const config_setting_t *vary);

#endif
