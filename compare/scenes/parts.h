/* What the files of this folder share. Not public. */
#ifndef SCALLOP_SCENE_PARTS_H
#define SCALLOP_SCENE_PARTS_H

#include <libconfig.h>

#include "compare/order/order.h"
#include "compare/scenes/scene.h"
#include "compare/scenes/state.h"

enum { MOST_CERTIFIED_DIGITS = 10000 };

struct reading {
  struct scene *scene;
  const struct scene_options *options; /* of the command line */
  const char *path;                    /* of the scene, for messages */
};

/* member.c: "scallop run: FILE:LINE: message" on stderr. Returns false. */
bool refuse_at(const struct reading *r, const config_setting_t *at, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

enum member_kind {
  MEMBER_OTHER,  /* known, and read elsewhere */
  MEMBER_TEXT,   /* const char *: not empty */
  MEMBER_TEXTS,  /* const char *[high]: one or more */
  MEMBER_WORD,   /* int: the place of the text among words, NULL-terminated */
  MEMBER_FLAG,   /* bool */
  MEMBER_COUNT,  /* long: from low to high */
  MEMBER_NUMBER, /* double: finite */
};
/* A member that a group may have, and the field of a struct where its value goes; that stays as it is where the group has no such
 * member. */
struct member {
  const char *name; /* NULL ends a list */
  enum member_kind kind;
  size_t field, count; /* count: of texts, the int that says how many */
  long low, high;
  const char *const *words;
  const char *only; /* the kinds of wants that may have it; NULL: all */
};
#define MEMBER(KIND, NAME, STRUCT, FIELD, ...) \
  { \
    .name = NAME, .kind = MEMBER_##KIND, .field = offsetof(struct STRUCT, FIELD), __VA_ARGS__ \
  }
#define OTHER(NAME) MEMBER(OTHER, NAME, member, name, )
const struct member *find_member(const struct member *members, const char *name);
bool read_member(const struct reading *r, const config_setting_t *at, const struct member *member, void *into);
/* Reads the members of a group, which is called what in messages ("a scene"), into a struct. want: the kind of the want, where it is one. */
bool read_members(const struct reading *r, const config_setting_t *group, const struct member *members, void *into,
                  const char *what, const char *want);

/* "a, b, c" or, quoted, "a" or "b" or "c" with the quotes. Returns text. */
const char *joined(char *text, size_t size, const char *const *names, bool quoted);
bool is_among(const char *name, const char *const *names);
bool is_ascii(const char *text); /* printable */
const config_setting_t *member_at(const config_setting_t *group, int i);
/* The elements of a list or an array; anything else is one. */
int element_count(const config_setting_t *at);
const config_setting_t *element_at(const config_setting_t *at, int i);
/* A number, or a text that is one. text: what was written, or NULL where the double says it all. */
bool is_number(const config_setting_t *at, double *value, const char **text);

struct kept { /* a text that the scene keeps */
  struct kept *next;
  char text[];
};
/* A text for as long as the scene lives. NULL: no memory, which is said. */
const char *keep(const struct reading *r, const char *format, ...) __attribute__((format(printf, 2, 3)));
const char *keep_number(const struct reading *r, double x);
/* Paths of inputs are those of the folder of the scene; so "measured:FILE", and other gaits as they are. NULL as above. */
const char *path_beside(const struct reading *r, const char *path);
const char *gait_beside(const struct reading *r, const char *gait);

/* text.c: refuses what libconfig would misread, or end the program for, in the text of a file and in those that it includes, which are
 * noted in the scene. */
bool check_text(const struct reading *r, const char *text);

/* plan.c: fills in scene->plan, from the kinds of its quantities. Nothing is solved. */
void make_plan(struct scene *scene);

/* vary.c, want.c: vary = ... and want = ... */
bool read_vary(const struct reading *r, const config_setting_t *vary);
bool read_wants(const struct reading *r, const config_setting_t *want);
/* command.c: the options of a want that is the table of another command; members: of any want */
bool read_command(const struct reading *r, const config_setting_t *at, struct scene_want *w, const struct member *members);

/* columns.c: columns by their formulas, or those that a kind of want has. w->columns grows. */
bool add_columns(const struct reading *r, const config_setting_t *at, struct scene_want *w, const char *const *texts);
extern const char *const order_columns[]; /* behind the columns of a want of orders */
bool usual_columns(const struct reading *r, const config_setting_t *at, struct scene_want *w);
/* Checks the series of a want: those of `of`, or else the usual ones of its source and order, which become those of the want. */
extern const char *const series_sources[];
bool find_series(const struct reading *r, const config_setting_t *at, struct scene_want *w);
bool has_column(const struct scene_want *w, const char *name);
/* Has a scene like this one that quantity? False: it is said why not. */
bool check_quantity(const struct reading *r, const config_setting_t *at, const struct scene_want *w, int place);
/* A number, or a formula of parameters and sticking_onset (*onset: it is one of these). */
bool read_end(const struct reading *r, const config_setting_t *at, struct sweep_end *end, bool *onset);
/* There is no quantity of that name. Returns false. */
bool refuse_quantity(const struct reading *r, const config_setting_t *at, const char *name);

/* A table that is being made */
struct output {
  const struct scene_want *want;
  struct style style;
  struct table table;
  bool is_open;
  /* orders: the errors of each series at each T so far */
  struct order_point *errors;
  long times;
};

struct running {
  const struct scene *scene;
  const struct scene_options *options;
  struct scene_state *state;
  struct output *output;
  long points, unsolved, failed_checks;
  bool failed;            /* a table can no longer be written */
  char why[POINT_STATUS]; /* the first reason of those unsolved */
};

/* output.c: the '#' lines and the names of the columns; and the columns of the want at the point, which are a row, or begin one of orders */
void output_begin(const struct running *r, struct output *o);
void output_row(const struct running *r, struct output *o);

/* orders.c: a point's errors; and, after the last T, the rows */
void orders_collect(const struct running *r, struct output *o);
void orders_finish(struct running *r, struct output *o);

#endif
