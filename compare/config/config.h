/* Files in libconfig's format, scenes and formula files: read whole, checked for what libconfig would misread, and
 * taken member by member into the fields of structs. */
#ifndef SCALLOP_COMPARE_CONFIG_CONFIG_H
#define SCALLOP_COMPARE_CONFIG_CONFIG_H

#include <libconfig.h>
#include <stdbool.h>
#include <stddef.h>

#include "compare/text/message.h"
#include "compare/text/shipped.h"

/* A file, or a text, that was read */
struct config {
  const char *command; /* for messages */
  const char *path;    /* likewise; "-" is standard input */
  config_t file;       /* libconfig's, to whose texts members point: it stays where it is */
  config_t kept;       /* likewise, of other texts: one list */
};

/* Reads the file at path, or text, which is called path in messages. EXIT_DONE, or the exit code, the message being on
 * stderr. To be closed all the same. shipped: those whose names a mistyped path may mean, or NULL. */
enum exit_code config_open(struct config *config, const char *command, const char *path, const char *text,
                           const struct shipped *shipped);
void config_close(struct config *config);
const config_setting_t *config_root(const struct config *config);

/* "scallop run: FILE:LINE: message" on stderr. Returns false. */
bool refuse_at(const struct config *config, const config_setting_t *at, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

enum member_kind {
  MEMBER_OTHER, /* known, and read elsewhere */
  MEMBER_TEXT,  /* const char *: not empty */
  MEMBER_TEXTS, /* const char *[high]: one or more */
  MEMBER_WORD,  /* int: the place of the text among words, NULL-terminated */
  MEMBER_FLAG,  /* bool */
  MEMBER_COUNT, /* long: from low to high */
};
/* A member that a group may have, and the field of a struct where its value goes; that stays as it is where the group
 * has no such member. */
struct member {
  const char *name; /* NULL ends a list */
  enum member_kind kind;
  size_t field, count; /* count: of texts, the int that says how many */
  long low, high;
  const char *const *words;
};
#define MEMBER(KIND, NAME, STRUCT, FIELD, ...) \
  { \
    .name = NAME, .kind = MEMBER_##KIND, .field = offsetof(struct STRUCT, FIELD), __VA_ARGS__ \
  }
#define OTHER(NAME) MEMBER(OTHER, NAME, member, name, )
/* Reads the members of a group, which is called what in messages ("a scene"), into a struct. */
bool read_members(struct config *config, const config_setting_t *group, const struct member *members, void *into,
                  const char *what);

bool is_ascii(const char *text);                                      /* printable */
const config_setting_t *member_at(const config_setting_t *at, int i); /* of a group */
/* The elements of a list or an array; anything else is one. */
int element_count(const config_setting_t *at);
const config_setting_t *element_at(const config_setting_t *at, int i);
/* A text, or a number as a text that reads back as the same double; NULL: it is neither. */
const char *text_of(struct config *config, const config_setting_t *at);

/* A text for as long as the configuration is open. NULL: no memory, which is said. */
const char *keep(struct config *config, const char *format, ...) __attribute__((format(printf, 2, 3), nonnull(2)));
/* Paths of inputs are those of the folder of the file; so "measured:FILE", and other gaits as they are. NULL as
 * above. */
const char *path_beside(struct config *config, const char *path);
const char *gait_beside(struct config *config, const char *gait);

#endif
