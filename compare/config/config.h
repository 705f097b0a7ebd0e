/* Files in libconfig's format (scenes and formula files), and functions that check them for texts that libconfig
 * misreads and read their members into structs. */
#ifndef SCALLOP_COMPARE_CONFIG_CONFIG_H
#define SCALLOP_COMPARE_CONFIG_CONFIG_H

#include <libconfig.h>
#include <stdbool.h>
#include <stddef.h>

#include "compare/text/message.h"
#include "compare/text/shipped.h"

/* A file, or a text, after reading */
struct config {
  const char *command; /* for messages */
  const char *path;    /* for messages and to read; "-" is standard input */
  config_t file;       /* owns the texts of members; must not be moved */
  config_t kept;       /* owns other texts, in one list */
};

/* Reads text if it is not NULL, else the file at path. shipped: names that a mistyped path may mean, or NULL. Returns
 * EXIT_DONE, or the exit code after a message on stderr; the configuration must be closed in either case. */
enum exit_code config_open(struct config *config, const char *command, const char *path, const char *text,
                           const struct shipped *shipped);
void config_close(struct config *config);
const config_setting_t *config_root(const struct config *config);

/* Prints "scallop run: FILE:LINE: message" to stderr. Returns false. */
bool refuse_at(const struct config *config, const config_setting_t *at, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

enum member_kind {
  MEMBER_OTHER, /* valid, read elsewhere */
  MEMBER_TEXT,  /* const char *: not empty */
  MEMBER_TEXTS, /* const char *[high]: one or more */
  MEMBER_WORD,  /* int: the place of the text among words, NULL-terminated */
  MEMBER_FLAG,  /* bool */
  MEMBER_COUNT, /* long: from low to high */
};
/* A member that a group may have, and the field of a struct for its value; a missing member leaves the field
 * unchanged. */
struct member {
  const char *name; /* NULL ends a list */
  enum member_kind kind;
  size_t field, count; /* count: offset of the int with the number of texts */
  long low, high;
  const char *const *words;
};
#define MEMBER(KIND, NAME, STRUCT, FIELD, ...) \
  { \
    .name = NAME, .kind = MEMBER_##KIND, .field = offsetof(struct STRUCT, FIELD), __VA_ARGS__ \
  }
#define OTHER(NAME) MEMBER(OTHER, NAME, member, name, )
/* Reads the members of a group into a struct; what: "a scene", in messages. Returns false after a message. */
bool read_members(struct config *config, const config_setting_t *group, const struct member *members, void *into,
                  const char *what);

bool is_ascii(const char *text);                                      /* printable */
const config_setting_t *member_at(const config_setting_t *at, int i); /* of a group */
/* Return the elements of a list or an array; another setting has one element, itself. */
int element_count(const config_setting_t *at);
const config_setting_t *element_at(const config_setting_t *at, int i);
/* Returns a text, or a number as a text that reads back as the same double; NULL for another setting. */
const char *text_of(struct config *config, const config_setting_t *at);

/* Returns a text, valid while the configuration is open; NULL: out of memory, after a message. */
const char *keep(struct config *config, const char *format, ...) __attribute__((format(printf, 2, 3), nonnull(2)));
/* Return the path of an input relative to the folder of the file, also in "measured:FILE"; other gaits unchanged. NULL
 * as above. */
const char *path_beside(struct config *config, const char *path);
const char *gait_beside(struct config *config, const char *gait);

#endif
