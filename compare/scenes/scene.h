/* Scenes: files that say which crawler and gait, what varies, and which tables are wanted. docs/reference/scenes.md
 * has the language. What a scene says of its points becomes a request; each of its tables is one of a command, whose
 * members are read as that command's options (compare/command/scene_table.c). */
#ifndef SCALLOP_COMPARE_SCENES_SCENE_H
#define SCALLOP_COMPARE_SCENES_SCENE_H

#include "compare/answers/rows.h"
#include "compare/config/config.h"
#include "compare/tables/plot.h"

enum { SCENE_TABLES = 32 };

struct scene {
  struct config config; /* whose texts all others point to */
  char *name;           /* of the file, without folder and .cfg */
  struct scene_head head;
  const char *formulas;   /* whose formulas are quantities too, or NULL */
  struct request request; /* the points of all tables */
  int tables;
  const config_setting_t *table[SCENE_TABLES];
};

/* Where a scene comes from: a file, or a text that has no folder. */
struct scene_source {
  const char *path; /* for messages, and to read if text is NULL */
  const char *text;
};

/* Reads a scene except its tables. given: of the command line; parameters that are given there take the place of the
 * scene's, varied or not. EXIT_DONE, or the exit code, the message being on stderr; to be freed in either case. */
enum exit_code scene_read(struct scene *scene, const struct scene_source *source, const struct request *given);
void scene_free(struct scene *scene);

/* Where the table and its picture go */
struct scene_files {
  const char *table; /* NULL: standard output */
  bool has_plot;
  struct plot plot;
};
/* style: of the table. False: the message is on stderr. */
bool scene_read_files(struct scene_files *files, struct scene *scene, const config_setting_t *table,
                      const struct style *style);
/* The texts of a list with commas between, as on the command line; NULL: not all are texts */
const char *scene_text_of_list(struct scene *scene, const config_setting_t *at);

/* vary.c: what varies */
bool scene_read_vary(struct scene *scene, const config_setting_t *vary);

#endif
