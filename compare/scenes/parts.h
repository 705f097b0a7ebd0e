/* What the files scene_*.c share while a scene is read. Not public. */
#ifndef SCALLOP_SCENE_PARTS_H
#define SCALLOP_SCENE_PARTS_H

#include <libconfig.h>

#include "compare/command/compare.h"
#include "compare/scenes/scene.h"

struct reading {
  struct scene *scene;
  const struct options *options; /* of the command line                                           */
  const char *path;              /* of the scene, for messages                                    */
};

/* "scallop run: FILE:LINE: message" on stderr. Returns false. */
bool refuse_at(const struct reading *r, const config_setting_t *at, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Is every member of the group called one of names (NULL-terminated)? what: "a scene", of which they are part. */
bool keys_known(const struct reading *r, const config_setting_t *group, const char *const *names, const char *what);

/* Of a member of a group: true if it is not there, and *value is then untouched. What is wrong with it is said. */
bool read_member_text(const struct reading *r, const config_setting_t *group, const char *name, const char **value);
bool read_member_flag(const struct reading *r, const config_setting_t *group, const char *name, bool *value);
bool read_member_count(const struct reading *r, const config_setting_t *group, const char *name, long low, long high,
                       long *value);
bool read_member_number(const struct reading *r, const config_setting_t *group, const char *name, double *value);
/* A text, or an array of at most `most` texts; *count: how many. */
bool read_member_texts(const struct reading *r, const config_setting_t *group, const char *name, const char **values,
                       int most, int *count);

/* A number, or a text that is one. text: what was written, or NULL where the double says it all. */
bool is_number(const config_setting_t *at, double *value, const char **text);
/* A number, or a formula of quantities that are known when it is needed. */
bool read_end(const struct reading *r, const config_setting_t *at, struct scene_end *end);

/* Is it of parameters, and of sticking_onset (*onset: then that is set)? False: it is said what is not. */
bool check_end(const struct reading *r, const config_setting_t *at, const struct scene_end *end, bool *onset);

bool is_sequence(const config_setting_t *at); /* an array or a list */

/* vary.c: vary = ... */
bool read_vary(const struct reading *r, const config_setting_t *vary);
/* want.c: want = ... */
bool read_wants(const struct reading *r, const config_setting_t *want);

/* columns.c: columns by their formulas, and those that a kind of want has. w->columns grows. */
bool read_column(const struct reading *r, const config_setting_t *at, struct scene_want *w, const char *text);
bool add_columns(const struct reading *r, const config_setting_t *at, struct scene_want *w, const char *const *texts);
bool add_labels(const struct reading *r, const config_setting_t *at, struct scene_want *w);
bool steady_columns(const struct reading *r, const config_setting_t *at, struct scene_want *w);
bool phase_columns(const struct reading *r, const config_setting_t *at, struct scene_want *w);
bool series_columns(const struct reading *r, const config_setting_t *at, struct scene_want *w, bool with_errors);
/* The series of a want: those of `of`, or the usual ones of its source and order. */
struct series_names {
  int count;
  const char *name[SCENE_COLUMNS];
};
bool read_series(const struct reading *r, const config_setting_t *at, struct series_names *names);
/* Has a scene like this one that quantity? False: it is said why not. */
bool check_quantity(const struct reading *r, const config_setting_t *at, const struct scene_want *w, int place);
/* A formula of the scene's quantities. NULL, or what is wrong with it: it lives until the next call. */
const char *read_formula(const struct reading *r, struct formula *formula, const char *text);
/* There is no quantity of that name. Returns false. */
bool refuse_quantity(const struct reading *r, const config_setting_t *at, const char *name);

/* command.c: is that the table of another command? And its options */
bool is_command(const char *what);
bool read_command(const struct reading *r, const config_setting_t *at, struct scene_want *w);

/* The first length bytes of text, and more after them, for as long as the scene lives. NULL: no memory, which is said. */
const char *keep_text(const struct reading *r, const char *text, int length, const char *more);
/* Paths of inputs are those of the folder of the scene. NULL as above. */
const char *path_beside(const struct reading *r, const char *path);
/* "measured:FILE" with such a path; other gaits as they are. */
const char *gait_beside(const struct reading *r, const char *gait);

#endif
